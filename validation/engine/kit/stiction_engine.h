/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Puts an engine behind the cases of stiction: fill a table of functions, call stiction_engine_main,
 * link libstiction_engine. The program then speaks the protocol of ../protocol/README.md on its
 * standard input and output; what it prints itself goes to its standard error.
 *
 * SI units throughout; vectors are x, y, z in the world's frame; rotations are unit quaternions
 * w, x, y, z that take the body's frame to the world's. An engine simulates one problem, at one
 * time, in one thread of calls. */
#ifndef STICTION_ENGINE_H
#define STICTION_ENGINE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { STICTION_PROTOCOL = 1 };

/* amplitude · e(t) · sin(2π frequency (t − begins) + phase), where e grows from 0 at `begins` to 1 at
 * `full_from` by the smooth step 6s⁵ − 15s⁴ + 10s³, or at once where they are equal; zero before. */
typedef struct {
  double amplitude[3];
  double frequency; /* Hz */
  double phase;     /* rad */
  double begins;    /* s */
  double full_from; /* s */
} stiction_oscillation;

/* Vectors over time: keyframes joined by the smooth step and constant outside (without one zero), and
 * on top of them, for engines that can, t · velocity and a sine. stiction_at reads all of it. */
typedef struct {
  size_t count;
  const double* time;       /* s, increasing */
  const double (*value)[3]; /* one a keyframe */
  double velocity[3];       /* of motions, m/s: `steady_motion` */
  stiction_oscillation oscillation;
} stiction_keyframes;

typedef enum { STICTION_POINT, STICTION_BOX, STICTION_BALL, STICTION_MESH } stiction_shape;

typedef struct {
  const char* name;
  stiction_shape shape;
  double size[3];              /* of a box: edge lengths, m */
  double radius;               /* of a ball, m */
  size_t vertex_count;         /* of a mesh */
  const double (*vertices)[3]; /* about the centre of mass, m */
  size_t tetrahedron_count;
  const uint32_t (*tetrahedra)[4]; /* vertices, of positive volume */
  int convex;                      /* 1: the mesh is the convex hull of its vertices */
  double mass;                     /* kg, spread evenly */
  double inertia[3][3];            /* about the centre, in the body's frame, kg m² */
  double youngs_modulus;           /* Pa; a rigid engine has no use for these three */
  double poisson_ratio;
  double damping_time;        /* β, s: viscous stress = β · elasticity · strain rate */
  double position[3];         /* of the centre of mass at t = 0, m */
  double rotation[4];         /* at t = 0 */
  double velocity[3];         /* of the centre, m/s */
  double angular_velocity[3]; /* rad/s */
  int held;                   /* 1: the points x of the body's frame with
                                  (x − held_point)·held_normal ≤ 0 follow `motion` */
  double held_point[3];
  double held_normal[3];
  stiction_keyframes motion; /* displacement of the held part, m */
  int self_collision;
  int must_deform;
} stiction_body;

/* A half-space: (x − point)·normal < 0 is inside. */
typedef struct {
  const char* name;
  double point[3];           /* m */
  double normal[3];          /* outward, unit */
  double friction;           /* μ of every pair with this obstacle: as it is, not to be combined */
  stiction_keyframes motion; /* displacement of the whole half-space, m */
} stiction_obstacle;

/* A force through a body's centre of mass and a couple, over time. */
typedef struct {
  size_t body;
  stiction_keyframes force;  /* N */
  stiction_keyframes couple; /* N m */
} stiction_body_load;

/* Pulls a body's centre by stiffness · axis · (axis · (anchor + t anchor_velocity − centre)). */
typedef struct {
  size_t body;
  double anchor[3];          /* at t = 0, m */
  double anchor_velocity[3]; /* m/s */
  double axis[3];            /* unit */
  double stiffness;          /* N/m */
} stiction_spring;

/* μ of one pair, in place of what holds for all. stiction_friction looks them up. */
typedef struct {
  size_t body;
  size_t other; /* an obstacle, or a body if `against_body` */
  int against_body;
  double friction;
} stiction_pair_friction;

typedef struct {
  const char* name;
  size_t body_count;
  const stiction_body* bodies;
  size_t obstacle_count;
  const stiction_obstacle* obstacles;
  stiction_keyframes gravity; /* m/s² */
  double drag_rate;           /* c, 1/s: force −m c v on all that moves; stiction_drag reads it */
  double drag_full_until;     /* s */
  double drag_ends;           /* s: faded out by then */
  double friction;            /* μ between bodies: as it is, not to be combined */
  double duration;            /* s */
  /* How finely the case needs it; what a setting says goes before all but `finer`. 0: as you like. */
  int fineness;  /* a body's longest edge over what it is resolved to */
  int roundness; /* points on a ball's surface, at least */
  double time;   /* s: what lasts so long is resolved */
  double finer;  /* divide the time step that comes of all that by this, ≥ 1 */
  /* stiction_load sums these up. */
  size_t load_count;
  const stiction_body_load* loads;
  size_t spring_count;
  const stiction_spring* springs;
  /* For engines that can. stiction_friction reads the first. */
  size_t pair_friction_count;
  const stiction_pair_friction* pair_friction;
  double restitution; /* e of every contact: normal speed after over before, 0 to 1 */
} stiction_problem;

