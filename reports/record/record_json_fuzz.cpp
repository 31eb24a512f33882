// SPDX-License-Identifier: GPL-3.0-or-later
// A records.jsonl: whatever it holds, records or one sentence; a record that was read is written,
// and reads the same.
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

#include "fuzz/property.h"
#include "reports/record/record_json.h"

using namespace stiction;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream stream(std::string(data, data + size));
  const auto file = fuzz::value_or_sentence<std::runtime_error>(
      [&] { return read_records(stream, "records.jsonl"); });
  if (!file) return 0;
  fuzz::hold(file->unfinished.find('\n') == std::string::npos, "a warning is one line");
  for (const Record& record : file->records) {
    const std::string line = to_json_line(record);
    fuzz::hold(line.find('\n') == std::string::npos, "a record is one line");
    const std::string again = to_json_line(from_json_line(line, "again"));
    fuzz::hold(again == line, "a record reads as it was written:\n" + line + "\n" + again);
  }
  return 0;
}
