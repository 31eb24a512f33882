// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reports/record/record.h"
#include "reports/screen/screen.h"

namespace stiction {

/// A question that a comparison answers, and who answered it best.
struct Placing {
  std::string question;        ///< "creep, 7 scenes"
  std::string rule, contacts;  ///< who
  std::string figure;          ///< "2.1e-13 m/s", "14 of 14 in 2 steps"
  std::string cost;  ///< "2.4 ×": friction of a contact over the fixed point's; "–" when not timed
  std::string paper;  ///< the paper's fixed point on its own contacts; "–" when not compared
};

/// Of each question that these records answer the best, or the best `places` where there are as
/// many; one that failed is never among them. Ties go to what costs less.
std::vector<Placing> placings(const std::vector<Record>& records, std::size_t places);

/// What a comparison found on one screen: who wins each question, what failed, with the command
/// that runs it again. `found` is what findings() says.
std::string comparison_summary(const std::vector<Record>& records, const Record& found,
                               const Screen& screen);

/// "./stiction compare --scene X --rule R --contacts C": runs that record again.
std::string compare_command(const Record& record);

}  // namespace stiction
