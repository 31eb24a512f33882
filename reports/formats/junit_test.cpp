// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/formats/junit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "reports/formats/test_screen.h"
#include "reports/record/test_records.h"

namespace stiction {
namespace {

using test::has;

// A reader strict enough to find what escaping can break: nesting, quotes, entities, characters
// that XML forbids. Returns the names of the elements in order of their opening.
class StrictXml {
 public:
  explicit StrictXml(const std::string& xml) : xml_(xml) {}

  std::vector<std::string> elements() {
    demand(xml_.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"), "declaration");
    at_ = xml_.find('\n');
    while (at_ < xml_.size()) {
      if (xml_[at_] == '<') {
        tag();
      } else {
        character();
      }
    }
    demand(open_.empty(), "an element stays open");
    return names_;
  }

 private:
  void demand(bool holds, const std::string& what) const {
    if (!holds) throw std::runtime_error(what + " at " + xml_.substr(at_, 60));
  }

  void character() {
    const char c = xml_[at_];
    demand(c == '\n' || static_cast<unsigned char>(c) >= 0x20, "control character");
    demand(c != '<', "bare <");
    demand(xml_.compare(at_, 3, "]]>") != 0, "bare ]]>");
    if (c == '&') {
      const std::string entity = xml_.substr(at_, xml_.find(';', at_) - at_ + 1);
      demand(entity == "&amp;" || entity == "&lt;" || entity == "&gt;" || entity == "&quot;" ||
                 entity == "&apos;",
             "entity");
    }
    ++at_;
  }

  void tag() {
    ++at_;
    const bool closes = xml_[at_] == '/';
    if (closes) ++at_;
    const std::size_t begin = at_;
    while (std::isalpha(static_cast<unsigned char>(xml_[at_])) != 0 || xml_[at_] == '-') ++at_;
    const std::string name = xml_.substr(begin, at_ - begin);
    demand(!name.empty(), "element name");
    while (xml_[at_] == ' ') attribute();
    const bool empty = xml_[at_] == '/';
    if (empty) ++at_;
    demand(xml_[at_] == '>', "end of tag");
    ++at_;
    if (closes) {
      demand(!open_.empty() && open_.back() == name, "nesting of " + name);
      open_.pop_back();
      return;
    }
    names_.push_back(name);
    if (!empty) open_.push_back(name);
  }

  void attribute() {
    at_ = xml_.find("=\"", at_) + 2;
    while (xml_[at_] != '"') character();
    ++at_;
  }

  const std::string& xml_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::vector<std::string> names_;
};

TEST(Junit, CountsAndTimes) {
  const std::string xml = junit_xml({test::passing_record(), test::failing_record(),
                                     test::error_record(), test::not_applicable_record()});
  EXPECT_TRUE(has(xml,
                  R"(<testsuites name="stiction" tests="4" failures="1" errors="1" skipped="1" )"
                  R"(time="0.750000">)"));
  EXPECT_TRUE(has(xml, R"(<testsuite name="incline/threshold" tests="1" failures="0" errors="0" )"
                       R"(skipped="0" time="0.250000">)"));
  EXPECT_TRUE(has(xml, R"(<testcase classname="incline.threshold" name="mu=0.3/azimuth=30" )"
                       R"(time="0.250000">)"));
}

TEST(Junit, IsWellFormed) {
  const std::string xml = junit_xml({test::passing_record(), test::failing_record(),
                                     test::error_record(), test::not_applicable_record()});
  const auto elements = StrictXml(xml).elements();
  const auto count = [&](const char* name) {
    return std::count(elements.begin(), elements.end(), name);
  };
  EXPECT_EQ(count("testsuite"), 4);
  EXPECT_EQ(count("testcase"), 4);
  EXPECT_EQ(count("failure"), 1);
  EXPECT_EQ(count("error"), 1);
  EXPECT_EQ(count("skipped"), 1);
  EXPECT_EQ(count("system-out"), 4);
}

TEST(Junit, AFailureNamesItsWorstCheck) {
  Record record = test::failing_record();
  Judgement mild = test::failing_check();
  mild.claim.quantity = "mild";
  mild.error = 2e-4;
  mild.of_tolerance = 2.0;
  record.checks.insert(record.checks.begin(), mild);
  const std::string xml = junit_xml({record});
  EXPECT_TRUE(has(xml, "<failure message=\"stopping distance: measured 0.31 m, expected 0.3 m"));
  EXPECT_TRUE(has(xml, "worst offender: vertex 17 at t = 0.42 s"));
  EXPECT_TRUE(has(xml, "pass: critical slope, tan θ: measured 0.300012"));
}

TEST(Junit, AFailureWithoutADecidingCheckIsStillAFailure) {
  Record record = test::failing_record();
  record.checks.clear();
  const std::string xml = junit_xml({record});
  EXPECT_TRUE(has(xml, "<failure "));
  EXPECT_NO_THROW(StrictXml(xml).elements());
}

TEST(Junit, HostileTextIsEscaped) {
  for (const Verdict verdict : {Verdict::kPass, Verdict::kFail, Verdict::kNotApplicable,
                                Verdict::kForInformation, Verdict::kError}) {
    Record record = test::hostile_record();
    record.verdict = verdict;
    record.checks[0].verdict = verdict;
    const std::string xml = junit_xml({record});
    EXPECT_NO_THROW(StrictXml(xml).elements()) << xml;
    EXPECT_FALSE(has(xml, "<script>"));
    EXPECT_TRUE(has(xml, "&lt;script&gt;"));
  }
}

TEST(Junit, NotANumberAsTimeIsZero) {
  EXPECT_FALSE(has(junit_xml({test::hostile_record()}), "time=\"nan\""));
}

TEST(Junit, NoRecords) {
  EXPECT_EQ(StrictXml(junit_xml({})).elements(), std::vector<std::string>{"testsuites"});
}

TEST(JunitXml, SkipsWhatFallsShortAsExpected) {
  const std::string xml = junit_xml({test::shortfall_record(), test::refuted_record()});
  EXPECT_NO_THROW(StrictXml(xml).elements());
  EXPECT_TRUE(has(xml,
                  "<skipped message=\"falls short, as expected in [0.305, 0.32] m: normal forces "
                  "never settle\"/>"));
  EXPECT_TRUE(has(xml, "<skipped message=\"a claim of the paper is refuted, as expected in"));
  EXPECT_TRUE(has(xml, "failures=\"0\""));
  EXPECT_TRUE(has(xml, "skipped=\"2\""));
}

TEST(JunitXml, FailsOutsideTheBand) {
  const std::string xml = junit_xml({test::outside_record(3e5)});
  EXPECT_NO_THROW(StrictXml(xml).elements());
  EXPECT_TRUE(has(xml, "worse than expected [0.305, 0.32] m"));
  EXPECT_TRUE(has(xml, "cause of the band: normal forces never settle"));
}

}  // namespace
}  // namespace stiction
