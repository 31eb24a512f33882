#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Siconos behind the engine protocol: its Moreau–Jean time stepping, its NSGS solver and its Bullet
collision, by its Python interface. Debian's python3-siconos is for the system's Python."""
import os
import pathlib
import sys

sys.dont_write_bytecode = True
os.environ["OPENBLAS_NUM_THREADS"] = "1"  # threads wait for one another far longer than such small systems take
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "engine" / "kit"))
import numpy
import stiction_engine
from stiction_engine import Lacks, Refused
import siconos.kernel as kernel
import siconos.numerics as numerics
from siconos.mechanics.collision import RigidBodyDS, SiconosBox, SiconosContactor, SiconosContactorSet, SiconosSphere
from siconos.mechanics.collision.bullet import SiconosBulletCollisionManager, SiconosBulletOptions
from exact_contacts import rotated, touches
from told_contacts import told_contacts

BOX, BALL = 0, 1  # collision groups; that of obstacle o is 2 + o
HERE = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]  # no displacement, no turn


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def upright_on(normal):
    """The quaternion that takes z to the normal."""
    x, y, z = normal
    if z < -1.0 + 1e-15:
        return [0.0, 1.0, 0.0, 0.0]
    q = numpy.array([1.0 + z, -y, x, 0.0])
    return list(q / numpy.linalg.norm(q))


def inertia_of(body):
    """Of an even box or ball, about its axes, kg m²."""
    if body.shape.kind == "ball":
        return [0.4 * body.mass * body.shape.radius**2] * 3
    x, y, z = (edge * edge for edge in body.shape.size)
    return [body.mass / 12.0 * both for both in (y + z, x + z, x + y)]


def law(friction):
    """Coulomb's, without rebound."""
    return kernel.NewtonImpactFrictionNSL(0.0, 0.0, friction, 3)


