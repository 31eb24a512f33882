// SPDX-License-Identifier: GPL-3.0-or-later
// Built once with all features and once without each (CMakeLists.txt): a few steps of a scene that
// uses a feature or does not, for callgrind to count.
#include "benchmarks/bench/features.h"
#include "reports/screen/program.h"

int main(int argc, char** argv) {
  return stiction::run_program("step",
                               [&] { return stiction::bench::run_step_program(argc, argv); });
}
