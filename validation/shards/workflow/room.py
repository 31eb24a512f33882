# SPDX-License-Identifier: GPL-3.0-or-later
"""For slurm_test.py: a folder with studies and the programs, and how results are compared."""
import csv
import json
import pathlib
import re
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent

sys.path.insert(0, str(HERE.parent))
from box_study import problem, same, study  # noqa: E402

COUNT = 2 * 20 * 20
BROKEN = 2 * 20  # of a study whose first friction is negative
PARTS = 4
PART_SECONDS = 2  # CPU time of a part that is killed in its middle


def same_row(row):
    return {name: value for name, value in row.items() if name != "cpu_seconds"}


class Room:
    """A folder with a study in it, and the programs."""

    def __init__(self, folder, build, slurm):
        self.folder, self.build, self.slurm = folder, build, slurm
        # Snakemake asks every second instead of every ten where CI is set.
        self.environment = {**slurm.environment, "CI": "true", "XDG_CACHE_HOME": str(folder / "cache")}
        for name in [name for name in self.environment if name.startswith("GTEST_")]:
            del self.environment[name]

    def study(self, name, duration, first=0.05):
        where = self.folder / name
        where.mkdir()
        (where / "box.toml").write_text(problem(duration))
        (where / "study.toml").write_text(study(20, 20, first=first))
        return where

    def duration_of(self, seconds):
        """How long a study must be simulated for a part to take so much CPU time on this machine, by the estimate."""
        where = self.study("estimated", 1)
        told = self.run(where, self.build / "sweep", "study.toml", "--dry-run", "--json")
        return round(max(0.1, seconds * PARTS / json.loads(told.stdout)["cpu_seconds"]), 2)

    def run(self, where, *words):
        return subprocess.run([str(word) for word in words], cwd=where, env=self.environment, capture_output=True, text=True, timeout=150)

    def snakemake_words(self, profile, *more):
        return ["snakemake", "-s", HERE / "Snakefile", "--profile", HERE / profile, "--config", "study=study.toml", "out=out",
                f"build={self.build}", f"most_jobs={PARTS}", "minutes_per_job=0.00001", "least_minutes=7", "page=false", *more]

    def snakemake(self, where, profile, *more):
        return self.run(where, *self.snakemake_words(profile, *more))

    def whole(self, where):
        """Of one piece: records and rows of points.csv, as they are compared."""
        self.run(where, self.build / "sweep", "study.toml", "--no-page", "--out", "whole")
        return compared(where / "whole/study/latest")

    def jobs(self):
        """Name, state, time limit, memory and processors of what Slurm knows."""
        text = self.slurm.told("scontrol", "show", "job", "--oneliner")
        return [dict(re.findall(r"(\w+)=(\S+)", line)) for line in text.splitlines() if "JobId=" in line]


def compared(run):
    with (run / "points.csv").open(newline="") as rows:
        table = [same_row(row) for row in csv.DictReader(rows)]
    return sorted(map(same, (run / "records.jsonl").read_text().splitlines())), table


def merged(where):
    return compared(next(where.glob("out/*/merged/study/latest")))


def whole_lines(file):
    return [line for line in file.read_text().splitlines(keepends=True) if line.endswith("\n")]


def computations(where):
    """How many there were in all parts: what a run takes over keeps its times, so that it is the same bytes."""
    lines = set()
    for file in where.glob("out/*/parts/*/study/*/records.jsonl"):
        if not file.parent.is_symlink():
            lines.update(whole_lines(file))
    return len(lines)


def wait_for(words, true, seconds=60):
    until = time.monotonic() + seconds
    while not (found := true()):
        if time.monotonic() > until:
            raise RuntimeError(f"waited {seconds} s in vain: {words}")
        time.sleep(0.05)
    return found