class Siconos(stiction_engine.Engine):
    name, version = "siconos", "4.4.0 (Debian; dynamics in double, Bullet's collision in single precision)"
    description = "Siconos: Moreau–Jean time stepping, Coulomb's cone by nonsmooth Gauss–Seidel"
    can = ["boxes", "balls", "body_contact", "varying_gravity", "oscillation", "drag", "loads", "spin"]
    settings_help = {
        "dt": "time step, s (default 0.005)",
        "theta": "of Moreau–Jean's scheme, 0.5 to 1 (default 0.50001)",
        "activation": "contacts act from this gap on, m (default 0)",
        "tolerance": "of NSGS, dimensionless (default 1e-8)",
        "iterations": "of NSGS, at most (default 10000)",
        "newton_iterations": "of the step, at most (default 20)",
        "contacts": "bullet (default; Siconos's own), exact (corners and balls on planes, balls on balls by the "
                    "adapter, the rest by Bullet)",
        "breaking_threshold": "Bullet: a contact ends when so far apart, m (default 0.02)",
        "processing_threshold": "Bullet: contacts are made when so far apart, m (default 0.03)",
        "obstacle_width": "of the box that stands for a half-space, m (default 100)",
        "obstacle_depth": "of that box, m (default 10)",
        "world_scale": "Bullet: its lengths over those of the problem (default 1)",
        "perturbations": "Bullet's, for contacts between boxes in several points (default 3)",
        "inside_margin": "Bullet's, over a body's least edge or radius; the shape stays as given (default 0.02)",
    }
    configurations = [
        {"name": "default", "settings": {}, "source": "defaults of its MechanicsHdf5Runner, with NSGS at 1e-8"},
        {"name": "best", "settings": {"contacts": "exact", "activation": "1e-6", "newton_iterations": "1"},
         "source": "our search at dt=0.005 (creep, threshold, acceleration, stop, ball pyramid): contacts by Bullet "
                   "(world_scale 1 to 100, perturbations 0 and 3) and exact, activation 0 to 1e-4 m, Newton "
                   "iterations 1 and 20, NSGS at 1e-8 and 1e-12, theta 0.50001 and 1"},
    ]
    ladder = [{"dt": dt} for dt in ("0.005", "0.0025", "0.00125", "0.000625", "0.0003125")]

    def load(self, problem):
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Siconos prints lines at each step; no reply goes there
        dt = min(0.005, problem.time) if problem.time > 0.0 else 0.005
        self.time_step = dt = self.number("dt", dt) / problem.finer
        if not dt > 0.0:
            raise Refused("setting 'dt' must be above 0")
        self.tell("dt", dt)
        self.problem = problem
        self.tell("outside_margin", 0.0)
        self.system = kernel.NonSmoothDynamicalSystem(0.0, 1e9)
        self.integrator = kernel.MoreauJeanOSI(self.number("theta", 0.50001))
        self.integrator.setConstraintActivationThreshold(self.number("activation", 0.0))
        contacts = self.text("contacts", "bullet")
        if contacts not in ("bullet", "exact"):
            raise Refused(f"setting 'contacts' is bullet or exact, not '{contacts}'")
        self.exact = contacts == "exact"
        self.collisions = self.make_collisions()
        self.things = [self.make_body(body) for body in problem.bodies]
        self.link_exact_contacts()
        self.stepping = self.make_stepping(dt)

    def make_collisions(self):
        """Bullet's, of those pairs of groups that have a law here."""
        options = SiconosBulletOptions()
        options.contactBreakingThreshold = self.number("breaking_threshold", options.contactBreakingThreshold)
        options.contactProcessingThreshold = self.number("processing_threshold", options.contactProcessingThreshold)
        count = int(self.number("perturbations", options.perturbationIterations))
        options.perturbationIterations = options.minimumPointsPerturbationThreshold = count
        options.worldScale = self.number("world_scale", options.worldScale)
        self.margin = self.number("inside_margin", 0.02)
        collisions = SiconosBulletCollisionManager(options)
        pairs = [(BOX, BOX), (BOX, BALL)] + ([] if self.exact else [(BALL, BALL)])
        for one, other in pairs:
            collisions.insertNonSmoothLaw(law(self.problem.friction), one, other)
        for o, obstacle in enumerate(self.problem.obstacles):
            if stiction_engine.moves(obstacle.motion):
                raise Lacks("moving obstacles")
            if not self.exact:
                self.add_obstacle(collisions, 2 + o, obstacle)
        return collisions

    def add_obstacle(self, collisions, group, obstacle):
        width, depth = self.number("obstacle_width", 100.0), self.number("obstacle_depth", 10.0)
        for kind in (BOX, BALL):
            collisions.insertNonSmoothLaw(law(obstacle.friction), kind, group)
        shape = SiconosBox(width, width, depth)
        shape.setInsideMargin(self.margin * depth)
        shape.setOutsideMargin(0.0)
        shapes = SiconosContactorSet()
        shapes.append(SiconosContactor(shape, HERE, group))
        centre = [p - 0.5 * depth * n for p, n in zip(obstacle.point, obstacle.normal)]
        collisions.insertStaticContactorSet(shapes, centre + upright_on(obstacle.normal))

    def link_exact_contacts(self):
        self.interactions = []
        for touch, friction, bodies in touches(self.problem) if self.exact else []:
            interaction = kernel.Interaction(law(friction), touch)
            self.system.link(interaction, *(self.things[b] for b in bodies))
            self.interactions.append((interaction, touch))

    def make_body(self, body):
        if body.shape.kind not in ("box", "ball"):
            raise Lacks("points" if body.shape.kind == "point" else "bodies given as meshes")
        if body.held:
            raise Lacks("held parts of bodies")
        if body.shape.kind == "ball":
            shape, least = SiconosSphere(body.shape.radius), body.shape.radius
        else:
            shape, least = SiconosBox(*body.shape.size), min(body.shape.size)
        shape.setInsideMargin(self.margin * least)
        shape.setOutsideMargin(0.0)
        spin = rotated(conjugate(body.rotation), numpy.array(body.angular_velocity, float))  # in its frame
        made = RigidBodyDS(list(body.position) + list(body.rotation), list(body.velocity) + list(spin), body.mass,
                           numpy.diag(inertia_of(body)))
        made.setUseContactorInertia(False)
        shapes = SiconosContactorSet()
        shapes.append(SiconosContactor(shape, HERE, BALL if body.shape.kind == "ball" else BOX))
        made.setContactors(shapes)
        self.system.insertDynamicalSystem(made)
        return made

    def make_stepping(self, dt):
        options = kernel.solver_options_create(numerics.SICONOS_FRICTION_3D_NSGS)
        options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = int(self.number("iterations", 10000))
        options.dparam[numerics.SICONOS_DPARAM_TOL] = self.number("tolerance", 1e-8)
        contacts = kernel.FrictionContact(3, options)
        contacts.setMaxSize(100000)
        contacts.setMStorageType(numerics.NM_SPARSE_BLOCK)
        contacts.setKeepLambdaAndYState(True)
        stepping = kernel.TimeStepping(self.system, kernel.TimeDiscretisation(0.0, dt))
        stepping.insertIntegrator(self.integrator)
        stepping.insertNonSmoothProblem(contacts)
        stepping.insertInteractionManager(self.collisions)
        stepping.setNewtonOptions(kernel.SICONOS_TS_NONLINEAR)
        stepping.setNewtonMaxIteration(int(self.number("newton_iterations", 20)))
        stepping.setNewtonTolerance(1e-10)
        self.options = options
        return stepping

    def clock(self):
        return self.stepping.startingTime()

    def advance(self, steps):
        for _ in range(steps):
            self.apply_loads()
            self.stepping.computeOneStep()
            self.stepping.nextStep()

    def apply_loads(self):
        """Forces of the step: gravity, loads and drag as at its start."""
        t = self.clock()
        gravity = numpy.array(stiction_engine.at(self.problem.gravity, t))
        for b, (body, made) in enumerate(zip(self.problem.bodies, self.things)):
            force, couple = stiction_engine.load_on(self.problem, b, t, list(made.q()[:3]))
            drag = self.drag(t)
            made.setFExtPtr(body.mass * (gravity - drag * made.twist()[:3]) + numpy.array(force))
            made.setMExtPtr(numpy.array(couple))

    def drag(self, t):
        drag = self.problem.drag
        if not drag.rate or t >= drag.ends:
            return 0.0
        if t <= drag.full_until:
            return drag.rate
        s = (t - drag.full_until) / (drag.ends - drag.full_until)
        return drag.rate * (1.0 - s**3 * (10.0 + s * (6.0 * s - 15.0)))

    def bodies(self):
        states = []
        for made in self.things:
            q, v = made.q(), made.twist()
            states.append((q[:3], v[:3], q[3:], rotated(q[3:], v[3:])))
        return states

    def contacts(self):
        return told_contacts(self)


if __name__ == "__main__":
    stiction_engine.main(Siconos)
