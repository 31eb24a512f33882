// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/record_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "reports/record/test_message.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

std::string edited(const std::function<void(nlohmann::json&)>& edit) {
  auto json = nlohmann::json::parse(to_json_line(test::passing_record()));
  edit(json);
  return json.dump();
}

std::string message_of_line(const std::string& line) {
  return test::message_of([&] { from_json_line(line, "records.jsonl:7"); });
}

TEST(RecordJson, RoundTrip) {
  for (const Record& record : {test::passing_record(), test::failing_record(), test::error_record(),
                               test::not_applicable_record(), test::compared_record(), Record{}}) {
    const std::string line = to_json_line(record);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(to_json_line(from_json_line(line, "here")), line) << "reading lost a field";
  }
}

// The round trip above compares writer with writer; here each field is looked at itself.
TEST(RecordJson, EveryFieldArrives) {
  Record in = test::compared_record();
  in.job = 7;
  in.environment.host = "node7";
  const Record out = from_json_line(to_json_line(in), "here");
  EXPECT_EQ(out.case_name, in.case_name);
  EXPECT_EQ(out.title, in.title);
  EXPECT_EQ(out.engine, in.engine);
  EXPECT_EQ(out.settings, in.settings);
  EXPECT_EQ(out.notes, in.notes);
  EXPECT_EQ(out.state_hash, in.state_hash);
  EXPECT_EQ(out.frames, in.frames);
  EXPECT_EQ(out.verdict, in.verdict);
  EXPECT_EQ(from_json_line(to_json_line(test::error_record()), "here").error,
            test::error_record().error);
  EXPECT_EQ(out.cost.cpu_seconds, in.cost.cpu_seconds);
  EXPECT_EQ(out.cost.steps, in.cost.steps);
  EXPECT_EQ(out.cost.contact_updates, in.cost.contact_updates);
  EXPECT_EQ(out.cost.simulated_seconds, in.cost.simulated_seconds);
  const auto expect_same = [](const ContactTime& a, const ContactTime& b) {
    EXPECT_EQ(a.median, b.median);
    EXPECT_EQ(a.lower, b.lower);
    EXPECT_EQ(a.upper, b.upper);
  };
  expect_same(out.cost.contact_phases, in.cost.contact_phases);
  expect_same(out.cost.whole_step, in.cost.whole_step);
  EXPECT_EQ(out.cost.told_cpu_seconds, in.cost.told_cpu_seconds);
  EXPECT_EQ(out.cost.phase_seconds, in.cost.phase_seconds);
  EXPECT_EQ(out.environment.revision, in.environment.revision);
  EXPECT_EQ(out.environment.toolchain, in.environment.toolchain);
  EXPECT_EQ(out.environment.machine, in.environment.machine);
  EXPECT_EQ(out.environment.date, in.environment.date);
  EXPECT_EQ(out.environment.host, in.environment.host);
  EXPECT_EQ(out.job, in.job);
  ASSERT_EQ(out.series.size(), 1u);
  EXPECT_EQ(out.series[0].name, in.series[0].name);
  EXPECT_EQ(out.series[0].unit, in.series[0].unit);
  EXPECT_EQ(out.series[0].x_name, in.series[0].x_name);
  EXPECT_EQ(out.series[0].x_unit, in.series[0].x_unit);
  EXPECT_EQ(out.series[0].x, in.series[0].x);
  EXPECT_EQ(out.series[0].y, in.series[0].y);
  ASSERT_EQ(out.meshes.size(), 1u);
  EXPECT_EQ(out.meshes[0].bodies, in.meshes[0].bodies);
  EXPECT_EQ(out.meshes[0].vertices, in.meshes[0].vertices);
  EXPECT_EQ(out.meshes[0].tetrahedra, in.meshes[0].tetrahedra);
  EXPECT_EQ(out.meshes[0].min_dihedral_angle, in.meshes[0].min_dihedral_angle);
  EXPECT_EQ(out.meshes[0].max_dihedral_angle, in.meshes[0].max_dihedral_angle);
  EXPECT_EQ(out.meshes[0].min_altitude, in.meshes[0].min_altitude);
  ASSERT_EQ(out.figures.size(), 1u);
  EXPECT_EQ(out.figures[0].quantity, in.figures[0].quantity);
  EXPECT_EQ(out.figures[0].unit, in.figures[0].unit);
  EXPECT_EQ(out.figures[0].meaning, in.figures[0].meaning);
  EXPECT_EQ(out.figures[0].value, in.figures[0].value);
  ASSERT_EQ(out.failures.size(), 1u);
  EXPECT_EQ(out.failures[0].reason, in.failures[0].reason);
  EXPECT_EQ(out.failures[0].parameter, in.failures[0].parameter);
  EXPECT_EQ(out.failures[0].values, in.failures[0].values);
  ASSERT_EQ(out.checks.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Judgement& a = out.checks[i];
    const Judgement& b = in.checks[i];
    EXPECT_EQ(a.claim.quantity, b.claim.quantity);
    EXPECT_EQ(a.claim.unit, b.claim.unit);
    EXPECT_EQ(a.claim.statement, b.claim.statement);
    EXPECT_EQ(a.claim.formula, b.claim.formula);
    EXPECT_EQ(a.claim.source, b.claim.source);
    EXPECT_EQ(a.claim.kind, b.claim.kind);
    EXPECT_EQ(a.value, b.value);
    EXPECT_EQ(a.claim.expected, b.claim.expected);
    EXPECT_EQ(a.error, b.error);
    EXPECT_EQ(a.claim.relative, b.claim.relative);
    EXPECT_EQ(a.claim.scale, b.claim.scale);
    EXPECT_EQ(a.claim.tolerance, b.claim.tolerance);
    EXPECT_EQ(a.claim.reason, b.claim.reason);
    EXPECT_EQ(a.of_tolerance, b.of_tolerance);
    EXPECT_EQ(a.digits, b.digits);
    EXPECT_EQ(a.worst, b.worst);
    ASSERT_EQ(a.band.has_value(), b.band.has_value());
    if (a.band) {
      EXPECT_EQ(a.band->low, b.band->low);
      EXPECT_EQ(a.band->high, b.band->high);
    }
    EXPECT_EQ(a.cause, b.cause);
    EXPECT_EQ(a.verdict, b.verdict);
  }
}

