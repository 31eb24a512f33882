// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "reports/record/record.h"

namespace stiction {

/// Every file of that name in a folder, as deep as it lies; links to folders are not followed. Throws
/// std::runtime_error that names the folder, where something in it cannot be read.
void each_file_named(const std::string& name, const std::filesystem::path& folder,
                     const std::function<void(const std::filesystem::path&)>& use);

/// Whether a run's folder is of a later run than another: by their names, which are times, and "-2", "-3" …
/// behind those of one second (reports/record/record_store.h).
bool is_later(const std::filesystem::path& run, const std::filesystem::path& other);

/// Every whole line of a file with its number, from 1 on, and the byte at which it begins.
void each_line_at(const std::filesystem::path& file,
                  const std::function<void(const std::string&, std::size_t, std::uint64_t)>& use);

/// Every record of a records.jsonl with the byte at which its line begins; a last line that a kill has cut
/// off is none. Throws std::runtime_error with file and line for what is no record.
void each_record_at(const std::filesystem::path& file,
                    const std::function<void(const Record&, std::uint64_t)>& use);

/// The record whose line begins at that byte. Throws like each_record_at.
Record record_at(const std::filesystem::path& file, std::uint64_t offset);

}  // namespace stiction
