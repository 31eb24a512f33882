// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// What a set of records comes to.
struct Tally {
  std::size_t pass = 0;  ///< records, as are the next six
  std::size_t fail = 0;
  std::size_t shortfall = 0;
  std::size_t refuted = 0;
  std::size_t error = 0;
  std::size_t not_applicable = 0;
  std::size_t information = 0;
  double cpu_seconds = 0.0;           ///< s, summed
  std::uint64_t steps = 0;            ///< time steps, summed
  std::uint64_t contact_updates = 0;  ///< summed

  void add(const Record& record);
  std::size_t records() const {
    return pass + fail + shortfall + refuted + error + not_applicable + information;
  }
};

Tally tally_of(const std::vector<Record>& records);

/// "11 pass, 1 fail, 3 expected shortfalls, 2 refuted, 0 errors, 2 not applicable, 1 for
/// information".
std::string verdicts_text(const Tally& tally);

/// "CPU 3.21 s, 12,345 steps, 98,765 contact updates".
std::string cost_text(const Tally& tally);

}  // namespace stiction
