// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "validation/core/runner.h"

/// For the tests of this folder.
namespace stiction::test {

/// A small problem without a mistake; line numbers in tests are of this text.
inline constexpr const char* kProblem = R"(title = "a point on a ramp"
duration = 0.1
gravity = [0, 0, -10]

[engine]
dt = 1e-3

[[obstacle]]
name = "ramp"
slope_deg = 20
friction = 0.5

[[body]]
name = "point"
shape = "point"
mass = 2.0
rests_on = "ramp"

[[check]]
observable = "speed"
expected = 0.0
tolerance = 1e-12
reason = "it sticks"
)";

/// A text in which `to` stands for the first `from`, which is there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("there is no '" + from + "'");
  return text.replace(at, from.size(), to);
}

/// A folder with a problem's file in it.
class UserProblem : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "user_problem_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text) {
    const std::filesystem::path file = folder_ / "ramp.toml";
    std::ofstream(file) << text;
    return file;
  }

  /// The problem with `from` replaced by `to`.
  static std::string edited(const std::string& from, const std::string& to) {
    return replaced(kProblem, from, to);
  }

  static Record run(const Case& one) {
    return run_job({one, find_engine("stiction"), one.variants.front()}, 1.0);
  }

  std::filesystem::path folder_;
};

}  // namespace stiction::test
