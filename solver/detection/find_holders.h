// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/scene/scene.h"
#include "solver/state.h"
#include "solver/workspace.h"

namespace stiction {

/// Finds which of its candidates holds the vertex of each group: `PairSearch::holds`. What is known to last
/// is not asked again.
class FindHolders {
 public:
  /// `last` are the contacts of the last step. A vertex that is in the body stays in the element that held it
  /// while no weight there is below −`margin`. All must outlive it.
  FindHolders(const Scene& scene, const PairGeometry& last, Real margin, PairSearch& search);

  /// Of the groups from `begin` to before `end`.
  void operator()(std::size_t begin, std::size_t end) const;

  /// Of all, where `holds` is of the last step, whose contacts are all remembered. Returns whether anything
  /// else holds any vertex now.
  bool any_changes(const Team* team) const;

 private:
  class Tests;

  std::int32_t open_in(const PairSearch::Group& group) const;
  void ask_ahead(std::size_t old) const;

  const Scene& scene_;
  const PairGeometry& last_;
  Real margin_;
  PairSearch& search_;
  int width_;
};

}  // namespace stiction
