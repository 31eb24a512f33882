// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "reports/record/record.h"

namespace stiction {

/// Every record of a records.jsonl with the byte at which its line begins; a last line that a kill has cut
/// off is none. Throws std::runtime_error with file and line for what is no record.
void each_record_at(const std::filesystem::path& file,
                    const std::function<void(const Record&, std::uint64_t)>& use);

/// The record whose line begins at that byte. Throws like each_record_at.
Record record_at(const std::filesystem::path& file, std::uint64_t offset);

}  // namespace stiction
