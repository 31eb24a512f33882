// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stiction {

/// The number in `unit` that a text like "5 MPa", "20 deg" or "-3 mm" says; none where it is no
/// number with a unit, or its unit measures something else. `unit` is one of the suite's own: "m",
/// "Pa", "deg", …
std::optional<double> quantity_in(std::string_view unit, std::string_view text);

/// As reports write it: "°" for "deg".
std::string shown_unit(const std::string& unit);

/// What may stand behind a number for this unit, e.g. {"m", "mm", "cm", "um", "km"}; empty for a
/// unit that has no others.
std::vector<std::string_view> units_like(std::string_view unit);

}  // namespace stiction
