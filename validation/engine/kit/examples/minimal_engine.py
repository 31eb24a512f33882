# SPDX-License-Identifier: BSD-3-Clause
"""The least engine: boxes that slide on half-spaces and do not turn, by symplectic Euler."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import stiction_engine


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


class Minimal(stiction_engine.Engine):
    name, version, description = "minimal-python", "1", "boxes that slide on half-spaces and do not turn"
    can = ["boxes", "varying_gravity", "oscillation", "pair_friction"]
    settings_help = {"dt": "time step, s (default 1e-3)"}
    symplectic_euler = True

    def load(self, problem):
        self.problem, self.t = problem, 0.0
        self.time_step = self.number("dt", 1e-3) / problem.finer
        self.x = [list(body.position) for body in problem.bodies]
        self.v = [list(body.velocity) for body in problem.bodies]

    def advance(self, steps):
        dt = self.time_step
        for _ in range(steps):
            g = stiction_engine.at(self.problem.gravity, self.t)
            for b, body in enumerate(self.problem.bodies):
                self.v[b] = [v + dt * a for v, a in zip(self.v[b], g)]
                for o in range(len(self.problem.obstacles)):
                    self.touch(b, 0.5 * body.shape.size[2], o)  # it lies flat
                self.x[b] = [x + dt * v for x, v in zip(self.x[b], self.v[b])]
            self.t += dt

    def touch(self, b, reach, o):
        plane, mu = self.problem.obstacles[o], stiction_engine.friction(self.problem, b, o)
        n = plane.normal
        gap = dot(n, [x - p for x, p in zip(self.x[b], plane.point)]) - reach
        push = -max(gap, 0.0) / self.time_step - dot(n, self.v[b])
        if push <= 0.0:
            return
        slip = [v - dot(n, self.v[b]) * a for v, a in zip(self.v[b], n)]
        left = max(0.0, 1.0 - mu * push / max(dot(slip, slip) ** 0.5, 1e-300))
        along = dot(n, self.v[b]) + push
        self.v[b] = [left * u + along * a for u, a in zip(slip, n)]

    def bodies(self):
        return [(x, v, body.rotation, [0.0] * 3) for x, v, body in zip(self.x, self.v, self.problem.bodies)]


stiction_engine.main(Minimal)
