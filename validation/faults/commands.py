# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands that full_disk.py and kill_campaign.py run, each in a folder of its own, and what their files must be."""
import dataclasses
import json
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import typing

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NODE = shutil.which("node")
REPORT = ROOT / "build" / "web" / "report.mjs"

PROBLEM = """
title = "a box falls"
duration = {duration}
gravity = [0, 0, -9.81]
[engine]
rule = "fixed-point"
dt = 2e-4
[[body]]
name = "box"
{shape}
mass = 1.0
youngs_modulus = 5e5
poisson_ratio = 0.3
position = [0, 0, 1]
[[check]]
observable = "speed"
expected = {speed}
tolerance = 1e-3
reason = "g t"
"""
BOX = 'shape = "box"\nsize = [0.2, 0.2, 0.1]'
SURFACE = 'shape = "surface"\nfile = "cube.off"\nscale = 1e-3\ncell_size = 0.2'
CUBE = """OFF
8 12 0
-100 -100 -100
100 -100 -100
-100 100 -100
100 100 -100
-100 -100 100
100 -100 100
-100 100 100
100 100 100
3 0 2 1
3 1 2 3
3 4 5 6
3 5 7 6
3 0 1 4
3 1 5 4
3 2 6 3
3 3 6 7
3 0 4 2
3 2 4 6
3 1 3 5
3 3 7 5
"""
# Left behind by nothing that ended in order: what stands under a name that is not its own.
TEMPORARY = re.compile(r"^\..*\.(tmp|latest)$|\.partial$|^new-|-journal$|^stiction-|^\.?org\.chromium")


def bench_json(value):
    return json.dumps({"benchmarks": [{"name": f"a{k}", "cpu_time": value + k, "time_unit": "ns"} for k in range(20)]})


@dataclasses.dataclass
class Command:
    name: str
    words: typing.Callable  # of the folder it runs in
    codes: tuple = (0,)  # when nothing goes wrong
    prepare: typing.Callable = lambda folder: None  # what must be there before
    optional: str = None  # a regular expression: files that may be missing where that is said
    tools: str = None  # what is said where git or CMake, which it calls, cannot write a file; they may try again
    few: bool = False  # among those of a short look
    script: bool = False  # what it starts are programs of its own


