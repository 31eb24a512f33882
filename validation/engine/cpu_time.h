// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace stiction {

/// CPU time of this thread so far, s: what others do on a shared machine counts little in it.
double thread_cpu_seconds();

}  // namespace stiction
