// SPDX-License-Identifier: GPL-3.0-or-later
// Every case of validation/cases/, seen from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "validation/core/runner.h"

namespace stiction {

// Found by GoogleTest where it names a parameter.
void PrintTo(const Job& job, std::ostream* out) { *out << job.which.name; }

namespace {

TEST(CaseCatalog, HasUniqueNamesInOrderWithTitlesAndVariants) {
  const std::vector<Case> cases = case_catalog();
  std::set<std::string> names;
  for (const Case& one : cases) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name << " is there twice";
    EXPECT_NE(one.name.find('/'), std::string::npos) << one.name << " has no family";
    EXPECT_FALSE(one.title.empty()) << one.name;
    EXPECT_TRUE(one.run) << one.name;
    EXPECT_TRUE(one.variants.empty()) << one.name << " names settings of an engine";
  }
  EXPECT_TRUE(std::is_sorted(cases.begin(), cases.end(),
                             [](const Case& a, const Case& b) { return a.name < b.name; }));
}

TEST(CaseCatalog, HasEachClaimOfTheInclineFamily) {
  for (const std::string glob :
       {"incline/threshold/mu=0.1/*", "incline/threshold/mu=0.3/*", "incline/threshold/mu=0.5/*",
        "incline/threshold/mu=0.6/*", "incline/threshold/mu=0.9/*",
        "incline/threshold/*azimuth=0/*", "incline/threshold/*azimuth=30/*",
        "incline/threshold/*azimuth=45/*", "incline/threshold/*yaw=20", "incline/below/creep/50%",
        "incline/below/creep/90%", "incline/below/creep/99%", "incline/below/stop/*",
        "incline/at-critical/*", "incline/above/*", "incline/level/stop/*", "incline/restick/*",
        "half-space/*"}) {
    EXPECT_NO_THROW(select_jobs(case_catalog(), {.globs = {glob}})) << glob;
  }
}

TEST(CaseCatalog, RunsEachVariantOfAnEngineOnce) {
  for (const EngineKind& engine : engine_catalog()) {
    for (const Case& one : cases_for(engine)) {
      const std::vector<Settings> all = variants_of(one, engine, true);
      EXPECT_FALSE(all.empty()) << one.name;
      EXPECT_EQ(std::set<Settings>(all.begin(), all.end()).size(), all.size())
          << one.name << " runs the same twice";
    }
  }
}

// A row whose case or variant is gone excuses nothing and misleads its readers. Whether a case
// still measures the quantity shows when it runs (CaseRun::demand_expected_checks).
TEST(CaseCatalog, HasACaseAndVariantForEachExpectationOfAnEngine) {
  for (const EngineKind& engine : engine_catalog()) {
    const std::vector<Case> cases = cases_for(engine);
    for (const Expectation& row : engine.expectations) {
      const bool met = std::any_of(cases.begin(), cases.end(), [&](const Case& one) {
        const std::vector<Settings> variants = variants_of(one, engine, true);
        return std::any_of(variants.begin(), variants.end(), [&](const Settings& variant) {
          return !expectations_of({row}, one.name, variant_text(variant)).empty();
        });
      });
      EXPECT_TRUE(met) << engine.name << ": " << row.cases << "  " << row.variant << "  "
                       << row.quantity;
    }
  }
}

TEST(CaseCatalog, HasExpectationsThatSayWhereAndWhy) {
  for (const EngineKind& engine : engine_catalog()) {
    for (const Expectation& row : engine.expectations) {
      const std::string name = std::string(row.cases) + "  " + row.variant + "  " + row.quantity;
      EXPECT_LE(row.band.low, row.band.high) << name;
      EXPECT_TRUE(std::isfinite(row.band.low)) << name;
      EXPECT_TRUE(row.verdict == Verdict::kShortfall || row.verdict == Verdict::kRefuted) << name;
      EXPECT_GE(std::string(row.cause.text).size(), 40u) << name << ": a cause is measured";
      EXPECT_GE(std::string(row.width.text).size(), 20u) << name << ": a width has a rule";
    }
  }
}

std::vector<Job> quick_jobs() { return select_jobs(case_catalog(), {.set = CaseSet::kQuick}); }

class QuickCase : public testing::TestWithParam<Job> {};

TEST_P(QuickCase, HasChecksWithClaimSourceAndReason) {
  const Record record = run_job(GetParam(), 1.0);
  EXPECT_EQ(record.error, "");
  EXPECT_FALSE(record.checks.empty());
  EXPECT_EQ(record.state_hash.size(), 16u);
  for (const Judgement& check : record.checks) {
    EXPECT_FALSE(check.claim.statement.empty()) << check.claim.quantity;
    EXPECT_FALSE(check.claim.source.empty()) << check.claim.quantity;
    EXPECT_FALSE(check.claim.unit.empty()) << check.claim.quantity;
    EXPECT_GE(check.claim.reason.size(), 10u)
        << check.claim.quantity << ": a reason is a derivation";
    EXPECT_GE(check.claim.tolerance, 0.0) << check.claim.quantity;
  }
  for (const Series& series : record.series) {
    EXPECT_EQ(series.x.size(), series.y.size()) << series.name;
    EXPECT_FALSE(series.x.empty()) << series.name;
  }
}

std::string readable(const testing::TestParamInfo<Job>& info) {
  std::string name = info.param.which.name;
  for (const auto& [key, value] : info.param.settings) name += "_" + value;
  for (char& letter : name) {
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Catalog, QuickCase, testing::ValuesIn(quick_jobs()), readable);

}  // namespace
}  // namespace stiction
