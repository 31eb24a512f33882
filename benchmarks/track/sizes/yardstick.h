// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "benchmarks/track/measure/tree.h"
#include "reference/process/conversation.h"

namespace stiction::track {

/// How steps are run: by whose yardstick (benchmarks/yardstick/), in registers of how many doubles, on how
/// many threads.
struct Way {
  std::string name;     ///< "before", "now", "registers of 2", "2 threads"
  std::string program;  ///< the yardstick
  int width = 0;        ///< 0: the widest that the processor has
  int threads = 1;
};

/// A workload: contacts between bodies of a family, about so many.
struct Workload {
  std::string family;
  int contacts = 0;
  bool is_long = false;  ///< measured with --full alone

  std::string name() const { return "step/" + family + "/contacts:" + std::to_string(contacts); }
};

/// Those that a yardstick knows. Throws TrackError, as all below.
std::vector<Workload> workloads_of(const std::string& yardstick);

/// Widths of the registers of this processor, in doubles, narrowest first; of the present yardstick alone.
std::vector<int> widths_of(const std::string& yardstick);

/// A yardstick at work on one workload.
class Yardstick {
 public:
  Yardstick(const Way& way, const Workload& workload);

  struct Settled {
    double contacts = 0.0;
    bool at_rest = false;
    double error = 0.0;  ///< the workload's, dimensionless
  };
  Settled settle();

  /// Of steps in a row from where it settled, s a step.
  struct Steps {
    double cpu = 0.0, wall = 0.0;
    std::map<std::string, double> phases;  ///< wall-clock, by name
    std::string hash;                      ///< of the state that they end in
  };
  Steps steps();

  /// Keeps its thread on a processor from now on, by the system's number; for ways of one thread.
  void stay_on(int processor);

  /// What a step takes at least: of the model's bytes by this machine's bandwidth, of its operations by
  /// what one core does of them, s. The present yardstick tells it alone, once settled.
  struct Limits {
    double bandwidth = 0.0, arithmetic = 0.0;
  };
  Limits limits();

 private:
  std::string what_;
  reference::Conversation conversation_;
};

}  // namespace stiction::track
