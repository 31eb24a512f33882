# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts in exact geometry, in double precision: relations of Siconos whose points and normals come from
here. What they may carry, and how the bodies move, is Siconos's."""
import numpy
import siconos.kernel as kernel


def rotated(q, v):
    """v turned by the unit quaternion w, x, y, z."""
    w, axis = q[0], numpy.asarray(q[1:])
    return v + 2.0 * numpy.cross(axis, numpy.cross(axis, v) + w * numpy.asarray(v))


class Touch(kernel.NewtonEuler3DR):
    """What touches: `body`, and an obstacle or `other_body`."""

    def __init__(self, **names):
        super().__init__()
        self.names = names

    def place(self, y, gap, normal, on_body, on_other):
        y[0] = gap
        self.nc()[:] = normal
        self.pc1()[:] = on_body
        self.pc2()[:] = on_other

    def computeJachqT(self, interaction, q0):
        """Siconos 4.4 makes the frame of a contact by orthoBaseFromVector (numerics/op3x3.h), whose second
        axis is not orthogonal to a normal with nx ≠ ny where nz is the largest. The rows of the Jacobian are
        D [1, …], D the frame: it is replaced by an orthonormal one about the same normal."""
        super().computeJachqT(interaction, q0)
        rows = numpy.array(self.jachqT())
        frame = rows[:, :3]
        normal = frame[0] / numpy.linalg.norm(frame[0])
        along = numpy.cross(normal, [1.0, 0.0, 0.0] if abs(normal[0]) < 0.6 else [0.0, 1.0, 0.0])
        along /= numpy.linalg.norm(along)
        right = numpy.array([normal, along, numpy.cross(normal, along)])
        self.jachqT()[:] = right @ numpy.linalg.inv(frame) @ rows


class PointOnPlane(Touch):
    """A point of a body, or the lowest one of a ball about that point, and a half-space."""

    def __init__(self, body, local, radius, obstacle, plane):
        super().__init__(body=body, obstacle=obstacle)
        self.local, self.radius = numpy.array(local, float), radius
        self.point, self.normal = numpy.array(plane.point, float), numpy.array(plane.normal, float)

    def computeh(self, time, q, y):
        centre = q[:3] + rotated(q[3:7], self.local)
        gap = self.normal.dot(centre - self.point) - self.radius
        foot = centre - self.radius * self.normal
        self.place(y, gap, self.normal, foot, foot - gap * self.normal)


class BallOnBall(Touch):
    def __init__(self, body, other, radius, other_radius):
        super().__init__(body=body, other_body=other)
        self.radius, self.other_radius = radius, other_radius

    def computeh(self, time, q, y):
        between = q[:3] - q[7:10]
        distance = numpy.sqrt(between.dot(between))
        normal = between / distance
        self.place(y, distance - self.radius - self.other_radius, normal, q[:3] - self.radius * normal,
                   q[7:10] + self.other_radius * normal)


def corners(size):
    x, y, z = (0.5 * edge for edge in size)
    return [[i * x, j * y, k * z] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]


def touches(problem):
    """Of each contact that may be (relation, μ, bodies): corners and balls on planes, balls on balls."""
    found = []
    for b, body in enumerate(problem.bodies):
        for o, plane in enumerate(problem.obstacles):
            points = [[0.0] * 3] if body.shape.kind == "ball" else corners(body.shape.size)
            radius = getattr(body.shape, "radius", 0.0)
            found += [(PointOnPlane(b, local, radius, o, plane), plane.friction, [b]) for local in points]
        for other in range(b):
            shapes = body.shape, problem.bodies[other].shape
            if all(shape.kind == "ball" for shape in shapes):
                found.append((BallOnBall(b, other, *(shape.radius for shape in shapes)), problem.friction,
                              [b, other]))
    return found