class Commands:
    """Made once: `store` gets what commands read."""

    def __init__(self, build, store, duration):
        """`duration` of the problems, s: each has a recording, of some thousand frames a second."""
        self.build, self.store = build, store
        self.environment = {**os.environ, "UV_USE_IO_URING": "0", "COLUMNS": "200", "TERM": "dumb",
                            "STICTION_MESHER": str(build / "mesh_surface")}
        for name in ("STICTION_RUN_FILE", "LD_PRELOAD"):
            self.environment.pop(name, None)
        (store / "box.toml").write_text(PROBLEM.format(shape=BOX, duration=duration, speed=9.81 * duration))
        (store / "surface.toml").write_text(PROBLEM.format(shape=SURFACE, duration=duration, speed=9.81 * duration))
        (store / "cube.off").write_text(CUBE)
        (store / "study.toml").write_text('problem = "box.toml"\n[[axis]]\nvary = "box.mass"\nvalues = [1, 2, 3]\n')
        (store / "import.json").write_text(bench_json(1))
        self.make("runs", "validate", "box.toml", "--out", "runs", "--set", "dt=1e-4")
        self.make("drawn", "validate", "box.toml", "--check-only", "--out", "drawn")
        self.make("history", "track", "import", "import.json", "--history", "history.sqlite")
        tree = store / "tree"
        for file in ROOT.rglob("*.md"):
            path = file.relative_to(ROOT)
            if "build" not in path.parts and not path.parts[0].startswith(".") and "<!-- " in file.read_text():
                (tree / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, tree / path)
        shutil.copytree(ROOT / "reports" / "documents", tree / "reports" / "documents", dirs_exist_ok=True)
        # A document that must be written anew.
        readme = tree / "README.md"
        text, count = re.subn(r"(<!-- v:pyramid-slip@quiet -->)[^<]*", r"\g<1>0", readme.read_text())
        assert count > 0, "README.md has lost its figure"
        readme.write_text(text)
        self.make_project()

    def make_project(self):
        """One of stand-ins, whose programs take no time: benchmarks/track/testdata."""
        project, data = self.store / "project", ROOT / "benchmarks" / "track" / "testdata"
        shutil.copytree(data, project)
        (self.store / "bin").mkdir()
        shutil.move(project / "valgrind", self.store / "bin" / "valgrind")
        (project / "bench.numbers").write_text("# 50 1000 1e-9 -O3\n")
        (project / "validate.numbers").write_text("# 6 pass -O3\n")
        (project / ".gitignore").write_text("build/\n")
        self.environment |= {"PATH": f"{self.store}/bin:{os.environ['PATH']}", "GIT_CONFIG_GLOBAL": "/dev/null",
                             "GIT_CONFIG_NOSYSTEM": "1"}
        git = ["git", "-c", "user.name=t", "-c", "user.email=t@example.org"]
        for words in ([*git, "init", "-q"], [*git, "add", "-A"], [*git, "commit", "-qm", "one"],
                      ["cmake", "-G", "Ninja", "-B", "build/release"],
                      ["cmake", "--build", "build/release", "--target", "bench", "validate"]):
            subprocess.run(words, cwd=project, env=self.environment, check=True, capture_output=True)

    def make(self, name, program, *words):
        ended = subprocess.run([self.build / program, *words], cwd=self.store, env=self.environment, check=False,
                               capture_output=True, text=True)
        assert ended.returncode in (0, 1), f"{name} could not be made: {ended.stderr}"

    def copy(self, *names):
        def prepare(folder):
            for name in names:
                (shutil.copytree if (self.store / name).is_dir() else shutil.copy)(self.store / name, folder / name)
        return prepare

    def all(self):
        one = lambda program, *words: lambda folder: [str(self.build / program), *words]
        page = lambda *words: lambda folder: [NODE, str(REPORT), *words]
        project = lambda *words: lambda folder: [str(self.build / "track"), "--root", str(self.store / "project"), "--work",
                                                 str(folder / "work"), *words]
        cases = ("--case", "slope/stops/*", "--case", "half-space/free-fall", "--jobs", "1")
        commands = [
            Command("validate", one("validate", *cases, "--verbose"), few=True),
            Command("validate, a problem, recordings", one("validate", "box.toml", "--vtk"),
                    prepare=self.copy("box.toml"), few=True),
            Command("validate, a surface", one("validate", "surface.toml"),
                    prepare=self.copy("surface.toml", "cube.off"), optional=r"\.mesh$|new-|/cache\b", few=True),
            Command("validate, an engine", one("validate", *cases, "--engine", str(self.build / "hosted_engine"))),
            Command("validate --check-only", one("validate", "box.toml", "--check-only"),
                    prepare=self.copy("box.toml"), few=True),
            Command("compare", one("compare", "--scene", "rules/slab", "--rule", "fixed-point", "--jobs", "1")),
            Command("compare engines", one("compare", "engines", "--engine", "plain", "--engine", "stiction", "--question",
                                           "creep-0", "--quick")),
            Command("sweep", one("sweep", "study.toml", "--jobs", "1"), prepare=self.copy("study.toml", "box.toml"), few=True),
            Command("bench", one("bench", "--benchmark_filter=^(depth|friction:none)/(slab|plane)/contacts:100$", "--benchmark_out=google.json")),
            Command("track import", one("track", "import", "import.json", "--history", "history.sqlite"),
                    prepare=self.copy("import.json", "history.sqlite"), few=True),
            Command("track import, no history yet", one("track", "import", "import.json", "--history", "new.sqlite"), prepare=self.copy("import.json")),
            Command("track export", one("track", "export", "import.json", "--history", "history.sqlite"),
                    prepare=self.copy("import.json", "history.sqlite"), few=True),
            Command("track history --out", one("track", "history", "--out", "trends", "--history", "history.sqlite"), prepare=self.copy("history.sqlite")),
            Command("track record", project("record", "--no-times")),
            Command("track --against", project("--against", "HEAD", "--no-times"),
                    tools=r"git cannot|cannot be (configured|built|run|counted|measured)"),
            Command("readme", one("readme", "--root", "tree"), prepare=self.copy("tree"), few=True),
        ]
        if NODE and REPORT.is_file():
            commands += [
                Command("report", page("runs", "--svg", "plots"), prepare=self.copy("runs")),
                Command("report --against", page("runs", "--against", "runs", "--out", "new.html"), codes=(0, 1),
                        prepare=self.copy("runs")),
                Command("report --manual", page("runs", "--manual", "manual.html"), prepare=self.copy("runs")),
                Command("report of a drawing", page("drawn/check-only"), prepare=self.copy("drawn")),
            ]
        return commands

    def scripts(self):
        """./stiction itself, of this tree and its build."""
        script = lambda *words: lambda folder: [str(ROOT / "stiction"), *words]
        return [
            Command("./stiction validate", script("validate", "--case", "half-space/free-fall", "--out", "runs"), script=True,
                    optional=r"/tmp/stiction-|report\.html|\.partial"),
            Command("./stiction report", script("report", "runs"), prepare=self.copy("runs"), script=True),
            Command("./stiction readme", script("readme", "--check"), script=True, codes=(0, 1)),
        ]


def temporary_files(folder):
    return [str(path.relative_to(folder)) for path in folder.rglob("*")
            if TEMPORARY.search(path.name) and "tree" not in path.relative_to(folder).parts]


def whole_lines(file):
    """How many records, and what is cut off behind them."""
    text = file.read_text(errors="replace")
    *lines, rest = text.split("\n")
    for line in lines:
        json.loads(line)
    return len(lines), rest


def runs_of_history(file):
    """How many runs, each whole; None where there is no table yet. Raises when it is damaged."""
    with sqlite3.connect(file) as base:
        state = base.execute("PRAGMA integrity_check").fetchone()[0]
        assert state == "ok", f"{file.name}: {state}"
        if base.execute("SELECT count(*) FROM sqlite_master WHERE name = 'run'").fetchone()[0] == 0:
            return None
        counts = base.execute("SELECT run.id, count(sample.value) FROM run LEFT JOIN sample ON sample.run = run.id GROUP BY run.id")
        sizes = [size for _, size in counts]
        assert all(size > 0 for size in sizes), f"{file.name}: a run without samples"
        return len(sizes)
