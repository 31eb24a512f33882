#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a person sees of `validate` on terminals of several sizes: terminal_test.py BUILD_DIR

With $STICTION_SCREENS, a folder, each screen is kept there as text.
"""
import fcntl
import os
import pathlib
import pty
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import unicodedata

ESCAPE = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def on_terminal(command, columns, lines, interrupted_after=None, interrupted_at=None, **environment):
    """Everything that the command writes to a terminal of that size, and its exit code. Ctrl-C is typed after
    `interrupted_after` seconds, or as soon as it has written what matches `interrupted_at`."""
    child, terminal = pty.fork()
    if child == 0:
        fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))
        for name in ("COLUMNS", "NO_COLOR"):
            os.environ.pop(name, None)
        os.environ.update({"TERM": "xterm", **environment})
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # what stands in a shell's background ignores it
        os.execvp(command[0], command)
    if interrupted_after is not None:
        threading.Timer(interrupted_after, os.write, (terminal, b"\x03")).start()
    written = b""
    while True:
        try:
            piece = os.read(terminal, 65536)
        except OSError:  # the child has closed its side
            break
        if not piece:
            break
        written += piece
        if interrupted_at is not None and re.search(interrupted_at, written.decode(errors="ignore")):
            os.write(terminal, b"\x03")
            interrupted_at = None
    _, status = os.waitpid(child, 0)
    return written.decode(), os.waitstatus_to_exitcode(status)


def seen(written):
    """The lines that stand on the screen at the end: a line that is drawn anew hides the one before."""
    lines = []
    for line in written.replace("\r\n", "\n").split("\n"):
        lines.append(ESCAPE.sub("", line.split("\r")[-1]))
    return lines[:-1] if lines and not lines[-1] else lines


def width(line):
    return sum(unicodedata.combining(sign) == 0 for sign in line)


failures = []


def check(what, holds, detail=""):
    print(("ok      " if holds else "FAIL    ") + what)
    if not holds:
        failures.append(what)
        print(detail)


def keep(name, lines):
    folder = os.environ.get("STICTION_SCREENS")
    if folder:
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, name + ".txt"), "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")


def main():
    validate = os.path.join(os.path.abspath(sys.argv[1]), "validate")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        look(validate)
        look_at_meshing(validate)
        look_at_script()
        os.chdir("/")
    sys.exit(1 if failures else 0)


def look_at_script():
    """The script's own line of progress while it builds, and its pages."""
    root = pathlib.Path(__file__).resolve().parent.parent
    tree = pathlib.Path("tree")
    (tree / "build/release").mkdir(parents=True)
    (tree / "bin").mkdir()
    (tree / "build/release/build.ninja").touch()
    shutil.copy(root / "stiction", tree)
    (tree / "reports" / "screen").mkdir(parents=True)
    for sourced in ("help.sh", "children.sh"):
        shutil.copy(root / "reports" / "screen" / sourced, tree / "reports" / "screen")
    tools = {"bin/cmake": "for k in 1 2 3; do echo \"[$k/3] Building solver/step.cpp\"; done",
             "bin/dpkg-query": 'for name; do echo "installed $name"; done',  # nothing is missing
             "build/release/readme": "echo 'what was asked for'"}
    for name, text in tools.items():
        (tree / name).write_text(f"#!/bin/sh\n{text}\n")
        (tree / name).chmod(0o755)
    path = f"{tree.resolve()}/bin:{os.environ['PATH']}"
    words = [str(tree / "stiction"), "readme"]
    written, code = on_terminal(words, 80, 24, PATH=path)
    check("the script shows the progress of a build, and takes it away",
          "[2/3] step.cpp" in written and seen(written) == ["what was asked for"] and code == 0, repr(written))
    written, _ = on_terminal(words, 80, 24, PATH=path, NO_COLOR="1")
    check("the script, NO_COLOR: no escape, but progress", "\x1b" not in written and "[2/3]" in written, repr(written))
    written, _ = on_terminal(words, 80, 24, PATH=path, TERM="dumb")
    check("the script, a dumb terminal: what was asked for alone", written == "what was asked for\r\n", repr(written))
    for variable in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
        written, _ = on_terminal([str(tree / "stiction"), "help", "test"], 80, 24, **variable)
        check(f"the script's pages, {variable}: no escape", "\x1b" not in written and "SYNOPSIS" in written, written)


MESHED = """
duration = 0.001
[[body]]
name = "cube"
shape = "surface"
file = "cube.off"
cell_size = 0.03
mass = 1
position = [0, 0, 1]
[[check]]
observable = "speed"
expected = 0.00981
tolerance = 1e-3
reason = "free fall"
"""


