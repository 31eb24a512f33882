// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/job_list.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/screen/program.h"
#include "validation/core/needs.h"
#include "validation/shards/job_costs.h"

namespace stiction {

namespace {

std::string line_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

std::string job_list_json(const Portion& portion) {
  const std::vector<Job>& jobs = portion.jobs();
  const std::vector<double> seconds = estimated_seconds(jobs);
  std::map<std::string, std::vector<std::string>> needs;  // of cases
  std::string text = "[";
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const Job& job = jobs[k];
    const auto [found, is_new] = needs.try_emplace(job.which.name);
    if (is_new) found->second = needs_of(job.which);
    const nlohmann::ordered_json json = {
        {"job", portion.number(k)},
        {"name", job.which.name},
        {"title", job.which.title},
        {"set", name_of(job.which.set)},
        {"engine", job.engine.name},
        {"configuration", called_configuration(job.engine, job.which.name, job.settings).name},
        {"settings", nlohmann::ordered_json(job.settings)},
        {"estimated_seconds", std::round(seconds[k] * 1000.0) / 1000.0},
        {"needs", found->second}};
    text += (k == 0 ? "\n" : ",\n") + line_of(json);
  }
  return text + "\n]\n";
}

void show_result_line(const Record& record) {
  const std::optional<double> digits = fewest_digits(record);
  nlohmann::ordered_json json = {{"job", nullptr},
                                 {"verdict", to_string(record.verdict)},
                                 {"case", record.case_name},
                                 {"engine", record.engine},
                                 {"configuration", record.configuration},
                                 {"cpu_seconds", record.cost.cpu_seconds},
                                 {"digits", nullptr},
                                 {"state_hash", record.state_hash},
                                 {"error", record.error}};
  if (record.job) json["job"] = *record.job;
  if (digits && std::isfinite(*digits)) json["digits"] = *digits;
  show_line(line_of(json));
  std::fflush(stdout);
}

}  // namespace stiction
