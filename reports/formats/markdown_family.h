// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/text/family.h"

namespace stiction {

/// The Markdown section of one case family: for each claim its formula, reference and the
/// tolerance's derivation, then a table of all checks of that claim; notes; a table of what the
/// runs cost.
std::string markdown_family(const Family& family);

}  // namespace stiction
