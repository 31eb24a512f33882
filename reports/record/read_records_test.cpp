// SPDX-License-Identifier: GPL-3.0-or-later
// Files of records, and the document that describes them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "reports/record/record_json.h"
#include "reports/record/test_message.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

TEST(ReadRecords, ReadsLinesInOrder) {
  std::istringstream stream(to_json_line(test::passing_record("a")) + "\n\n" +
                            to_json_line(test::passing_record("b")) + "\n");
  const RecordFile file = read_records(stream, "records.jsonl");
  ASSERT_EQ(file.records.size(), 2u);
  EXPECT_EQ(file.records[0].case_name, "a");
  EXPECT_EQ(file.records[1].case_name, "b");
  EXPECT_TRUE(file.unfinished.empty());
}

TEST(ReadRecords, AnEmptyFileHasNone) {
  std::istringstream stream("");
  const RecordFile file = read_records(stream, "records.jsonl");
  EXPECT_TRUE(file.records.empty());
  EXPECT_TRUE(file.unfinished.empty());
}

TEST(ReadRecords, ACrashAtAnyByteLosesNoFinishedRecord) {
  const std::string first = to_json_line(test::passing_record("a")) + "\n";
  const std::string second = to_json_line(test::failing_record("b"));
  for (std::size_t bytes = 0; bytes <= second.size(); ++bytes) {
    std::istringstream stream(first + second.substr(0, bytes));
    const RecordFile file = read_records(stream, "records.jsonl");
    const bool complete = bytes == second.size();  // only the line break is missing
    ASSERT_EQ(file.records.size(), complete ? 2u : 1u) << bytes;
    ASSERT_EQ(file.unfinished.empty(), complete || bytes == 0) << bytes;
    if (!file.unfinished.empty()) {
      ASSERT_EQ(file.unfinished.substr(0, 16), "records.jsonl:2:");
    }
  }
}

TEST(ReadRecords, AFaultInTheMiddleIsAnErrorWithItsLine) {
  const std::string good = to_json_line(test::passing_record());
  std::istringstream broken(good + "\n" + good.substr(0, 40) + "\n" + good + "\n");
  EXPECT_EQ(test::message_of([&] { read_records(broken, "r.jsonl"); }).substr(0, 10), "r.jsonl:2:");
  std::istringstream last("{}\n");
  EXPECT_EQ(test::message_of([&] { read_records(last, "r.jsonl"); }),
            "r.jsonl:1: schema_version: the required field is missing");
  std::istringstream complete_but_wrong("{}");
  EXPECT_NE(test::message_of([&] { read_records(complete_but_wrong, "r.jsonl"); }), "");
}

TEST(ReadRecords, AMissingFileIsNamed) {
  EXPECT_EQ(
      test::message_of([] { read_records(std::filesystem::path("/nonexistent/records.jsonl")); }),
      "Cannot open \"/nonexistent/records.jsonl\": No such file or directory");
}

TEST(ReadRecords, AFolderIsNoFile) {
  EXPECT_NE(test::message_of([] { read_records(std::filesystem::path("/")); }), "");
}

TEST(SchemaDocument, ItsExampleIsARecord) {
  const auto document = std::filesystem::path(__FILE__).parent_path() / "schema.md";
  std::ifstream stream(document);
  ASSERT_TRUE(stream) << document;
  std::string example;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("{")) example = line;
  }
  EXPECT_EQ(to_json_line(from_json_line(example, "schema.md")),
            to_json_line(test::passing_record()));
}

}  // namespace
}  // namespace stiction
