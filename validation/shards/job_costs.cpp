// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/shards/job_costs.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include "reports/text/family.h"

namespace stiction {

namespace {

constexpr double kLeast = 0.02;  // s: starting a case takes that

struct Mean {
  double sum = 0.0;
  int count = 0;
  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

class Table {
 public:
  Table() {
    std::vector<double> all;
    for (const CaseCost& row : case_costs()) {
      const std::string name = row.case_name;
      means_[name + "\n" + row.configuration].add(row.cpu_seconds);
      means_[name].add(row.cpu_seconds);
      means_[family_name(name) + "/"].add(row.cpu_seconds);
      all.push_back(row.cpu_seconds);
    }
    if (all.empty()) return;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    median_ = *middle;
  }

  double seconds(const std::string& case_name, const std::string& configuration) const {
    for (const std::string& key :
         {case_name + "\n" + configuration, case_name, family_name(case_name) + "/"}) {
      const auto found = means_.find(key);
      if (found != means_.end()) return found->second.value() + kLeast;
    }
    return median_ + kLeast;
  }

 private:
  std::map<std::string, Mean> means_{};
  double median_ = 1.0;
};

}  // namespace

std::vector<double> estimated_seconds(const std::vector<Job>& jobs) {
  static const Table table;
  std::vector<double> seconds;
  for (const Job& job : jobs) {
    seconds.push_back(table.seconds(
        job.which.name, called_configuration(job.engine, job.which.name, job.settings).name));
  }
  return seconds;
}

std::vector<std::size_t> order_to_begin(const std::vector<double>& seconds, int threads) {
  std::vector<std::size_t> left(seconds.size()), order;
  std::iota(left.begin(), left.end(), 0);
  double of_left = std::accumulate(seconds.begin(), seconds.end(), 0.0);
  while (!left.empty()) {
    const auto longest =
        std::max_element(left.begin(), left.end(),
                         [&](std::size_t a, std::size_t b) { return seconds[a] < seconds[b]; });
    const auto next = seconds[*longest] * threads >= of_left ? longest : left.begin();
    order.push_back(*next);
    of_left -= seconds[*next];
    left.erase(next);
  }
  return order;
}

std::vector<std::size_t> jobs_of(const Shard& shard, const std::vector<Job>& jobs,
                                 Together together) {
  const std::vector<double> seconds = estimated_seconds(jobs);
  if (together == Together::kNothing) return jobs_of(shard, seconds);
  std::vector<std::string> names;  // of the cases, in order
  std::map<std::string, double> costs;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    if (costs.count(jobs[k].which.name) == 0) names.push_back(jobs[k].which.name);
    costs[jobs[k].which.name] += seconds[k];
  }
  std::vector<double> of_cases;
  for (const std::string& name : names) of_cases.push_back(costs[name]);
  std::set<std::string> own;
  for (const std::size_t k : jobs_of(shard, of_cases)) own.insert(names[k]);
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    if (own.count(jobs[k].which.name) > 0) numbers.push_back(k);
  }
  return numbers;
}

}  // namespace stiction
