// SPDX-License-Identifier: GPL-3.0-or-later
// A plant for validation/validate_test.sh: what is expected to fall short meets its claim, since
// the method `paper` is the method `quiet` under another name. The table of expectations must
// object.
#include "validation/engines/stiction/stiction_method.h"

namespace stiction {

void unplanted_read_method(SettingsReader& reader, Options& options);

void read_method(SettingsReader& reader, Options& options) {
  unplanted_read_method(reader, options);
  const double time_step = options.time_step;
  const Settings none;
  SettingsReader quiet(none);
  unplanted_read_method(quiet, options);
  options.time_step = time_step;
}

}  // namespace stiction
