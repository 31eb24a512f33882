#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds `compare` with further friction rules, those of WORK/tree/solver/friction/rules/, and runs it:
compare_with_rules.py BUILD ROOT WORK argument …   Only what knows the rules as types is compiled once more."""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

build, root, work = (pathlib.Path(word) for word in sys.argv[1:4])
program = work / "compare"


def including(header):
    """The objects of the build whose source includes it, by whatever way."""
    told = subprocess.run(["ninja", "-t", "deps"], cwd=build, check=True, text=True, capture_output=True).stdout
    return {block.split(":")[0] for block in told.split("\n\n") if re.search(rf"/{re.escape(header)}$", block, re.M)}


def compile_all():
    text = next(build.rglob("generated/solver/friction/friction_rules.inc")).read_text()
    for header in sorted((work / "tree/solver/friction/rules").glob("*.h")):
        words = header.stem.split("_")
        text = f'#include "{header}"\n' + text.rstrip("\n")
        text += f' X({"".join(word.capitalize() for word in words)}, "{"-".join(words)}")\n'
    generated = work / "generated/solver/friction/friction_rules.inc"
    generated.parent.mkdir(parents=True)
    generated.write_text(text)
    link = subprocess.run(["ninja", "-t", "commands", "compare"], cwd=build, check=True, text=True, capture_output=True).stdout
    link = [line for line in link.splitlines() if " -o compare " in line][-1]
    running, objects, asking = [], [], including("solver/friction/with_rule.h")
    for unit in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(unit["file"])
        words = shlex.split(unit["command"])
        at = words.index("-o") + 1
        wanted = file.suffix == ".cpp" and "_test" not in file.name and "plants" not in file.parts
        own = re.search(r"CMakeFiles/stiction_(solver|validation|comparison)\.dir/", unit["command"])
        if not (wanted and own and file.is_relative_to(root) and words[at] in asking):
            continue
        object_file = work / (file.stem + ".o")
        words[at] = str(object_file)
        words.insert(words.index("-c"), f"-I{work / 'generated'}")
        # Before the build's own folder, else that one's list is taken.
        first = next(k for k, word in enumerate(words) if word.startswith(("-I", "-isystem")))
        words.insert(first, f"-I{work / 'generated'}")
        objects.append(str(object_file))
        running.append(words)
        if len(running) == (os.cpu_count() or 1):
            run(running)
            running = []
    run(running)
    link = link.replace(" -o compare ", f" -o {program} {' '.join(objects)} ")
    subprocess.run(link, shell=True, cwd=build, check=True)


def run(commands):
    started = [subprocess.Popen(words, cwd=build) for words in commands]
    if any(one.wait() != 0 for one in started):
        sys.exit("the rule cannot be compiled")


if not program.exists():
    compile_all()
os.execv(program, [str(program), *sys.argv[4:]])
