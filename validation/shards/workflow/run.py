#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a program of the suite, and notes when it has run to its end: run.py --out DIR --done FILE --log FILE -- PROGRAM …

Results that are bad are results too: checks that fail (exit code 1), points that broke off (2). A run that did not come to
its end is none, whatever its exit code: what it finished stands in DIR, and the next try takes it over.
"""
import argparse
import fcntl
import json
import pathlib
import shlex
import subprocess
import sys


def finished_run(out):
    """The last run in a folder that came to its end: of a sweep one folder deeper."""
    links = [link for link in (out / "latest", *out.glob("*/latest")) if link.is_symlink()]
    return max((link.resolve() for link in links), default=None, key=lambda run: run.name)


def broken_off(run):
    with (run / "records.jsonl").open() as lines:
        return sum(json.loads(line)["verdict"] == "error" for line in lines)


def wait_for_turn(out):
    """Where Snakemake was killed, a job of it may still be at the same part: that one ends first."""
    stream = (out / "lock").open("w")
    try:
        fcntl.lockf(stream, fcntl.LOCK_EX)
    except OSError:  # a file system without locks: at worst points are computed twice
        pass
    return stream


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("out", "done", "log"):
        parser.add_argument(f"--{name}", type=pathlib.Path, required=True)
    parser.add_argument("command", nargs="+")
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    lock = wait_for_turn(asked.out)
    before = finished_run(asked.out)
    with asked.log.open("a") as log:
        ended = subprocess.run([*asked.command, "--out", str(asked.out)], stdout=subprocess.PIPE, stderr=log, text=True)
    run = finished_run(asked.out)
    if ended.returncode not in (0, 1, 2) or run == before:
        how = f"exit code {ended.returncode}" if ended.returncode >= 0 else f"signal {-ended.returncode}"
        with asked.log.open("a") as log:
            print(f"run: {shlex.join(asked.command)} did not come to its end: {how}", file=log)
        return 1
    note = {"run": str(run), "exit_code": ended.returncode, "broke_off": broken_off(run), "screen": ended.stdout}
    new = asked.done.with_name(asked.done.name + ".new")
    new.write_text(json.dumps(note) + "\n")
    new.replace(asked.done)
    lock.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
