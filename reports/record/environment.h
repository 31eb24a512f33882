// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reports/record/record.h"

namespace stiction {

/// Revision and toolchain of this build, the machine it runs on, and the present UTC time.
Environment current_environment();

}  // namespace stiction
