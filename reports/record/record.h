// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stiction {

/// What an expected value rests on.
enum class ReferenceKind { kAnalytic, kExactComputed, kSelfConverged, kExternal, kGolden };

/// Outcome of one check, and of a record as the worst of its checks. `kShown` marks a quantity that
/// is reported beside the verdicts (the old method, a literal reading) and never decides one.
/// `kLimit` and `kRefuted` mark a check whose claim does not hold, but whose value lies in a band
/// that was stated beforehand with its cause (`Check::band`, `Check::cause`): a shortfall of the
/// method, or a claim of the paper that was tested and found not to hold. Outside the band, on
/// either side, it fails.
enum class Verdict { kPass, kFail, kLimit, kRefuted, kNotApplicable, kShown, kError };

/// Where a value is expected that falls short of its claim; both ends belong to it.
struct Band {
  double low = 0.0;   ///< in the check's unit
  double high = 0.0;  ///< in the check's unit; infinite for what diverges
};

/// One quantity held against its expected value.
struct Check {
  std::string quantity{};  ///< what was measured, e.g. "stopping distance"
  std::string unit{};      ///< SI; "1" when dimensionless
  std::string claim{};     ///< one sentence, what must hold
  std::string formula{};   ///< closed form in Unicode maths; may be empty
  std::string source{};    ///< bibliography key or derivation
  ReferenceKind kind = ReferenceKind::kAnalytic;
  double value = 0.0;          ///< measured, in `unit`
  double expected = 0.0;       ///< in `unit`
  double error = 0.0;          ///< value − expected, or its ratio to `scale` when `relative`
  bool relative = false;       ///< error and tolerance are relative to |scale|
  double scale = 1.0;          ///< what a relative error is relative to, in `unit`
  double tolerance = 0.0;      ///< |error| ≤ tolerance holds; same unit as `error`
  std::string reason{};        ///< derivation of the tolerance
  double digits = 0.0;         ///< −log10 of the relative error, capped at 16
  std::string worst{};         ///< where the worst offender stood; may be empty
  std::optional<Band> band{};  ///< where the value is expected, short of its claim; mostly nowhere
  std::string cause{};         ///< why, as measured; empty without a band
  Verdict verdict = Verdict::kFail;
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

/// What a run cost. All zero when nothing was counted.
struct Cost {
  double cpu_seconds = 0.0;            ///< process or thread CPU time of the engine's steps, s
  std::uint64_t steps = 0;             ///< time steps
  std::uint64_t contact_updates = 0;   ///< contacts summed over steps, whatever the sweeps
  double ns_per_contact_update = 0.0;  ///< contact phases only, ns; 0 when not timed
  std::map<std::string, double> phase_seconds{};  ///< CPU time by phase, s; empty when not timed
};

/// Where and with what a record was made.
struct Environment {
  std::string revision{};   ///< git revision, "+" behind it when the tree was changed
  std::string toolchain{};  ///< compiler, version, build type, flags that matter
  std::string machine{};    ///< processor name and core count
  std::string date{};       ///< UTC, ISO 8601
};

/// One record: case × engine × settings. Written as one line of JSON (reports/record/schema.md).
struct Record {
  static constexpr int kSchemaVersion = 3;

  std::string case_name{};  ///< path-like, e.g. "incline/threshold/mu=0.3/azimuth=30"
  std::string title{};      ///< one line for people
  std::string engine{};     ///< e.g. "stiction"
  std::map<std::string, std::string> settings{};  ///< of the engine, e.g. rule → fixed-point
  std::string variant{};  ///< of the case, e.g. "method=paper rule=secant"; empty for a user's own
  std::vector<Check> checks{};
  std::vector<std::string> notes{};  ///< what a reader must know: why a case fails, what limits it
  std::vector<Series> series{};
  std::vector<Mesh> meshes{};  ///< of the finest simulation; empty when the engine shows none
  Cost cost{};
  std::string state_hash{};  ///< 16 hex digits; empty when the engine has none
  Environment environment{};
  Verdict verdict = Verdict::kFail;
  std::string error{};   ///< what went wrong when verdict is kError
  std::string frames{};  ///< file in the run's folder with a Recording (frames.h); may be empty
};

/// Worst of a record's checks: error, then fail, then limit, then refuted, then pass. When nothing
/// decides: kShown if a check is shown, otherwise (an empty list too) kNotApplicable.
Verdict combined_verdict(const std::vector<Check>& checks);

/// The check that decides: of those with the worst verdict (order as above), the one whose |error|
/// is largest against its tolerance (NaN counts as infinite; the first of equals). Null when every
/// check is shown or not applicable. The pointer lives as long as `checks` is unchanged.
const Check* worst_check(const std::vector<Check>& checks);

/// Spelling used in records and tables ("pass", "exact-computed", …), and back.
/// The parsers return nothing for an unknown word.
std::string to_string(Verdict verdict);
std::string to_string(ReferenceKind kind);
std::optional<Verdict> parse_verdict(const std::string& word);
std::optional<ReferenceKind> parse_reference_kind(const std::string& word);

}  // namespace stiction
