// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

#include "solver/contact/contact_order.h"
#include "solver/contact/contacts.h"
#include "solver/contact/edge_contacts.h"
#include "solver/contact/pair_contacts.h"
#include "solver/contact/pair_options.h"
#include "solver/depth/consistent_scratch.h"
#include "solver/depth/outlets.h"
#include "solver/detection/box_arrays.h"
#include "solver/detection/element_boxes.h"
#include "solver/detection/spatial_hash.h"
#include "solver/detection/triangle_balls.h"
#include "solver/elasticity/element_shares.h"
#include "solver/parallel/team_choice.h"
#include "solver/state.h"

namespace stiction {

/// The phases of a step, in order.
enum class Phase { kForces, kPredict, kDetect, kDepth, kNormalForce, kFriction, kIntegrate };
inline constexpr std::array<const char*, 7> kPhaseNames = {
    "forces", "predict", "detect", "depth", "normal force", "friction", "integrate"};

/// Wall-clock time spent in each phase, s.
using PhaseSeconds = std::array<double, kPhaseNames.size()>;

/// Adds the life of the object to a phase's time; does nothing when there is no clock to add to.
class PhaseTimer {
 public:
  PhaseTimer(PhaseSeconds* seconds, Phase phase)
      : total_(seconds ? &(*seconds)[static_cast<std::size_t>(phase)] : nullptr) {
    if (total_) start_ = std::chrono::steady_clock::now();
  }
  ~PhaseTimer() {
    if (!total_) return;
    *total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double* total_;
  std::chrono::steady_clock::time_point start_;
};

/// Scratch memory of the search for pair contacts, and its lists of candidates, which outlive a
/// step (pair_candidates.h).
struct PairSearch {
  std::vector<Vec3> predicted;  ///< x*, per vertex, m

  std::uint64_t scene = 0;      ///< serial number of the scene that the lists are of
  Real skin = 0.0;              ///< m
  std::vector<Vec3> reference;  ///< x* that a body's lists were made at, per vertex, m
  std::vector<Real> moved;      ///< per body: bound on |x* − reference| of its vertices, m
  std::vector<double> path;     ///< per body: bound on how far a vertex has gone in this scene, m,
                                ///< summed from one x* to the next
  double stride = 0.0;          ///< the longest way of a vertex from the last x* to this one, m
  double strides = 0.0;         ///< summed over the steps of this scene, m
  std::vector<Real> farthest, longest;  ///< scratch of those two, per body
  std::vector<char> renewed;            ///< per body: its lists are made anew in this step
  std::vector<Box3> box;                ///< per body
  std::vector<Box3> overlap;            ///< per body: where it can meet others
  std::vector<int> order;               ///< bodies along x
  struct Candidate {
    std::int32_t vertex, element;  ///< that it may be in
  };
  /// Vertices of one body that may be in tetrahedra of another.
  struct Meeting {
    std::int32_t body, other;  ///< whose tetrahedra, whose vertices
    Box3 common;               ///< m
    std::size_t begin, end;    ///< in `found`
  };
  std::vector<Meeting> meeting;         ///< by body, then other
  std::vector<Candidate> found;         ///< of each meeting, by element
  std::vector<std::int32_t> candidate;  ///< the same elements, by vertex, then element
  /// The places in a list of those of which something else may be found in the next steps: in so many, as long
  /// as `strides` isn't above `until`, m (lasting.h).
  struct Awake {
    std::vector<std::uint32_t> place;
    int steps = 0;
    double until = 0.0;
  };
  std::vector<std::int32_t> holds;  ///< of each group: the element that holds its vertex, or −1
  bool found_same = false;          ///< of these lists, what the step before found was found again
  /// The candidates of one key and, once it is in contact, the triangles that may be nearest.
  struct alignas(64) Group {
    ContactKey key;
    std::int32_t candidate_begin, candidate_end;
    std::int32_t near_begin = 0, near_end = 0;  ///< in `near`
    std::int32_t near_element = -1;  ///< while the vertex is in this one; −1: not listed yet
    std::int8_t listings = 0;        ///< how often they have been listed since the lists were made
    // Steps in a row with the same verdict, and on the same face, since it was last asked for how long.
    std::int8_t held = 0, stayed = 0;
    /// While it stays on its face: whether faces that are nearer are passed over, on which it can't rest;
    /// −1: not known.
    std::int8_t passes_over = -1;
    Real near_reach = 0.0;  ///< m: up to this distance at the reference `near` names all
    /// What the test of the candidates has found, and will find while the paths of both bodies together
    /// are below `holds_until`, m: ≥ 0, the element that holds the vertex, and held it before; −2 − e:
    /// none, and it was with e in the last step; −1: none, and it was with none.
    std::int32_t verdict = std::numeric_limits<std::int32_t>::max();
    /// The vertex's face, which it still is while the paths are below `stays_until`, m
    /// (depth/staying.h).
    std::int32_t stays_on = -1;
    double holds_until = -std::numeric_limits<double>::infinity();
    double stays_until = -std::numeric_limits<double>::infinity();
  };
  static_assert(sizeof(Group) == 64);
  std::vector<Group> group;  ///< by key
  Awake group_awake;
  struct Near {
    Real distance;  ///< of the group's vertex at the reference, m
    std::int32_t triangle;
  };
  std::vector<Near> near;          ///< of each group: by distance, then triangle
  std::vector<Outlets> outlets;    ///< per vertex, once consistent depth has asked for them
  std::vector<TriangleBall> ball;  ///< per triangle; infinite while its body can meet no other