TEST(RecordJson, APointOfASweepArrivesWithItsAxes) {
  Record in = test::passing_record();
  EXPECT_EQ(to_json_line(in).find("\"axes\""), std::string::npos) << "of no sweep";
  in.point = "0123456789abcdef";
  in.axes = {{"ramp.slope_deg", "deg", 20.5}, {"ramp.friction", "1", 0.1}};
  const Record out = from_json_line(to_json_line(in), "here");
  EXPECT_EQ(out.point, in.point);
  ASSERT_EQ(out.axes.size(), 2u);
  EXPECT_EQ(out.axes[0].name, "ramp.slope_deg");
  EXPECT_EQ(out.axes[0].unit, "deg");
  EXPECT_EQ(out.axes[0].value, 20.5);
  EXPECT_EQ(out.axes[1].name, "ramp.friction");
  EXPECT_EQ(out.axes[1].value, 0.1);
}

TEST(RecordJson, DoublesAreExact) {
  std::mt19937_64 bits(42);
  Record record;
  Series series;
  series.y = {0.0,
              -0.0,
              0.1,
              1.0 / 3.0,
              5e-324,
              -2.2250738585072014e-308,
              1e22,
              9007199254740993.0,
              std::numeric_limits<double>::max(),
              std::nextafter(1.0, 2.0)};
  for (int i = 0; i < 20000; ++i) {
    const double value = std::bit_cast<double>(bits());
    if (std::isfinite(value)) series.y.push_back(value);
  }
  series.x.assign(series.y.size(), 0.0);
  record.series = {series};
  const Record out = from_json_line(to_json_line(record), "here");
  ASSERT_EQ(out.series[0].y.size(), series.y.size());
  for (std::size_t i = 0; i < series.y.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint64_t>(out.series[0].y[i]),
              std::bit_cast<std::uint64_t>(series.y[i]))
        << series.y[i];
  }
}

