// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/record/record_json.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "reports/record/json_field.h"
#include "reports/record/old_record.h"
#include "reports/text/number.h"

namespace stiction {
namespace {

using Json = nlohmann::json;
using OrderedJson =
    nlohmann::ordered_json;  // keeps the order of reports/record/schema.md in the line

// ---- writing

OrderedJson number(double value) {
  if (std::isfinite(value)) return value;
  return format_exact(value);
}

OrderedJson numbers(const std::vector<double>& values) {
  OrderedJson array = OrderedJson::array();
  for (const double value : values) array.push_back(number(value));
  return array;
}

OrderedJson texts(const std::map<std::string, std::string>& entries) {
  OrderedJson json = OrderedJson::object();
  for (const auto& [name, value] : entries) json[name] = value;
  return json;
}

OrderedJson check_json(const Judgement& check) {
  const Claim& claim = check.claim;
  OrderedJson json = {{"quantity", claim.quantity},
                      {"unit", claim.unit},
                      {"claim", claim.statement},
                      {"formula", claim.formula},
                      {"source", claim.source},
                      {"kind", to_string(claim.kind)},
                      {"expected", number(claim.expected)},
                      {"relative", claim.relative}};
  if (claim.scale) json["scale"] = number(*claim.scale);
  json["tolerance"] = number(claim.tolerance);
  json["reason"] = claim.reason;
  json["headline"] = claim.headline;
  json["value"] = number(check.value);
  json["worst"] = check.worst;
  json["error"] = number(check.error);
  json["of_tolerance"] = number(check.of_tolerance);
  if (check.digits) json["digits"] = number(*check.digits);
  if (check.band) json["band"] = numbers({check.band->low, check.band->high});
  json["cause"] = check.cause;
  json["because"] = check.because;
  json["verdict"] = to_string(check.verdict);
  return json;
}

OrderedJson figure_json(const Figure& figure) {
  return {{"quantity", figure.quantity},
          {"unit", figure.unit},
          {"meaning", figure.meaning},
          {"value", number(figure.value)}};
}

OrderedJson failure_json(const Failure& failure) {
  return {{"reason", failure.reason},
          {"parameter", failure.parameter},
          {"values", numbers(failure.values)}};
}

OrderedJson series_json(const Series& series) {
  if (series.x.size() != series.y.size()) {
    throw std::invalid_argument(fmt::format("series \"{}\" has {} x but {} y", series.name,
                                            series.x.size(), series.y.size()));
  }
  return {{"name", series.name},     {"unit", series.unit},    {"x_name", series.x_name},
          {"x_unit", series.x_unit}, {"x", numbers(series.x)}, {"y", numbers(series.y)}};
}

OrderedJson mesh_json(const Mesh& mesh) {
  return {{"bodies", mesh.bodies},
          {"vertices", mesh.vertices},
          {"tetrahedra", mesh.tetrahedra},
          {"min_dihedral_angle", number(mesh.min_dihedral_angle)},
          {"max_dihedral_angle", number(mesh.max_dihedral_angle)},
          {"min_altitude", number(mesh.min_altitude)}};
}

OrderedJson axis_json(const AxisValue& axis) {
  return {{"name", axis.name}, {"unit", axis.unit}, {"value", number(axis.value)}};
}

OrderedJson quartiles_json(const ContactTime& time) {
  return OrderedJson::array({number(time.lower), number(time.upper)});
}

OrderedJson cost_json(const Cost& cost) {
  OrderedJson phases = OrderedJson::object();
  for (const auto& [phase, seconds] : cost.phase_seconds) phases[phase] = number(seconds);
  return {{"cpu_seconds", number(cost.cpu_seconds)},
          {"steps", cost.steps},
          {"contact_updates", cost.contact_updates},
          {"simulated_seconds", number(cost.simulated_seconds)},
          {"ns_per_contact_update", number(cost.contact_phases.median)},
          {"ns_per_contact_update_quartiles", quartiles_json(cost.contact_phases)},
          {"ns_per_contact_step", number(cost.whole_step.median)},
          {"ns_per_contact_step_quartiles", quartiles_json(cost.whole_step)},
          {"told_cpu_seconds", number(cost.told_cpu_seconds)},
          {"phase_seconds", std::move(phases)}};
}

OrderedJson environment_json(const Environment& environment) {
  OrderedJson json = {{"revision", environment.revision},
                      {"toolchain", environment.toolchain},
                      {"machine", environment.machine},
                      {"date", environment.date}};
  if (!environment.host.empty()) json["host"] = environment.host;
  return json;
}

template <typename Element, typename ToJson>
OrderedJson array_of(const std::vector<Element>& elements, ToJson to_json) {
  OrderedJson array = OrderedJson::array();
  for (const Element& element : elements) array.push_back(to_json(element));
  return array;
}

// ---- reading

std::string read_text(const JsonField& field) { return field.text(); }
double read_real(const JsonField& field) { return field.real(); }

Band read_band(const JsonField& field) {
  const std::vector<double> ends = field.list(read_real);
  if (ends.size() != 2) field.fail(fmt::format("expected 2 numbers, found {}", ends.size()));
  return {ends[0], ends[1]};
}

Judgement read_check(const JsonField& field) {
  Judgement check;
  check.claim.quantity = field["quantity"].text();
  check.claim.unit = field["unit"].text();
  check.claim.statement = field["claim"].text();
  check.claim.formula = field.optional_text("formula");
  check.claim.source = field["source"].text();
  check.claim.kind = field["kind"].word(parse_reference_kind);
  check.claim.expected = field["expected"].real();
  check.claim.relative = field["relative"].boolean();
  check.claim.scale = field.optional_real("scale");
  check.claim.tolerance = field["tolerance"].real();
  check.claim.reason = field["reason"].text();
  check.claim.headline = field.optional_text("headline");
  check.value = field["value"].real();
  check.worst = field.optional_text("worst");
  check.error = field["error"].real();
  check.of_tolerance = field["of_tolerance"].real();
  check.digits = field.optional_real("digits");
  if (field.has("band")) check.band = read_band(field["band"]);
  check.cause = field.optional_text("cause");
  check.because = field.optional_text("because");
  check.verdict = field["verdict"].word(parse_verdict);
  return check;
}

Figure read_figure(const JsonField& field) {
  return {field["quantity"].text(), field["unit"].text(), field["meaning"].text(),
          field["value"].real()};
}

Failure read_failure(const JsonField& field) {
  Failure failure{field["reason"].text(), field.optional_text("parameter"), {}};
  if (field.has("values")) failure.values = field["values"].list(read_real);
  return failure;
}

Series read_series(const JsonField& field) {
  Series series;
  series.name = field["name"].text();
  series.unit = field["unit"].text();
  series.x_name = field["x_name"].text();
  series.x_unit = field["x_unit"].text();
  series.x = field["x"].list(read_real);
  series.y = field["y"].list(read_real);
  if (series.x.size() != series.y.size()) {
    field.fail(fmt::format("{} x but {} y", series.x.size(), series.y.size()));
  }
  return series;
}

Mesh read_mesh(const JsonField& field) {
  return {field["bodies"].text(),
          field["vertices"].count(),
          field["tetrahedra"].count(),
          field["min_dihedral_angle"].real(),
          field["max_dihedral_angle"].real(),
          field["min_altitude"].real()};
}

AxisValue read_axis(const JsonField& field) {
  return {field["name"].text(), field["unit"].text(), field["value"].real()};
}

void read_quartiles(const JsonField& cost, const char* name, ContactTime& time) {
  if (!cost.has(name)) return;
  const std::vector<double> two = cost[name].list(read_real);
  if (two.size() != 2) cost[name].fail("two quartiles are required");
  time.lower = two[0];
  time.upper = two[1];
}

Cost read_cost(const JsonField& field) {
  Cost cost;
  cost.cpu_seconds = field["cpu_seconds"].real();
  cost.steps = field["steps"].count();
  cost.contact_updates = field["contact_updates"].count();
  cost.contact_phases.median = field["ns_per_contact_update"].real();
  read_quartiles(field, "ns_per_contact_update_quartiles", cost.contact_phases);
  if (field.has("ns_per_contact_step")) {
    cost.whole_step.median = field["ns_per_contact_step"].real();
    read_quartiles(field, "ns_per_contact_step_quartiles", cost.whole_step);
  }
  if (field.has("simulated_seconds")) cost.simulated_seconds = field["simulated_seconds"].real();
  if (field.has("told_cpu_seconds")) cost.told_cpu_seconds = field["told_cpu_seconds"].real();
  if (field.has("phase_seconds")) cost.phase_seconds = field["phase_seconds"].map(read_real);
  return cost;
}

Environment read_environment(const JsonField& field) {
  return {field["revision"].text(), field["toolchain"].text(), field["machine"].text(),
          field["date"].text(), field.optional_text("host")};
}

Record read_record(const JsonField& field) {
  const std::uint64_t version = field["schema_version"].count();
  if (version < 1 || version > std::uint64_t{Record::kSchemaVersion}) {
    field["schema_version"].fail(
        fmt::format("version {} is not one that this program reads (1 to {})", version,
                    Record::kSchemaVersion));
  }
  const bool is_old = version < 4;
  Record record;
  record.case_name = field["case"].text();
  record.title = field.optional_text("title");
  record.engine = field["engine"].text();
  if (field.has("settings")) record.settings = field["settings"].map(read_text);
  record.variant = field.optional_text("variant");
  record.configuration = field.optional_text("configuration");
  if (field.has("differs")) record.differs = field["differs"].map(read_text);
  if (field.has("simulations")) record.simulations = field["simulations"].count();
  if (field.has("problem")) record.problem = field["problem"].object_text();
  record.verdict = field["verdict"].word(parse_verdict);
  record.error = field.optional_text("error");
  record.checks = field["checks"].list(is_old ? read_old_check : read_check);
  if (field.has("figures")) record.figures = field["figures"].list(read_figure);
  if (field.has("failures")) record.failures = field["failures"].list(read_failure);
  if (field.has("notes")) record.notes = field["notes"].list(read_text);
  if (is_old) split_old_checks_and_notes(record);
  if (field.has("meshes")) record.meshes = field["meshes"].list(read_mesh);
  record.cost = read_cost(field["cost"]);
  record.state_hash = field.optional_text("state_hash");
  record.environment = read_environment(field["environment"]);
  if (field.has("series")) record.series = field["series"].list(read_series);
  if (field.has("job")) record.job = field["job"].count();
  record.point = field.optional_text("point");
  if (field.has("axes")) record.axes = field["axes"].list(read_axis);
  record.frames = field.optional_text("frames");
  return record;
}

}  // namespace

std::string to_json_line(const Record& record) {
  OrderedJson json = {{"schema_version", Record::kSchemaVersion},
                      {"case", record.case_name},
                      {"title", record.title},
                      {"engine", record.engine},
                      {"settings", texts(record.settings)},
                      {"variant", record.variant},
                      {"configuration", record.configuration},
                      {"differs", texts(record.differs)},
                      {"simulations", record.simulations},
                      {"verdict", to_string(record.verdict)},
                      {"error", record.error},
                      {"checks", array_of(record.checks, check_json)},
                      {"figures", array_of(record.figures, figure_json)},
                      {"failures", array_of(record.failures, failure_json)},
                      {"notes", record.notes},
                      {"meshes", array_of(record.meshes, mesh_json)},
                      {"cost", cost_json(record.cost)},
                      {"state_hash", record.state_hash},
                      {"environment", environment_json(record.environment)},
                      {"series", array_of(record.series, series_json)},
                      {"frames", record.frames}};
  if (record.job) json["job"] = *record.job;
  if (!record.point.empty()) {
    json["point"] = record.point;
    json["axes"] = array_of(record.axes, axis_json);
  }
  if (!record.problem.empty()) json["problem"] = OrderedJson::parse(record.problem);
  constexpr int kNoIndent = -1;
  constexpr bool kKeepUnicode = false;
  return json.dump(kNoIndent, ' ', kKeepUnicode, OrderedJson::error_handler_t::replace);
}

Record from_json_line(const std::string& line, const std::string& where) {
  Json json;
  try {
    json = Json::parse(line);
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not valid JSON: {}", where, error.what()));
  }
  return read_record(JsonField(json, where, ""));
}

std::string each_record(std::istream& stream, const std::string& name,
                        const std::function<void(Record)>& use) {
  std::string line, unfinished;
  for (std::size_t number_of_line = 1; std::getline(stream, line); ++number_of_line) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string where = fmt::format("{}:{}", name, number_of_line);
    // getline meets the end of the file only on a line that has no line break.
    if (stream.eof() && !Json::accept(line)) {
      unfinished = where + ": the line is cut off; the records before it are complete";
      break;
    }
    use(from_json_line(line, where));
  }
  if (stream.bad()) throw std::runtime_error(name + ": reading failed");
  return unfinished;
}

RecordFile read_records(std::istream& stream, const std::string& name) {
  RecordFile file;
  file.unfinished =
      each_record(stream, name, [&](Record one) { file.records.push_back(std::move(one)); });
  return file;
}

RecordFile read_records(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(fmt::format("Cannot open \"{}\": {}", file.string(),
                                         std::generic_category().message(errno)));
  }
  return read_records(stream, file.string());
}

}  // namespace stiction