def look_at_meshing(validate):
    """Two hundred thousand tetrahedra take some seconds, in which something is to be seen."""
    corners = [f"{x} {y} {z}" for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = ["0 2 1", "1 2 3", "4 5 6", "5 7 6", "0 1 4", "1 5 4", "2 6 3", "3 6 7", "0 4 2", "2 4 6", "1 3 5", "3 7 5"]
    pathlib.Path("cube.off").write_text("\n".join(["OFF", "8 12 0", *corners, *("3 " + face for face in faces)]) + "\n")
    pathlib.Path("cube.toml").write_text(MESHED)
    command = [validate, "cube.toml", "--list"]
    cache = {"XDG_CACHE_HOME": os.getcwd()}
    written, code = on_terminal(command, 80, 24, **cache)
    check("meshing is seen while it goes on", re.search(r"meshing cube.off: about 185 185 tetrahedra · \d", written), written)
    check("… and gone when it is done", len(seen(written)) == 1 and code == 0, seen(written))
    written, _ = on_terminal(command, 80, 24, **cache)
    check("… and not done twice", "meshing" not in written, written)


def look(validate):
    quick = [validate, "--quick", "--no-page"]
    few = [validate, "--case", "half-space/*", "--case", "incline/below/*", "--no-page"]
    for columns, lines in ((80, 24), (200, 50)):
        written, code = on_terminal(quick, columns, lines)
        screen = seen(written)
        size = f"{columns} × {lines}"
        keep(f"validate-quick-{columns}x{lines}", screen)
        check(f"{size}: the quick set passes", code == 0, written)
        check(f"{size}: all of it stands on one screen", len(screen) < lines, "\n".join(screen))
        wide = [line for line in screen if width(line) > columns and not line.startswith("Report: ")]
        check(f"{size}: no line is too wide", not wide, "\n".join(wide))
        check(f"{size}: who holds is said", any(line.startswith("Who holds") for line in screen))
        progress = re.findall(r"\[(\d+)/(\d+)\] ", written)
        check(f"{size}: progress is shown", len(progress) > 5)
        long_lines = [line.rstrip() for line in re.split(r"\r|\n", written)
                      if line.startswith("[") and width(line) >= columns]
        check(f"{size}: … on one line", not long_lines, "\n".join(long_lines))

    # Something ends in each of its seconds: the line is drawn when something does, and tells nothing before two have passed.
    cases = ("incline/threshold/*", "slab/rest/drift", "slab/rest/fixed", "slab/rest/random", "slab/rest/many/20")
    longer = [validate, *(word for case in cases for word in ("--case", case)), "--jobs", "2", "--no-page"]
    time_left = r"· \d+ s left"
    written, _ = on_terminal(longer, 80, 24, interrupted_at=time_left)
    check("a run of some seconds tells the time that is left", re.search(time_left, written), written)

    for variables in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
        written, code = on_terminal(longer, 80, 24, interrupted_after=1, **variables)
        answered = any(line.startswith("stiction validate: interrupted") for line in re.split("[\r\n]+", written))
        check(f"Ctrl-C is answered on a line of its own, without an escape, {variables}",
              answered and code == 130 and "\x1b" not in written, repr(written))

    failing = [validate, "--case", "half-space/free-fall", "--tolerance-scale", "0", "--no-page"]
    written, code = on_terminal(failing, 80, 24)
    screen = seen(written)
    keep("validate-failing-80x24", screen)
    check("what fails is coloured", "\x1b[1;31m" in written and code == 1)
    check("… printed whole, with the command that reruns it",
          any("again: ./stiction validate --case 'half-space/free-fall'" in line for line in screen))
    written, _ = on_terminal(failing, 80, 24, NO_COLOR="1")
    check("NO_COLOR: no escape at all", "\x1b" not in written, written)
    written, _ = on_terminal(few, 80, 24, NO_COLOR="1")
    check("… but progress", "\x1b" not in written and len(re.findall(r"\[(\d+)/(\d+)\] ", written)) > 5)
    written, _ = on_terminal(failing, 80, 24, NO_COLOR="")
    check("an empty NO_COLOR says nothing", "\x1b[1;31m" in written)
    for command in (few, failing, [validate, "--help"], [validate, "--bogus"]):
        written, _ = on_terminal(command, 80, 24, TERM="dumb")
        check(f"a dumb terminal gets no escape: {command[1]}", "\x1b" not in written and "\r" not in written.replace("\r\n", ""))
    words = re.compile(r"[a-z/-]{4,}")
    roomy, narrow = (words.findall(" ".join(seen(on_terminal(quick, columns, 120)[0])))
                     for columns in (80, 40))
    lost = set(roomy) - set(narrow)
    check("a narrow window loses no word", not lost, str(lost))

    plain = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "NO_COLOR")}
    piped = subprocess.run(few, capture_output=True, text=True, env=plain, check=False)
    check("a pipe gets no escape, and stderr is empty",
          "\x1b" not in piped.stdout and piped.stderr == "", piped.stderr)
    verbose = subprocess.run([*quick, "--verbose"], capture_output=True, text=True, check=False,
                             env={**plain, "COLUMNS": "80"})
    wide = [line for line in verbose.stdout.splitlines() if width(line) > 80]
    keep("validate-verbose-80", verbose.stdout.splitlines())
    check("--verbose: every check, and no name is cut",
          "…" not in verbose.stdout and "nearest to failing" in verbose.stdout)
    # Paths and commands stay whole, to be copied; a case's line is as long as its name.
    wide = [line for line in wide if not re.match(r"Report: |.*again: |[a-z]\S*/\S+  ", line)]
    check("COLUMNS=80: no line is too wide", not wide, "\n".join(wide))


main()
