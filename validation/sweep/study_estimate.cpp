// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/sweep/study_estimate.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "reports/text/text.h"
#include "validation/shards/job_costs.h"
#include "validation/user/preview.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

constexpr std::size_t kTried = 5;  // points of each engine
constexpr std::size_t kTold = 6;   // points

std::string axis_text(const Axis& axis) {
  const std::string unit = axis.unit == "1" ? "" : " " + shown_unit(axis.unit);
  if (axis.values.empty()) {
    return fmt::format("{} from {:g} to {:g}{}{}", axis.vary, axis.from, axis.to, unit,
                       axis.log ? ", by factors" : "");
  }
  if (axis.values.size() == 1) return fmt::format("{} = {:g}{}", axis.vary, axis.values[0], unit);
  return fmt::format("{}: {} values from {:g} to {:g}{}", axis.vary, axis.values.size(),
                     axis.values.front(), axis.values.back(), unit);
}

// CPU time of the points from `first` on, s, by a few among them; none where all of those broke off.
std::optional<double> cpu_seconds(const Points& points, std::size_t first, std::size_t count) {
  const std::size_t tried = std::min(kTried, count);
  double sum = 0.0;
  int known = 0;
  for (std::size_t k = 0; k < tried; ++k) {
    const std::size_t point = first + (tried == 1 ? 0 : k * (count - 1) / (tried - 1));
    try {
      const Job job = points.job(point);
      sum += estimate(points.problem(point), job.engine, job.settings).cpu_seconds;
      ++known;
    } catch (const std::exception&) {
      continue;  // its record will say why it cannot run
    }
  }
  if (known == 0) return std::nullopt;
  return sum / known * static_cast<double>(count);
}

// Of a study of cases: by the table of what they cost.
double case_seconds(const Study& study, const Points& points) {
  std::vector<Job> jobs;  // one of an engine and case stands for its others
  for (std::size_t k = 0; k < points.size(); k += study.designs()) jobs.push_back(points.job(k));
  const std::vector<double> seconds = estimated_seconds(jobs);
  return std::accumulate(seconds.begin(), seconds.end(), 0.0) *
         static_cast<double>(study.designs());
}

std::optional<double> all_seconds(const Study& study, const Points& points) {
  if (!study.problem) return case_seconds(study, points);
  const std::size_t each = points.size() / study.engines.size();
  double total = 0.0;
  bool known = false;
  for (std::size_t k = 0; k < study.engines.size(); ++k) {
    const std::optional<double> seconds = cpu_seconds(points, k * each, each);
    known = known || seconds;
    total += seconds.value_or(0.0);
  }
  if (!known) return std::nullopt;
  return total;
}

// What this process took, which has run some points, and what a sweep holds of each (measured: 0.5 kB).
double memory_mib(const Points& points) {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0 + static_cast<double>(points.size()) / 1024.0;
}

}  // namespace

std::string dry_run_json(const Study& study, const Points& points) {
  nlohmann::ordered_json json = {{"study", study.name}, {"points", points.size()}};
  json["engines"] = nlohmann::ordered_json::array();
  for (const StudyEngine& one : study.engines) json["engines"].push_back(name_of(one));
  const std::optional<double> seconds = all_seconds(study, points);
  json["cpu_seconds"] = seconds ? nlohmann::ordered_json(*seconds) : nullptr;
  json["memory_mib"] = std::ceil(memory_mib(points));
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string dry_run_screen(const Study& study, const Points& points, int jobs,
                           const Screen& screen) {
  std::string text = bullet(study.title, screen.width, "");
  for (const Axis& axis : study.axes) text += bullet(axis_text(axis), screen.width);
  if (study.samples) {
    text += bullet(fmt::format("{} samples of that box", study.samples->count), screen.width);
  }
  const std::size_t each = points.size() / study.engines.size();
  double total = 0.0;
  for (std::size_t k = 0; k < study.engines.size(); ++k) {
    std::string words = fmt::format("engine {}: {} points", name_of(study.engines[k]), each);
    if (study.problem) {
      const std::optional<double> seconds = cpu_seconds(points, k * each, each);
      words += seconds ? fmt::format(", about {} of CPU time", time_text(*seconds))
                       : ", none of those tried can run";
      total += seconds.value_or(0.0);
    }
    text += bullet(words, screen.width);
  }
  text += fmt::format("{} points", points.size());
  if (study.problem) {
    text += fmt::format(": about {} with {} at a time", time_text(total / jobs), jobs);
  }
  text += '\n';
  for (std::size_t k = 0; k < std::min(kTold, points.size()); ++k) {
    text += fmt::format("  {}  {}\n", points.hash(k), one_line(points.name(k)));
  }
  if (points.size() > kTold) text += fmt::format("  and {} more\n", points.size() - kTold);
  return text;
}

}  // namespace stiction
