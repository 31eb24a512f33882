// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/screen/program.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "reports/screen/screen.h"
#include "reports/text/exit_code.h"
#include "reports/text/text.h"

namespace stiction {

namespace {

// Unlike a signal that is ignored, one that is handled is not ignored by the programs started from
// here.
void pass_over(int) {}

int could_not_run(const std::string& name, const std::string& sentence) {
  tell(name + ": " + sentence);
  return kCouldNotRun;
}

// Why the standard output could not be written to, which a write after the one that failed tells.
int output_error() {
  std::clearerr(stdout);
  errno = 0;
  static_cast<void>(std::fputc('\n', stdout));
  return std::fflush(stdout) == 0 || errno == 0 ? EIO : errno;
}

int not_shown(const std::string& name) {
  const int error = output_error();
  if (error == EPIPE) return kCouldNotRun;
  return could_not_run(name, std::string("what it says could not be written to the standard "
                                         "output: ") +
                                 std::strerror(error));
}

}  // namespace

void show(std::string_view text) {
  const std::string lines = printable(text, screen_of(STDOUT_FILENO).colour);
  std::fwrite(lines.data(), 1, lines.size(), stdout);
}

void show_line(std::string_view text) { show(one_line(text) + "\n"); }

void tell(std::string_view text) {
  const std::string line = one_line(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

int run_program(const std::string& name, const ProgramBody& body) {
  std::signal(SIGPIPE, pass_over);
  std::signal(SIGXFSZ, pass_over);
  try {
    const int code = body();
    const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    return written ? code : not_shown(name);
  } catch (const std::system_error& error) {
    return std::ferror(stdout) != 0 ? not_shown(name) : could_not_run(name, error.what());
  } catch (const std::bad_alloc&) {
    return could_not_run(name, "memory ran out");
  } catch (const std::exception& error) {
    return could_not_run(name, error.what());
  } catch (...) {
    return could_not_run(name, "it was ended by what is no error of its own");
  }
}

}  // namespace stiction
