// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "validation/engine/problem.h"

namespace stiction {

/// A problem as the protocol writes it (protocol/README.md). Throws InputError with one sentence for
/// what no engine can simulate: numbers that are not finite, a mass, size or radius that is not
/// above 0, a negative μ, a normal or axis that is not of unit length, loads on bodies that are not
/// there.
nlohmann::json problem_json(const Problem& problem);

/// The same as text, for people: of a mesh the numbers of vertices and tetrahedra, and its box.
std::string problem_summary(const Problem& problem);

nlohmann::json accuracy_json(const Accuracy& accuracy);

}  // namespace stiction
