#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflow on a Slurm of one node, started for it: slurm_test.py BUILD_DIR

A study that went through Slurm in parts, with jobs killed and the node drained, is the study in one piece, and no point of it
was computed twice. Exit code 77 where Slurm, munge or Snakemake is not installed; 1 if STICTION_NEEDS_SLURM is set, as CI does.
"""
import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(HERE), str(HERE / "slurm")]
import one_node  # noqa: E402
from room import BROKEN, COUNT, PARTS, PART_SECONDS, Room, compared, computations, merged, wait_for, whole_lines  # noqa: E402
from box_study import faults, hold, study as study_of  # noqa: E402


def undisturbed(room):
    where = room.study("undisturbed", 0.05)
    wanted = room.whole(where)
    hold(len(wanted[0]) == COUNT, f"{COUNT} points in one piece")
    ran = room.snakemake(where, "slurm")
    hold(ran.returncode == 0, f"the workflow through Slurm: exit code {ran.returncode} {ran.stderr[-600:]}")
    hold(merged(where) == wanted, "its records and its table are those of one piece, but for times")
    jobs = [job for job in room.jobs() if job["JobName"] == "stiction-part"]
    hold(len(jobs) == PARTS and all(job["JobState"] == "COMPLETED" for job in jobs), f"{len(jobs)} jobs of Slurm did it")
    plan = json.loads((where / "out/plan.json").read_text())
    memory = 256 + 2 * plan["memory_mib"]
    asked = {(job["TimeLimit"], job["MinMemoryNode"], job["NumCPUs"]) for job in jobs}
    hold(asked == {("00:07:00", f"{memory:.0f}M", "1")}, f"Slurm was asked for what the estimate says: {asked}")
    hold(COUNT == computations(where), "no point was computed twice")
    first = {file: file.stat().st_mtime_ns for file in where.glob("out/*/done/*.json")}
    again = room.snakemake(where, "slurm", "minutes_per_job=0.1")
    hold(again.returncode == 0 and len(first) == PARTS and {file: file.stat().st_mtime_ns for file in where.glob("out/*/done/*.json")} == first,
         "the same again, with other wishes for jobs, runs no part")
    study = where / "study.toml"
    study.write_text(study.read_text().replace("to = 45", "to = 45\n# changed"))
    changed = room.snakemake(where, "local")
    plans = [file.parent.name for file in where.glob("out/*/plan.json")]
    known = [file for file in where.glob("out/*/parts/*/study/latest/records.jsonl") if json.loads((where / "out/plan.json").read_text())["plan"] in file.parts]
    hold(changed.returncode == 0 and len(plans) == 2 and len(known) == PARTS, f"a changed study has parts of its own {changed.stderr[-600:]}")
    hold(computations(where) == COUNT, "which take the points that they share with the earlier one")


def part_processes(where, number):
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            words = (entry / "cmdline").read_bytes().decode().split("\0")
            if words[0].endswith("/sweep") and f"{number}/{PARTS}" in words and (entry / "cwd").resolve() == where:
                found.append(int(entry.name))
    return found


def disturbed(room):
    """Of the first part the program is killed, and in the second try the job. The node is drained in between."""
    where = room.study("disturbed", room.duration_of(PART_SECONDS))
    wanted = room.whole(where)

    def finished(number, run):
        """Lines of the run-th run of a part."""
        files = sorted(file for file in where.glob(f"out/*/parts/{number}/study/*/records.jsonl") if not file.parent.is_symlink())
        return len(whole_lines(files[run])) if len(files) > run else 0

    def part_jobs(state):
        return [job for job in room.jobs() if job["JobName"] == "stiction-part" and job["JobState"] == state and
                job["WorkDir"] == str(where)]

    def job_of(number):
        return next((job["JobId"] for job in part_jobs("RUNNING") if job["StdOut"].endswith(f"-{number}.log.slurm")), None)

    with (where / "screen").open("w") as screen:
        started = subprocess.Popen([str(word) for word in room.snakemake_words("slurm")], cwd=where, env=room.environment,
                                   stdout=screen, stderr=subprocess.STDOUT)
    try:
        wait_for("the first part has points", lambda: finished(1, 0) > 10)
        os.kill(part_processes(where, 1)[0], signal.SIGKILL)
        had = finished(1, 0)
        hold(10 < had < COUNT // PARTS, f"the first part's program is killed with {had} of {COUNT // PARTS} points done")
        room.slurm.told("scontrol", "update", f"NodeName={one_node.NODE}", "State=DRAIN", "Reason=test")
        wait_for("what runs ends", lambda: not part_jobs("RUNNING"))
        waiting = wait_for("parts wait", lambda: part_jobs("PENDING"))
        time.sleep(1.5)
        hold(started.poll() is None and not part_jobs("RUNNING"), f"the node is drained, and {len(waiting)} parts wait for it")
        room.slurm.told("scontrol", "update", f"NodeName={one_node.NODE}", "State=RESUME")
        wait_for("the first part runs again", lambda: finished(1, 1) > had + 10)
        job = job_of(1)
        hold(job in {one["JobId"] for one in part_jobs("RUNNING") if one["TimeLimit"] == "00:14:00"}, "its second try has twice the time")
        room.slurm.told("scancel", "--signal=KILL", "--full", job)
        hold(started.wait(timeout=100) == 1, "a part whose job is killed too is given up")
    finally:
        if started.poll() is None:
            started.terminate()
            started.wait()
    screen = (where / "screen").read_text()
    hold(len(re.findall(r"part failed, Slurm's job \d+; out/log/\S+-1\.log and", screen)) == 2, f"which is told:\n{screen}")
    hold(len(list(where.glob("out/*/done/*.json"))) == PARTS - 1 and not list(where.glob("out/*/merged.json")), "all others end, and nothing is merged")
    before = computations(where)
    hold(before < COUNT, f"{before} of {COUNT} points are known")
    again = room.snakemake(where, "slurm")
    hold(again.returncode == 0, f"the same command again ends whole: {again.stderr[-600:]}")
    hold(merged(where) == wanted, "and has what one piece has, but for times")
    hold(computations(where) == COUNT, f"{computations(where)} computations, {COUNT} points: none was computed twice")


def by_hand(room):
    where = room.study("by-hand", 0.05)
    wanted = room.whole(where)
    ran = room.run(where, "sbatch", "--wait", "--array=1-4", "--mem=200M", "--output=%a.log", "--wrap",
                   f"{room.build}/sweep study.toml --out shared --no-page --jobs 1")
    runs = [run for run in (where / "shared/study").iterdir() if not run.is_symlink()]
    hold(ran.returncode == 0 and len(runs) == 4, f"an array of Slurm by hand: {len(runs)} runs {ran.stderr}")
    put = room.run(where, room.build / "merge", "shared", "--out", "merged", "--no-page")
    hold(put.returncode == 0 and compared(where / "merged/study/latest") == wanted, f"merged, they are one piece {put.stderr}")


def local(room):
    where = room.study("local", 0.05)
    wanted = room.whole(where)
    ran = room.snakemake(where, "local")
    hold(ran.returncode == 0 and merged(where) == wanted, f"the local profile gives the same {ran.stderr[-600:]}")


def broken_off(room):
    where = room.study("broken", 0.05, first=-0.05)
    ran = room.snakemake(where, "local")
    told = f"{BROKEN} of {COUNT} broke off"
    hold(ran.returncode == 0 and told in ran.stderr, f"points that break off are results, and told: {ran.stderr[-300:]}")
    room.snakemake(where, "local")
    hold(computations(where) == COUNT, "and are not computed again")
    retried = room.snakemake(where, "local", "retry=true")
    hold(retried.returncode == 0 and computations(where) == COUNT + BROKEN, "unless they are to be retried, and then once")


FLAKY = """import os, re
text = open("minimal_engine.py").read()
if os.path.exists("broken"):
    text = text.replace("def advance(self, steps):", "def advance(self, steps):\\n        raise RuntimeError('a licence is missing')")
