// SPDX-License-Identifier: GPL-3.0-or-later
// What `track sizes` measures whole steps with. It is built with this revision's solver, and together with this
// revision's workloads with another's (beside.cmake), whose own bench may have timed something else under the
// same name. So it takes only what revisions have in common, and asks whether they have the rest.
//
//   yardstick --list                      family, contacts, 1 if that is a size of long runs: a line each
//   yardstick --widths                    those of this processor's registers
//   yardstick FAMILY CONTACTS [THREADS]   answers, a line of JSON for each line that it reads:
//     settle   {"contacts":…,"at_rest":true,"error":…}
//     steps    {"cpu":…,"wall":…,"phases":{"forces":…},"hash":"…"}   s a step, of 32 from there
//     on K     {}                                                    from now on by the system's processor K alone
//     limits   {"bandwidth":…,"arithmetic":…}                        s a step, what the machine allows
#include <sched.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "benchmarks/workloads/workload.h"
#include "solver/hash.h"
#include "solver/step.h"
#include "validation/engine/cpu_time.h"
#if __has_include("solver/parallel/team.h")
#include "solver/parallel/team.h"
#else
namespace stiction {
struct Team {
  explicit Team(int threads) {
    if (threads != 1) throw std::runtime_error("this revision has no threads inside a step");
  }
};
}  // namespace stiction
#endif
#if __has_include("solver/parallel/team_choice.h")
#include "solver/parallel/team_choice.h"
#define STICTION_CHOOSES
#endif
#ifdef STICTION_PRESENT  // built with its own revision
#include "benchmarks/bench/cost_model.h"
#include "benchmarks/bench/machine_peak.h"
#include "solver/lanes/lane_width.h"
#endif

namespace stiction::bench {

namespace {

constexpr int kSteps = 32;

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// A team of one is none, as for who never asked for threads.
template <class AWorkspace>
void give(AWorkspace& workspace, const Team* team, int threads) {
  if constexpr (requires { workspace.team = team; }) {
    if (threads > 1) workspace.team = team;
  }
}

class Yardstick {
 public:
  Yardstick(const std::string& family, int contacts, int threads)
      : contacts_(contacts), threads_(threads), team_(threads) {
    for (const WorkloadFamily& one : family_catalog()) {
      if (one.name == family) family_ = one;
    }
    if (family_.name.empty()) {
      throw std::runtime_error("there is no family of workloads '" + family + "'");
    }
  }

  std::string settle() {
    settled_ = bench::settle(family_, contacts_);
    bool at_rest = true;
    for (const Judgement& check : settled_.checks) {
      at_rest = at_rest && check.verdict == Verdict::kPass;
    }
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), R"({"contacts":%zu,"at_rest":%s,"error":%.6g})",
                  settled_.contacts(), at_rest ? "true" : "false", settled_.error());
    return text.data();
  }

  std::string steps() {
    demand_settled();
    choose();
    begin();
    const double cpu = thread_cpu_seconds(), wall = wall_seconds();
    go_on();
    const double cpu_step = (thread_cpu_seconds() - cpu) / kSteps;
    const double wall_step = (wall_seconds() - wall) / kSteps;
    // Once more with clocks between phases, which whole steps are not to pay for.
    begin();
    PhaseSeconds seconds{};
    work_.workspace.phase_seconds = &seconds;
    go_on();
    work_.workspace.phase_seconds = nullptr;
    std::array<char, 100> part{};
    std::string phases;
    for (std::size_t p = 0; p < kPhaseNames.size(); ++p) {
      std::snprintf(part.data(), part.size(), R"(%s"%s":%.6g)", p == 0 ? "" : ",", kPhaseNames[p],
                    seconds[p] / kSteps);
      phases += part.data();
    }
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  R"({"cpu":%.6g,"wall":%.6g,"hash":"%016llx","phases":{)", cpu_step, wall_step,
                  static_cast<unsigned long long>(hash_of(work_.state)));
    return text.data() + phases + "}}";
  }

  std::string limits() const {
#ifdef STICTION_PRESENT
    demand_settled();
    const MachinePeak peak = measure_peak();
    const ModelledCost cost = modelled_cost({"step", {}, true, settled_.options.rule}, settled_);
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), R"({"bandwidth":%.6g,"arithmetic":%.6g})",
                  cost.bytes / peak.bytes_per_second, cost.flops / peak.flops_per_second);
    return text.data();
