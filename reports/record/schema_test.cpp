// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON Schema, the writer and the reader say the same.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "reports/record/record_json.h"
#include "reports/record/test_message.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

using nlohmann::json;

json schema_json() {
  std::ifstream stream(std::filesystem::path(__FILE__).parent_path() / "schema.json");
  return json::parse(stream);
}

bool conforms(const json& record) {
  static const json document = schema_json();
  static const valijson::Schema& schema = [] {
    static valijson::Schema parsed;
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(document),
                                            parsed);
    return std::ref(parsed);
  }();
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(record), nullptr);
}

bool is_read(const json& record) {
  return test::message_of([&] { from_json_line(record.dump(), "here"); }).empty();
}

std::vector<Record> every_kind() {
  return {test::passing_record(),
          test::failing_record(),
          test::shortfall_record(),
          test::refuted_record(),
          test::error_record(),
          test::not_applicable_record(),
          Record{},
          test::outside_record(1.0),
          test::compared_record()};
}

// Has every field.
Record banded_and_compared() {
  Record record = test::compared_record();
  record.checks = test::shortfall_record().checks;
  record.checks.front().claim.scale = 0.3;
  record.job = 7;
  record.environment.host = "node7";
  return record;
}

// Pointers to all fields of a line, those of the first element of each list.
void collect(const json& value, const json::json_pointer& at,
             std::vector<json::json_pointer>& pointers) {
  if (value.is_array() && !value.empty()) {
    pointers.push_back(at / 0);
    collect(value[0], at / 0, pointers);
  }
  if (!value.is_object()) return;
  for (const auto& [name, field] : value.items()) {
    pointers.push_back(at / name);
    collect(field, at / name, pointers);
  }
}

std::vector<json::json_pointer> all_fields(const json& record) {
  std::vector<json::json_pointer> pointers;
  collect(record, json::json_pointer(), pointers);
  return pointers;
}

TEST(RecordSchema, HoldsOfWhatIsWritten) {
  for (const Record& record : every_kind()) {
    EXPECT_TRUE(conforms(json::parse(to_json_line(record)))) << to_json_line(record);
  }
  EXPECT_TRUE(conforms(json::parse(to_json_line(test::hostile_record()))));
}

TEST(RecordSchema, KnowsEveryFieldThatIsWritten) {
  const json schema = schema_json();
  const json whole = json::parse(to_json_line(banded_and_compared()));
  const auto known = [&](const json& of, const json& value) {
    for (const auto& [name, field] : value.items()) {
      EXPECT_TRUE(of.at("properties").contains(name)) << name;
    }
  };
  known(schema, whole);
  for (const auto& [list, type] : {std::pair{"checks", "check"}, std::pair{"figures", "figure"},
                                   std::pair{"failures", "failure"}, std::pair{"meshes", "mesh"},
                                   std::pair{"series", "series"}}) {
    known(schema.at("definitions").at(type), whole.at(list).at(0));
  }
  for (const char* type : {"cost", "environment"}) {
    known(schema.at("definitions").at(type), whole.at(type));
  }
}

// Each field in turn is left out, or made another type: the schema refuses what the reader refuses.
TEST(RecordSchema, RefusesWhatTheReaderRefuses) {
  const json whole = json::parse(to_json_line(banded_and_compared()));
  int refused = 0;
  for (const json::json_pointer& field : all_fields(whole)) {
    json without = whole;
    if (field.back() == "0") {
      // That a series has as many x as y is no matter of a JSON Schema.
      if (field.parent_pointer().parent_pointer().to_string() == "/series/0") continue;
      without[field.parent_pointer()].erase(0);
    } else {
      without[field.parent_pointer()].erase(field.back());
    }
    EXPECT_EQ(conforms(without), is_read(without)) << "without " << field.to_string();
    for (const json& other : {json(nullptr), json(true), json("word"), json(-1.5),
                              json::array({"x"}), json{{"x", 1}}}) {
      json changed = whole;
      changed[field] = other;
      EXPECT_EQ(conforms(changed), is_read(changed)) << field.to_string() << " = " << other;
      refused += !is_read(changed);
    }
  }
  EXPECT_GT(refused, 200);
}

}  // namespace
}  // namespace stiction
