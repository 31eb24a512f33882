#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts of runs as a person calls them: merge_test.py BUILD_DIR

What the parts of validate and compare are merged into is what one piece gives, but for times; each job is in one part; what
is missing, cut off or of another run is refused.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from box_study import faults, hold, plain_environment, problem, study  # noqa: E402

CHOSEN = ["--case", "incline/restick/box", "--case", "oscillator/free*", "--case", "oscillator/stick-slip", "--case", "slab/rest/one", "--case", "half-space/*"]
COMPARED = ["--scene", "falling-box/r=0.35", "--contacts", "paper"]
COSTS = {"ns_per_contact_update", "ns_per_contact_update_quartiles", "ns_per_contact_step", "ns_per_contact_step_quartiles",
         "cpu_seconds", "phase_seconds", "told_cpu_seconds"}


def records_of(folder, drop_times=True):
    records = [json.loads(line) for line in (folder / "latest/records.jsonl").read_text().splitlines()]
    for record in records if drop_times else []:
        del record["environment"]["date"]
        record["cost"] = {name: value for name, value in record["cost"].items() if name not in COSTS}
    return records


def deal(whole, parts):
    """Gives the parts the records that the whole has of their jobs, so that times are the same too."""
    lines = {json.loads(line).get("job"): line for line in (whole / "latest/records.jsonl").read_text().splitlines()}
    for file in parts.glob("*/records.jsonl"):
        if not file.parent.is_symlink():
            jobs = [json.loads(line)["job"] for line in file.read_text().splitlines()]
            file.write_text("".join(lines[job] + "\n" for job in jobs))


def same_bytes(one, other, *names):
    for name in names:
        hold((one / "latest" / name).read_bytes() == (other / "latest" / name).read_bytes(), f"{name} has the bytes of one piece")


class Folder:
    def __init__(self, name, build):
        self.path = pathlib.Path(name)
        self.build = build
        self.plain = plain_environment()

    def run(self, program, *words, **environment):
        return subprocess.run([self.build / program, *words], cwd=self.path, env={**self.plain, **environment}, capture_output=True,
                              text=True, timeout=200)


def validate_in_parts(folder):
    def validate(*words, **environment):
        return folder.run("validate", *CHOSEN, "--no-page", *words, **environment)

    whole = validate("--out", "whole", "--jobs", "1")
    wanted = records_of(folder.path / "whole")
    seen = []
    for number in range(3):
        part = validate("--out", "parts", GTEST_SHARD_INDEX=str(number), GTEST_TOTAL_SHARDS="3")
        hold(part.returncode == whole.returncode, f"part {number + 1} of 3, by GoogleTest's variables: {part.stderr.strip()}")
        seen += [record["job"] for record in records_of(folder.path / "parts")]
    hold(sorted(seen) == list(range(len(wanted))) and len(wanted) > 10, f"each of {len(wanted)} jobs is in one part")
    merged = folder.run("merge", "parts", "--out", "merged", "--no-page", GTEST_SHARD_INDEX="1", GTEST_TOTAL_SHARDS="3")
    hold(merged.returncode == whole.returncode, f"they are merged, with the exit code of the whole {merged.stderr}")
    hold(records_of(folder.path / "merged") == wanted, "the records are those of one piece, in order, but for times")
    frames = [sorted((path.name, path.read_bytes()) for path in (folder.path / out / "latest/frames").iterdir()) for out in ("whole", "merged")]
    hold(len(frames[0]) > 3 and frames[0] == frames[1], f"{len(frames[0])} recordings are the same bytes")
    deal(folder.path / "whole", folder.path / "parts")
    folder.run("merge", "parts", "--out", "dealt", "--no-page")
    same_bytes(folder.path / "dealt", folder.path / "whole", "records.jsonl", "report.md", "junit.xml", "records.csv")
    again = folder.run("merge", "dealt", "--out", "again", "--no-page")
    hold(again.returncode == whole.returncode, "what was merged is a run like others")
    same_bytes(folder.path / "again", folder.path / "whole", "records.jsonl")


