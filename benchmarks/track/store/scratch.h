// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace stiction::track {

/// A new folder for a child's files, removed with everything in it at the end.
class Scratch {
 public:
  Scratch();  ///< throws TrackError
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Those of all threads, for a program that ends without its destructors. No further one is made.
  static void remove_all();

 private:
  std::filesystem::path folder_;
};

/// A file's whole content; empty when it cannot be read.
std::string content_of(const std::filesystem::path& file);

}  // namespace stiction::track