TEST(RecordJson, CountsAreExact) {
  Record record;
  record.cost.steps = std::numeric_limits<std::uint64_t>::max();
  record.cost.contact_updates = (std::uint64_t{1} << 53) + 1;  // no double
  const Record out = from_json_line(to_json_line(record), "here");
  EXPECT_EQ(out.cost.steps, record.cost.steps);
  EXPECT_EQ(out.cost.contact_updates, record.cost.contact_updates);
}

TEST(RecordJson, NotANumberAndInfinitiesSurvive) {
  const std::string line = to_json_line(test::hostile_record());
  EXPECT_EQ(line.find("null"), std::string::npos);
  const Record out = from_json_line(line, "here");
  const Judgement& check = out.checks.front();
  EXPECT_TRUE(std::isnan(check.value));
  EXPECT_TRUE(std::isnan(check.error));
  EXPECT_EQ(check.claim.expected, test::kInf);
  EXPECT_EQ(check.claim.scale, -test::kInf);
  EXPECT_TRUE(std::isnan(out.series[0].x[0]));
  EXPECT_EQ(out.series[0].y[0], -test::kInf);
  EXPECT_EQ(out.cost.phase_seconds.begin()->second, test::kInf);
}

TEST(RecordJson, HostileTextArrivesButForBrokenUtf8) {
  std::string expected = test::hostile_text();
  expected.replace(expected.find('\xff'), 1, "\uFFFD");
  const std::string line = to_json_line(test::hostile_record());
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const Record out = from_json_line(line, "here");
  EXPECT_EQ(out.title, expected);
  EXPECT_EQ(out.checks[0].worst, expected);
  EXPECT_EQ(out.settings.begin()->first, expected);
}

TEST(RecordJson, ASeriesOfUnequalLengthsIsRefused) {
  Record record = test::passing_record();
  record.series[0].x.push_back(1.0);
  EXPECT_THROW(to_json_line(record), std::invalid_argument);
  const std::string line = edited([](auto& json) { json["series"][0]["x"].push_back(1.0); });
  EXPECT_EQ(message_of_line(line), "records.jsonl:7: series[0]: 3 x but 2 y");
}

TEST(RecordJson, UnknownFieldsAreIgnored) {
  const std::string line = edited([](auto& json) {
    json["future"] = {1, 2};
    json["checks"][0]["future"] = "x";
    json["cost"]["future"] = nullptr;
  });
  EXPECT_EQ(to_json_line(from_json_line(line, "here")), to_json_line(test::passing_record()));
}

TEST(RecordJson, OptionalFieldsMayBeMissing) {
  const std::string line = edited([](auto& json) {
    for (const char* name : {"title", "settings", "error", "figures", "failures", "notes",
                             "state_hash", "series", "frames"}) {
      json.erase(name);
    }
    json["cost"].erase("phase_seconds");
    json["checks"][0].erase("formula");
    for (const char* name : {"worst", "scale", "digits", "band", "cause"}) {
      json["checks"][0].erase(name);
    }
  });
  EXPECT_EQ(from_json_line(line, "here").case_name, test::passing_record().case_name);
}

TEST(RecordJson, EveryOtherFieldIsRequired) {
  const auto whole = nlohmann::json::parse(to_json_line(test::compared_record()));
  const auto demand = [&](const nlohmann::json::json_pointer& parent, const std::string& path,
                          const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      auto json = whole;
      ASSERT_EQ(json[parent].erase(name), 1u) << name;
      EXPECT_EQ(message_of_line(json.dump()),
                "records.jsonl:7: " + path + name + ": the required field is missing");
    }
  };
  using Pointer = nlohmann::json::json_pointer;
  demand(Pointer(""), "",
         {"schema_version", "case", "engine", "verdict", "checks", "cost", "environment"});
  demand(Pointer("/checks/0"), "checks[0].",
         {"quantity", "unit", "claim", "source", "kind", "value", "expected", "error", "relative",
          "tolerance", "reason", "of_tolerance", "verdict"});
  demand(Pointer("/figures/0"), "figures[0].", {"quantity", "unit", "meaning", "value"});
  demand(Pointer("/failures/0"), "failures[0].", {"reason"});
  demand(Pointer("/cost"), "cost.",
         {"cpu_seconds", "steps", "contact_updates", "ns_per_contact_update"});
  demand(Pointer("/environment"), "environment.", {"revision", "toolchain", "machine", "date"});
  demand(Pointer("/series/0"), "series[0].", {"name", "unit", "x_name", "x_unit", "x", "y"});
}

