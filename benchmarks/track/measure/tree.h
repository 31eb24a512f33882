// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace stiction::track {

/// A built revision: its programs are in `build`.
struct Tree {
  std::string label;     ///< as a person named it: "HEAD~1", "present"
  std::string revision;  ///< 12 hex digits, "+" behind it when files were changed
  std::filesystem::path build;

  std::filesystem::path program(const std::string& name) const { return build / name; }
};

/// Where the project stands on disk.
struct Project {
  std::filesystem::path root;   ///< of the git repository
  std::filesystem::path build;  ///< of the present tree
  std::filesystem::path work;   ///< worktrees, what is remembered, the history
};

/// Takes the variables with which git tells a hook of its clone (GIT_DIR, GIT_INDEX_FILE, …) out of the
/// environment: a git that is to work in another folder would work in that clone.
void forget_git_variables();

/// The full commit id of a revision. Throws TrackError when git knows none of that name.
std::string commit_of(const Project& project, const std::string& reference);

/// Commits behind `good` up to and with `bad`, oldest first, along first parents.
/// Throws TrackError unless `good` is an ancestor of `bad`.
std::vector<std::string> commits_between(const Project& project, const std::string& good,
                                         const std::string& bad);

/// Subject line of a commit.
std::string subject_of(const Project& project, const std::string& commit);

/// What a comparison of two revisions runs of each.
inline const std::vector<std::string> kMeasuredPrograms = {"bench", "validate"};

/// The tree that is worked on, already built. Throws TrackError when a program is missing.
Tree present_tree(const Project& project,
                  const std::vector<std::string>& programs = kMeasuredPrograms);

/// Checks out `reference` under `project.work`, which the caller holds (work_lock.h), and builds it there
/// with the compiler and options of the present build; what is there already is only brought up to date,
/// a worktree that git no longer takes for one is made anew. Beside its own programs there is the present
/// tree's yardstick (benchmarks/yardstick/beside.cmake). Throws TrackError when git, cmake or the compiler
/// fail, with their last line.
Tree build_tree(const Project& project, const std::string& reference,
                const std::vector<std::string>& programs = kMeasuredPrograms);

}  // namespace stiction::track
