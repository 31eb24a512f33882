// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "solver/demand.h"
#include "validation/core/digest.h"
#include "validation/engine/settings.h"
#include "validation/shards/run_plan.h"
#include "validation/user/user_run.h"

namespace stiction {

namespace {

namespace fs = std::filesystem;

std::string settings_words(const Settings& settings) {
  std::string words;
  for (const auto& [name, value] : settings) words += name + "=" + value + "\n";
  return words;
}

}  // namespace

Points::Points(const Study& study) : study_(study), alike_("point 1\n" + revision_words() + "\n") {
  if (study.problem) alike_ += surface_words(*study.problem);
  if (study.keeps_series) alike_ += "with series\n";
  for (const StudyEngine& one : study.engines) {
    engines_.push_back(engine_words(one.kind) + settings_words(one.settings));
  }
  if (!study.samples) return;
  const Samples& how = *study.samples;
  samples_ = reference::unit_samples(how.method, study.axes.size(), how.count, how.seed);
}

Points::Place Points::place(std::size_t point) const {
  const std::size_t designs = study_.designs();
  const std::size_t cases = std::max<std::size_t>(1, study_.cases.size());
  return {point / (designs * cases), point / designs % cases, point % designs};
}

const StudyEngine& Points::engine(std::size_t point) const {
  return study_.engines[place(point).engine];
}

std::vector<double> Points::values(std::size_t point) const {
  std::size_t design = place(point).design;
  std::vector<double> values(study_.axes.size());
  for (std::size_t k = study_.axes.size(); k-- > 0;) {
    const Axis& axis = study_.axes[k];
    if (study_.samples) {
      values[k] = at_share(axis, samples_[design][k]);
    } else {
      values[k] = axis.values[design % axis.values.size()];
      design /= axis.values.size();
    }
  }
  return values;
}

std::string Points::name(std::size_t point) const {
  std::string name =
      study_.problem ? "user/" + study_.problem_name : study_.cases[place(point).which].name;
  const std::vector<double> all = values(point);
  for (std::size_t k = 0; k < all.size(); ++k) {
    name += fmt::format("/{}={}", study_.axes[k].vary, all[k]);
  }
  return name;
}

toml::table Points::root(std::size_t point) const {
  toml::table root = study_.problem ? study_.problem->root : toml::table{};
  const std::vector<double> all = values(point);
  for (std::size_t k = 0; k < all.size(); ++k) set_value(root, study_.axes[k].vary, all[k]);
  return root;
}

std::string Points::hash(std::size_t point) const {
  std::ostringstream words;
  words << alike_ << engines_[place(point).engine];
  if (!study_.problem) words << study_.cases[place(point).which].name << '\n';
  words << toml::toml_formatter(root(point));
  return hash_of_words(words.str());
}

std::string Points::plan() const {
  std::string words = alike_ + hash_of_file(study_.file);
  for (const std::string& engine : engines_) words += engine;
  if (study_.problem) words += hash_of_file(study_.problem->file);
  return hash_of_words(words);
}

UserProblem Points::problem(std::size_t point) const {
  return read_parsed(study_.problem->file, root(point));
}

Job Points::job(std::size_t point) const {
  const StudyEngine& one = engine(point);
  Job job;
  job.engine = one.kind;
  if (!study_.problem) {
    job.which = study_.cases[place(point).which];
    Settings varied;
    const std::vector<double> all = values(point);
    for (std::size_t k = 0; k < all.size(); ++k) {
      varied[study_.axes[k].vary.substr(std::string("engine.").size())] = fmt::format("{}", all[k]);
    }
    job.settings = merged(one.settings, varied);
    return job;
  }
  job.which.name = name(point);
  job.which.title = study_.title;
  job.settings = one.settings;
  try {
    auto user = std::make_shared<const UserProblem>(problem(point));
    job.settings = merged(one.settings, user->settings);
    job.which.variants = {job.settings};
    job.which.run = [user](CaseRun& run) { run_user_problem(run, *user); };
  } catch (const InputError& error) {
    job.which.run = [error](CaseRun&) { throw error; };
  }
  return job;
}

Record Points::finished(std::size_t point, Record record) const {
  record.case_name = name(point);
  if (study_.problem) record.title = study_.title;
  record.job = point;
  record.point = hash(point);
  record.axes.clear();
  const std::vector<double> all = values(point);
  for (std::size_t k = 0; k < all.size(); ++k) {
    record.axes.push_back({study_.axes[k].vary, study_.axes[k].unit, all[k]});
  }
  if (!study_.keeps_series) record.series.clear();
  return record;
}

}  // namespace stiction
