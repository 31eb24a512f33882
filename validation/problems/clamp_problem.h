// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "validation/core/case_run.h"
#include "validation/engine/problem.h"
#include "validation/estimate/threshold.h"

namespace stiction {

/// Boxes in a row along x, pressed between two jaws that close along x; gravity falls along −z, so
/// that it lies in every contact plane and only friction carries it.
struct ClampSetup {
  int boxes = 1;
  double width = 0.1;     ///< w: edge of a (cubic) box, m
  double box_mass = 1.0;  ///< m, kg
  Eigen::Vector3i box_cells{2, 2, 2};
  Vec3 bar{0.04, 0.14, 0.14};  ///< thickness, breadth and height of a jaw, m
  Eigen::Vector3i bar_cells{1, 2, 2};
  double offset = 0.0;    ///< Δh: the left bar stands this much above the right one, m
  bool rigid = false;     ///< jaws are moving half-spaces instead of deformable bars
  double squeeze = 1e-3;  ///< way of each jaw's outer face inwards, m
  double friction = 0.5;  ///< μ
  double fall = 9.81;     ///< g, m/s²
  Elasticity elasticity{.youngs_modulus = 2e5, .poisson_ratio = 0.3, .damping_time = 5e-4};
  double bar_stiffness = 1.0;  ///< Young's modulus of the bars over that of the boxes
  double fall_full = 0.8;      ///< time at which gravity is full, s
  /// No body is shifted across the row: vertices may lie on vertices, edges on edges.
  bool flush = false;
};

/// When the clamp has closed and when gravity begins, s.
inline constexpr double kClosed = 0.3, kFallFrom = 0.4;

/// Bodies: the boxes from left to right, then the left and the right bar; with rigid jaws obstacle
/// 0 is the left one, 1 the right one.
Problem clamp_problem(const ClampSetup& setup);

/// What acts across one contact plane, by the samples of both sides.
struct JointForce {
  double normal = 0.0;      ///< Σ fⁿ, N
  double height = 0.0;      ///< of the pressure centre, z, m
  double across = 0.0;      ///< of the pressure centre, x, m
  double lift = 0.0;        ///< Σ of the vertical part of normal forces on the box, over Σ fⁿ
  double along = 0.0;       ///< Σ of the vertical part of friction over Σ |f|
  Vec3 on_left{0, 0, 0};    ///< on the left body, reactions included (Newton's third law), N
  Vec3 own_left{0, 0, 0};   ///< … of the contacts whose vertex is the left body's, N
  Vec3 own_right{0, 0, 0};  ///< on the right body, of the contacts whose vertex is its own, N
  double own_normal = 0.0;  ///< Σ fⁿ of the vertices of boxes, N
  double own_height = 0.0;  ///< … and their pressure centre, z, m
};

/// Joint j = 0 … n: left jaw, between boxes j − 1 and j, right jaw.
JointForce joint_force(const Engine& engine, const ClampSetup& setup, int joint);

/// Mean of Σ fⁿ at the two jaws, N.
double clamp_force(const Engine& engine, const ClampSetup& setup);

/// Runs until gravity is full and tells whether the first box stays: from 0.3 to 0.6 s after that it
/// creeps by less than 1e-4 m/s, or what is left of the way by which it has settled slows down. What is
/// just short of holding by the fraction ε of its weight accelerates at ε g, so that this criterion moves
/// a threshold by 2.3e-5 at most. Nor may it have sunk by 2 mm in all: a box that slips can be caught by
/// the upper edge of a bar. With `twice` it is watched for as long again, and judged by the last 0.3 s.
struct ClampProbe {
  bool holds = false;
  double unloaded = 0.0;  ///< N of the clamp before gravity, N
  double force = 0.0;     ///< … and 0.3 s after gravity is full, N
  double slope = 0.0;     ///< Δh/w of the pressure centres then, dimensionless
  double lift = 0.0;      ///< vertical part of the normal force at the right jaw over N, then
  double along = 0.0;     ///< share of the friction there that is vertical, then
  double creep = 0.0;     ///< mean speed of the fall over the last 0.3 s, m/s
  double excess = 0.0;    ///< what its fall has gained in them, m/s (threshold.h); 0: not seen
};
ClampProbe probe_clamp(CaseRun& run, const ClampSetup& setup, const Accuracy& accuracy = {},
                       bool twice = false);

/// Where a search over `squeeze` begins and how it goes on (threshold.h), m.
struct ClampSearch {
  double guess = 0.0;
  double step = 0.0;                 ///< > 0, taken towards less
  double reach = 0.0;                ///< beyond this from the guess it gives up
  double width = 0.0;                ///< of the bracket
  double slope = Holding::kUnknown;  ///< of the excess, if it is known, 1/s
};

/// Clamps at either side of the threshold, found by a search over `squeeze`.
struct ClampThreshold {
  ClampProbe holds, fails;
  double squeeze = 0.0;  ///< of the clamp that holds, m
  double slope = 0.0;    ///< of the excess, 1/s
  int evaluations = 0;
  /// Forces under load, N; NaN when nothing was bracketed. The lower one is that of the failing clamp at
  /// the same moment, which goes on smoothly from those that hold, unless the box has left it by then:
  /// where it turns as it is loaded it gives at a fold, towards which the force falls as the root of the
  /// distance. No lower than where that root leads, through the last two that hold, if the fold is at the
  /// clamp that fails.
  double upper = 0.0, lower = 0.0;
  double middle() const { return 0.5 * (lower + upper); }
  double half() const { return 0.5 * std::abs(upper - lower); }
};
ClampThreshold clamp_threshold(CaseRun& run, ClampSetup setup, const ClampSearch& search,
                               const Accuracy& accuracy = {});

/// Motion of one body in the clamp: z and the angle of its rotation, from the start.
struct Pose {
  double height = 0.0;  ///< of the centre of mass, m
  double angle = 0.0;   ///< about y (the axis of the offset's couple), degrees
};
Pose pose_of(const Engine& engine, std::size_t body);

/// Records what the paper observes over time, and the box's fall and turn.
class ClampSeries {
 public:
  void sample(const Simulation& simulation);
  void add_to(CaseRun& run) const;

 private:
  std::vector<double> time_, kinetic_, slip_, height_, angle_;
};

/// Runs to `end`, sampling `samples` times from the present on.
void advance_sampled(Simulation& simulation, double end, int samples, ClampSeries& series);

}  // namespace stiction
