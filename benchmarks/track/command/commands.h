// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "benchmarks/track/measure/campaign.h"
#include "reports/text/exit_code.h"

namespace stiction::track {

/// What a user may ask for; each command reads its part.
struct Arguments {
  std::string root;     ///< of the project; empty: that of the folder one stands in
  std::string build;    ///< of the present tree; empty: build/release
  std::string work;     ///< for worktrees and the history; empty: build/track
  std::string history;  ///< the SQLite file; empty: history.sqlite in `work`
  std::string against;  ///< a revision
  std::string metric;   ///< name or glob
  std::string good, bad = "HEAD";
  std::string file;        ///< to import or export; "-" is stdin or stdout
  std::string out;         ///< folder of runs for the report page
  int threads = 2;         ///< inside a step, to be compared with one
  std::int64_t run = 0;    ///< id in the history; 0: the last
  std::int64_t other = 0;  ///< the run to compare with it
  bool quick = false;
  bool full = false;
  bool json = false;
  bool markdown = false;
  bool all = false;
  bool verbose = false;
  bool report_improvement = false;
  bool no_record = false;
  Scope scope;
};

/// Each prints to stdout and gives the exit code, or throws TrackError.
int track_against(const Arguments& arguments);
int track_record(const Arguments& arguments);
int track_history(const Arguments& arguments);
int track_compare(const Arguments& arguments);
int track_import(const Arguments& arguments);
int track_export(const Arguments& arguments);
int track_bisect(const Arguments& arguments);
int track_sizes(const Arguments& arguments);

}  // namespace stiction::track
