// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "validation/judge/expectation.h"

namespace stiction {

/// Where this project's solver is known to fall short of a case's claim. The rows stand in
/// validation/engines/stiction/expectations/, by family.
Expectations stiction_expectations();

}  // namespace stiction
