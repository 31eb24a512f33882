// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/record/record.h"

namespace stiction {

/// The slip at which [Lazarevych2009] calls a contact static, m/s.
inline constexpr double kStaticSlip = 1e-9;

/// Something that does not happen in a figure of the paper; `source` names the figure.
inline Claim zero_claim(const std::string& source, const std::string& quantity,
                        const std::string& unit, const std::string& statement, double tolerance,
                        const std::string& reason) {
  return {.quantity = quantity,
          .unit = unit,
          .statement = statement,
          .formula = quantity + " = 0",
          .source = source,
          .kind = ReferenceKind::kExternal,
          .expected = 0.0,
          .tolerance = tolerance,
          .reason = reason};
}

}  // namespace stiction
