#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep as a person calls it: sweep_test.py BUILD_DIR [KILLS]

A study in one piece and in shards has the same points; one that is killed KILLS times (SIGKILL, 8) at random moments loses
no finished point and computes none twice; a point that broke off is told, and retried when asked.
"""
import json
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "shards"))
from box_study import faults, hold, plain_environment, problem, same, study  # noqa: E402

COUNT = 2 * 20 * 21


def main():
    program = pathlib.Path(sys.argv[1]).resolve() / "sweep"
    kills = int(sys.argv[2]) if len(sys.argv) > 2 else 8
    random.seed(1)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "box.toml").write_text(problem(0.03 * kills))
        (folder / "study.toml").write_text(study(20, 21))
        plain = plain_environment()

        def words(out, *more):
            return [program, "study.toml", "--no-page", "--out", out, *more]

        def run(out, *more, **environment):
            return subprocess.run(words(out, *more), cwd=folder, env={**plain, **environment}, capture_output=True, text=True, timeout=120)

        def lines(out):
            """Of the newest run."""
            return (folder / out / "study/latest/records.jsonl").read_text().splitlines()

        began = time.monotonic()
        whole = run("whole")
        takes = time.monotonic() - began
        hold(whole.returncode == 0, f"a study in one piece: exit code {whole.returncode} {whole.stderr}")
        wanted = sorted(map(same, lines("whole")))
        hold(len(wanted) == COUNT and len({json.loads(line)["point"] for line in lines("whole")}) == COUNT,
             f"{COUNT} points, each with a name of its own")
        table = (folder / "whole/study/latest/points.csv").read_bytes()
        hold(table.count(b"\r\n") == COUNT + 1, "a table with a line a point")

        again = run("whole")
        hold("0 computed" in again.stdout and sorted(map(same, lines("whole"))) == wanted, "the same again computes nothing")
        fresh = run("whole", "--fresh")
        hold(f"{COUNT} computed" in fresh.stdout and sorted(map(same, lines("whole"))) == wanted, "unless all of it is asked for")
        shared = run("elsewhere", "--share", "whole")
        hold("0 computed" in shared.stdout, "points of another folder are taken")

        for number in range(4):
            part = run("parts", SLURM_ARRAY_TASK_ID=str(number + 3), SLURM_ARRAY_TASK_COUNT="4", SLURM_ARRAY_TASK_MIN="3")
            hold(part.returncode == 0, f"shard {number + 1} of 4")
        together = run("parts")
        hold("0 computed" in together.stdout and sorted(map(same, lines("parts"))) == wanted, "four shards are the whole")

        # Killed at random moments: whatever was finished by then is in some run's file.
        seen, computed = set(), 0
        for number in range(kills):
            started = subprocess.Popen(words("killed", "--jobs", "2"), cwd=folder, env=plain, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(0.04 + random.uniform(0, 1.5 * takes / kills))
            started.send_signal(signal.SIGKILL)
            started.wait()
            runs = sorted((folder / "killed/study").glob("*/records.jsonl"), key=lambda file: file.stat().st_ctime_ns)
            newest = [json.loads(line)["point"] for line in (runs[-1].read_text().rpartition("\n")[0].splitlines() if runs else [])]
            if len(newest) != len(set(newest)):
                hold(False, "a point stands twice in a run")
            # A run takes over what is known before it computes: unless it was killed before, all of it.
            new = set(newest) - seen
            if new and not seen <= set(newest):
                hold(False, f"points were computed before all {len(seen)} known ones were taken")
            computed += len(new)
            seen |= set(newest)
        last = run("killed")
        hold(last.returncode == 0 and sorted(map(same, lines("killed"))) == wanted, f"after {kills} kills the whole is the same")
        hold(0 < computed < COUNT, f"of {COUNT} points {computed} were finished when it was killed")
        hold(f"{COUNT - computed} computed" in last.stdout, "and were not computed again")

        # An engine's program that was changed is another.
        kit = pathlib.Path(__file__).resolve().parent.parent / "engine/kit"
        for file in ("stiction_engine.py", "examples/minimal_engine.py"):
            (folder / pathlib.Path(file).name).write_bytes((kit / file).read_bytes())
        (folder / "study.toml").write_text('problem = "box.toml"\nengines = ["python3 minimal_engine.py"]\n[[axis]]\nvary = "ramp.friction"\nvalues = [0.2, 0.6]\n')
        hold("2 computed" in run("own").stdout and "0 computed" in run("own").stdout, "a person's own engine")
        with (folder / "minimal_engine.py").open("a") as stream:
            stream.write("# changed\n")
        hold("2 computed" in run("own").stdout, "is another when its file has changed")

        (folder / "study.toml").write_text(study(20, 21, first=-0.05))
        broke = run("broke")
        hold(broke.returncode == 2 and "ramp.friction=-0.05" in broke.stderr, "points that break off are told, with exit code 2")
        hold("0 computed" in run("broke").stdout, "and stay as they are")
        retried = run("broke", "--retry")
        hold(" 42 computed" in retried.stdout, f"unless they are retried: {retried.stdout.splitlines()[0]}")
        lost = run("lost", "--share", "nowhere")
        hold(lost.returncode == 2 and not (folder / "lost").exists(), "a folder to share that is not there is refused before a run")
        hold(run("x", "--shard", "3/2").returncode == 2, "a shard that is none is refused")
        few = run("few", "--shard", "5000/9000")
        hold(few.returncode == 0 and " 0 computed" in few.stdout, "an empty shard is fine")
        dry = run("dry", "--dry-run")
        hold(dry.returncode == 0 and f"{COUNT} points" in dry.stdout and not (folder / "dry").exists(), "a dry run computes nothing")
        # What broke off for want of time: a retry with more of it stays, and so does a result beside a later failure.
        (folder / "study.toml").write_text(study(2, 2))
        hold(run("slow", "--max-seconds", "1e-9").returncode == 2, "points that need too long break off")
        hold(run("slow", "--retry").returncode == 0 and "0 computed" in run("slow").stdout and run("slow").returncode == 0,
             "one retry with more time is enough")
        hold(run("slow", "--fresh", "--max-seconds", "1e-9").returncode == 2 and run("slow").returncode == 0,
             "and a result is not lost to a later failure")
        point = json.loads(lines("slow")[0])
        one = run("nothing", "--point", point["point"])
        hold(one.returncode == 0 and point["checks"][0]["quantity"] in one.stdout and not (folder / "nothing").exists(), f"one point again: {one.stdout.split()[:4]}")
        none = run("nothing", "--point", "0" * 16)
        hold(none.returncode == 2 and "no point '0000000000000000'" in none.stderr, "a point that is none is refused")
        # A point that another version of the study computed is told as a point of this one.
        (folder / "study.toml").write_text(study(2, 1).replace("from = 5\nto = 45\ncount = 1", "values = [20]"))
        run("grown")
        (folder / "study.toml").write_text('title = "grown"\n' + study(2, 3).replace("from = 5\nto = 45\ncount = 3", "values = [10, 20, 30]"))
        grown = run("grown")
        seen = [json.loads(line) for line in lines("grown")]
        hold("4 points are known" in grown.stderr and {one["title"] for one in seen} == {"grown"} and
             sorted({one["job"] for one in seen}) == list(range(12)), "points of an earlier version of a study are taken, and told as of this one")
        with (folder / "grown/study/latest").resolve().joinpath("records.jsonl").open("a") as stream:
            stream.write("garbage\n" + json.dumps({"point": seen[0]["point"]}, separators=(",", ":")) + "\n")
        damaged = run("grown")
        hold(damaged.returncode == 0 and "0 computed" in damaged.stdout and ": left out" in damaged.stderr, "a damaged line is told, and left out")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())
