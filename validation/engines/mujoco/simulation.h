// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mujoco/mujoco.h>

#include <cstddef>
#include <cstdint>
#include <memory>

#include "validation/engine/kit/stiction_engine.h"

namespace stiction_mujoco {

struct ModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, ModelDeleter>;
using Data = std::unique_ptr<mjData, DataDeleter>;

/// All that the future depends on, and how much room the contacts had.
struct Saved {
  Data data;
  int contact_room, row_room;
};

/// One problem in MuJoCo. Geom o is obstacle o, geom obstacle_count + b body b; body b is MuJoCo's
/// b + 1, with entries 7 b … of qpos and 6 b … of qvel.
class Simulation {
 public:
  /// Reads settings; throws, or ends the call by stiction_lacks.
  explicit Simulation(const stiction_problem& problem);

  double time_step() const { return model_->opt.timestep; }  ///< s
  double time() const { return data_->time; }                ///< s
  void advance(std::uint64_t steps);
  void body(std::size_t index, stiction_body_state& state) const;
  /// Those of the last step: found at its start, with the forces over it and the slip at its end.
  std::size_t contacts(stiction_contact* contacts, std::size_t room) const;
  Saved* save() const;
  void restore(const Saved& saved);

 private:
  void find_contacts();
  void apply_loads();
  void refuse_divergence() const;
  stiction_contact contact(int index) const;

  const stiction_problem& problem_;
  Model model_;
  Data data_;
};

}  // namespace stiction_mujoco
