#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command on a disk that becomes full, at each of its writes in turn.

    full_disk.py BUILD [--few] [--only NAME] [--most N]

The N-th call that makes or writes a file fails with ENOSPC, for N = 1, 2, 3 … until the command gets through (full_disk.cpp),
in three ways: that call alone, it and all behind it, and it by half. Each time the command must end with exit code 2 and a
sentence that names the file, leave no file under a name that is not its own, every record and every run of a history whole,
and what was there before as it was or new and whole. --few tries a few N of some commands; --most N of each.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the tree stays as it is
from commands import Commands, runs_of_history, temporary_files, whole_lines

KINDS = ("from", "once", "short")
failures = []


def fail(what, why, detail=""):
    failures.append(what)
    print(f"FAIL    {what}: {why}\n{detail}", flush=True)


def names(folder):
    """Its files, runs without their time and links as links."""
    plain = lambda path: re.sub(r"\d{4}-\d\d-\d\dT\d\d-\d\d-\d\dZ(-\d+)?", "RUN", str(path.relative_to(folder)))
    return {plain(path) for path in folder.rglob("*") if (path.is_file() or path.is_symlink())}


class Disk:
    def __init__(self, commands, command, base):
        self.commands, self.command, self.base = commands, command, base

    def run(self, at, kind):
        """Exit code, what it said on both streams, the call that failed (none: it got through), calls, and its folder."""
        folder = self.base / "work"
        shutil.rmtree(folder, ignore_errors=True)
        for name in ("work", "work/cache", "work/tmp"):
            (self.base / name).mkdir()
        self.command.prepare(folder)
        counter, log = self.base / "counter", self.base / "log"
        counter.write_bytes(bytes(8))
        log.unlink(missing_ok=True)
        environment = {**self.commands.environment, "XDG_CACHE_HOME": str(folder / "cache"), "TMPDIR": str(folder / "tmp"),
                       "LD_PRELOAD": str(self.commands.build / "full_disk.so"), "FULL_DISK_IN": str(folder),
                       "FULL_DISK_COUNTER": str(counter), "FULL_DISK_LOG": str(log), "FULL_DISK_AT": str(at),
                       "FULL_DISK_KIND": kind}
        ended = subprocess.run(self.command.words(folder), cwd=folder, env=environment, check=False, timeout=300,
                               stdin=subprocess.DEVNULL, capture_output=True)
        failed = log.read_text().strip() if log.exists() else ""
        return (ended.returncode, ended.stdout.decode(errors="replace"), ended.stderr.decode(errors="replace"), failed,
                int.from_bytes(counter.read_bytes(), "little"), folder)


def told_names(failed):
    """Of which one must be in the sentence: the file, as it is called in the end, or its folder."""
    path = pathlib.Path(failed.split(" ", 1)[1])
    own = re.sub(r"^\.(.*)\.tmp$|(.*)\.partial$|(.*)-journal$", lambda found: next(filter(None, found.groups())), path.name)
    # What an engine or a child writes for its caller alone.
    if "/tmp/stiction-" in failed and not own.startswith("stiction-"):
        return {own, "No space left on device"}
    own = own.replace("XXXXXX", "")
    return {own, path.parent.name} if own.startswith("new-") or own.endswith(".mesh") else {own}


