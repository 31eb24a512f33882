// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/needs.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "validation/core/case_run.h"
#include "validation/engine/protocol/manifest_words.h"

namespace stiction {

namespace {

// Thrown as soon as a problem is known; no exception of the library's, so that no case catches it.
struct Loaded {
  Problem problem;
};

class Asked : public Engine {
 public:
  void load(const Problem& problem, const Accuracy&) override { throw Loaded{problem}; }

  double time_step() const override { return 1.0; }
  std::uint64_t steps_done() const override { return 0; }
  void advance(std::uint64_t) override {}
  BodyMotion body(std::size_t) const override { return {}; }
  Energies energies() const override { return {}; }
  Momenta momenta() const override { return {}; }
  Settings settings() const override { return {}; }
  Cost cost() const override { return {}; }
  std::uint64_t state_hash() const override { return 0; }
};

constexpr bool Manifest::*kNothing = nullptr;

Manifest all_but(bool Manifest::*feature) {
  Manifest manifest;
  for (const ManifestWord& one : kManifestWords) manifest.*one.has = one.has != feature;
  return manifest;
}

// The problem of a case's first simulation on an engine with these features; none where it does not come
// to that.
std::optional<Problem> first_problem(const Case& which, const Manifest& manifest) {
  EngineKind kind;
  kind.name = "asked";
  kind.manifest = manifest;
  kind.make = [](const Settings&) { return std::make_unique<Asked>(); };
  CaseRun run(which, kind, {}, 1.0);
  try {
    which.run(run);
  } catch (const Loaded& loaded) {
    return loaded.problem;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> needs_of(const Case& which) {
  if (!which.variants.empty()) return {};  // a study of one engine, which has all that it needs
  // Most cases ask for nothing by themselves: then their problem says it all.
  std::optional<Problem> problem = first_problem(which, Manifest{});
  const bool asks = !problem;
  if (asks) problem = first_problem(which, all_but(kNothing));
  if (!problem) problem = first_problem(which, all_but(&Manifest::deformable));  // of rigid bodies
  if (!problem) return {};
  std::vector<std::string> words;
  for (const ManifestWord& one : kManifestWords) {
    const Manifest without = all_but(one.has);
    if (!missing(without, *problem).empty() || (asks && !first_problem(which, without))) {
      words.emplace_back(one.word);
    }
  }
  // Of convex bodies either word will do, so that neither is missed alone.
  Manifest no_meshes = all_but(&Manifest::meshes);
  no_meshes.convex_meshes = false;
  const bool is_told = std::find(words.begin(), words.end(), "meshes") != words.end();
  if (!is_told && !missing(no_meshes, *problem).empty()) words.emplace_back("convex_meshes");
  return words;
}

}  // namespace stiction
