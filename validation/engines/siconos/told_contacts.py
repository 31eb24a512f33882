# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts of the last step, as the protocol tells them."""
import numpy
import siconos.kernel as kernel
from siconos.mechanics.collision import cast_ContactR
from exact_contacts import rotated


def distance(shape, made, point):
    """Of the point from the body's surface, m; near it, exact to first order."""
    q = made.q()
    local = rotated([q[3], -q[4], -q[5], -q[6]], point - q[:3])
    if shape.kind == "ball":
        return numpy.linalg.norm(local) - shape.radius
    return max(abs(x) - 0.5 * edge for x, edge in zip(local, shape.size))


def bullet_names(engine, relation):
    """Siconos tells the first of the two that touch; the other one has its point on it."""
    first = [made.number() for made in engine.things].index(relation.ds.number())
    point, normal = relation.pc2(), relation.nc()
    for o, obstacle in enumerate(engine.problem.obstacles):
        if not engine.exact and normal.dot(obstacle.normal) > 0.999:
            if abs(numpy.dot(point - obstacle.point, obstacle.normal)) < 2e-2:
                return {"body": first, "obstacle": o}
    others = [b for b in range(len(engine.things)) if b != first]
    near = min(others, key=lambda b: abs(distance(engine.problem.bodies[b].shape, engine.things[b], point)))
    return {"body": first, "other_body": near}


def velocity(made, point):
    q, twist = made.q(), made.twist()
    return twist[:3] + numpy.cross(rotated(q[3:], twist[3:]), point - q[:3])


def told_contacts(engine):
    found = []
    if engine.clock() == 0.0:
        return found  # there is no index set before the first step
    exact = {interaction.number(): touch for interaction, touch in engine.interactions}
    for interaction in kernel.interactions(engine.system.topology().indexSet(1)):
        touch = exact.get(interaction.number())
        relation = touch or cast_ContactR(interaction.relation())
        names = touch.names if touch else bullet_names(engine, relation)
        normal, point = numpy.array(relation.nc()), numpy.array(relation.pc1())
        force = numpy.array(relation.contactForce()[:3]) / engine.time_step
        slip = velocity(engine.things[names["body"]], point)
        if "other_body" in names:
            slip = slip - velocity(engine.things[names["other_body"]], point)
        friction = force - force.dot(normal) * normal
        size = numpy.linalg.norm(friction)
        law = kernel.cast_NewtonImpactFrictionNSL(interaction.nonSmoothLaw())
        found.append({**names, "normal": normal.tolist(), "gap": float(interaction.y(0)[0]),
                      "normal_force": max(float(force.dot(normal)), 0.0), "friction_force": friction.tolist(),
                      "slip": (slip - slip.dot(normal) * normal).tolist(), "position": point.tolist(),
                      "sticks": bool(size < (1.0 - 1e-6) * law.mu() * force.dot(normal))})
    return found
