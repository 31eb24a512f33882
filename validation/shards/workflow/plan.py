#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""In how many parts a command shall run: plan.py --out OUT -- BUILD/sweep study.toml

Writes OUT/PLAN/plan.json and a copy of it, OUT/plan.json. PLAN is a hash of all that results depend on. The number of
parts of a plan stays what it was first, as parts of another number would not find what those have finished.
"""
import argparse
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
UNKNOWN_SECONDS = 1.0  # of a point, where nothing tells
UNKNOWN_MEMORY_MIB = 700  # of validate and compare


def output(words):
    environment = {"STICTION_SCRIPT": str(ROOT / "stiction"), **os.environ}  # with which programs build the mesher
    done = subprocess.run(words, capture_output=True, text=True, env=environment)
    if done.returncode != 0:
        sys.exit(done.stderr.strip() or f"plan: '{' '.join(words)}' ended with exit code {done.returncode}")
    return done.stdout


def estimated(words, is_sweep):
    """How many jobs, and what they take."""
    asked = json.loads(output([*words, "--dry-run" if is_sweep else "--list", "--json"]))
    if is_sweep:
        points, seconds = asked["points"], asked["cpu_seconds"]
        seconds = points * UNKNOWN_SECONDS if seconds is None else seconds
        return {"jobs": points, "cpu_seconds": seconds, "longest_seconds": seconds / points, "memory_mib": asked["memory_mib"],
                "latest": f"{asked['study']}/latest"}
    cases = {}  # which stay in one part
    for job in asked:
        cases[job["name"]] = cases.get(job["name"], 0) + job["estimated_seconds"]
    return {"jobs": len(asked), "cpu_seconds": sum(cases.values()), "longest_seconds": max(cases.values()),
            "memory_mib": UNKNOWN_MEMORY_MIB, "latest": "latest"}


def identity(words, jobs, out):
    """What the program calls the whole run. It says so in the run of a part that is empty, as there are more parts than jobs."""
    probe = out / f"probe-{os.getpid()}"
    try:
        output([*words, "--shard", f"{jobs + 1}/{jobs + 1}", "--out", str(probe), "--no-page", "--lines"])
        return json.loads(next(probe.rglob("run.json")).read_text())["plan"]
    finally:
        shutil.rmtree(probe, ignore_errors=True)


def write(file, content):
    """Whole or not at all."""
    new = file.with_name(file.name + ".new")
    new.write_text(json.dumps(content) + "\n")
    new.replace(file)


def forget_broken(folder):
    """Parts with points that broke off are to run again; what was made of them goes first, as it is what Snakemake asks for."""
    broken = [file for file in (folder / "done").glob("*.json") if json.loads(file.read_text())["broke_off"] > 0]
    for file in ([folder / "page", folder / "merged.json"] if broken else []) + broken:
        file.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--minutes", type=float, default=15, help="that a job shall take")
    parser.add_argument("--most", type=int, default=1000, help="jobs")
    parser.add_argument("--cpus", type=int, default=1, help="of a job")
    parser.add_argument("--retry", default="False", choices=["True", "False"])
    parser.add_argument("words", nargs="+", help="of the command")
    asked = parser.parse_args()
    is_sweep = pathlib.Path(asked.words[0]).name == "sweep"
    plan = estimated(asked.words, is_sweep)
    name = identity(asked.words, plan["jobs"], asked.out)
    folder = asked.out / name
    known = folder / "plan.json"
    if known.exists():
        plan = json.loads(known.read_text())
    else:
        wanted = math.ceil(plan["cpu_seconds"] / 60 / asked.minutes / asked.cpus) if asked.minutes > 0 else asked.most
        parts = max(1, min(wanted, asked.most, plan["jobs"]))
        plan.update(plan=name, parts=parts, numbers=[f"{k:0{len(str(parts))}d}" for k in range(1, parts + 1)], share=[])
        if is_sweep:  # points that an earlier version of the study has too
            for other in sorted(asked.out.glob("*/plan.json")):
                merged = other.parent / "merged"
                plan["share"] += ["--share", str(merged if merged.exists() else other.parent)]
        folder.mkdir(parents=True)
        write(known, plan)
    if asked.retry == "True":
        forget_broken(folder)
    (asked.out / "log").mkdir(exist_ok=True)
    write(asked.out / "plan.json", plan)
    print(f"stiction: {plan['jobs']} {'points' if is_sweep else 'jobs'}, about {plan['cpu_seconds'] / 60:.3g} CPU minutes, in {plan['parts']} parts")


if __name__ == "__main__":
    main()
