#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands are told to end, or killed, at random moments: kill_campaign.py BUILD [--count N] [--seed S] [--only NAME]

Each time: the records that were told as finished are there and whole (only SIGKILL may cut the last line, which the next
reader then says), the history is whole and has what was told, nothing that it started goes on, SIGINT and SIGTERM leave no
file under a name that is not its own and end it with 130 and 143 within seconds, and the same command then runs to its end.
"""
import argparse
import collections
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the tree stays as it is
from commands import NODE, REPORT, Command, Commands, runs_of_history, temporary_files, whole_lines

SIGNALS = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
PATIENCE = 20  # s, on a machine that does other things too
failures = []
numbers = collections.Counter()


def fail(what, why, detail=""):
    failures.append(what)
    print(f"FAIL    {what}: {why}\n{detail}", flush=True)


def processes_of(session, folder):
    """Those that are alive: of this session, or at work in the folder (a browser makes a session of its own)."""
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            _, _, rest = stat.read_text().rpartition(")")
            state, _, _, its_session = rest.split()[:4]
            words = stat.with_name("cmdline").read_text().replace("\0", " ")
            here = str(folder) in words or os.readlink(stat.with_name("cwd")).startswith(str(folder))
            if state != "Z" and (int(its_session) == session or here):
                found.append((int(stat.parent.name), words))
        except (OSError, ValueError):
            continue  # it has ended
    return found


def gone(session, folder, seconds):
    """Waits for them to end; those that are left."""
    until = time.monotonic() + seconds
    while (left := processes_of(session, folder)) and time.monotonic() < until:
        time.sleep(0.02)
    return left


def heed():
    """In the child: what stands in a shell's background is deaf to Ctrl-C, and would stay so."""
    for one in SIGNALS[1:]:
        signal.signal(one, signal.SIG_DFL)


def start(commands, command, folder):
    environment = {**commands.environment, "XDG_CACHE_HOME": str(folder / "cache"), "TMPDIR": str(folder / "tmp")}
    with open(folder / "out", "wb") as out, open(folder / "err", "wb") as err:
        return subprocess.Popen(command.words(folder), cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=out,
                                stderr=err, start_new_session=True, preexec_fn=heed)


def said(folder):
    return (folder / "out").read_text(errors="replace") + (folder / "err").read_text(errors="replace")


def check_records(what, folder, signal_number, errors):
    """What is there, beside what was told."""
    kept = {}
    for file in folder.rglob("records.jsonl"):
        if "latest" in file.relative_to(folder).parts:
            continue
        lines, rest = whole_lines(file)
        kept[str(file)] = lines
        numbers["records kept"] += lines
        if rest:
            numbers["lines cut"] += 1
            if signal_number != signal.SIGKILL:
                fail(what, f"a record is cut off: {rest[-60:]}")
            elif NODE and REPORT.is_file():
                page = subprocess.run([NODE, str(REPORT), str(file.parent)], capture_output=True, text=True, check=False)
                if page.returncode != 0 or "cut off" not in page.stdout + page.stderr:
                    fail(what, "the reader does not say that a line is cut off", page.stdout + page.stderr)
    found = re.search(r"(\d+) finished records? (?:is|are) in (\S+records\.jsonl)", errors)
    if found and kept.get(found[2]) != int(found[1]):
        fail(what, f"{found[1]} records were told, {kept.get(found[2])} are there")
    # `validate --verbose` prints a record once it is kept.
    cases = set(re.findall(r"^([a-z][\w-]*/\S+)  \S.*\n", (folder / "out").read_text(), re.M))
    text = "".join(pathlib.Path(file).read_text(errors="replace") for file in kept)
    if lost := [case for case in cases if f'"{case}"' not in text]:
        fail(what, f"told and lost: {lost}")
    numbers["records told"] += len(cases) + (int(found[1]) if found else 0)


def check_histories(what, folder, before):
    for file in folder.rglob("*.sqlite"):
        try:
            runs = runs_of_history(file) or 0
        except Exception as error:
            fail(what, f"{error}")
            continue
        told = len(re.findall(r"^Run \d+", (folder / "out").read_text(), re.M))
        least = before.get(file.name, 0) + told
        if "what was measured is in the history" in (folder / "err").read_text():
            least = max(least, before.get(file.name, 0) + 1)
        most = before.get(file.name, 0) if "nothing of it is in the history" in (folder / "err").read_text() else least + 2
        if not least <= runs <= most:
            fail(what, f"{runs} runs in {file.name}, not {least} to {most}")
        numbers["histories whole"] += 1