  // Scratch of making lists: what they were before, a meeting's elements and vertices, and where each
  // vertex's candidates end.
  std::vector<Meeting> old_meeting;
  std::vector<Candidate> old_found;
  std::vector<Group> old_group;
  std::vector<Near> old_near;
  ElementBoxes element_boxes;               ///< of one body, where it can meet another
  std::vector<std::int32_t> common_vertex;  ///< of a meeting
  std::vector<Box3> vertex_block;  ///< of several surface vertices in turn, at the reference
  SpatialHash hash;
  std::vector<std::int32_t> candidate_end;

  std::vector<Box3> travel;  ///< per body: of its vertices in a step, m
  /// Two bodies that a step can carry through each other; `travel` is 0 while there are none. With
  /// PairFace::kOpposed alone, as the next.
  struct Outrun {
    std::int32_t body = -1, other = -1;
    Real travel = 0.0;  ///< of one against the other in a step, m
    Real width = 0.0;   ///< least width of an element of either, m
  };
  Outrun outrun;
  /// The first contact so deep that it can't be told from a passage (note_too_deep); `depth` is 0
  /// while there is none. With PairFace::kOpposed alone, which knows where a vertex came from.
  struct TooDeep {
    std::int32_t vertex = -1, body = -1;
    Real depth = 0.0;  ///< m
    Real width = 0.0;  ///< least width of an element of the two, m
  };
  TooDeep too_deep;

