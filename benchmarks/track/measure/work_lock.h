// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace stiction::track {

/// The folder of other revisions and their builds, held by one program at a time: two would build into
/// each other's folders, and each would be in the other's times. The system lets go of it when the
/// program ends, however it does.
class WorkLock {
 public:
  /// Makes the folder where it is missing. Throws TrackError when another program holds it.
  explicit WorkLock(const std::filesystem::path& folder);
  ~WorkLock();
  WorkLock(const WorkLock&) = delete;
  WorkLock& operator=(const WorkLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace stiction::track
