// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "validation/shards/portion.h"

namespace stiction {

inline CLI::Option* add_shard(CLI::App& app, std::string& shard) {
  return app
      .add_option(
          "--shard", shard,
          "Only the I-th of N parts [by GTEST_SHARD_INDEX or SLURM_ARRAY_TASK_ID, else all]")
      ->type_name("I/N")
      ->group("What runs");
}

inline void add_list_json(CLI::App& app, bool& json) {
  app.add_flag(
         "--json", json,
         "With --list: every job that would run, as a JSON array with what it needs and about "
         "how long it takes")
      ->group("What runs");
}

inline void add_lines(CLI::App& app, bool& lines) {
  app.add_flag("--lines", lines,
               "For programs: a line a result, as soon as it is known, and nothing else "
               "(validation/shards/README.md names its fields)")
      ->group("What is written");
}

/// Those of programs whose parts `./stiction merge` puts together.
inline void add_portion(CLI::App& app, PortionWords& words) {
  add_shard(app, words.shard);
  app.add_option("--parts", words.parts,
                 "Compute nothing: put the parts of this run together that are in the folder "
                 "(./stiction merge asks for it); repeatable")
      ->type_name("DIR")
      ->group("What runs");
}

}  // namespace stiction
