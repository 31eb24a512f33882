// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <shared_mutex>
#include <string_view>

namespace stiction {

/// Of files that are made here, less what the umask takes.
inline constexpr mode_t kFileMode = 0666;

/// Whether the disk is waited for.
enum class Wait { kNo, kYes };

/// Writes a file completely or not at all: an older one stays until the new one is whole, which is called
/// ".NAME.tmp" until then. What a link points to is written, and the link stays; what is no file, as
/// /dev/stdout or a pipe, is written to. Throws std::runtime_error, one sentence that names the file and
/// the cause.
void write_whole(const std::filesystem::path& file, std::string_view content,
                 Wait wait = Wait::kYes);

/// Everything to a descriptor. Returns 0 or the error's number.
int write_fully(int descriptor, std::string_view content, Wait wait = Wait::kYes);

/// Held while files are written by other means, by one thread or several.
class Writing {
 public:
  Writing();

 private:
  std::shared_lock<std::shared_mutex> lock_;
};

/// For a program that is being ended: waits for what is being written, by write_whole too, and lets nothing
/// else begin.
void end_writing();

}  // namespace stiction