TEST(RecordJson, WrongTypesNameTheField) {
  const auto message = [](const char* pointer, const nlohmann::json& value) {
    return message_of_line(
        edited([&](auto& json) { json[nlohmann::json::json_pointer(pointer)] = value; }));
  };
  const std::string at = "records.jsonl:7: ";
  EXPECT_EQ(message("/checks/0/value", "1.5"),
            at + "checks[0].value: expected a number, \"nan\", \"inf\" or \"-inf\", found string");
  EXPECT_EQ(message("/checks/0/value", nullptr),
            at + "checks[0].value: expected a number, \"nan\", \"inf\" or \"-inf\", found null");
  EXPECT_EQ(message("/checks/0/relative", 1),
            at + "checks[0].relative: expected true or false, found 1");
  EXPECT_EQ(message("/cost/steps", -1),
            at + "cost.steps: expected a whole number from 0 to 2^64 − 1, found -1");
  EXPECT_EQ(message("/cost/steps", 1.5),
            at + "cost.steps: expected a whole number from 0 to 2^64 − 1, found 1.5");
  EXPECT_EQ(message("/cost/steps", 1.8446744073709552e19),
            at + "cost.steps: expected a whole number from 0 to 2^64 − 1, found "
                 "1.8446744073709552e+19");
  EXPECT_EQ(message("/cost", nlohmann::json::array()),
            at + "cost: expected an object, found array");
  EXPECT_EQ(message("/checks", "none"), at + "checks: expected a list, found string");
  EXPECT_EQ(message("/notes/0", 3), at + "notes[0]: expected a string, found 3");
  EXPECT_EQ(message("/settings/dt", 0.001), at + "settings.dt: expected a string, found 0.001");
  EXPECT_EQ(message("/verdict", "passed"), at + "verdict: unknown word \"passed\"");
  EXPECT_EQ(message("/checks/0/kind", "oracle"), at + "checks[0].kind: unknown word \"oracle\"");
}

TEST(RecordJson, AnotherSchemaVersionIsRefused) {
  for (const int version : {0, Record::kSchemaVersion + 1}) {
    const auto line = edited([&](auto& json) { json["schema_version"] = version; });
    EXPECT_NE(message_of_line(line).find("schema_version: version"), std::string::npos);
  }
}

TEST(RecordJson, ABandReadsBackInfinitiesIncluded) {
  Record record = test::refuted_record();
  record.checks.front().band->high = test::kInf;
  const Record copy = from_json_line(to_json_line(record), "line");
  ASSERT_TRUE(copy.checks.front().band.has_value());
  EXPECT_EQ(copy.checks.front().band->low, 0.305);
  EXPECT_EQ(copy.checks.front().band->high, test::kInf);
  EXPECT_EQ(copy.checks.front().verdict, Verdict::kRefuted);
  EXPECT_EQ(copy.variant, "method=paper");
  EXPECT_EQ(to_json_line(test::passing_record()).find("band"), std::string::npos)
      << "no band, no field";
}

TEST(RecordJson, HalfABandIsRefused) {
  auto json = nlohmann::json::parse(to_json_line(test::shortfall_record()));
  json["checks"][0]["band"].erase(1);
  EXPECT_EQ(message_of_line(json.dump()),
            "records.jsonl:7: checks[0].band: expected 2 numbers, found 1");
}

TEST(RecordJson, WhatIsNoObject) {
  EXPECT_EQ(message_of_line("[]"), "records.jsonl:7: expected an object, found array");
  EXPECT_EQ(message_of_line("3"), "records.jsonl:7: expected an object, found 3");
  EXPECT_NE(message_of_line("{").find("records.jsonl:7: not valid JSON"), std::string::npos);
  EXPECT_NE(message_of_line("").find("records.jsonl:7: not valid JSON"), std::string::npos);
}

}  // namespace
}  // namespace stiction
