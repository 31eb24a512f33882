// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

#include "reports/record/record.h"

/// Records for the tests of this folder.
namespace stiction::test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Every character that one of the formats gives a meaning to, a terminal escape, a NUL and a byte
/// that is no UTF-8.
inline std::string hostile_text() {
  return std::string(
             "<script>alert(1)</script> & \"q\" 'a' | a,b; `c` *d* [e](f) $g$ \\ ]]> "
             "line\nbreak\r\n\ttab \x1b[31m nul") +
         '\0' + "bad\xff" + "end μ";
}

inline Judgement passing_check() {
  return {.claim = {.quantity = "critical slope, tan θ",
                    .unit = "1",
                    .statement = "A box sticks if and only if tan θ ≤ μ.",
                    .formula = "tan θ_c = μ",
                    .source = "Coulomb1785",
                    .kind = ReferenceKind::kAnalytic,
                    .expected = 0.3,
                    .relative = true,
                    .scale = 0.3,
                    .tolerance = 1e-4,
                    .reason = "half the bracket's width plus the settling error, first order in Δt",
                    .headline = "critical slope"},
          .value = 0.300012,
          .worst = "upper end of the bracket",
          .error = 4e-5,
          .of_tolerance = 0.4,
          .digits = 4.4,
          .verdict = Verdict::kPass};
}

inline Judgement failing_check() {
  return {.claim = {.quantity = "stopping distance",
                    .unit = "m",
                    .statement = "A sliding box stops and stays.",
                    .formula = "d = v₀²/(2g(μ cos θ − sin θ))",
                    .source = "Coulomb1785",
                    .kind = ReferenceKind::kAnalytic,
                    .expected = 0.30,
                    .tolerance = 1e-4,
                    .reason = "v₀Δt/2, the bias of symplectic Euler"},
          .value = 0.31,
          .worst = "vertex 17 at t = 0.42 s",
          .error = 0.01,
          .of_tolerance = 100.0,
          .digits = 1.5,
          .verdict = Verdict::kFail};
}

inline Record passing_record(const std::string& case_name = "incline/threshold/mu=0.3/azimuth=30") {
  Record record;
  record.case_name = case_name;
  record.title = "A box on a slope that is turned";
  record.engine = "stiction";
  record.settings = {{"dt", "0.001"}, {"rule", "fixed-point"}};
  record.variant = "default";
  record.configuration = "paper, fixed point";
  record.differs = {{"kappa", "0.7"}};
  record.simulations = 28;
  record.problem = R"({"bodies":[{"name":"box"}]})";
  record.checks = {passing_check()};
  record.notes = {"The box is 0.2 m wide, so that it does not topple."};
  record.meshes = {{"box", 18, 20, 54.7, 90.0, 0.058}};
  record.series = {{"kinetic energy", "J", "time", "s", {0.0, 0.5}, {1.0, 0.25}}};
  record.cost = {.cpu_seconds = 0.25,
                 .told_cpu_seconds = 0.2,
                 .steps = 12000,
                 .simulated_seconds = 1.2,
                 .contact_updates = 96000,
                 .contact_phases = {41.5, 40.0, 44.0},
                 .whole_step = {325.0, 320.0, 350.0},
                 .phase_seconds = {{"friction", 0.1}, {"detect", 0.02}}};
  record.state_hash = "0123456789abcdef";
  record.environment = {"4f2a9c1+", "g++ 12.2.0 release", "Example CPU, 2 cores",
                        "2025-11-20T23:41:05Z"};
  record.verdict = Verdict::kPass;
  record.frames = "frames/012-incline_threshold.bin";
  return record;
}

inline Record failing_record(const std::string& case_name = "incline/below/mu=0.3") {
  Record record = passing_record(case_name);
  record.title = "A sliding box comes to rest";
  record.checks = {failing_check(), passing_check()};
  record.notes = {"Fails until the stop is resolved within a step."};
  record.verdict = Verdict::kFail;
  return record;
}

/// Does not meet its claim, as expected: its value 0.31 m lies in a band.
inline Record expected_record(Verdict verdict) {
  Record record = failing_record();
  record.case_name = "slab/rest";
  record.variant = "method=paper";
  for (Judgement& check : record.checks) {
    if (check.verdict != Verdict::kFail) continue;
    check.verdict = verdict;
    check.band = Band{0.305, 0.32};
    check.cause = "normal forces never settle";
    check.because = "contacts come and go";
  }
  record.verdict = verdict;
  return record;
}

inline Record shortfall_record() { return expected_record(Verdict::kShortfall); }
inline Record refuted_record() { return expected_record(Verdict::kRefuted); }

/// As the others, but outside its band.
inline Record outside_record(double value) {
  Record record = expected_record(Verdict::kFail);
  record.checks.front().value = value;
  record.checks.front().error = value - record.checks.front().claim.expected;
  return record;
}

inline Record error_record() {
  Record record = passing_record("incline/above/mu=0.9");
  record.checks.clear();
  record.notes.clear();
  record.verdict = Verdict::kError;
  record.error = "the time step 0.1 s is above the stability limit of element 3";
  return record;
}

inline Record not_applicable_record() {
  Record record = passing_record("slab/threshold");
  record.checks.clear();
  record.notes = {"the engine has no deformable obstacles"};
  record.cost = {};
  record.series.clear();
  record.verdict = Verdict::kNotApplicable;
  return record;
}

/// With what a comparison measures too.
inline Record compared_record() {
  Record record = failing_record();
  record.figures = {{"steps to 1e-9", "1", "static friction is found again soon", 12.0}};
  record.failures = {{"a body left its place", "gain", {-0.5, 2.3}}};
  return record;
}

/// Hostile in each of its texts, NaN and infinite in its numbers.
inline Record hostile_record() {
  const std::string text = hostile_text();
  Judgement check;
  check.claim.quantity = check.claim.unit = check.claim.statement = check.claim.formula =
      check.claim.source = check.claim.reason = check.claim.headline = check.worst = check.because =
          text;
  check.value = kNan;
  check.claim.expected = kInf;
  check.error = -kNan;
  check.claim.scale = -kInf;
  check.claim.tolerance = kNan;
  check.of_tolerance = kInf;
  check.digits = kNan;
  Record record;
  record.case_name = "evil/" + text;
  record.title = record.engine = record.state_hash = record.error = text;
  record.settings = record.differs = {{text, text}};
  record.configuration = text;
  record.checks = {check};
  record.notes = {text};
  record.series = {{text, text, text, text, {kNan}, {-kInf}}};
  record.cost.cpu_seconds = kNan;
  record.cost.phase_seconds = {{text, kInf}};
  record.environment = {text, text, text, text, text};
  return record;
}

}  // namespace stiction::test
