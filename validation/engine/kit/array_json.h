// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace stiction::kit {

/// An array of numbers in a message: [1.5, 2], vectors [[0, 0, 1], …] one after the other, or
/// {"f64": "…"}, base64 of little-endian doubles.
/// Throws std::runtime_error with one sentence that names `what` when it is neither.
std::vector<double> read_array(const nlohmann::json& value, const std::string& what);

/// A whole number from 0 to `most`, written as one: 3, not 3.0.
/// Throws std::runtime_error with one sentence that names `what` when it is anything else.
std::uint64_t read_count(const nlohmann::json& value, const std::string& what,
                         std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// As numbers up to 48 of them, in base64 beyond that: a mesh is read as fast as it is written.
nlohmann::json write_array(const double* values, std::size_t count);

}  // namespace stiction::kit