def trial(commands, command, base, one, moment, usual):
    what = f"{command.name}, {one.name} after {moment:.3f} s"
    folder = fresh_folder(command, base)
    before = {file.name: runs_of_history(file) or 0 for file in folder.rglob("*.sqlite")}
    process = start(commands, command, folder)
    time.sleep(moment)
    early = process.poll() is not None
    if not early:
        process.send_signal(one)
    began = time.monotonic()
    try:
        code = process.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        fail(what, f"it runs on {PATIENCE} s later", said(folder))
        process.kill()
        code = process.wait()
    took = time.monotonic() - began
    numbers[command.name, one.name] += not early
    numbers["ended by it"] += not early and code in (128 + one, -one)
    errors = (folder / "err").read_text(errors="replace")
    # A signal before the program heeds any ends it at once; a shell calls that by the same number.
    ended = 128 + one if code in (128 + one, -one) else code
    if not (ended == 128 + one or code in command.codes):
        fail(what, f"exit code {code}", said(folder))
    if one != signal.SIGKILL and took > 8:
        fail(what, f"it took {took:.1f} s to end", said(folder))
    # Of what is killed nobody ends the children: they end when they find nobody to talk to, or have done their work.
    left = gone(process.pid, folder, PATIENCE if one == signal.SIGKILL else 0.3)
    if left:
        fail(what, f"left running: {left}", said(folder))
        for number, _ in left:
            os.kill(number, signal.SIGKILL)
    more = [line for line in errors.splitlines() if line not in usual]
    if len(more) > 1 or "Traceback" in errors or "terminate called" in errors:
        fail(what, "more than is to be said", errors)
    if one != signal.SIGKILL and (files := temporary_files(folder)):
        fail(what, f"left: {files}", said(folder))
    try:
        check_records(what, folder, one, errors)
        check_histories(what, folder, before)
        for file in folder.rglob("*"):  # what was there before is as it was, or new and whole
            old = commands.store / file.relative_to(folder)
            if old.is_file() and file.suffix in (".md", ".json", ".html") and file.stat().st_size < 0.9 * old.stat().st_size:
                fail(what, f"{file.name} was whole and is cut")
    except Exception as error:
        fail(what, f"{type(error).__name__}: {error}", said(folder))
    return not early


def fresh_folder(command, base):
    folder = base / "work"
    shutil.rmtree(folder, ignore_errors=True)
    for name in ("work", "work/cache", "work/tmp"):
        (base / name).mkdir()
    command.prepare(folder)
    return folder


def whole_run(commands, command, base):
    """When nothing disturbs it: how long it takes, s, and the lines that it says on its standard error."""
    folder = fresh_folder(command, base)
    began = time.monotonic()
    code = start(commands, command, folder).wait(300)
    if code not in command.codes:
        fail(command.name, f"exit code {code} when nothing disturbs it", said(folder))
    return time.monotonic() - began, (folder / "err").read_text().splitlines()


def again(commands, command, base):
    """After the last of its kills the command runs to its end in the folder as it was left."""
    folder = base / "work"
    process = start(commands, command, folder)
    code = process.wait(300)
    if code not in command.codes:
        fail(command.name, f"exit code {code} when it is run again", said(folder))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("build", type=pathlib.Path)
    options.add_argument("--count", type=int, default=500)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--only", default="", help="commands whose name holds this")
    options.add_argument("--no-scripts", action="store_true", help="leave ./stiction itself out")
    asked = options.parse_args()
    chance = random.Random(asked.seed)
    with tempfile.TemporaryDirectory(prefix="kills-") as name:
        base = pathlib.Path(name).resolve()
        (base / "store").mkdir()
        commands = Commands(asked.build.resolve(), base / "store", 0.1)
        small = asked.count < 100 and not asked.only
        more = [Command("mesh_surface", lambda folder: [str(commands.build / "mesh_surface"), "cube.off", "--cell-size", "12"],
                        prepare=commands.copy("cube.off"))]
        if NODE and REPORT.is_file() and shutil.which("chromium"):
            more.append(Command("report, a PDF", lambda folder: [NODE, str(REPORT), "runs", "--manual", "manual.pdf"],
                                prepare=commands.copy("runs")))
        everything = commands.all() + more + ([] if asked.no_scripts else commands.scripts())
        chosen = [one for one in everything if asked.only in one.name and (one.few or not small)]
        for k, command in enumerate(chosen):
            seconds, usual = whole_run(commands, command, base)
            kills = (asked.count - k - 1) // len(chosen) + 1
            met = tries = 0
            while met < kills and tries < 4 * kills:
                met += trial(commands, command, base, SIGNALS[(k + tries) % len(SIGNALS)], chance.uniform(0.0, seconds), usual)
                tries += 1
            again(commands, command, base)
            counts = ", ".join(f"{numbers[command.name, one.name]} {one.name}" for one in SIGNALS)
            print(f"        {command.name}: {counts}, {tries - met} came too late ({seconds:.2f} s)", flush=True)
    kills = sum(numbers[command.name, one.name] for command in chosen for one in SIGNALS)
    print(f"{kills} kills, of which {numbers['ended by it']} ended their program (seed {asked.seed}): {numbers['records kept']} records "
          f"kept, {numbers['records told']} of them told, {numbers['lines cut']} lines cut, "
          f"{numbers['histories whole']} histories whole, {len(failures)} failures")
    sys.exit(1 if failures else 0)


main()
