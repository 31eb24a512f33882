// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/screen/screen.h"
#include "validation/comparison/engines/answers.h"

namespace stiction {

/// What the answers say on one screen: who holds at which cost, who does not and by how much, where
/// others are closer or cheaper than our own solver, and who broke.
std::string engine_summary(const EngineAnswers& answers, const Screen& screen);

}  // namespace stiction
