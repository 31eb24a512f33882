// SPDX-License-Identifier: GPL-3.0-or-later
// A planted fault for validation/validate_test.sh: the friction iteration learns with the wrong
// sign. What is expected to fall short must not excuse it.
#include "validation/stiction_method.h"

namespace stiction {

void unplanted_read_method(SettingsReader& reader, Options& options);

void read_method(SettingsReader& reader, Options& options) {
  unplanted_read_method(reader, options);
  options.friction.gain = -options.friction.gain;
}

}  // namespace stiction