def judge(disk, at, kind, usual):
    """Whether the command still met its N-th call."""
    command = disk.command
    code, output, errors, failed, _, folder = disk.run(at, kind)
    what = f"{command.name}, {kind} {at} ({failed.replace(str(folder), '…')})"
    said = output + errors
    if not failed:
        if code not in command.codes:
            fail(what, f"exit code {code} though nothing failed", said)
        return False
    words = told_names(failed)
    named = any(word in line for line in said.splitlines() for word in words) if code in (0, 1) else \
        any(word in errors for word in words)
    optional = command.optional and re.search(command.optional, failed)
    theirs = command.tools and re.search(r"/work/(work|store/project)/", failed)
    if theirs and code in command.codes:
        return True
    if code < 0 or code >= 128:
        fail(what, f"it ended with {code}", said)
    elif code != 2 and not (optional and code in command.codes):
        fail(what, f"exit code {code}", said)
    elif not named and not (command.tools and re.search(command.tools, errors)):
        fail(what, f"no sentence names {' or '.join(words)}", said)
    added = [line for line in errors.splitlines() if line not in usual["errors"]]
    if len(added) > (3 if command.script else 2 if command.optional else 1):
        fail(what, "more than a sentence", errors)
    # A journal stays where a history cannot be rolled back; whoever opens it next does so.
    if left := [name for name in temporary_files(folder) if not name.endswith("-journal")]:
        fail(what, f"left: {left}", said)
    try:
        check_files(folder, disk, usual, code)
    except Exception as error:  # whatever is wrong with a file is a failure of this trial
        fail(what, f"{error}", said)
    return True


def check_files(folder, disk, usual, code):
    missing = usual["names"] - names(folder)
    if code in disk.command.codes and [name for name in missing if not re.search(disk.command.optional or "^$", name)]:
        raise AssertionError(f"exit code {code} without {missing}")
    for file in folder.rglob("*"):
        before = disk.commands.store / file.relative_to(folder)
        if file.name == "records.jsonl" and not file.is_symlink():
            lines, rest = whole_lines(file)
            assert not rest, f"{file.name} ends in the middle of a record behind {lines}"
        elif file.suffix == ".sqlite":
            runs = runs_of_history(file)
            assert runs is None or runs >= usual["runs before"], f"{runs} runs are left"
        elif before.is_file() and not before.is_symlink() and file.read_bytes() != before.read_bytes():
            assert file.stat().st_size > 0.9 * before.stat().st_size, f"{file.name} was whole and is cut"


def sweep(commands, command, base, most, few):
    disk = Disk(commands, command, base)
    code, output, errors, _, calls, folder = disk.run(0, "once")
    if code not in command.codes or calls == 0:
        fail(command.name, f"exit code {code}, {calls} writes when nothing fails", output + errors)
        return 0
    history = folder / "history.sqlite"
    before = (commands.store / "history.sqlite")
    usual = {"names": names(folder), "errors": errors.splitlines(),
             "runs before": runs_of_history(before) if history.exists() and command.name != "track record" else 0}
    began, trials = time.time(), 0
    numbers = sorted({1, 2, calls // 2, calls - 1, calls} - {0}) if few else [
        # Of hundreds of files of a kind, one after the other, a part.
        at for at in range(1, calls + 30) if at <= 80 or at % 13 == 0 or at > calls - 40]
    for kind in KINDS if not few else ("from", "short"):
        for at in numbers:
            if trials >= most or not judge(disk, at, kind, usual):
                break
            trials += 1
    print(f"        {command.name}: {trials} of {len(KINDS)} × {calls} writes failed ({time.time() - began:.0f} s)", flush=True)
    return trials


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--few", action="store_true")
    options.add_argument("--only", default="")
    options.add_argument("--no-scripts", action="store_true")
    options.add_argument("--most", type=int, default=10**6)
    asked = options.parse_args()
    with tempfile.TemporaryDirectory(prefix="full-disk-") as name:
        base = pathlib.Path(name).resolve()
        (base / "store").mkdir()
        commands = Commands(asked.build.resolve(), base / "store", 0.004)
        chosen = [one for one in commands.all() + ([] if asked.few or asked.no_scripts else commands.scripts())
                  if asked.only in one.name and (one.few or not asked.few)]
        trials = sum(sweep(commands, one, base, asked.most, asked.few) for one in chosen)
        print(f"{trials} writes failed in {len(chosen)} commands: {len(failures)} wrongly")
    sys.exit(1 if failures else 0)


main()
