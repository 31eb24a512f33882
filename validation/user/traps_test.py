#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Problems whose claim is false must not pass: traps_test.py BUILD_DIR. And the problems they are made of must."""
import json
import pathlib
import subprocess
import sys
import tempfile

BOX = """duration = 1
gravity = [0, 0, -10]
[engine]
dt = 1e-3
[[obstacle]]
name = "floor"
point = [0, 0, -5]
friction = 0.9
[[obstacle]]
name = "ramp"
slope_deg = 20
azimuth_deg = 90
friction = 0.5
[[body]]
name = "box"
shape = "point"
mass = 2
rests_on = "ramp"
[[check]]
observable = "mean-velocity"
direction = "downhill"
from = 0.5
expected = 0
tolerance = 1e-9
reason = "20° is below 26.6°"
"""
FALL = """duration = 0.5
gravity = [0, 0, -10]
[engine]
dt = 1e-3
[[body]]
name = "stone"
shape = "point"
mass = 3
position = [0, 0, 5]
velocity = [2, 0, 0]
[[check]]
observable = "displacement"
direction = [0, 0, 1]
expected = -1.25
tolerance = 2e-2
reason = "½ g t², and the steps' first order"
"""
STACK = """duration = 1
gravity = { time = [0, 0.2], acceleration = [[0, 0, 0], [0, 0, -10]] }
friction = 0.5
drag = { rate = 50, full_until = 0.3, ends = 0.4 }
[[obstacle]]
name = "floor"
friction = 0.5
[[body]]
name = "low"
shape = "box"
size = [0.1, 0.1, 0.1]
mass = 1
damping_time = 1e-3
rests_on = "floor"
[[body]]
name = "top"
shape = "box"
size = [0.1, 0.1, 0.1]
mass = 1
damping_time = 1e-3
rests_on = "low"
[[check]]
observable = "normal-force"
body = "low"
expected = 30
tolerance = "10 mN"
reason = "10 N of the upper box, 20 N of the floor; what still moves"
[[check]]
observable = "slip"
body = "top"
extreme = "largest"
from = 0.5
expected = 0
tolerance = "1 mm/s"
reason = "nothing pushes it; what still moves"
[[check]]
observable = "position"
body = "top"
direction = [0, 0, 1]
relative_to = "low"
expected = 0.1
tolerance = "1 mm"
reason = "both sink in, and are pressed, by less"
"""
EXAMPLES = pathlib.Path(__file__).resolve().parent / "examples"
BASES = {"box": BOX, "fall": FALL, "stack": STACK, **{file.stem: file.read_text() for file in sorted(EXAMPLES.glob("*.toml"))}}

WINDOW = 'observable = "mean-velocity"\ndirection = "downhill"\nfrom = 0.5'
DROP = 'observable = "displacement"\ndirection = [0, 0, 1]'


def claims(base, old, *news):
    """Each of `news` in place of `old`: a false claim a value."""
    return [(base, {old: new}) for new in news]


