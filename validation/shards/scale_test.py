#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a sweep costs beside its simulations, and on paper how a million points would go: scale_test.py BUILD_DIR [--write]

Measures 10 000 short points on this machine: time and memory a point, size of records, merging. From these it tells what a
million points take on a cluster, and holds the tables of README.md beside it to that (within a factor of 10, as machines
and their load differ). --write renews them.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from box_study import faults, hold, plain_environment, problem, study  # noqa: E402

README = pathlib.Path(__file__).with_name("README.md")
POINTS, PARTS = 10_000, 4
MOST_OVERHEAD = 2e-3  # s a point, beyond its simulation
MOST_MEMORY = 2048  # bytes a point: what makes a million of them fit a node
# The cluster on paper.
MILLION, NODES, CPUS, POINT_SECONDS, JOB_SECONDS = 1_000_000, 100, 32, 0.1, 900


class Folder:
    def __init__(self, name, build):
        self.path, self.build = pathlib.Path(name), build
        (self.path / "box.toml").write_text(problem(0.01))
        self.plain = plain_environment()

    def study(self, name, across, up):
        (self.path / f"{name}.toml").write_text(study(across, up, engines=["plain"]))

    def run(self, *words):
        """CPU time, s, and peak memory, bytes, of a program that must end well. (A clock on the wall would tell of what else runs.)"""
        started = subprocess.Popen([self.build / words[0], *words[1:], "--no-page"], cwd=self.path, env=self.plain, stdout=subprocess.DEVNULL)
        _, status, used = os.wait4(started.pid, 0)
        started.returncode = os.waitstatus_to_exitcode(status)
        if started.returncode != 0:
            raise RuntimeError(f"{words} ended with exit code {started.returncode}")
        return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024

    def records(self, run):
        return (self.path / run / "latest/records.jsonl").read_text().splitlines()


def measured(folder):
    folder.study("few", 10, 10)
    folder.study("many", 100, POINTS // 100)
    folder.study("million", 1000, MILLION // 1000)
    _, least = folder.run("sweep", "few.toml", "--jobs", "1", "--out", "few")
    took, memory = folder.run("sweep", "many.toml", "--jobs", "1", "--out", "whole")
    lines = folder.records("whole/many")
    simulated = sum(json.loads(line)["cost"]["cpu_seconds"] for line in lines)
    hold(len(lines) == POINTS, f"{POINTS} points in {took:.2g} s of CPU time")
    overhead = (took - simulated) / POINTS
    hold(overhead <= MOST_OVERHEAD, f"{overhead * 1e3:.2g} ms a point beyond its simulation (at most {MOST_OVERHEAD * 1e3:g})")
    a_point = max(0.0, (memory - least) / POINTS)
    hold(a_point <= MOST_MEMORY, f"{a_point:.0f} bytes of memory a point (at most {MOST_MEMORY}), {memory / 2**20:.0f} MiB in all")
    for number in range(1, PARTS + 1):
        folder.run("sweep", "many.toml", "--jobs", "1", "--out", f"parts/{number}", "--shard", f"{number}/{PARTS}")
    merge, _ = folder.run("merge", "parts", "--out", "merged")
    hold(len(folder.records("merged/many")) == POINTS, f"merged from {PARTS} parts in {merge:.2g} s of CPU time")
    part, part_memory = folder.run("sweep", "million.toml", "--out", "empty", "--shard", f"{MILLION + 1}/{MILLION + 1}")
    hold(part_memory < 2**30, f"a part of {MILLION} points begins with {part_memory / 2**20:.0f} MiB, {part:.2g} s of CPU time")
    return {"overhead": overhead, "memory": memory, "record": sum(map(len, lines)) / POINTS, "merge": merge / POINTS, "part": part,
            "part_memory": part_memory}


def table(found):
    jobs = round(MILLION * POINT_SECONDS / JOB_SECONDS)
    hours = MILLION * POINT_SECONDS / 3600
    slots = min(jobs, NODES * CPUS)
    rows = [("measured here: CPU time of a point beyond its simulation", f"{found['overhead'] * 1e3:.2g} ms"),
            ("… record of a point", f"{found['record'] / 1e3:.2g} kB"),
            ("… CPU time of merging, a point", f"{found['merge'] * 1e3:.2g} ms"),
            (f"… CPU time of the start of a part of {MILLION:.0e} points", f"{found['part']:.2g} s"),
            ("… its memory", f"{found['part_memory'] / 2**20:.0f} MiB"),
            ("on paper: simulation", f"{hours:.0f} CPU hours"),
            ("… jobs", f"{jobs}"),
            ("… points a job", f"{MILLION // jobs}"),
            ("… starts of parts, of all CPU time", f"{100 * jobs * found['part'] / (MILLION * POINT_SECONDS):.1g} %"),
            ("… wall time until the last part has ended", f"{JOB_SECONDS / 60 * max(1, jobs / slots):.0f} min"),
            ("… files: records, table, plan and link of each part, two logs, a mark that it is done", f"{jobs * 7}"),
            ("… records", f"{MILLION * found['record'] / 1e9:.2g} GB"),
            ("… merging", f"{MILLION * found['merge'] / 60:.2g} min")]
    return "| what | |\n| --- | --- |\n" + "".join(f"| {name} | {value} |\n" for name, value in rows)


BLOCK = re.compile(r"(<!-- scale -->\n)(.*?)(<!-- /scale -->)", re.S)


def values_of(text):
    return {row[0]: float(row[1]) for row in re.findall(r"^\| (.+?) \| ([0-9.e+]+)", text, re.M)}


def main():
    with tempfile.TemporaryDirectory() as name:
        text = table(measured(Folder(name, pathlib.Path(sys.argv[1]).resolve())))
    if "--write" in sys.argv:
        README.write_text(BLOCK.sub(lambda found: found[1] + text + found[3], README.read_text()))
        return len(faults) > 0
    told, fresh = values_of(BLOCK.search(README.read_text())[2]), values_of(text)
    hold(told.keys() == fresh.keys(), "the README tells the same quantities")
    for name in told.keys() & fresh.keys():
        hold(told[name] / 10 <= fresh[name] <= 10 * told[name], f"{name}: {fresh[name]:g}, told {told[name]:g}")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())