def what_is_missing(folder):
    parts = sorted(path.parent for path in (folder.path / "parts").glob("*/run.json") if not path.parent.is_symlink())

    def refused(words, *folders):
        result = folder.run("merge", *folders, "--out", "refused", "--no-page")
        hold(result.returncode == 2 and re.search(words, result.stderr) and len(result.stderr.splitlines()) == 1 and
             not (folder.path / "refused").exists(), f"refused: {result.stderr.strip()}")

    refused("of 3 parts 2 is missing", parts[0], parts[2])
    refused("no run of a part", folder.path.parent / folder.path.name / "whole/latest/frames")
    refused("there is no folder", "nowhere")
    cut = folder.path / "cut"
    shutil.copytree(parts[1], cut / parts[1].name)
    file = cut / parts[1].name / "records.jsonl"
    text = file.read_text()
    file.write_text(text[:len(text) - 40])
    refused("a part was interrupted", parts[0], cut, parts[2])
    folder.run("validate", "--case", "half-space/*", "--no-page", "--out", "other", "--shard", "1/2")
    refused("parts of different runs", "parts", "other")
    file.write_text("{}\n")
    refused("records.jsonl:1: ", parts[0], cut, parts[2])
    (cut / parts[1].name / "run.json").write_text('{"schema_version":1,"program":"sh"}')
    refused("words: the required field is missing", cut)
    file.write_text("")
    (cut / parts[1].name / "run.json").write_text('{"schema_version":1,"program":"/bin/sh","words":["-c","id"],"plan":"","jobs":1,"shard":{"number":1,"count":1}}')
    refused("there is no program", cut)
    hold(folder.run("validate", *CHOSEN, "--shard", "1/2", "--parts", "parts").returncode == 2, "a shard of what is put together is none")


def sweep_in_parts(folder):
    (folder.path / "box.toml").write_text(problem(0.05))
    file = folder.path / "study.toml"
    file.write_text(study(4, 5))
    whole = folder.run("sweep", "study.toml", "--jobs", "1", "--out", "swept", "--no-page")
    for number in (1, 2, 3):
        part = folder.run("sweep", "study.toml", "--shard", f"{number}/3", "--out", f"thirds/{number}", "--no-page")
        hold(part.returncode == 0 and f"part {number} of 3, 1" in part.stderr, f"a third of a study: {part.stderr.strip()}")
    for number in (1, 2, 3):
        deal(folder.path / "swept/study", folder.path / f"thirds/{number}/study")
    merged = folder.run("merge", "thirds", "--out", "swept-parts", "--no-page", GTEST_SHARD_INDEX="1", GTEST_TOTAL_SHARDS="3")
    hold(merged.returncode == whole.returncode == 0 and "40 points, from 3 parts" in merged.stdout, f"they are merged {merged.stderr}")
    same_bytes(folder.path / "swept-parts/study", folder.path / "swept/study", "records.jsonl", "points.csv")
    shutil.rmtree(folder.path / "thirds")
    hold(folder.run("merge", "swept-parts", "--out", "swept-again", "--no-page").returncode == 0, "what was merged is a run like others, when its parts have gone")
    file.write_text(study(4, 6))
    changed = folder.run("merge", "swept-parts", "--out", "swept-changed", "--no-page")
    hold(changed.returncode == 2 and "an earlier version" in changed.stderr, f"the parts of a study that was changed are refused: {changed.stderr.strip()[:90]}")


MESH = """OFF
4 4 0
0 0 0
0.1 0 0
0 0.1 0
0 0 HEIGHT
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
"""


