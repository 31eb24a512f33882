// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

/// A new folder for a child's files, removed with everything in it at the end.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "stiction-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw TrackError("no temporary folder can be made");
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;  // what the system keeps, it clears itself
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// A file's whole content; empty when it cannot be read.
inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace stiction::track
