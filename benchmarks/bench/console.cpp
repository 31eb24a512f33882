// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/bench/console.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "reports/screen/program.h"

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

Console::Console(const MachinePeak& machine, std::vector<std::string> names, std::size_t further,
                 bool verbose)
    : machine_(machine),
      names_(std::move(names)),
      verbose_(verbose),
      progress_(names_.size() + further) {}

void Console::add(const std::string& lines) {
  text_ += lines;
  if (!verbose_) return;
  progress_.clear();
  show(lines);
  std::fflush(stdout);
}

bool Console::ReportContext(const Context&) {
  add(fmt::format("Measured now on one core: {:.1f} GB/s of memory, {:.1f} Gflop/s in double.\n\n",
                  1e-9 * machine_.bytes_per_second, 1e-9 * machine_.flops_per_second));
  add(fmt::format("{:<42}{:>9}{:>12}{:>9}{:>9}{:>9}{:>8}{:>7}\n", "phase / family / size",
                  "contacts", "ns/contact", "B/cont.", "fl/cont.", "of band.", "of peak", "error"));
  progress_.show(0, names_.front());
  return true;
}

void Console::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) {
      add(fmt::format("{:<42} {}\n", plain_name(run), run.error_message));
      continue;
    }
    if (run.aggregate_unit == benchmark::StatisticUnit::kPercentage) {
      add(fmt::format("{:<42}{:>9}{:>11.2f}%\n", plain_name(run), "",
                      100.0 * counter(run, "time_per_contact")));
      continue;
    }
    // A spread is in the unit of its quantity; what it is of is in its name.
    add(fmt::format("{:<42}{:>9.0f}{:>12.1f}{:>9.0f}{:>9.0f}{:>8.0f}%{:>7.0f}%{:>8.1g}\n",
                    plain_name(run), counter(run, "contacts"),
                    1e9 * counter(run, "time_per_contact"), counter(run, "bytes_per_contact"),
                    counter(run, "flops_per_contact"), 100.0 * counter(run, "of_bandwidth"),
                    100.0 * counter(run, "of_peak"), counter(run, "error")));
  }
  // Repetitions of a benchmark come one by one.
  if (!runs.empty() && runs.front().run_name.function_name != last_) {
    last_ = runs.front().run_name.function_name;
    ++done_;
  }
  if (done_ < names_.size()) progress_.show(done_, names_[done_]);
}

bool JsonFile::ReportContext(const Context& context) {
  SetOutputStream(&text_);
  return JSONReporter::ReportContext(context);
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

std::string table(const std::vector<Scaling>& scalings) {
  if (scalings.empty()) return "";
  std::string text =
      fmt::format("\nCost over contacts, time ∝ contactsᵖ\n{:<8}{:<42}{:>12}{:>15}{:>28}\n",
                  "family", "phase", "exponent p", "95 % interval", "ns/contact, small … large");
  for (const Scaling& scaling : scalings) {
    text += fmt::format(
        "{:<8}{:<42}{:>12.3f}{:>15}{:>28}\n", scaling.family, scaling.part, scaling.law.exponent,
        fmt::format("± {:.3f}", scaling.law.exponent_margin),
        fmt::format("{:.1f} … {:.1f}", 1e9 * scaling.seconds.front() / scaling.contacts.front(),
                    1e9 * scaling.seconds.back() / scaling.contacts.back()));
  }
  return text;
}

std::string table(const std::vector<FeatureCost>& features) {
  if (features.empty()) return "";
  std::string text = fmt::format(
      "\nModel only what a scene needs: instructions of a step\n{:<48}{:>14}{:>19}{:>17}\n",
      "feature", "not built in", "unused ÷ without", "used ÷ without");
  for (const FeatureCost& feature : features) {
    text += fmt::format("{:<48}{:>14.0f}{:>19.5f}{:>17.3f}\n", feature.title, feature.without,
                        feature.unused / feature.without, feature.used / feature.without);
  }
  return text;
}

}  // namespace stiction::bench
