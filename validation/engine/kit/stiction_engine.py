# SPDX-License-Identifier: BSD-3-Clause
"""Puts an engine written in Python behind the cases of stiction: no dependencies, one file.

    import stiction_engine

    class MyEngine(stiction_engine.Engine):
        name, version, can = "mine", "1.0", ["boxes"]
        def load(self, problem): ...
        def advance(self, steps): ...
        def bodies(self): ...

    stiction_engine.main(MyEngine)

SI units; vectors are lists [x, y, z] in the world's frame; rotations are unit quaternions [w, x, y, z]
from the body's frame to the world's. The protocol itself: ../protocol/README.md.
"""
import base64
import json
import math
import os
import struct
import sys
import time
import traceback
from types import SimpleNamespace


class Refused(Exception):
    """The problem or setting cannot be simulated: one sentence. Any other exception does the same."""


class Lacks(Exception):
    """The engine lacks what the problem needs: the case is not applicable, in these words."""


class Engine:
    """What to override. Functions that are left out are features that the engine lacks."""

    name = "engine"
    version = ""          # of the engine behind the adapter
    description = ""      # one line
    can = []              # words of the protocol, a list or a text: "boxes balls body_contact"
    settings_help = {}    # name → meaning, unit, default
    configurations = []   # {"name": "default", "settings": {"dt": "0.01"}, "source": "where they come from"}
    ladder = []           # efforts from the usual to the most: {"dt": "0.005"}, …
    symplectic_euler = False

    time_step = 1e-3      # Δt, s; load() may set it

    def load(self, problem):
        """Takes the problem and stands at t = 0. `problem` has the fields of the protocol as attributes;
        self.number("dt", 1e-3) and self.text("solver", "pgs") read the run's settings, self.tell(name,
        value) writes a native parameter into the record."""
        raise NotImplementedError

    def advance(self, steps):
        """Whole steps."""
        raise NotImplementedError

    def bodies(self):
        """Of each body (position, velocity, rotation, angular velocity): m, m/s, quaternion, rad/s."""
        raise NotImplementedError

    # May be left out:
    #   clock()           → the engine's own time, s
    #   contacts()        → a list of dicts as in the protocol
    #   energies()        → {"kinetic": J, "gravity": J, "elastic": J}
    #   momenta()         → {"linear": [...], "angular": [...]}
    #   surface()         → triangles of each body; vertices() → where their vertices are
    #   save()            → a copy of all that the future depends on; restore(copy)

    def number(self, name, fallback):
        """The setting as a finite number, or the fallback; either is told to the record."""
        text = self._given.get(name)
        try:
            value = float(fallback if text is None else text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise Refused(f"setting '{name}' must be a number, not '{text}'")
        self.tell(name, value)
        return value

    def text(self, name, fallback):
        """The setting as it stands, or the fallback; either is told to the record."""
        value = self._given.get(name, fallback)
        self.tell(name, value)
        return value

    def tell(self, name, value):
        self._resolved[name] = value if isinstance(value, str) else repr(value)


def _smooth_step(s):
    return s * s * s * (10.0 + s * (6.0 * s - 15.0))


def at(keyframes, t):
    """Value at time t of keyframes (.time, .value), joined by the smooth step 6s⁵ − 15s⁴ + 10s³, and what lies
    on top of them: t · .velocity, and .oscillation, a sine or None."""
    value = [a + t * v for a, v in zip(_between(keyframes, t), keyframes.velocity)]
    sine = keyframes.oscillation
    if sine is None or t <= sine.begins:
        return value
    grown = _smooth_step((t - sine.begins) / (sine.full_from - sine.begins)) if t < sine.full_from else 1.0
    now = grown * math.sin(2.0 * math.pi * sine.frequency * (t - sine.begins) + sine.phase)
    return [a + now * b for a, b in zip(value, sine.amplitude)]


def moves(motion):
    """Whether an obstacle or a held part has a motion."""
    return bool(motion.time) or varies(motion)


def varies(keyframes):
    """Whether the value is not the same at all times."""
    return len(keyframes.time) > 1 or any(keyframes.velocity) or keyframes.oscillation is not None


def friction(problem, body, other, against_body=False):
    """μ of a body against an obstacle, or another body: as it is, not to be combined."""
    for pair in problem.pair_friction:
        if pair.against_body == against_body and (
                (pair.body, pair.other) == (body, other) or against_body and (pair.other, pair.body) == (body, other)):
            return pair.friction
    return problem.friction if against_body else problem.obstacles[other].friction


def _between(keyframes, t):
    time_, value = keyframes.time, keyframes.value
    if not time_:
        return [0.0, 0.0, 0.0]
    if t <= time_[0]:
        return list(value[0])
    if t >= time_[-1]:
        return list(value[-1])
    k = next(i for i, one in enumerate(time_) if one > t)
    s = (t - time_[k - 1]) / (time_[k] - time_[k - 1])
    s = _smooth_step(s)
    return [a + s * (b - a) for a, b in zip(value[k - 1], value[k])]


def load_on(problem, body, t, position):
    """What loads and springs do to a body whose centre is there: force through it (N), couple (N m)."""
    force, couple = [0.0] * 3, [0.0] * 3
    for load in problem.loads:
        if load.body == body:
            force = [a + b for a, b in zip(force, at(load.force, t))]
            couple = [a + b for a, b in zip(couple, at(load.couple, t))]
    for spring in problem.springs:
        if spring.body == body:
            stretch = sum(a * (p + t * v - x) for a, p, v, x in
                          zip(spring.axis, spring.anchor, spring.anchor_velocity, position))
            force = [f + spring.stiffness * stretch * a for f, a in zip(force, spring.axis)]
    return force, couple


def numbers(value):
    """[1, 2], [[1, 2], …] or {"f64": base64 of little-endian doubles} as a flat list."""
    if isinstance(value, dict):
        data = base64.b64decode(value["f64"], validate=True)
        return list(struct.unpack(f"<{len(data) // 8}d", data))
    return [x for one in value for x in (one if isinstance(one, list) else [one])]


def vectors(value, width=3):
    """The same as lists of `width` numbers each."""
    flat = numbers(value)
    return [flat[k:k + width] for k in range(0, len(flat), width)]


def _keyframes(value):
    value = value or {}
    sine = value.get("oscillation")
    return SimpleNamespace(
        time=numbers(value.get("time", [])), value=vectors(value.get("value", [])),
        velocity=numbers(value.get("velocity", [0.0] * 3)),
        oscillation=sine and SimpleNamespace(**{"amplitude": [0.0] * 3, "frequency": 0.0, "phase": 0.0,
                                                "begins": 0.0, "full_from": 0.0, **sine}))


def _body(one):
    shape = one["shape"]
    body = SimpleNamespace(name="", mass=1.0, position=[0.0] * 3, rotation=[1.0, 0.0, 0.0, 0.0],
                           velocity=[0.0] * 3, angular_velocity=[0.0] * 3, held=None,
                           self_collision=False, must_deform=False)
    body.__dict__.update(one)
    kind, form = next(iter(shape.items()))
    body.shape = SimpleNamespace(kind=kind, **form)
    if kind == "mesh":
        body.shape.vertices = vectors(form["vertices"])
        body.shape.tetrahedra = vectors(form["tetrahedra"], 4)
    body.elasticity = SimpleNamespace(**{"youngs_modulus": 5e5, "poisson_ratio": 0.3, "damping_time": 0.0,
                                         **one.get("elasticity", {})})
    body.motion = _keyframes(one.get("motion"))
    return body


def read_problem(message):
    """`problem` and `accuracy` of a `load` message as attributes, what is left out as by default."""
    given, accuracy = message["problem"], message.get("accuracy", {})
    problem = SimpleNamespace(**{"name": "", "friction": 0.0, "duration": 1.0, "restitution": 0.0, **given})
    problem.bodies = [_body(one) for one in given["bodies"]]
    problem.obstacles = [
        SimpleNamespace(**{"name": "", "point": [0.0] * 3, "normal": [0.0, 0.0, 1.0], "friction": 0.0, **one,
                           "motion": _keyframes(one.get("motion"))}) for one in given.get("obstacles", [])]
    problem.gravity = _keyframes(given.get("gravity"))
    problem.drag = SimpleNamespace(**{"rate": 0.0, "full_until": 0.0, "ends": 0.0, **given.get("drag", {})})
    problem.loads = [SimpleNamespace(body=one["body"], force=_keyframes(one.get("force")),
                                     couple=_keyframes(one.get("couple"))) for one in given.get("loads", [])]
    problem.pair_friction = [SimpleNamespace(**{"against_body": False, **one}) for one in given.get("pair_friction", [])]
    problem.springs = [SimpleNamespace(**one) for one in given.get("springs", [])]
    for name in ("fineness", "roundness", "time"):
        setattr(problem, name, accuracy.get(name, 0))
    problem.finer = accuracy.get("finer", 1.0)
    return problem


class _Session:
    def __init__(self, kind):
        self.kind, self.engine, self.steps, self.cpu = kind, None, 0, 0.0
        self.saved, self.last_saved = {}, 0

    def answer(self, message):
        verb = message.get("do")
        if verb not in ("hello", "load", "advance", "observe", "save", "restore", "quit"):
            raise Refused(f"there is no request '{verb}'")
        if verb not in ("hello", "load", "quit") and self.engine is None:
            raise Refused(f"'{verb}' came before a problem was loaded")
        return getattr(self, verb)(message)

    def hello(self, _):
        kind = self.kind
        tells = [what for what in ("contacts", "energies", "momenta", "surface") if hasattr(kind, what)]
        can = kind.can.split() if isinstance(kind.can, str) else list(kind.can)
        snapshots = ["snapshots"] if hasattr(kind, "save") and hasattr(kind, "restore") else []
        return {"protocol": 1, "name": kind.name, "version": kind.version, "description": kind.description,
                "can": can + tells + snapshots, "settings": kind.settings_help,
                "configurations": kind.configurations, "ladder": kind.ladder,
                "symplectic_euler": kind.symplectic_euler}

    def load(self, message):
        settings = message.get("settings", {})
        for name in settings:
            if name not in self.kind.settings_help:
                raise Refused(f"there is no setting '{name}'")
        self.engine = self.kind()
        self.engine._given, self.engine._resolved = settings, {}
        self.engine.load(read_problem(message))
        self.steps, self.cpu = 0, 0.0
        self.engine._resolved.setdefault("dt", repr(self.engine.time_step))
        return {"time_step": self.engine.time_step, "settings": self.engine._resolved}

    def _now(self):
        clock = getattr(self.engine, "clock", lambda: self.steps * self.engine.time_step)
        return {"steps": self.steps, "time": clock()}

    def advance(self, message):
        before = time.process_time()
        if message["steps"] > 0:
            self.engine.advance(message["steps"])
        self.cpu += time.process_time() - before
        self.steps += message["steps"]
        return {**self._now(), "cpu": self.cpu}

    def observe(self, message):
        seen = {}
        for what in message["what"]:
            if what == "bodies":
                parts = zip(*self.engine.bodies())
                names = ("position", "velocity", "rotation", "angular_velocity")
                seen[what] = {name: [float(x) for one in part for x in one] for name, part in zip(names, parts)}
            elif hasattr(self.engine, what):
                seen[what] = getattr(self.engine, what)()
            else:
                raise Refused(f"this engine does not tell '{what}'")
        return seen

    def save(self, message):
        for state in message.get("forget", []):
            self.saved.pop(state, None)
        state, self.last_saved = self.last_saved, self.last_saved + 1
        self.saved[state] = (self.engine.save(), self.steps)
        return {"state": state}

    def restore(self, message):
        copy, self.steps = self.saved[message["state"]]
        self.engine.restore(copy)
        return self._now()

    def quit(self, _):
        return {}


def _finite(value):
    """JSON has no NaN and no infinity: null stands for them."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {name: _finite(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(one) for one in value]
    return value


def _make_sure_of_standard_streams():
    """Without one of them the engine behind would be given its number for the first file that it opens."""
    for stream, mode in enumerate((os.O_RDONLY, os.O_RDONLY, os.O_WRONLY)):
        try:
            os.fstat(stream)
        except OSError:
            os.open(os.devnull, mode)


def main(kind):
    """Speaks the protocol until `quit` or the end of the input. What the engine prints goes to stderr."""
    _make_sure_of_standard_streams()
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    session = _Session(kind)
    for line in sys.stdin or ():
        message = {}
        try:
            message = json.loads(line)
            reply = session.answer(message)
        except Lacks as words:
            reply = {"lacks": str(words)}
        except Refused as words:
            reply = {"error": str(words)}
        except Exception as error:  # whatever went wrong is the case's error; where, is on stderr
            traceback.print_exc()
            place = traceback.extract_tb(error.__traceback__)[-1]
            where = f"{os.path.basename(place.filename)}:{place.lineno}, in {place.name}"
            reply = {"error": f"{type(error).__name__}: {error} ({where})"}
        out.write(json.dumps(_finite(reply), allow_nan=False) + "\n")
        out.flush()
        if isinstance(message, dict) and message.get("do") == "quit":
            break
