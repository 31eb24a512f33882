// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled into each program (stiction_program of the CMakeLists.txt at the top), not into a library:
// no header, as there is nothing to call. A program that was started without one of its standard
// streams would give its number to the first file it opens, and what it prints would go there.
#include <fcntl.h>
#include <unistd.h>

namespace {

// Numbers are given out from the lowest that is free, so that each gets its own. Input ends at once,
// errors go nowhere, and output cannot be written to, so that what was to be shown is no success.
[[gnu::constructor]] void make_sure_of_standard_streams() {
  const int modes[] = {O_RDONLY, O_RDONLY, O_WRONLY};
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", modes[stream]));
  }
}

}  // namespace