def files_that_changed(folder):
    """The files that a problem names are of the run too; an engine that is a command is not started unasked."""
    (folder.path / "mesh.toml").write_text(problem(0.01).replace('shape = "box"', 'shape = "surface"\nfile = "tet.off"').replace("size = [0.2, 0.2, 0.1]\n", ""))
    for number, height in ((1, "0.1"), (2, "0.2")):
        (folder.path / "tet.off").write_text(MESH.replace("HEIGHT", height))
        folder.run("validate", "mesh.toml", "--shard", f"{number}/2", "--out", "meshes", "--no-page")
    merged = folder.run("merge", "meshes", "--out", "merged-meshes", "--no-page")
    hold(merged.returncode == 2 and "parts of different runs" in merged.stderr, "parts with another mesh are of another run")
    for number, more in ((1, ()), (2, ("--finer", "2"))):
        folder.run("validate", "--case", "half-space/*", "--shard", f"{number}/2", "--out", "steps", "--no-page", *more)
    merged = folder.run("merge", "steps", "--out", "merged-steps", "--no-page")
    hold(merged.returncode == 2 and "parts of different runs" in merged.stderr, "parts with other time steps are of another run")
    hostile = folder.path / "hostile/2026-01-01T00-00-00Z"
    hostile.mkdir(parents=True)
    (hostile / "records.jsonl").write_text((folder.path / "whole/latest/records.jsonl").read_text().splitlines(keepends=True)[0])
    for program, words in (("validate", ["--engine", "touch started"]), ("validate", ["--engine=touch started"]),
                           ("compare", ["engines", "--engine", "plain", "touch started"])):
        (hostile / "run.json").write_text(json.dumps({"schema_version": 1, "program": program, "words": words, "plan": "", "jobs": 1,
                                                      "shard": {"number": 1, "count": 1}}))
        merged = folder.run("merge", "hostile", "--out", "x", "--no-page")
        hold(merged.returncode == 2 and "--trust allows it" in merged.stderr and not (folder.path / "started").exists(), f"refused: {merged.stderr.strip()}")


def compare_in_parts(folder):
    def compare(*words):
        return folder.run("compare", *COMPARED, "--no-page", *words)

    whole = compare("--out", "compared", "--jobs", "1")
    for number in (1, 2):
        part = compare("--out", "halves", "--shard", f"{number}/2")
        hold(part.returncode == 0 and not part.stdout, f"half {number} of a comparison: {part.stderr.strip()[:60]}")
    merged = folder.run("merge", "halves", "--out", "together", "--no-page")
    hold(whole.returncode == 0 and merged.returncode == 0, f"a comparison's halves are merged {merged.stderr}")
    hold(records_of(folder.path / "together") == records_of(folder.path / "compared"), "its records are those of one piece, but for times")
    deal(folder.path / "compared", folder.path / "halves")
    folder.run("merge", "halves", "--out", "dealt-halves", "--no-page")
    same_bytes(folder.path / "dealt-halves", folder.path / "compared", "comparison.md", "report.md", "records.csv")


def lists_and_lines(folder):
    listed = json.loads(folder.run("validate", "--quick", "--list", "--json").stdout)
    hold([job["job"] for job in listed] == list(range(len(listed))) and len(listed) > 20, f"--list --json: {len(listed)} jobs")
    wanted = {"job", "name", "title", "set", "engine", "configuration", "settings", "estimated_seconds", "needs"}
    hold(all(set(job) == wanted and job["estimated_seconds"] > 0 for job in listed), "each with its fields")
    needs = {job["name"]: job["needs"] for job in listed}
    hold("body_contact" in needs["slab/rest/one"] and "points" in needs["half-space/bounce"], "and what an engine must have for it")
    halves = [json.loads(folder.run("validate", "--quick", "--list", "--json", "--shard", f"{k}/2").stdout) for k in (1, 2)]
    hold(sorted(halves[0] + halves[1], key=lambda job: job["job"]) == listed, "two halves are the whole")
    run = folder.run("validate", "--quick", "--lines", "--no-page", "--out", "lines")
    lines = [json.loads(line) for line in run.stdout.splitlines()]
    hold(run.returncode == 0 and {line["job"] for line in lines} == {job["job"] for job in listed}, "--lines: a line a result, and nothing else")
    hold(set(lines[0]) == {"job", "verdict", "case", "engine", "configuration", "cpu_seconds", "digits", "state_hash", "error"}, "with its fields")
    empty = folder.run("validate", "--case", "half-space/bounce", "--shard", "40/50", "--no-page", "--out", "empty")
    hold(empty.returncode == 0 and "part 40 of 50, 0 of" in empty.stderr, "an empty shard is fine")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(name, pathlib.Path(sys.argv[1]).resolve())
        validate_in_parts(folder)
        what_is_missing(folder)
        compare_in_parts(folder)
        sweep_in_parts(folder)
        files_that_changed(folder)
        lists_and_lines(folder)
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())
