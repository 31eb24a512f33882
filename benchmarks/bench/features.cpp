// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "benchmarks/track/measure/callgrind.h"
#include "benchmarks/track/measure/child.h"
#include "reports/screen/program.h"
#include "solver/demand.h"
#include "solver/step.h"

namespace stiction::bench {

namespace {

constexpr int kContacts = 100;
constexpr int kSteps = 4;

WorkloadFamily family_named(const std::string& name) {
  const std::vector<WorkloadFamily> families = family_catalog();
  return *std::find_if(families.begin(), families.end(),
                       [&](const WorkloadFamily& family) { return family.name == name; });
}

// A scene at rest that is set up in another way.
template <class SetUp>
Workload settled(const std::string& name, const SetUp& set_up) {
  WorkloadFamily family = family_named(name);
  family.make = [&, make = family.make](int contacts) {
    Setup setup = make(contacts);
    set_up(setup);
    return setup;
  };
  return settle(family, kContacts);
}

// The scene at rest, then a few steps with the options changed, so that they are warm too.
template <class Change>
Workload slab_with(const Change& change) {
  Workload work = settle(family_named("slab"), kContacts);
  change(work.options);
  for (int k = 0; k < kSteps; ++k) step(*work.scene, work.options, work.state, work.workspace);
  return work;
}

Workload post_correction(bool used) {
  return slab_with([&](Options& options) {
    options.pairs.gain = NormalGain::kPaper;
    options.pairs.post_correction = used;
  });
}

// On the level, where plates rest without friction too, and both builds come to the same state: on their slope
// each build's search would have something else to do.
Workload friction_memory(bool used) {
  return settled("slab", [&](Setup& setup) {
    setup.rule = used ? kTimedRule : "none";
    setup.description.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};
  });
}

Workload edge_contacts(bool used) {
  return slab_with([&](Options& options) { options.pairs.edges = used; });
}

Workload self_collision(bool used) {
  return settled("slab", [&](Setup& setup) {
    for (BodyDescription& body : setup.description.bodies) body.self_collision = used;
  });
}

// Without elasticity: as many point masses on the plane as the elastic box has contacts.
Workload elasticity(bool used) {
  return settled("plane", [&](Setup& setup) {
    if (used) return;
    BodyDescription& body = setup.description.bodies[0];
    const Eigen::Matrix3Xd all = body.mesh.vertices;
    const double below = all.row(2).minCoeff();
    Eigen::Index kept = 0;
    for (Eigen::Index v = 0; v < all.cols(); ++v) {
      if (all(2, v) == below) body.mesh.vertices.col(kept++) = all.col(v);
    }
    body.mesh.vertices.conservativeResize(3, kept);
    body.mesh.tetrahedra.resize(4, 0);
    body.point_mass = 1e-3;
  });
}

Workload timing(bool) {
  return slab_with([](Options&) {});
}

}  // namespace

std::vector<OptionalFeature> optional_features() {
  return {{"post-correction", "post-correction of the paper's normal forces", post_correction},
          {"friction-memory", "friction memory (rule none / stored-vector)", friction_memory},
          {"edge-contacts", "contacts of crossing edges, where none cross", edge_contacts},
          {"self-collision", "self-collision of both plates", self_collision},
          {"elasticity", "elasticity (point masses / a box)", elasticity},
          {"timing", "timing of the phases", timing}};
}

std::optional<std::vector<FeatureCost>> measure_features(
    std::string& why_not, const std::function<void(const std::string&)>& next) {
  if (!track::has_program("valgrind")) {
    why_not = "valgrind is not installed";
    return {};
  }
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::vector<FeatureCost> costs;
  for (const OptionalFeature& feature : optional_features()) {
    if (next) next("optional feature: " + feature.name);
    const auto count = [&](const std::string& program, const std::string& use) {
      return track::count_instructions(program + " cannot be counted",
                                       {(folder / program).string(), feature.name, use},
                                       {"--toggle-collect=stiction::bench::measured_steps*"}) /
             kSteps;
    };
    try {
      costs.push_back({feature.name, feature.title, count("step_without_" + feature.name, "unused"),
                       count("step_with_all", "unused"), count("step_with_all", "used")});
    } catch (const track::TrackError& error) {
      why_not = error.what();
      return {};
    }
  }
  return costs;
}

[[gnu::noinline]] void measured_steps(Workload& work, int steps, PhaseSeconds* clock) {
  work.workspace.phase_seconds = clock;
  for (int k = 0; k < steps; ++k) step(*work.scene, work.options, work.state, work.workspace);
}

int run_step_program(int argc, char** argv) {
  const std::vector<OptionalFeature> features = optional_features();
  const std::string name = argc == 3 ? argv[1] : "", use = argc == 3 ? argv[2] : "";
  const auto feature = std::find_if(features.begin(), features.end(),
                                    [&](const OptionalFeature& one) { return one.name == name; });
  if (feature == features.end() || (use != "used" && use != "unused")) {
    throw InputError("it needs the name of a feature and 'used' or 'unused'");
  }
  Workload work = feature->prepare(use == "used");
  PhaseSeconds seconds{};
  measured_steps(work, kSteps, name == "timing" && use == "used" ? &seconds : nullptr);
  show_line(fmt::format("{:016x}", hash_of(work.state)));
  return 0;
}

}  // namespace stiction::bench
