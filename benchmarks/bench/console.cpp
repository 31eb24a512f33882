// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/console.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace stiction::bench {

namespace {

std::string plain_name(const benchmark::BenchmarkReporter::Run& run) {
  std::string name = run.run_name.function_name;
  if (!run.aggregate_name.empty()) name += "_" + run.aggregate_name;
  return name;
}

double counter(const benchmark::BenchmarkReporter::Run& run, const char* name) {
  const auto at = run.counters.find(name);
  return at == run.counters.end() ? NAN : static_cast<double>(at->second);
}

}  // namespace

bool Console::ReportContext(const Context&) {
  fmt::print("Measured now on one core: {:.1f} GB/s of memory, {:.1f} Gflop/s in double.\n\n",
             1e-9 * machine_.bytes_per_second, 1e-9 * machine_.flops_per_second);
  fmt::print("{:<42}{:>9}{:>12}{:>9}{:>9}{:>9}{:>8}{:>7}\n", "phase / family / size", "contacts",
             "ns/contact", "B/cont.", "fl/cont.", "of band.", "of peak", "error");
  return true;
}

void Console::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) {
      fmt::print("{:<42} {}\n", plain_name(run), run.error_message);
      continue;
    }
    if (run.aggregate_unit == benchmark::StatisticUnit::kPercentage) {
      fmt::print("{:<42}{:>9}{:>11.2f}%\n", plain_name(run), "",
                 100.0 * counter(run, "time_per_contact"));
      continue;
    }
    // A spread is in the unit of its quantity; what it is of is in its name.
    fmt::print("{:<42}{:>9.0f}{:>12.1f}{:>9.0f}{:>9.0f}{:>8.0f}%{:>7.0f}%{:>8.1g}\n",
               plain_name(run), counter(run, "contacts"), 1e9 * counter(run, "time_per_contact"),
               counter(run, "bytes_per_contact"), counter(run, "flops_per_contact"),
               100.0 * counter(run, "of_bandwidth"), 100.0 * counter(run, "of_peak"),
               counter(run, "error"));
  }
  std::fflush(stdout);
}

void JsonFile::ReportRuns(const std::vector<Run>& runs) {
  std::vector<Run> renamed = runs;
  for (Run& run : renamed) {
    run.run_name.time_type.clear();
    run.run_name.min_time.clear();
    // What it calls CPU time includes the restoring between batches; ours is CPU time already.
    run.cpu_accumulated_time = run.real_accumulated_time;
  }
  benchmark::JSONReporter::ReportRuns(renamed);
}

void print(const std::vector<Scaling>& scalings) {
  if (scalings.empty()) return;
  fmt::print("\nCost over contacts, time ∝ contactsᵖ\n{:<8}{:<42}{:>12}{:>15}{:>28}\n", "family",
             "phase", "exponent p", "95 % interval", "ns/contact, small … large");
  for (const Scaling& scaling : scalings) {
    fmt::print(
        "{:<8}{:<42}{:>12.3f}{:>15}{:>28}\n", scaling.family, scaling.part, scaling.law.exponent,
        fmt::format("± {:.3f}", scaling.law.exponent_margin),
        fmt::format("{:.1f} … {:.1f}", 1e9 * scaling.seconds.front() / scaling.contacts.front(),
                    1e9 * scaling.seconds.back() / scaling.contacts.back()));
  }
}

void print(const std::vector<FeatureCost>& features) {
  fmt::print("\nModel only what a scene needs: instructions of a step\n{:<48}{:>14}{:>19}{:>17}\n",
             "feature", "not built in", "unused ÷ without", "used ÷ without");
  for (const FeatureCost& feature : features) {
    fmt::print("{:<48}{:>14.0f}{:>19.5f}{:>17.3f}\n", feature.title, feature.without,
               feature.unused / feature.without, feature.used / feature.without);
  }
}

}  // namespace stiction::bench
