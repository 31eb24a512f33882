// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "reports/recording/frames.h"
#include "validation/engine/engine.h"

namespace stiction {

/// Takes frames of a simulation at even times: the surfaces that the engine shows, the contacts
/// that carry a force, the direction of gravity.
class Recorder {
 public:
  static constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

  /// Keeps the names, the gravity and the obstacles of the problem; those that move are not drawn.
  explicit Recorder(const Problem& problem);

  /// Takes the first frame now, and one every `interval` (s) from then on. An engine that shows no
  /// surface is not recorded.
  void start(const Engine& engine, double interval);

  /// The step at whose end the next frame is due; far away when none is.
  std::uint64_t due_step() const { return due_step_; }

  /// Takes a frame. The recording ends where something has flown off: quantised in a box of that
  /// size, the rest of the scene would be lost.
  void take(const Engine& engine);

  bool has_frames() const { return !recording_.frames.empty(); }
  Recording recording() && { return std::move(recording_); }

 private:
  Recording recording_;
  Gravity gravity_;
  std::vector<std::vector<Eigen::Index>> shown_;  // vertices of each body that its surface names
  Vec3 centre_ = Vec3::Zero();                    // of the first frame, m
  double size_ = 0.0;                             // … and its diagonal, m
  double begin_ = 0.0;                            // s
  double interval_ = 0.0;                         // s
  std::uint64_t taken_ = 0;
  std::uint64_t due_step_ = kNever;
};

}  // namespace stiction
