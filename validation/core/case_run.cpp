// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/core/case_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "validation/engine/protocol/problem_json.h"
#include "validation/engine/settings.h"
#include "validation/judge/verdict.h"

namespace stiction {

namespace {

// The first few of what may be hundreds.
std::string joined(const std::vector<std::string>& sentences) {
  constexpr std::size_t kTold = 3;
  std::string text;
  for (std::size_t k = 0; k < std::min(kTold, sentences.size()); ++k) {
    text += (k == 0 ? "" : "; ") + sentences[k];
  }
  if (sentences.size() > kTold) text += fmt::format("; and {} more", sentences.size() - kTold);
  return text;
}

}  // namespace

CaseRun::CaseRun(const Case& which, EngineKind engine, Settings settings, double tolerance_scale,
                 bool keeps_frames)
    : engine_(std::move(engine)),
      settings_(std::move(settings)),
      configuration_(engine_.configuration ? engine_.configuration(settings_) : Configuration{}),
      tolerance_scale_(tolerance_scale),
      keeps_frames_(keeps_frames) {
  record_.case_name = which.name;
  record_.title = which.title;
  record_.engine = engine_.name;
  record_.settings = settings_;
  const CalledConfiguration called = called_configuration(engine_, which.name, settings_);
  record_.configuration = called.name;
  record_.differs = called.differs;
  if (tolerance_scale_ != 1.0) note(scale_sentence(tolerance_scale_));
  const std::vector<Settings> variants = variants_of(which, engine_, true);
  if (std::find(variants.begin(), variants.end(), settings_) == variants.end()) return;
  configuration_.contrast = configuration_.contrast || for_contrast(which, engine_, settings_);
  record_.variant = variant_text(settings_);
  if (tolerance_scale_ != 1.0) return;
  expectations_ = expectations_of(engine_.expectations, which.name, record_.variant);
}

CaseRun::Running CaseRun::simulate(const Problem& problem, const Accuracy& accuracy) {
  return simulate_with({}, problem, accuracy);
}

CaseRun::Running CaseRun::simulate_with(const Settings& over, const Problem& problem,
                                        const Accuracy& accuracy) {
  const std::string lacking = missing(engine_.manifest, problem);
  if (!lacking.empty()) throw NotApplicable("the engine has no " + lacking);
  Accuracy asked = accuracy;
  asked.finer *= finer_;
  Running running(new Simulation(engine_, merged(settings_, over), problem, asked,
                                 keeps_frames_ ? &may_record_ : nullptr),
                  {this});
  if (configuration_.contrast) running->shows_contrast();
  running->limit_cpu(cpu_limit_ - record_.cost.cpu_seconds);
  started(running->engine());
  if (record_.problem.empty()) record_.problem = problem_summary(problem);
  ++record_.simulations;
  return running;
}

void CaseRun::need(bool Manifest::*feature, const std::string& words) const {
  if (!(engine_.manifest.*feature)) throw NotApplicable("the engine has no " + words);
}

std::optional<Settings> CaseRun::settings_without(Without what) const {
  return engine_.without ? engine_.without(what) : std::nullopt;
}

void CaseRun::check(Claim claim, double value, std::string worst) {
  const Expectation* known = find_expectation(expectations_, claim.quantity);
  if (known == nullptr ? configuration_.contrast : finer_ != 1) {
    return show(std::move(claim), value, std::move(worst));
  }
  quantities_.insert(claim.quantity);
  Judgement found = judge(std::move(claim), value, tolerance_scale_,
                          known ? std::optional(known_shortfall(*known)) : std::nullopt);
  found.worst = std::move(worst);
  record_.checks.push_back(std::move(found));
}

void CaseRun::show(Claim claim, double value, std::string worst) {
  quantities_.insert(claim.quantity);
  Judgement found = for_information(std::move(claim), value);
  found.worst = std::move(worst);
  record_.checks.push_back(std::move(found));
}

void CaseRun::refine_time(int finer) {
  finer_ = finer;
  record_.variant.clear();  // the steps are the user's own
  note(finer_sentence(finer));
}

void CaseRun::demand_expected_checks() {
  for (const Expectation& row : expectations_) {
    if (quantities_.count(row.quantity) > 0) continue;
    record_.checks.push_back(judge(unmet_claim(row), 0.0));
  }
}

void CaseRun::started(const Engine& engine) {
  const auto size = [](const std::vector<Mesh>& meshes) {
    return std::accumulate(
        meshes.begin(), meshes.end(), std::uint64_t{0},
        [](std::uint64_t sum, const Mesh& mesh) { return sum + mesh.tetrahedra; });
  };
  std::vector<Mesh> meshes = engine.meshes();
  if (size(meshes) > size(record_.meshes)) record_.meshes = std::move(meshes);
  if (settings_resolved_) return;
  record_.settings = engine.settings();
  for (const char* name : {"method", "build"}) {
    const auto found = settings_.find(name);
    if (found != settings_.end()) record_.settings[name] = found->second;
  }
  settings_resolved_ = true;
}

CaseRun CaseRun::part(const Settings& settings) const {
  CaseRun part({.name = record_.case_name, .title = record_.title}, engine_, settings,
               tolerance_scale_);
  part.passages_noted_ = passages_noted_;
  part.finer_ = finer_;
  return part;
}

CaseRun CaseRun::nested(const Case& which, EngineKind engine, Settings settings) const {
  CaseRun run(which, std::move(engine), std::move(settings), tolerance_scale_);
  run.finer_ = finer_;
  return run;
}

void CaseRun::include(const Record& part, bool pays) {
  record_.notes.insert(record_.notes.end(), part.notes.begin(), part.notes.end());
  if (!part.error.empty()) passages_.push_back(part.error);
  hash_.add(part.state_hash.data(), part.state_hash.size());
  if (record_.problem.empty()) record_.problem = part.problem;
  record_.simulations += part.simulations;
  if (pays) bill(part.cost);
}

void CaseRun::TakeOver::operator()(Simulation* simulation) const {
  const std::unique_ptr<Simulation> owned(simulation);
  run->ended(owned->outcome());
}

void CaseRun::ended(Simulated outcome) {
  passed(outcome.passages, outcome.contrast);
  if (!outcome.faults.empty()) {
    const std::string words = "the engine's arithmetic did " + outcome.faults;
    if (outcome.contrast) {
      note(words);
    } else {
      faults_.insert(words + ": what it gave is not to be trusted");
    }
  }
  bill(outcome.cost);
  hash_.add(&outcome.state_hash, sizeof outcome.state_hash);
  if (outcome.recording) recording_ = std::move(outcome.recording);
}

void CaseRun::bill(const Cost& cost) {
  Cost& total = record_.cost;
  total.cpu_seconds += cost.cpu_seconds;
  total.told_cpu_seconds += cost.told_cpu_seconds;
  total.steps += cost.steps;
  total.simulated_seconds += cost.simulated_seconds;
  total.contact_updates += cost.contact_updates;
  for (const auto& [phase, seconds] : cost.phase_seconds) total.phase_seconds[phase] += seconds;
  if (cost.whole_step.median > 0.0) {
    // Of several simulations each counts by its contacts.
    const auto updates = static_cast<double>(cost.contact_updates);
    timed_contacts_ += updates;
    const auto add = [&](const ContactTime& time, ContactTime& sum) {
      sum.median += time.median * updates;
      sum.lower += time.lower * updates;
      sum.upper += time.upper * updates;
    };
    add(cost.contact_phases, contact_phases_);
    add(cost.whole_step, whole_step_);
  }
}

void CaseRun::passed(const std::vector<std::string>& passages, bool noted) {
  if (passages.empty()) return;
  if (noted || passages_noted_) {
    note(joined(passages));
  } else {
    passages_.insert(passages_.end(), passages.begin(), passages.end());
  }
}

Record CaseRun::record() const {
  Record record = record_;
  if (finer_ != 1) {
    record.settings[kFinerSetting] = record.differs[kFinerSetting] = fmt::format("{}", finer_);
  }
  if (timed_contacts_ > 0.0) {
    const auto mean = [this](const ContactTime& sum) -> ContactTime {
      return {sum.median / timed_contacts_, sum.lower / timed_contacts_,
              sum.upper / timed_contacts_};
    };
    record.cost.contact_phases = mean(contact_phases_);
    record.cost.whole_step = mean(whole_step_);
  }
  if (record.cost.steps > 0) record.state_hash = fmt::format("{:016x}", hash_.value());
  record.verdict = verdict_of(record);
  if (!passages_.empty()) {
    record.verdict = Verdict::kError;
    record.error = joined(passages_);
  } else if (!faults_.empty()) {
    record.verdict = Verdict::kError;
    record.error = fmt::format("{}", fmt::join(faults_, "; "));
  }
  return record;
}

}  // namespace stiction
