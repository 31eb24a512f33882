// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/user_screen.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "reports/record/record_store.h"
#include "reports/record/whole_file.h"
#include "reports/screen/program.h"
#include "reports/screen/screen.h"
#include "reports/text/text.h"
#include "validation/engine/protocol/problem_json.h"
#include "validation/user/preview.h"

namespace stiction {

namespace {

// The problem of a job; none where it could not be meshed.
const UserProblem* problem_of(const std::vector<UserCase>& problems, const Job& job) {
  const auto found = std::find_if(problems.begin(), problems.end(), [&](const UserCase& one) {
    return one.which.name == job.which.name;
  });
  return found == problems.end() ? nullptr : found->problem.get();
}

// What the page's program draws.
void write_problems(const std::vector<UserCase>& problems, const std::filesystem::path& folder) {
  nlohmann::json all = nlohmann::json::array();
  for (const UserCase& one : problems) {
    all.push_back({{"case", one.which.name},
                   {"title", one.which.title},
                   {"problem", nlohmann::json::parse(problem_summary(one.problem->problem))}});
  }
  std::error_code none;  // what is wrong shows when the file is written
  std::filesystem::create_directories(folder, none);
  write_whole(folder / "problems.json",
              all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace

void show_problems(const std::vector<UserCase>& problems, const std::vector<Job>& jobs,
                   const std::filesystem::path& out) {
  for (const UserCase& one : problems) {
    if (!one.problem) throw InputError(one.error);
  }
  const std::size_t width = screen_of(STDOUT_FILENO).width;
  for (const Job& job : jobs) {
    const UserProblem* const user = problem_of(problems, job);
    if (user == nullptr) continue;
    show_line(fmt::format("{}: {}", job.which.name, job.which.title));
    show(explained(*user, width));
    show(bullet(fmt::format("engine {}: {}", job.engine.name,
                            estimate_text(estimate(*user, job.engine, job.settings, job.finer))),
                width));
  }
  write_problems(problems, out / "check-only");
  tell_run_folder(out / "check-only");
}

void tell_long_runs(const std::vector<UserCase>& problems, const std::vector<Job>& jobs) {
  constexpr double kLong = 10.0;  // s
  for (const Job& job : jobs) {
    const UserProblem* const user = problem_of(problems, job);
    if (user == nullptr) continue;
    try {
      const UserEstimate found = estimate(*user, job.engine, job.settings, job.finer);
      if (found.cpu_seconds >= kLong) tell(job.which.name + ": " + estimate_text(found));
    } catch (const std::exception&) {
      continue;  // its record will say why it cannot run
    }
  }
}

}  // namespace stiction
