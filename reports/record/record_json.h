// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "reports/record/record.h"

namespace stiction {

/// A record as one line of JSON without the line break, in the fields of reports/record/schema.md.
/// Doubles and 64-bit counts read back exactly; NaN and infinities, which JSON lacks, are the
/// strings "nan", "inf", "-inf". Broken UTF-8 becomes U+FFFD. Throws std::invalid_argument when a
/// series has not as many x as y: such a line could not be read.
std::string to_json_line(const Record& record);

/// The record of one such line. Unknown fields are ignored.
/// Throws std::runtime_error "<where>: <field>: <what is wrong>" for text that is not JSON, a
/// missing required field, a wrong type, an unknown word, or a schema version newer than this
/// program's. `where` is what the user can find the line by, e.g. "records.jsonl:12".
Record from_json_line(const std::string& line, const std::string& where);

/// What a records.jsonl holds.
struct RecordFile {
  std::vector<Record> records;  ///< finished ones, in file order
  std::string unfinished;  ///< "file:line: …" of a last line that a crash cut off; empty when none
};

/// Reads JSON Lines. Empty lines are skipped. A last line without a line break that is not complete
/// JSON is a crash's trace and is reported in `unfinished`; any other fault throws as above, and so
/// does a stream that fails while it is read. `name` stands for the file in messages.
RecordFile read_records(std::istream& stream, const std::string& name);

/// The same record by record, for files of any size; returns `unfinished`.
std::string each_record(std::istream& stream, const std::string& name,
                        const std::function<void(Record)>& use);

/// As above; throws std::runtime_error too when the file cannot be opened.
RecordFile read_records(const std::filesystem::path& file);

}  // namespace stiction
