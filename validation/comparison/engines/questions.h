// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace stiction {

/// How the answer of an engine to a question is told: always how far it is from the right one.
enum class Answer {
  kMagnitude,  ///< |value|, in its unit: creep
  kDegrees,    ///< value − expected
  kRelative,   ///< (value − expected)/expected
  kCount,      ///< value − expected, a whole number
  kValue       ///< the value itself, beside what is expected: a critical μ
};

/// What `compare engines` asks: one check of one neutral case.
struct Question {
  std::string id;         ///< of its column and its records: engines/<id>
  std::string heading;    ///< of its column, a few letters
  std::string words;      ///< what is asked, for people
  std::string case_name;  ///< a neutral case
  std::string quantity;   ///< of its checks
  Answer answer = Answer::kRelative;
  bool quick = false;  ///< asked with --quick
  bool curve = false;  ///< asked along the ladder of efforts: the case lasts the same for all
};

/// All of them, in the order of the columns.
const std::vector<Question>& engine_questions();

}  // namespace stiction