# What is simulated makes the claim false, or the claim is of another value.
FALSE = [
    *claims("box", "slope_deg = 20", "slope_deg = 27", "slope_deg = 35", 'slope_deg = "45 deg"', 'slope_deg = "0.6 rad"',
            "normal = [0, 1, 1]", "slope_deg = 60"),
    *claims("box", "friction = 0.5", "friction = 0", "friction = 0.3", 'friction = "30 %"'),
    *claims("box", 'rests_on = "ramp"', 'rests_on = "ramp"\nspeed_downhill = 3', 'rests_on = "ramp"\noffset = [0, 0, 2]'),
    *claims("box", "gravity = [0, 0, -10]", "gravity = [0, 9, -10]", "gravity = [0, 0, 10]",
            "gravity = { constant = [0, 0, -10], amplitude = [0, 8, 0], frequency = 0.5 }",
            "gravity = { time = [0, 0.6], acceleration = [[0, 0, -10], [0, 8, -10]] }"),
    *claims("box", "expected = 0", "expected = 1e-6", 'expected = "-3 mm/s"', "expected = 1"),
    *claims("box", WINDOW, 'observable = "normal-force"',
            'observable = "friction-force"\ndirection = "downhill"', 'observable = "contacts"'),
    *claims("box", "[[check]]", '[[load]]\nbody = "box"\nforce = [0, 0, 30]\n[[check]]',
            '[[load]]\nbody = "box"\nforce = { time = [0, 0.8], value = [[0, 0, 0], [0, "20 N", 0]] }\n[[check]]',
            '[[spring]]\nbody = "box"\nanchor = [0, 9, 0]\naxis = [0, 1, 0]\nstiffness = "1 N/mm"\n[[check]]'),
    *claims("box", "[[check]]", '[[pair]]\nbody = "box"\nagainst = "ramp"\nfriction = 0.3\n[[check]]'),
    ("box", {'name = "ramp"\n': 'name = "ramp"\nmotion = { velocity = [0, 0.1, 0] }\n'}),
    ("box", {'name = "ramp"\n': 'name = "ramp"\nmotion = { amplitude = [0, "2 cm", 0], frequency = 7 }\n'}),
    ("box", {'name = "ramp"\n': 'name = "ramp"\nmotion = { time = [0.2, 0.9], offset = [[0, 0, 0], [0, 0.1, 0]] }\n'}),
    ("box", {'"downhill"\n': '{ downhill = "ramp" }\n', "slope_deg = 20": "slope_deg = 30"}),
    ("box", {"reason": 'scale = 1\nrelative = true\nreason', "slope_deg = 20": "slope_deg = 28"}),
    ("box", {"duration = 1\n": 'duration = 1\nsweep = { vary = "ramp.slope_deg", values = [10, 20, 27] }\n'}),
    ("box", {"duration = 1\n": 'duration = 1\nsweep = { vary = "box.mass", values = [1, 2] }\n', "slope_deg = 20": "slope_deg = 27"}),
    ("box", {"duration = 1\n": 'duration = 1\nthreshold = { vary = "ramp.slope_deg", holds_at = 20, fails_at = 30, within = 0.1, '
             'expected = 25, tolerance = 0.2, reason = "it is 26.6" }\n'}),
    ("box", {"duration = 1\n": 'duration = 1\nthreshold = { vary = "ramp.friction", holds_at = 0.5, fails_at = 0.3, within = 0.01, '
             'expected = 0.4, tolerance = 0.02, reason = "it is 0.364" }\n'}),
    *claims("fall", "expected = -1.25", "expected = 1.25", "expected = 0", 'expected = "-1.25 mm"'),
    *claims("fall", DROP, 'observable = "displacement"\ndirection = [0, 0, -1]', 'observable = "drift"',
            'observable = "velocity"\ndirection = [1, 0, 0]', 'observable = "acceleration"\ndirection = [0, 0, 1]',
            'observable = "displacement"\ndirection = [0, 0, 1]\nfrom = 0.1', 'observable = "speed"',
            'observable = "kinetic-energy"'),
    *claims("fall", "gravity = [0, 0, -10]", 'gravity = ["-10 m/s²", 0, 0]', "gravity = [0, 0, -9]",
            "gravity = [0, 0, -10]\ndrag = { rate = 5, full_until = 0.3, ends = 0.4 }"),
    *claims("stack", "expected = 30", "expected = 20", "expected = 10", 'expected = 30\nagainst = "floor"',
            'expected = 30\nagainst = "top"'),
    *claims("stack", 'relative_to = "low"', 'relative_to = "floor"', ""),
    # Back at rest at the end: at one time it would pass.
    ("stack", {"[[check]]": '[[load]]\nbody = "top"\nforce = { time = [0.5, 0.55, 0.6], value = [[0, 0, 0], [9, 0, 0], [0, 0, 0]] }\n[[check]]'}),
    ("stack", {"[[check]]": '[[load]]\nbody = "top"\ncouple = { time = [0.5, 0.6], value = [[0, 0, 0], [0, 0, 2]] }\n[[check]]'}),
    ("stack", {'"normal-force"\nbody = "low"\nexpected = 30\ntolerance = "10 mN"':
               '"rotation"\nbody = "low"\ndirection = [0, 0, 1]\nexpected = 3\ntolerance = "1 deg"'}),
    # What touches nothing has no slip, not one of 0.
    *claims("stack", 'extreme = "largest"\nfrom = 0.5', 'extreme = "largest"\nfrom = 0.5\nagainst = "floor"', 'against = "floor"'),
    # Before the first step there are no contacts: the least force is not 0.
    ("box", {WINDOW: 'observable = "normal-force"\nextreme = "smallest"'}),
    *claims("ramp", "slope_deg = 20", "slope_deg = 27", "slope_deg = 19"),
    *claims("ramp", "expected = 9.2183846", "expected = 9.2184", "expected = -9.2183846"),
    *claims("gripper", "friction = 0.5\n\n[[obstacle]]", "friction = 0.02\n\n[[obstacle]]"),
    *claims("gripper", 'expected = "5 cm"', 'expected = "6 cm"'),
    *claims("drawer", '"-0.45 N m"', '"-0.05 N m"', '"-0.3 N m"'),
    *claims("drawer", "friction = 0.6", "friction = 0.1"),
    *claims("shaken-stack", '"0.795 mm"', '"1.3 mm"', '"8 mm"'),
    *claims("shaken-stack", "friction = 0.4\n\n[[obstacle]]", "friction = 0.05\n\n[[obstacle]]"),
]

