// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/record/judgement.h"

namespace stiction {

/// A measured number that nobody judges: what a comparison sets side by side.
struct Figure {
  std::string quantity{};  ///< e.g. "steps to 1e-9"
  std::string unit{};      ///< SI; "1" when dimensionless
  std::string meaning{};   ///< one sentence: what a small value means
  double value = 0.0;      ///< in `unit`; infinite: it did not get there
};

/// What broke while figures were measured. A sweep over a parameter names the values that did;
/// without values it is the whole record.
struct Failure {
  std::string reason{};          ///< one sentence
  std::string parameter{};       ///< e.g. "gain"; empty without values
  std::vector<double> values{};  ///< of the parameter
};

/// A quantity over time or over a parameter, decimated to what a plot can show.
struct Series {
  std::string name{};    ///< e.g. "kinetic energy"
  std::string unit{};    ///< of y
  std::string x_name{};  ///< e.g. "time"
  std::string x_unit{};  ///< of x
  std::vector<double> x{};
  std::vector<double> y{};  ///< as many as x
};

/// The mesh that an engine made of a body, and how well shaped it is.
struct Mesh {
  std::string bodies{};  ///< name, or "the first and n more" of one mesh
  std::uint64_t vertices = 0;
  std::uint64_t tetrahedra = 0;
  double min_dihedral_angle = 0.0;  ///< degrees
  double max_dihedral_angle = 0.0;  ///< degrees
  double min_altitude = 0.0;        ///< shortest of any tetrahedron, m
};

/// Wall-clock time of a step over its contacts, ns: median and quartiles over the steps that were
/// timed. All zero when none was.
struct ContactTime {
  double median = 0.0, lower = 0.0, upper = 0.0;
};

/// What a run cost. All zero when nothing was counted.
struct Cost {
  double cpu_seconds = 0.0;        ///< process or thread CPU time of the engine's steps, s
  double told_cpu_seconds = 0.0;   ///< what an engine of its own process says of itself; 0: nothing
  std::uint64_t steps = 0;         ///< time steps
  double simulated_seconds = 0.0;  ///< Δt summed over steps, s; 0: not told
  std::uint64_t contact_updates = 0;  ///< contacts summed over steps, whatever the sweeps
  ContactTime contact_phases{};       ///< normal force and friction
  ContactTime whole_step{};           ///< all phases
  std::map<std::string, double> phase_seconds{};  ///< wall-clock, s; empty when not timed
};

/// What a sweep varied, and to which value.
struct AxisValue {
  std::string name{};  ///< e.g. "ramp.slope_deg"
  std::string unit{};  ///< "1" when dimensionless
  double value = 0.0;  ///< in `unit`
};

/// Where and with what a record was made.
struct Environment {
  std::string revision{};   ///< git revision, "+" behind it when the tree was changed
  std::string toolchain{};  ///< compiler, version, build type, flags that matter
  std::string machine{};    ///< processor name and core count
  std::string date{};       ///< UTC, ISO 8601
  std::string host{};       ///< the machine's name in its network; empty: not told
};

/// Among a record's settings, how the case was perturbed, which is none of its engine: "turned/1"
/// (validation/stability/).
inline constexpr const char* kPerturbedSetting = "perturbed";
/// … and by how much its time steps are finer than those that the case takes else: "2" (--finer).
inline constexpr const char* kFinerSetting = "finer";

/// One record: case × engine × settings. Written as one line of JSON (reports/record/schema.json).
struct Record {
  static constexpr int kSchemaVersion = 4;

  std::string case_name{};  ///< path-like, e.g. "incline/threshold/mu=0.3/azimuth=30"
  std::string title{};      ///< one line for people
  std::string engine{};     ///< e.g. "stiction"
  std::map<std::string, std::string> settings{};  ///< of the engine, e.g. rule → fixed-point
  std::string variant{};  ///< of the case, e.g. "method=paper rule=secant"; empty for a user's own
  std::string configuration{};  ///< what people call the way it was run, e.g. "paper, secant"
  std::map<std::string, std::string> differs{};  ///< settings over those of the configuration
  std::uint64_t simulations = 0;                 ///< that the case ran; a bisection runs dozens
  /// The first simulation's problem, as a JSON object (schema.json); empty when none was told.
  std::string problem{};
  std::vector<Judgement> checks{};
  std::vector<Figure> figures{};     ///< of a comparison
  std::vector<Failure> failures{};   ///< of a comparison
  std::vector<std::string> notes{};  ///< what a reader must know: why a case fails, what limits it
  std::vector<Series> series{};
  std::vector<Mesh> meshes{};  ///< of the finest simulation; empty when the engine shows none
  Cost cost{};
  std::string state_hash{};  ///< 16 hex digits; empty when the engine has none
  Environment environment{};
  Verdict verdict = Verdict::kFail;
  std::string error{};                 ///< what went wrong when verdict is kError
  std::optional<std::uint64_t> job{};  ///< its place in the whole run, from 0; of a part's too
  std::string point{};            ///< of a sweep: 16 hex digits, a hash of what was run; else empty
  std::vector<AxisValue> axes{};  ///< of a sweep
  std::string frames{};  ///< file in the run's folder with a Recording (frames.h); may be empty
};

/// Worst of a record's checks; kForInformation for one that has only figures.
Verdict verdict_of(const Record& record);

/// The digits of a record: fewest of its checks that pass or fail and have any; NaN counts as
/// fewest. Nothing when there is none.
std::optional<double> fewest_digits(const Record& record);

}  // namespace stiction
