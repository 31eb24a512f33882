// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_case.h"

#include <fstream>

#include "validation/user/user_problem.h"

namespace stiction {

Case read_user_problem(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file)) {
    throw InputError("cannot read '" + file.string() + "'");
  }
  Case one;
  one.name = "user/" + file.stem().string();
  one.title = file.filename().string();
  try {
    UserProblem user = user_problem(stream, file);
    if (!user.title.empty()) one.title = user.title;
    one.variants = {user.settings};
    one.run = [user = std::move(user)](CaseRun& run) { run_user_problem(run, user); };
  } catch (const NotMeshed& error) {
    one.variants = {Settings{}};
    one.run = [error](CaseRun&) { throw error; };
  }
  return one;
}

}  // namespace stiction