# What cannot be simulated, or observed: an error of the record.
BROKEN = [
    ("box", {"duration = 1\n": 'duration = 1\nthreshold = { vary = "ramp.slope_deg", holds_at = 10, fails_at = 20, within = 0.1, '
             'expected = 15, tolerance = 9, reason = "it holds at both" }\n'}),
    *claims("box", "duration = 1\n", "duration = 1e300\n"),
    *claims("box", "from = 0.5\n", "from = 0.9999\n", "at = 0.0001\n"),
    ("box", {"duration = 1\n": "duration = 1e-4\n", "from = 0.5\n": ""}),
]

BRICK = 'shape = "box"\nsize = [0.2, 0.2, 0.1]\nmass = 1\n'
# What would be another problem than the one that was meant: refused with the line, before anything runs.
REFUSED = [
    ("box", {'rests_on = "ramp"': "position = [0, 0, 1]"}),  # whose downhill?
    *claims("box", 'name = "ramp"', 'name = "floor"'),
    *claims("box", "[[check]]", f'[[body]]\nname = "a"\n{BRICK}rests_on = "floor"\n[[check]]'),  # which body?
    *claims("box", "[[check]]", *(
        f'[[body]]\nname = "a"\n{BRICK}rests_on = "floor"\n[[body]]\nname = "b"\n{BRICK}{there}\n[[check]]\nbody = "a"'
        for there in ('rests_on = "floor"', 'rests_on = "floor"\noffset = [0.1, 0, 0]', 'rests_on = "a"\noffset = [0, 0, "-1 mm"]',
                      'rests_on = "floor"\nyaw_deg = 45', "position = [0, 0, -5.2]", 'rests_on = "b"'))),
    *claims("box", "mass = 2", 'mass = "2 m"', 'mass = "2"', "mass = nan", "mass = -2", "mass = 0", "mass = 2\nradius = 1", "mass = 2\nvelocity = [1, 0, 0]"),
    *claims("box", "tolerance = 1e-9", 'tolerance = "1 kg"', "tolerance = inf", "tolerance = -1"),
    *claims("box", "from = 0.5", "from = 1.5", "from = -1", "window = 3"),
    *claims("box", "duration = 1\n", "duration = 0\n", "duration = inf\n",
            'duration = 1\nthreshold = { vary = "ramp.slope_deg", holds_at = 20, fails_at = 30, within = 2, expected = 26, tolerance = 0.1, '
            'reason = "narrower than it is found" }\n'),
    *claims("fall", "direction = [0, 0, 1]", "direction = [0, 0, 0]", 'direction = "downhill"'),
    *claims("box", "slope_deg = 20\nazimuth_deg = 90\n", ""),  # level: what is downhill?
    ("box", {WINDOW: 'observable = "rotation"\ndirection = [0, 0, 1]'}),  # of a point
    *claims("box", "[[check]]", '[[load]]\nbody = "box"\ncouple = [0, 0, 1]\n[[check]]'),
    *claims("box", "mass = 2", "mass = 2\nspin = [0, 0, 1]"),
    *claims("stack", 'extreme = "largest"', 'extreme = "largest"\nagainst = "top"'),
    ("box", {"duration = 1\n": 'duration = 1\nsweep = { vary = "box.force.time", values = [1, 2] }\n',
             "[[check]]": '[[load]]\nbody = "box"\nforce = { time = [0.1, 0.2, 0.3], value = [[0, 0, 0], [1, 0, 0], [2, 0, 0]] }\n[[check]]'}),
    ("box", {"duration = 1\n": 'duration = 1\nthreshold = { vary = "ramp.friction", holds_at = 0.5, fails_at = -0.1, within = 0.01, '
             'expected = 0.364, tolerance = 0.01, reason = "tan 20°" }\n'}),
    *claims("stack", 'relative_to = "low"', 'relative_to = "top"', 'relative_to = "hill"', 'against = "low"', 'extreme = "most"'),
    *claims("stack", 'name = "top"\n', 'name = "top"\nheld = { point = [0, 0, -0.06], normal = [0, 0, 1] }\n',
            'name = "top"\nmotion = { velocity = [1, 0, 0] }\n'),
]


