#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Text that others wrote, in everything that people read: hostile_text_test.py BUILD_DIR

Problem files, their names, engines' own words, records and settings carry signs that steer a terminal,
turn the direction of text, forge lines, or are formulas of a spreadsheet. None may come through.
"""
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# Each sign alone would do harm; NUL cannot stand in the words of a command or the name of a file.
IN_NAMES = ("\x07\x08\x1b]0;title\x07\x1b[2J\x1b[8mhidden\r\x7f\u0085\u009b31m\u200e\u200f\u061c"
            "\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069\u2028\u2029\nFORGED line\n\tFORGED")
HOSTILE = "=HYPERLINK(1)" + IN_NAMES + "\0end"
UNSEEN = re.compile("[\0-\x09\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")

# Passes on what the engine behind it says, with words of its own.
ENGINE = """
import json, subprocess, sys
hostile = json.loads(sys.argv[2])
child = subprocess.Popen([sys.argv[1]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
for line in sys.stdin:
    asked = json.loads(line)
    child.stdin.write(line)
    child.stdin.flush()
    said = json.loads(child.stdout.readline())
    if asked["do"] == "hello":
        said["description"] = said["version"] = hostile
        said["settings"] = {name: hostile for name in said["settings"]}
        if sys.argv[3] == "named":
            said["settings"][hostile] = hostile
        if sys.argv[3] == "configured":
            said["configurations"] = [{"name": "mine" + hostile, "source": hostile, "settings": {"dt": "1e-4"}}]
    if asked["do"] == "load" and sys.argv[3] in ("error", "lacks"):
        said = {sys.argv[3]: hostile}
    if asked["do"] == "load" and sys.argv[3] == "noise":
        print(hostile, file=sys.stderr)
        sys.exit(hostile)
    print(json.dumps(said), flush=True)
"""

PROBLEM = """
title = HOSTILE
duration = 0.01
[[body]]
name = "box"
shape = "box"
size = [0.2, 0.2, 0.1]
mass = 1.0
position = [0, 0, 1]
[[check]]
observable = "speed"
expected = 0.0981
tolerance = TOLERANCE
reason = HOSTILE
claim = HOSTILE
source = HOSTILE
"""

failures = []


def check(what, holds, detail=""):
    print(("ok      " if holds else "FAIL    ") + what)
    if not holds:
        failures.append(what)
        print("        " + repr(detail)[:600])


def looked_at(what, text, where):
    found = UNSEEN.search(text)
    around = text[max(0, found.start() - 60):found.end() + 60] if found else ""
    check(f"{what}: no unseen sign in {where}", not found, around)
    forged = [line for line in text.splitlines() if line.lstrip("|<>- \"'").startswith("FORGED")]
    # What wraps long text may begin a line with any word.
    check(f"{what}: no forged line in {where}", not forged, forged)


def run(what, command, codes=(0, 1, 2)):
    environment = {**os.environ, "COLUMNS": "5000"}
    ended = subprocess.run(command, capture_output=True, check=False, timeout=120, env=environment)
    output, errors = ended.stdout.decode(), ended.stderr.decode()  # a byte that is no UTF-8 ends the test
    check(f"{what}: ends by itself, with {codes}", ended.returncode in codes, (ended.returncode, errors))
    looked_at(what, output, "stdout")
    looked_at(what, errors, "stderr")
    return output + errors


def report(what, folder):
    """The files of a run that people or their spreadsheets read."""
    for file in folder.glob("latest/*"):
        if file.suffix in (".md", ".xml"):
            looked_at(what, file.read_text(), file.name)
        if file.suffix == ".csv":
            text = file.read_bytes().decode()
            looked_at(what, text.replace("\r\n", "\n"), file.name)
            cells = [cell for row in csv.reader(text.splitlines()[1:]) for cell in row]
            formulas = [cell for cell in cells if re.match(r"\s*[=+@-]", cell) and not number(cell)]
            check(f"{what}: no formula in {file.name}", not formulas, formulas)


def number(cell):
    try:
        float(cell)
    except ValueError:
        return False
    return True


def problem(folder, name, **changes):
    text = PROBLEM
    for key, value in {"HOSTILE": json.dumps(HOSTILE).replace("\\u007f", "\\u007F"), "TOLERANCE": "1e-12",
                       **changes}.items():
        text = text.replace(key, value)
    file = folder / (name + ".toml")
    file.write_text(text)
    return str(file)


def problems(validate, folder):
    quiet = ["--no-page", "--out", str(folder / "out")]
    for name, tolerance in (("holds", "1e-3"), ("fails", "0"), ("=1" + IN_NAMES, "0")):
        what = f"a problem that {name[:5]!r}"
        file = problem(folder, name, TOLERANCE=tolerance)
        run(what, [validate, file, *quiet])
        report(what, folder / "out")
        run(what + ", --verbose", [validate, file, "--verbose", *quiet])
        run(what + ", --list", [validate, file, "--list"], (0,))
    for key in ("HOSTILE = 1\n[[body]]", "[[body]]\nHOSTILE = 1\n", "[[body]]\nrests_on = HOSTILE\n"):
        file = problem(folder, "refused")
        text = pathlib.Path(file).read_text()
        pathlib.Path(file).write_text(text.replace("[[body]]", key.replace("HOSTILE", json.dumps(HOSTILE))))
        run(f"a problem with {key[:20]!r}", [validate, file, *quiet], (2,))
    run("a problem that is not there", [validate, str(folder / (IN_NAMES + ".toml"))], (2,))
    folder_of_that_name = folder / ("out" + IN_NAMES)
    run("a folder for reports", [validate, problem(folder, "holds"), "--no-page", "--out", str(folder_of_that_name)])
    bytes_alone = os.fsencode(folder) + b"/bad\xff\xfe.toml"
    pathlib.Path(problem(folder, "holds")).rename(os.fsdecode(bytes_alone))
    run("a file whose name is no UTF-8", [os.fsencode(validate), bytes_alone, *map(os.fsencode, quiet)], (0, 1))
    report("a file whose name is no UTF-8", folder / "out")


def engines(build, folder):
    script = folder / "engine.py"
    script.write_text(ENGINE)
    validate, engine, compare = (str(build / name) for name in ("validate", "engine", "compare"))
    out = ["--no-page", "--out", str(folder / "engines")]
    for kind in ("words", "configured", "named", "error", "lacks", "noise"):
        # program_words splits as a shell does.
        words = f"'{sys.executable}' '{script}' '{build / 'hosted_engine'}' '{json.dumps(HOSTILE)}' {kind}"
        run(f"an engine, {kind}: show", [engine, "show", words])
        run(f"an engine, {kind}: check", [engine, "check", words])
        run(f"an engine, {kind}: validate", [validate, "--engine", words, "--case", "half-space/free-fall", *out])
        report(f"an engine, {kind}: validate", folder / "engines")
        run(f"an engine, {kind}: unknown setting",
            [validate, "--engine", words, "--case", "half-space/free-fall", "--set", IN_NAMES + "=1"], (2,))
    words = f"'{sys.executable}' '{script}' '{build / 'hosted_engine'}' '{json.dumps(HOSTILE)}' configured"
    run("an engine: compare", [compare, "engines", "--quick", "--question", "creep-half", "--engine", words, *out])
    report("an engine: compare", folder / "engines")


def words_of_a_command(build):
    for name, option in (("validate", "--case"), ("validate", "--engine"), ("validate", "--set"),
                         ("validate", "--suite"), ("validate", "--perturb"), ("validate", "--configuration"),
                         ("validate", "--jobs"), ("validate", "--show-expectations"), ("compare", "--scene"),
                         ("compare", "--rule"), ("bench", "--filter"), ("bench", "--fixed"), ("readme", "--root"),
                         ("readme", "--against"), ("track", "--history"), ("engine", "show"), ("validate", IN_NAMES),
                         ("compare", IN_NAMES), ("engine", IN_NAMES), ("mesh_surface", "--cell-size")):
        run(f"{name} {option[:9]!r}", [str(build / name), option, IN_NAMES], (1, 2, 16))
    run("mesh_surface of no file", [str(build / "mesh_surface"), IN_NAMES + ".off"], (16, 17))


def records(build, folder):
    """Read back: what another program wrote, and what is no record at all."""
    free_fall = [str(build / "validate"), "--case", "half-space/free-fall", "--no-page", "--out", str(folder / "own")]
    run("a run", free_fall, (0,))
    record = json.loads((folder / "own/latest/records.jsonl").read_text().splitlines()[0])

    for field in ("case", "title", "engine", "error", "state_hash"):
        (folder / "records.jsonl").write_text(json.dumps({**record, field: HOSTILE}) + "\n")
        run(f"records with that {field}",
            [str(build / "validate"), "--show-expectations", str(folder / "records.jsonl")])
    (folder / "records.jsonl").write_text(json.dumps({HOSTILE: HOSTILE}) + "\n")
    run("no records", [str(build / "validate"), "--show-expectations", str(folder / "records.jsonl")], (2,))
    run("readme against no records", [str(build / "readme"), "--against", str(folder)], (2,))
    (folder / "import.json").write_text(json.dumps({
        "context": {"host_name": HOSTILE, "date": "2026-01-01T00:00:00+00:00", "library_build_type": HOSTILE},
        "benchmarks": [{"name": "step" + HOSTILE, "run_name": "step" + HOSTILE, "run_type": "iteration",
                        "iterations": 1, "cpu_time": 1.0, "real_time": 1.0, "time_unit": "ns", "label": HOSTILE}]}))
    track = [str(build / "track")]
    history = ["--history", str(folder / "history.sqlite")]
    run("track import", [*track, "import", str(folder / "import.json"), *history])
    run("track history", [*track, "history", "--all", "--any-machine", *history])
    run("track export", [*track, "export", "-", *history])


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        os.chdir(folder)
        problems(str(build / "validate"), folder)
        engines(build, folder)
        words_of_a_command(build)
        records(build, folder)
        os.chdir("/")
    print(f"{len(failures)} fail")
    sys.exit(1 if failures else 0)


main()
