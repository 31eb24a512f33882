// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "validation/comparison/figures.h"

namespace stiction {

/// What the records of a comparison say in plain words, as the notes of a record of its own
/// ("findings"): computed from them, so that it changes when they do. What was not compared in this
/// run is not spoken of.
Record findings(const std::vector<Record>& records);

/// Median over the scenes of what divides the fixed point's final creep on the paper's contacts;
/// NaN where it was not compared.
struct CreepDivided {
  double by_rule = 0.0;      ///< the stored vector on the same contacts
  double by_contacts = 0.0;  ///< the fixed point on quiet contacts
  double by_both = 0.0;
};
CreepDivided creep_divided(const Figures& figures);

// The parts; each may have nothing to say.
using Sentences = std::vector<std::string>;
Sentences fixed_point_against_secant(const Figures& figures);
Sentences rules_that_beat_both(const Figures& figures);
Sentences rules_within_fifty_steps(const Figures& figures);
Sentences frozen_steps(const Figures& figures);
Sentences rule_or_contacts(const Figures& figures);
Sentences loads_of_the_cone(const Figures& figures);
Sentences what_stops_the_vector(const Figures& figures);
Sentences from_sliding(const Figures& figures);
Sentences poses_at_rest(const Figures& figures);
Sentences hard_conditions(const Figures& figures);
Sentences gain_sweeps(const Figures& figures);
Sentences pareto_front(const Figures& figures);
Sentences builds_beside(const Figures& figures);

}  // namespace stiction
