// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gsl/gsl_errno.h>

namespace stiction::reference {

/// From the first call on GSL tells errors by status codes alone, for the life of the program: its
/// default handler ends it. The handler is global, so it is never put back while another thread may
/// still be solving.
inline void quiet_gsl() {
  static gsl_error_handler_t* const before = gsl_set_error_handler_off();
  static_cast<void>(before);
}

}  // namespace stiction::reference
