#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every program with each of its standard streams closed, full and broken: streams_test.py BUILD_DIR

Nothing it opens may take a closed stream's place, what could not be shown is no success, and whether
anyone reads the errors changes nothing.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STREAMS = ("input", "output", "errors")
FAULTS = ("closed", "full", "broken")

failures = []


def check(what, holds, detail=""):
    if not holds:
        failures.append(what)
        print(f"FAIL    {what}\n{detail}")


def spoil(stream, fault):
    """In the child, before its program: the stream is closed, a full disk, or a pipe nobody is at the other end of."""
    if fault == "closed":
        os.close(stream)
        return
    if fault == "full":
        end = os.open("/dev/full", os.O_RDONLY if stream == 0 else os.O_WRONLY)
    else:
        reader, writer = os.pipe()
        end, other = (reader, writer) if stream == 0 else (writer, reader)
        os.close(other)
    os.dup2(end, stream)
    os.close(end)


def run(command, stream=None, fault=None):
    """How it ends: the exit code, negative for a signal, and what it wrote to streams that can be read."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        ended = subprocess.run(
            command, stdin=subprocess.DEVNULL, stdout=output, stderr=errors, check=False, timeout=120,
            restore_signals=True, preexec_fn=None if stream is None else lambda: spoil(stream, fault))
        output.seek(0)
        errors.seek(0)
        return ended.returncode, output.read().decode(), errors.read().decode()


def untimed(text):
    """Without its figures, of which some are times."""
    return re.sub(r"[0-9.e+-]+", "", text)


def try_streams(name, command, code):
    """`code`: what it ends with when nothing is wrong with its streams."""
    usual = run(command)
    check(f"{name}: exit code {code}", usual[0] == code, f"{usual}")
    for fault in FAULTS:
        for stream, word in enumerate(STREAMS):
            what = f"{name}, {word} {fault}"
            ended, output, errors = run(command, stream, fault)
            if word == "output" and usual[1]:
                check(f"{what}: exit code 2", ended == 2, f"{ended}\n{errors}")
                # Who has closed a pipe knows that, and need not be told.
                more = errors.removeprefix(usual[2]).splitlines()
                said = len(more) == 1 and "standard output" in more[0]
                check(f"{what}: one sentence", said or (fault == "broken" and not more), errors)
                continue
            check(f"{what}: exit code {code}", ended == code, f"{ended}\n{errors}")
            if word == "errors":
                check(f"{what}: the output is the same", untimed(output) == untimed(usual[1]), output)
    print(f"ok      {name}" if not failures else f"        {name}")


def records_stay_records(build, folder):
    """What is said does not come between the lines of a file that was opened in its place."""
    for stream, word in enumerate(STREAMS):
        out = folder / f"report-{word}"
        run([str(build / "validate"), "--case", "half-space/free-fall", "--verbose", "--no-page", "--out", str(out)],
            stream, "closed")
        files = list(out.glob("*/records.jsonl"))
        check(f"a run without standard {word}: has records", files)
        for file in files:
            for line in file.read_text().splitlines():
                try:
                    json.loads(line)
                except ValueError:
                    check(f"a run without standard {word}: records.jsonl has records alone", False, line)


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    program = lambda name, *words: [str(build / name), *words]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.chdir(folder)
        for one in ("validate", "compare", "sweep", "bench", "track", "engine", "readme", "mesh_surface"):
            try_streams(f"{one} --help", program(one, "--help"), 0)
            try_streams(f"{one} --bogus", program(one, "--bogus"), 2)
        try_streams("validate --list", program("validate", "--list"), 0)
        try_streams("compare --list", program("compare", "--list"), 0)
        try_streams("compare engines --list", program("compare", "engines", "--list"), 0)
        study = pathlib.Path(__file__).resolve().parent / "sweep/examples/hold-or-slide.toml"
        try_streams("sweep --dry-run", program("sweep", str(study), "--dry-run"), 0)
        try_streams("bench --list-fixed", program("bench", "--list-fixed"), 0)
        try_streams("engine list", program("engine", "list"), 0)
        try_streams("engine show", program("engine", "show", "stiction"), 0)
        try_streams("engine check", program("engine", "check", str(build / "hosted_engine")), 0)
        (folder / "import.json").write_text('{"benchmarks": [{"name": "a", "cpu_time": 1, "time_unit": "ns"}]}')
        history = ["--history", str(folder / "history.sqlite")]
        subprocess.run(program("track", "import", "import.json", *history), check=True, capture_output=True)
        try_streams("track history", program("track", "history", *history), 0)
        try_streams("readme of no tree", program("readme", "--check", "--root", str(folder)), 2)
        try_streams("an engine's program", program("hosted_engine", "--bogus"), 2)
        try_streams("a step", program("step_with_all", "timing", "used"), 0)
        try_streams("a step of nothing", program("step_with_all"), 2)
        case = ["--case", "half-space/rest", "--no-page", "--out", str(folder / "report")]
        try_streams("validate, a case that breaks off", program("validate", *case, "--set", "dt=0.01"), 2)
        try_streams("the script", [str(ROOT / "stiction"), "help"], 0)
        try_streams("the script, no command", [str(ROOT / "stiction"), "bogus"], 2)
        try_streams("mesh_surface of nothing", program("mesh_surface", "nowhere.off"), 16)
        records_stay_records(build, folder)
        os.chdir("/")
    print(f"{len(failures)} fail")
    sys.exit(1 if failures else 0)


main()