#else
    throw std::runtime_error("only the present revision is asked for limits");
#endif
  }

 private:
  void demand_settled() const {
    if (!settled_.scene) throw std::runtime_error("it has not settled yet");
  }

  // Whether threads pay just now, which the solver finds as steps go on, if it can.
  void choose() {
#ifdef STICTION_CHOOSES
    if (threads_ == 1) return;
    TeamChoice choice(team_);
    work_ = settled_;
    work_.workspace.team_choice = &choice;
    go_on(TeamChoice::kFirst + TeamChoice::kTrial);
    work_.workspace.team_choice = nullptr;
    chosen_ = choice.chosen();
#endif
  }

  void begin() {
    work_ = settled_;
    give(work_.workspace, chosen_, threads_);
  }

  void go_on(int steps = kSteps) {
    for (int k = 0; k < steps; ++k) {
      step(*work_.scene, work_.options, work_.state, work_.workspace);
    }
  }

  WorkloadFamily family_;
  int contacts_, threads_;
  Team team_;
  const Team* chosen_ = &team_;
  Workload settled_, work_;
};

void list() {
  for (const WorkloadFamily& family : family_catalog()) {
    for (const int size : family.sizes) std::printf("%s %d 0\n", family.name.c_str(), size);
    for (const int size : family.full_sizes) std::printf("%s %d 1\n", family.name.c_str(), size);
  }
}

void list_widths() {
#ifdef STICTION_PRESENT
  for (const int width : lane_widths()) std::printf("%d\n", width);
#endif
}

int whole_number(const std::string& word, int least = 1) {
  std::size_t read = 0;
  int number = 0;
  try {
    number = std::stoi(word, &read);
  } catch (const std::logic_error&) {
    read = 0;
  }
  if (read == 0 || read != word.size() || number < least) {
    throw std::runtime_error("'" + word + "' is no number of contacts, threads or processors");
  }
  return number;
}

// As reference/process/processors.h has it, which other revisions need not have. Without a word where the system
// doesn't let it: then it is timed wherever it runs.
void stay_on(int processor) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (processor < CPU_SETSIZE) CPU_SET(processor, &set);
  sched_setaffinity(0, sizeof set, &set);
}

// The next line of stdin; false at its end.
bool read_line(std::string& line) {
  line.clear();
  for (int c = std::getchar(); c != EOF; c = std::getchar()) {
    if (c == '\n') return true;
    line += static_cast<char>(c);
  }
  return false;
}

void converse(Yardstick& yardstick) {
  for (std::string line; read_line(line);) {
    std::string answer;
    if (line == "settle") {
      answer = yardstick.settle();
    } else if (line == "steps") {
      answer = yardstick.steps();
    } else if (line.starts_with("on ")) {
      stay_on(whole_number(line.substr(3), 0));
      answer = "{}";
    } else if (line == "limits") {
      answer = yardstick.limits();
    } else {
      throw std::runtime_error("it is asked for '" + line + "', which it doesn't know");
    }
    std::printf("%s\n", answer.c_str());
    std::fflush(stdout);
  }
}

void run(int argc, char** argv) {
  const auto word = [&](int k) { return std::string(k < argc ? argv[k] : ""); };
  if (word(1) == "--list") return list();
  if (word(1) == "--widths") return list_widths();
  if (argc < 3) throw std::runtime_error("usage: yardstick FAMILY CONTACTS [THREADS]");
  Yardstick yardstick(word(1), whole_number(word(2)), argc > 3 ? whole_number(word(3)) : 1);
  converse(yardstick);
}

}  // namespace

}  // namespace stiction::bench

int main(int argc, char** argv) {
  try {
    stiction::bench::run(argc, argv);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "yardstick: %s\n", error.what());
    return 2;
  }
}