exec(text)
"""


def retried(room):
    """An engine that cannot run at first, and then can."""
    where = room.study("retried", 0.05)
    for file in ("stiction_engine.py", "examples/minimal_engine.py"):
        shutil.copy(HERE.parents[1] / "engine/kit" / file, where)
    (where / "flaky.py").write_text(FLAKY)
    study = where / "study.toml"
    study.write_text(study_of(3, 3, engines=["python3 flaky.py"]))
    (where / "broken").touch()
    ran = room.snakemake(where, "local")
    hold(ran.returncode == 0 and "9 of 9 broke off" in ran.stderr, f"all points break off: {ran.stderr[-300:]}")
    (where / "broken").unlink()
    ran = room.snakemake(where, "local", "retry=true")
    hold(ran.returncode == 0 and "of 9 broke off" not in ran.stderr, f"once retried, what was merged has their new results: {ran.stdout.splitlines()[1:3]}")


def other_commands(room):
    where = room.folder / "validate"
    where.mkdir()
    words = ["--case", "half-space/*", "--case", "incline/below/*"]
    room.run(where, room.build / "validate", *words, "--no-page", "--out", "whole")
    ran = room.run(where, "snakemake", "-s", HERE / "Snakefile", "--profile", HERE / "local", "--config", f"command=validate {' '.join(words)}",
                   "out=out", f"build={room.build}", "most_jobs=3", "minutes_per_job=0.00001", "page=false")

    def figures(run):
        return [(one["case"], one["configuration"], one["verdict"], one["state_hash"]) for one in map(json.loads, (run / "records.jsonl").read_text().splitlines())]

    whole = figures(where / "whole/latest")
    hold(ran.returncode == 0 and sorted(figures(next(where.glob("out/*/merged/latest")))) == sorted(whole) and len(whole) > 4,
         f"validate in parts is validate in one piece {ran.stderr[-600:]}")


def refusals(room):
    where = room.study("refused", 0.05)
    for more, words in ((["nonsense=1"], "there is no config key 'nonsense'"), (["retry=perhaps"], "neither true nor false"),
                        (["study=none.toml"], "cannot read 'none.toml'"), (["command=validate"], "what shall run?")):
        ran = room.snakemake(where, "local", *more)
        hold(ran.returncode == 1 and words in ran.stderr and "Traceback" not in ran.stderr and len(ran.stderr.splitlines()) < 3, f"refused: {ran.stderr.strip()}")
    (where / "scontrol").write_text("#!/bin/sh\necho 'slurm_load_jobs error: Unable to contact slurm controller (connect failure)' >&2\nexit 1\n")
    (where / "scontrol").chmod(0o755)
    status = [subprocess.run([HERE / "slurm/status", "123456"], env={**room.environment, "PATH": path + room.environment["PATH"]},
                             capture_output=True, text=True, timeout=60).stdout for path in ("", f"{where}:")]
    hold(status == ["success\n", "running\n"], f"a job that Slurm forgot is left to its file; without an answer it is asked again: {status}")


def main():
    if lacking := one_node.missing("snakemake"):
        print(f"slurm_test: not tried, as these programs are not installed: {', '.join(lacking)}")
        return 1 if os.environ.get("STICTION_NEEDS_SLURM") else 77
    if os.getuid() != 0:
        print("slurm_test: not tried, as a Slurm of its own needs root")
        return 1 if os.environ.get("STICTION_NEEDS_SLURM") else 77
    one_node.end_on_signals()
    build = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name, one_node.OneNode() as slurm:
        room = Room(pathlib.Path(name), build, slurm)
        for one in (undisturbed, disturbed, by_hand, local, broken_off, retried, other_commands, refusals):
            began = time.monotonic()
            one(room)
            print(f"     {one.__name__}: {time.monotonic() - began:.0f} s", flush=True)
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())
