// SPDX-License-Identifier: GPL-3.0-or-later
// Work and precision of a person's questions: CPU time a simulated second against the error of the
// answer, for each method × sweeps × Δt up to the stable limit × refinement.
#include "reports/formats/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>

#include "solver/demand.h"
#include "solver/friction/catalog.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/precision_question.h"
#include "validation/engine/settings.h"
#include "validation/engines/stiction/configurations.h"
#include "validation/engines/stiction/stiction_method.h"

namespace stiction {

namespace {

// Of one run, vertices × steps: a quarter of a second of CPU time, more or less, and twice that where
// bodies touch. It ends the ladder of time steps.
constexpr double kMostWork = 3e6;

// What took less CPU time in all (s) is run again, up to so many times; the median of the times counts.
constexpr double kEnough = 0.15;
constexpr int kMostRepeats = 5;

// A question's reference, computed by the first run that asks.
class KnownReference {
 public:
  explicit KnownReference(PrecisionQuestion question) : question_(std::move(question)) {}
  const PrecisionQuestion& question() const { return question_; }

  const PrecisionReference& get(const CaseRun& run) {
    const std::lock_guard<std::mutex> lock(one_at_a_time_);
    if (!known_) {
      known_ = question_.reference([&](const Settings& settings) { return run.part(settings); });
    }
    return *known_;
  }

 private:
  PrecisionQuestion question_;
  std::mutex one_at_a_time_;
  std::optional<PrecisionReference> known_;
};

struct Answered {
  double value = 0.0;    // in the question's unit
  std::string broken{};  // why it has no value; else empty
  Record record{};
};

Answered answer(const PrecisionQuestion& question, const CaseRun& run, int cells) {
  CaseRun part = run.part(run.settings());
  Answered found;
  try {
    found.value = question.answer(part, cells);
  } catch (const InputError& why) {
    found.broken = why.what();
  }
  found.record = part.record();
  // Bodies that passed through each other, and arithmetic without an answer; notes of a method that is
  // known for it.
  if (found.broken.empty()) found.broken = found.record.error;
  if (found.broken.empty() && !found.record.notes.empty()) {
    found.broken = found.record.notes.front();
  }
  if (found.broken.empty() && !std::isfinite(found.value)) found.broken = "there is no answer";
  return found;
}

double cpu_a_second(const Cost& cost) { return cost.cpu_seconds / cost.simulated_seconds; }

void run_question(CaseRun& run, KnownReference& known, int cells) {
  const PrecisionQuestion& question = known.question();
  Answered found = answer(question, run, cells);
  run.pay(found.record.cost);
  std::vector<double> times{cpu_a_second(found.record.cost)};
  double spent = found.record.cost.cpu_seconds;
  while (found.broken.empty() && spent < kEnough && times.size() < kMostRepeats) {
    const Answered again = answer(question, run, cells);
    run.pay(again.record.cost);
    spent += again.record.cost.cpu_seconds;
    times.push_back(cpu_a_second(again.record.cost));
    if (again.record.state_hash != found.record.state_hash) {
      found.broken = "a repetition ended in another state";
    }
  }
  std::sort(times.begin(), times.end());
  double error = std::nan(""), doubt = std::nan("");
  if (found.broken.empty()) {
    const PrecisionReference& reference = known.get(run);
    const double unit = question.scale > 0.0 ? question.scale : 1.0;
    const double dt =
        found.record.cost.simulated_seconds / static_cast<double>(found.record.cost.steps);
    error = std::abs(found.value - reference.value) / unit;
    doubt = (reference.uncertainty + question.resolution(dt)) / unit;
    run.note(fmt::format("{} {:.10g} {}, reference {:.10g} ± {:.1e} ({})", question.title,
                         found.value, question.unit, reference.value, reference.uncertainty,
                         reference.words));
    if (error >= question.lost) {
      found.broken = fmt::format("it did not hold: the error is {:.2g}", error);
    }
  }
  if (!found.broken.empty()) run.add(Failure{found.broken});
  const std::string unit = question.scale > 0.0 ? "1" : question.unit;
  run.add(Figure{kErrorAtMost, unit, "error and what it can't be told from", error + doubt});
  run.add(Figure{kErrorDoubt, unit, "what an error can't be told from", doubt});
  run.add(Figure{kWorkTime, "s/s", "little work a simulated second", times[times.size() / 2]});
  run.add(Figure{kWorkSpread, "1", "slowest repetition over the fastest",
                 times.back() / times.front()});
}

// Every configuration of the engine, with its own number of sweeps and with others.
std::vector<Settings> efforts() {
  std::vector<Settings> all;
  for (const Configuration& one : method_configurations()) {
    all.push_back(one.settings);
    Settings& settings = all.back();
    Options options;
    const Settings given = settings;
    SettingsReader reader(given);
    read_method(reader, options);
    settings["rule"] = options.rule;
    if (settings.at("rule") == "none") continue;
    const int own = friction_rule_card(settings.at("rule")).sweeps;
    const Settings base = settings;
    for (const int sweeps : {1, 8}) {
      if (sweeps == own) continue;
      all.push_back(base);
      all.back()["sweeps"] = fmt::format("{}", sweeps);
    }
  }
  return all;
}

}  // namespace

std::vector<Case> comparisons_work_precision() {
  std::vector<Case> cases;
  for (PrecisionQuestion& question : precision_questions()) {
    const auto known = std::make_shared<KnownReference>(std::move(question));
    for (const int cells : known->question().cells) {
      const StableStep stable = stable_step(known->question(), cells);
      const double finest = known->question().seconds * stable.vertices / kMostWork;
      for (const double dt : time_steps_about(stable.limit, finest)) {
        Case one{.name = fmt::format("{}{}/cells={}/dt={}", kWorkPrecision, known->question().name,
                                     cells, step_text(dt)),
                 .title = fmt::format("{}, {} cells, Δt {} s", known->question().title, cells,
                                      step_text(dt)),
                 .set = CaseSet::kFull,
                 .variants = efforts(),
                 .run = [=](CaseRun& run) { run_question(run, *known, cells); }};
        for (Settings& variant : one.variants) variant["dt"] = step_text(dt);
        cases.push_back(std::move(one));
      }
    }
  }
  return cases;
}

}  // namespace stiction
