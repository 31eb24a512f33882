// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "validation/core/case.h"

namespace stiction {

/// What an engine must have for a case, in the words of the protocol's manifest ("boxes",
/// "contacts"; manifest_words.h): found by starting the case on an engine that tells what it is asked
/// for and simulates nothing. Nothing of a study of one engine. What a case asks for after its first simulation has begun is not seen.
std::vector<std::string> needs_of(const Case& which);

}  // namespace stiction
