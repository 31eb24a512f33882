// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/measure/tree.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "benchmarks/track/measure/child.h"
#include "reports/screen/program.h"

namespace stiction::track {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShortLength = 12;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string git(const Project& project, const std::string& what, std::vector<std::string> words) {
  words.insert(words.begin(), {"git", "-C", project.root.string()});
  return demand_run(what, words);
}

// Options of the present build that change what is compiled, or how fast: as cmake's arguments.
std::vector<std::string> same_options(const fs::path& build) {
  std::ifstream cache(build / "CMakeCache.txt");
  if (!cache) throw TrackError(fmt::format("there is no build in {}", build.string()));
  std::vector<std::string> options;
  for (std::string line; std::getline(cache, line);) {
    for (const char* name :
         {"CMAKE_BUILD_TYPE", "CMAKE_CXX_COMPILER", "CMAKE_CXX_COMPILER_LAUNCHER",
          "CMAKE_CXX_FLAGS", "CMAKE_CXX_FLAGS_RELEASE", "CMAKE_EXE_LINKER_FLAGS",
          "STICTION_DEMANDS_ONLY", "STICTION_WARNINGS_AS_ERRORS"}) {
      if (line.rfind(std::string(name) + ":", 0) == 0) options.push_back("-D" + line);
    }
  }
  return options;
}

// Whether git takes the folder itself for a worktree: from one without a sound .git it goes up to the
// clone that the folder stands in, and would work there.
bool is_worktree(const fs::path& source) {
  if (!fs::exists(source / ".git")) return false;
  const Ended top = run({"git", "-C", source.string(), "rev-parse", "--show-toplevel"});
  std::error_code differ;
  return top.code == 0 && fs::equivalent(last_line(top.output), source, differ);
}

// Git's entries of worktrees in our folder that were removed by hand; those of others, which may stand
// on a disk that is not there just now, are theirs (so no `git worktree prune`).
void forget_lost_trees(const Project& project) {
  const fs::path ours = fs::weakly_canonical(project.work);
  constexpr std::string_view kPath = "worktree ";
  for (const std::string& line : lines_of(
           git(project, "git cannot list its worktrees", {"worktree", "list", "--porcelain"}))) {
    if (!line.starts_with(kPath)) continue;
    const fs::path path = line.substr(kPath.size());
    if (path.parent_path() != ours || fs::exists(path)) continue;
    git(project, "git cannot forget " + path.string(),
        {"worktree", "remove", "--force", "--force", path.string()});
  }
}

void check_out(const Project& project, const std::string& commit, const fs::path& source) {
  const std::string what = "git cannot check out " + commit.substr(0, kShortLength);
  const bool is_there = is_worktree(source);
  if (!is_there) fs::remove_all(source);  // what is left of one
  forget_lost_trees(project);
  if (!is_there) {
    fs::create_directories(source.parent_path());
    git(project, what, {"worktree", "add", "--force", "--detach", source.string(), commit});
    return;
  }
  demand_run(what,
             {"git", "-C", source.string(), "checkout", "--quiet", "--force", "--detach", commit});
}

}  // namespace

void forget_git_variables() {
  for (const std::string& name : lines_of(run({"git", "rev-parse", "--local-env-vars"}).output)) {
    unsetenv(name.c_str());
  }
}

std::string commit_of(const Project& project, const std::string& reference) {
  const Ended ended = run({"git", "-C", project.root.string(), "rev-parse", "--verify", "--quiet",
                           "--end-of-options", reference + "^{commit}"});
  if (ended.code != 0) {
    throw TrackError(
        fmt::format("git knows no revision '{}' in {}", reference, project.root.string()));
  }
  return last_line(ended.output);
}

std::vector<std::string> commits_between(const Project& project, const std::string& good,
                                         const std::string& bad) {
  const Ended ancestor =
      run({"git", "-C", project.root.string(), "merge-base", "--is-ancestor", good, bad});
  if (ancestor.code != 0) {
    throw TrackError(fmt::format("'{}' does not come before '{}'", good.substr(0, kShortLength),
                                 bad.substr(0, kShortLength)));
  }
  return lines_of(git(project, "git cannot list the revisions",
                      {"rev-list", "--first-parent", "--reverse", good + ".." + bad}));
}

std::string subject_of(const Project& project, const std::string& commit) {
  return last_line(git(project, "git cannot show the revision",
                       {"log", "-1", "--format=%h %s", "--abbrev=12", commit}));
}

Tree present_tree(const Project& project, const std::vector<std::string>& programs) {
  Tree tree{.label = "present", .revision = "", .build = project.build};
  for (const std::string& program : programs) {
    if (!fs::exists(tree.program(program))) {
      throw TrackError(fmt::format("{} is not built", tree.program(program).string()));
    }
  }
  tree.revision = commit_of(project, "HEAD").substr(0, kShortLength);
  if (!git(project, "git cannot show the state", {"status", "--porcelain"}).empty()) {
    tree.revision += "+";
  }
  return tree;
}

Tree build_tree(const Project& project, const std::string& reference,
                const std::vector<std::string>& programs) {
  const std::string commit = commit_of(project, reference);
  const std::string revision = commit.substr(0, kShortLength);
  const fs::path source = project.work / revision;
  // As deep below its sources as the present build, so that a compiler cache knows its commands.
  Tree tree{.label = reference == commit ? revision : reference,
            .revision = revision,
            .build = source / "build" / "release"};
  check_out(project, commit, source);
  if (!fs::exists(tree.build / "build.ninja")) {
    tell(fmt::format("stiction track: building {}; a few minutes the first time", tree.label));
  }
  // Each time: the options of the present build may have changed since.
  std::vector<std::string> words = {"cmake",
                                    "-G",
                                    "Ninja",
                                    "-S",
                                    source.string(),
                                    "-B",
                                    tree.build.string(),
                                    "-DSTICTION_BUILD_TESTS=OFF"};
  for (const std::string& option : same_options(project.build)) words.push_back(option);
  const fs::path beside = project.root / "benchmarks/yardstick/beside.cmake";
  words.push_back("-DCMAKE_PROJECT_stiction_INCLUDE=" + beside.string());
  words.push_back("-DSTICTION_PRESENT_CATALOG=" +
                  (project.build / "generated/family_catalog.cpp").string());
  demand_run(fmt::format("{} cannot be configured", tree.label), words);
  words = {"cmake", "--build", tree.build.string(), "--target"};
  words.insert(words.end(), programs.begin(), programs.end());
  demand_run(fmt::format("{} cannot be built", tree.label), words);
  return tree;
}

}  // namespace stiction::track
