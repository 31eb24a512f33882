// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/process/pipe.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string_view>

#include "reference/process/child.h"

namespace stiction::reference {

void fail(const std::string& what, int number) {
  throw ChildError(what + ": " + std::strerror(number));
}

Pipe::Pipe() {
  if (pipe2(end_.data(), O_CLOEXEC) != 0) fail("no pipe to a child process", errno);
}

Pipe::~Pipe() {
  close_end(0);
  close_end(1);
}

void Pipe::close_end(std::size_t which) {
  if (end_[which] >= 0) close(end_[which]);
  end_[which] = -1;
}

std::vector<char*> environment_of_child() {
  constexpr std::string_view kNotPassedOn = "STICTION_RUN_FILE=";
  std::vector<char*> variables;
  for (char** one = environ; *one != nullptr; ++one) {
    if (!std::string_view(*one).starts_with(kNotPassedOn)) variables.push_back(*one);
  }
  variables.push_back(nullptr);
  return variables;
}

int Deadline::wait() const {
  if (std::isinf(seconds_)) return -1;
  return static_cast<int>(std::ceil(1e3 * std::clamp(left(), 0.0, 1e3)));
}

double Deadline::left() const {
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start_;
  return seconds_ - gone.count();
}

}  // namespace stiction::reference
