# SPDX-License-Identifier: GPL-3.0-or-later
"""For tests of sweeps and their parts: a box on a ramp over friction and slope, and what is the same of two records."""
import json
import os

faults = []  # what did not hold


def hold(true, words):
    print("ok   " if true else "FAIL ", words, flush=True)
    if not true:
        faults.append(words)


def problem(duration):
    return f"""duration = {duration}
gravity = [0, 0, -10]
[engine]
dt = 1e-3
[[obstacle]]
name = "ramp"
slope_deg = 20
friction = 0.5
[[body]]
name = "box"
shape = "box"
size = [0.2, 0.2, 0.1]
mass = 1
youngs_modulus = 1e5
rests_on = "ramp"
[[check]]
observable = "speed"
expected = 0
tolerance = 1e-3
reason = "it sticks"
"""


def study(frictions, slopes, engines=("stiction", "plain"), first=0.05):
    """Of a problem in box.toml; `first` is the least friction, up to 1."""
    return f"""problem = "box.toml"
engines = {json.dumps(engines)}
[[axis]]
vary = "ramp.friction"
from = {first}
to = 1
count = {frictions}
[[axis]]
vary = "ramp.slope_deg"
from = 5
to = 45
count = {slopes}
"""


def same(line):
    """A record without what is of the moment: times, and where it ran."""
    record = json.loads(line)
    for name in ("cost", "environment"):
        del record[name]
    return json.dumps(record, sort_keys=True)


def plain_environment():
    """Without variables that name a part."""
    return {name: value for name, value in os.environ.items() if not name.startswith(("GTEST_", "SLURM_"))}