/* At time t (s): values over time; whether there are any, and whether they change; the drag's rate c (1/s); what loads and springs do to a body whose
 * centre is at `position` (m): a force through the centre (N) and a couple (N m). */
void stiction_at(const stiction_keyframes* keyframes, double t, double value[3]);
int stiction_moves(const stiction_keyframes* motion);
int stiction_varies(const stiction_keyframes* keyframes);
double stiction_drag(const stiction_problem* problem, double t);
int stiction_has_loads(const stiction_problem* problem, size_t body);
void stiction_load(const stiction_problem* problem, size_t body, double t, const double position[3],
                   double force[3], double couple[3]);

/* μ of a body against an obstacle, or another body if `against_body`: as it is, not to be combined. */
double stiction_friction(const stiction_problem* problem, size_t body, size_t other,
                         int against_body);

/* Settings of this run, while load() runs: as given, else the fallback. A text that is no number is
 * refused in words. stiction_tell writes a native parameter into the record, as resolved. */
int stiction_has(const char* setting);
double stiction_number(const char* setting, double fallback);
const char* stiction_text(const char* setting, const char* fallback);
void stiction_tell(const char* parameter, const char* value);
void stiction_tell_number(const char* parameter, double value);

/* Ends the present call with one sentence: what cannot be simulated (an error), or what the engine
 * lacks for this problem (then the case is not applicable). They return to stiction_engine_main, by
 * a C++ exception; in C++ any std::exception does what stiction_refuse does. */
#ifdef __cplusplus
[[noreturn]]
#endif
void stiction_refuse(const char* sentence);
#ifdef __cplusplus
[[noreturn]]
#endif
void stiction_lacks(const char* words);

typedef struct {
  double position[3];         /* of the centre of mass, m */
  double velocity[3];         /* m/s */
  double rotation[4];         /* w, x, y, z */
  double angular_velocity[3]; /* rad/s */
} stiction_body_state;

/* One contact at the end of the last step. */
typedef struct {
  size_t body;
  size_t other; /* what it touches: an obstacle, or a body if `against_body` */
  int against_body;
  double normal[3];         /* unit, out of what it touches, towards `body` */
  double gap;               /* m, below 0 where they overlap */
  double normal_force;      /* on `body` along the normal, N, ≥ 0; mean over the step */
  double friction_force[3]; /* on `body`, N */
  double slip[3];           /* tangential velocity of `body` over what it touches, m/s */
  double position[3];       /* m */
  int sticks;               /* the engine's own word */
} stiction_contact;

typedef struct {
  const char* name;
  const char* help; /* meaning, unit, default */
} stiction_setting;

/* A way to run the engine: settings as "dt=0.01 iterations=50", and where their values come from. */
typedef struct {
  const char* name; /* "default", "best" */
  const char* settings;
  const char* source;
} stiction_configuration;

/* What an engine brings. Required: name, load, time_step, advance, body. Any other that is NULL is a
 * feature that the engine lacks. Arrays end with an entry whose name is NULL. `self` is what load
 * returned. */
typedef struct {
  const char* name;
  const char* version; /* of the engine behind the adapter */
  const char* description;
  /* What it can, words of the protocol with spaces between: "boxes balls body_contact loads". */
  const char* can;
  const stiction_setting* settings;
  const stiction_configuration* configurations;
  /* Efforts, from usual to most: settings as above, laid over each configuration. */
  const char* const* ladder;
  int symplectic_euler; /* 1: v += Δt a(t), x += Δt v, to round-off */

  void* (*load)(const stiction_problem* problem); /* stands at t = 0; the problem outlives it */
  double (*time_step)(void* self);                /* Δt, s */
  void (*advance)(void* self, uint64_t steps);    /* whole steps */
  double (*time)(void* self); /* the engine's own clock, s; NULL: steps · Δt */
  void (*body)(void* self, size_t index, stiction_body_state* state);
  /* Writes up to `room` contacts and returns how many there are. */
  size_t (*contacts)(void* self, stiction_contact* contacts, size_t room);
  /* Energies in J: kinetic, gravity, elastic. NULL: reckoned from rigid bodies. */
  void (*energies)(void* self, double* kinetic, double* gravity, double* elastic);
  /* Linear momentum (kg m/s), angular momentum about the origin (kg m²/s). NULL: as above. */
  void (*momenta)(void* self, double linear[3], double angular[3]);
  /* For bodies that deform: the surface's triangles and where its vertices are (m); each writes up
   * to `room` and returns how many there are. */
  size_t (*surface)(void* self, size_t body, uint32_t (*triangles)[3], size_t room);
  size_t (*vertices)(void* self, size_t body, double (*positions)[3], size_t room);
  void* (*save)(void* self); /* a copy of all that the future depends on */
  void (*restore)(void* self, const void* saved);
  void (*forget)(void* self, void* saved); /* frees what save returned; may be NULL */
  void (*end)(void* self);                 /* frees self; may be NULL */
} stiction_engine;

/* Speaks the protocol until `quit` or the end of the input. Returns the exit code. */
int stiction_engine_main(const stiction_engine* engine, int argc, char** argv);

#ifdef __cplusplus
}
#endif
#endif
