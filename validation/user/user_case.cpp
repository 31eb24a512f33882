// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_case.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <utility>

#include "reports/text/text.h"
#include "validation/user/user_run.h"

namespace stiction {

namespace {

namespace fs = std::filesystem;

UserCase read_one(const fs::path& file, const std::string& name) {
  std::ifstream stream(file);
  if (!stream || fs::is_directory(file)) {
    throw InputError("cannot read '" + one_line(file.string()) + "'");
  }
  UserCase out;
  out.which.name = "user/" + name;
  out.which.title = file.filename().string();
  try {
    auto user = std::make_shared<UserProblem>(user_problem(stream, file));
    if (!user->title.empty()) out.which.title = user->title;
    out.which.variants = {user->settings};
    out.which.run = [user](CaseRun& run) { run_user_problem(run, *user); };
    out.problem = std::move(user);
  } catch (const NotMeshed& error) {
    out.error = error.what();
    out.which.variants = {Settings{}};
    out.which.run = [error](CaseRun&) { throw error; };
  }
  return out;
}

// The last `parts` of a path, without its ending: "b/ramp" of /a/b/ramp.toml.
std::string end_of(const fs::path& path, int parts) {
  fs::path name = path.stem();
  fs::path folder = path.parent_path();
  for (int k = 1; k < parts && folder.has_filename(); ++k, folder = folder.parent_path()) {
    name = folder.filename() / name;
  }
  return one_line(name.string());
}

std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<fs::path> paths;
  std::map<fs::path, std::string> seen;
  for (const std::string& file : files) {
    std::error_code no_path;  // a pipe has none: the shell's <(…)
    paths.push_back(fs::weakly_canonical(file, no_path));
    if (no_path) paths.back() = file;
    const auto [before, first] = seen.emplace(paths.back(), file);
    if (!first) throw InputError(fmt::format("the problem '{}' is given twice", one_line(file)));
  }
  std::vector<int> parts(files.size(), 1);
  std::vector<std::string> names(files.size());
  for (bool apart = false; !apart;) {
    std::map<std::string, int> count;
    for (std::size_t k = 0; k < files.size(); ++k) {
      names[k] = end_of(paths[k], parts[k]);
      ++count[names[k]];
    }
    apart = true;
    for (std::size_t k = 0; k < files.size(); ++k) {
      if (count[names[k]] == 1 || end_of(paths[k], parts[k] + 1) == names[k]) continue;
      ++parts[k];
      apart = false;
    }
  }
  return names;
}

}  // namespace

std::vector<UserCase> read_user_problems(const std::vector<std::string>& files) {
  const std::vector<std::string> names = names_of(files);
  std::vector<UserCase> cases;
  for (std::size_t k = 0; k < files.size(); ++k) cases.push_back(read_one(files[k], names[k]));
  return cases;
}

Case read_user_problem(const fs::path& file) {
  return read_user_problems({file.string()}).front().which;
}

}  // namespace stiction