  /// The options that what is known of contacts, faces, edges and partners depends on.
  struct KnownFor {
    PairFace face = PairFace::kOpposed;
    PairWeights weights = PairWeights::kTetrahedron;
    PairKey key = PairKey::kBody;
    Real tie_margin = 0.0, border_margin = 0.0, hysteresis = 0.0;
    bool operator==(const KnownFor&) const = default;
  } known_for;
  /// Whether the next are of the present lists, or were of those before.
  bool edges_listed = false;
  /// Two sharp edges that may come to cross.
  struct EdgePair {
    ContactKey key;
    std::uint32_t body_a, body_b;
    /// While the paths of both bodies together are below this, m, they can't touch (edge_pair.h).
    double apart_until = -std::numeric_limits<double>::infinity();
    std::int8_t apart = 0;  ///< steps in a row in which they couldn't
  };
  std::vector<EdgePair> edge_candidate;  ///< in the order of their keys
  Awake edge_awake;                      ///< those that may touch
  BoxArrays edge_box;                    ///< of each sharp edge, at the reference
  // Scratch of listing those: what they were before, the meetings of a body with later ones, and of each
  // the other's edges that are near.
  std::vector<EdgePair> old_edge_candidate;
  struct EdgeMeeting {
    const Meeting* of;
    bool keeps;                      ///< its pairs of edges are as they were
    std::size_t begin = 0, end = 0;  ///< in `near_edge`
  };
  std::vector<EdgeMeeting> edge_meeting;
  std::vector<std::size_t> near_edge;
  BoxArrays near_edge_box;
  /// How two edges pass each other.
  struct EdgeCrossing {
    Real along_a, along_b;  ///< where, 0 … 1 from the first end
    Vec3 normal;            ///< n ∥ (direction of a) × (direction of b), out of b's body, unit
    Real gap;  ///< (point of a − point of b)·n, m; negative when they interpenetrate
  };
  /// Edges that touch, in the order of their keys: scratch.
  struct EdgeTouch {
    ContactKey key;
    EdgeCrossing crossing;
    bool outdone = false;  ///< by another, so that it counts for nothing
  };
  std::vector<EdgeTouch> edge_touch;
  std::vector<std::size_t> touch_counts;  ///< places of those that no other outdoes
  std::vector<std::uint64_t> touch_by_b;  ///< their places below their edges b, in this order
  std::vector<ContactKey> touch_key;      ///< of those that it was made of
  /// … of a part of the candidates, which a thread of a team looks at.
  struct EdgePart {
    std::vector<EdgeTouch> touch;
    std::vector<Vec3> start;  ///< x_t0 of the vertices at edges that were asked for, m
  };
  std::vector<EdgePart> edge_part;
};

/// What a sweep changed.
struct SweepChange {
  Real power = 0.0;  ///< Σ w |r|², r the change of a contact's force, W
  Real slip2 = 0.0;  ///< max (w |r|)², m²/s²: the slip that the sweep took away, squared
};

/// Of one contact, a record of four numbers as a Velocity is.
struct alignas(4 * sizeof(Real)) ForceChange {
  Vec3 force;  ///< N
  Real power;  ///< w |force|², W; of a change by a sweep alone
};

/// Scratch memory of the conjugate directions of friction forces, per contact.
struct ConjugateScratch {
  std::vector<ForceChange> change;     ///< r, of f by the last sweep
  std::vector<ForceChange> direction;  ///< p
  std::vector<SweepChange> of_chunk;   ///< of the chunks of the contacts' order
};

/// Scratch memory of a step, kept so that a warm step allocates nothing, and what the last step
/// did. Nothing in it is needed to continue from a State.
struct Workspace {
  std::vector<Force> force;        ///< per vertex, N: gravity and elasticity at _t0
  std::vector<Velocity> velocity;  ///< per vertex: v*, corrected in place to v_t1
  OneSidedContacts contacts;       ///< with obstacles, of the last step
  FrictionMemory memory;           ///< the memory being written
  PairContacts pairs;              ///< between bodies, of the last step
  FrictionMemory pair_friction;    ///< the memory being written
  EdgeContacts edges;              ///< between crossing edges, of the last step
  FrictionMemory edge_friction;    ///< the memory being written
  /// The statuses being written, of `contacts`, `pairs` and `edges`.
  std::vector<ContactStatus> ended, pair_ended, edge_ended;
  ConjugateScratch conjugate, pair_conjugate, edge_conjugate;
  std::vector<Real> load;  ///< per vertex: N_p, or Σ h_jp (see pair_normal_force.h)
  ContactOrder pair_order, obstacle_order, edge_order;  ///< in which forces act
  ElementShares shares;                                 ///< of the team, where there is one
  PairSearch search;
  ConsistentScratch consistent;
  std::uint64_t contact_updates = 0;      ///< summed over steps
  std::uint64_t sweeps = 0;               ///< of the friction phase, summed over steps
  PhaseSeconds* phase_seconds = nullptr;  ///< where to add times; null: nothing is timed
  /// Threads that do a step side by side, to the same bits; null: none but the caller's.
  const Team* team = nullptr;
  /// Decides before each step who does it, and says so in `team`; null: that stays as it was set. Outlives
  /// the workspace, and is of one simulation at a time. `run_phase` alone doesn't ask it.
  TeamChoice* team_choice = nullptr;
};

}  // namespace stiction