def text_of(base, edits):
    text = BASES[base]
    for old, new in edits.items():
        if old not in text:
            sys.exit(f"{base} has no {old!r}")
        text = text.replace(old, new, 1)
    return text


def main():
    validate = pathlib.Path(sys.argv[1]).resolve() / "validate"
    faults = 0

    def hold(true, words):
        nonlocal faults
        if not true:
            faults += 1
            print("FAIL   ", words)

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(files):
            return subprocess.run([validate, "--no-page", "--max-seconds", "60", "--out", folder / "out", *files], cwd=folder,
                                  capture_output=True, text=True, timeout=300)

        def verdicts():
            lines = (folder / "out/latest/records.jsonl").read_text().splitlines()
            return {one["case"]: one["verdict"] for one in map(json.loads, lines)}

        sound = []
        for base, text in BASES.items():
            sound.append(folder / f"{base}.toml")
            sound[-1].write_text(text)
        answer = run(sound)
        hold(answer.returncode == 0, f"the sound problems: exit code {answer.returncode}\n{answer.stdout}{answer.stderr}")
        hold(set(verdicts().values()) == {"pass"}, f"the sound problems: {verdicts()}")
        traps = {}
        for number, (base, edits) in enumerate([*FALSE, *BROKEN]):
            file = folder / f"false-{number}.toml"
            file.write_text(text_of(base, edits))
            traps[file] = (f"{base} with {edits}", "fail" if number < len(FALSE) else "error")
        answer = run(traps)
        hold(answer.returncode == 2, f"all false ones, errors among them: exit code {answer.returncode}\n{answer.stderr}")
        hold((folder / "out/latest").exists(), "the false ones have records")
        found = verdicts()
        for file, (words, expected) in traps.items():
            verdict = found.get(f"user/{file.stem}", "no record")
            hold(verdict == expected, f"{words}: {verdict}, not {expected}")
        for number, (base, edits) in enumerate(REFUSED):
            file = folder / f"refused-{number}.toml"
            file.write_text(text_of(base, edits))
            answer = run([file])
            told = answer.stderr.splitlines()
            hold(answer.returncode == 2 and len(told) == 1 and f"{file.name}:" in told[0],
                 f"{base} with {edits}: exit code {answer.returncode}, {answer.stderr or answer.stdout}")
    print(f"{len(FALSE)} false claims, {len(BROKEN)} that cannot be observed, {len(REFUSED)} refused problems, {len(BASES)} sound ones: {faults} faults")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main())
