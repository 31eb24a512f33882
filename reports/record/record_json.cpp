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

OrderedJson check_json(const Check& check) {
  OrderedJson json = {{"quantity", check.quantity},
                      {"unit", check.unit},
                      {"claim", check.claim},
                      {"formula", check.formula},
                      {"source", check.source},
                      {"kind", to_string(check.kind)},
                      {"value", number(check.value)},
                      {"expected", number(check.expected)},
                      {"error", number(check.error)},
                      {"relative", check.relative},
                      {"scale", number(check.scale)},
                      {"tolerance", number(check.tolerance)},
                      {"reason", check.reason},
                      {"digits", number(check.digits)},
                      {"worst", check.worst},
                      {"cause", check.cause},
                      {"verdict", to_string(check.verdict)}};
  if (check.band) {
    json["expected_low"] = number(check.band->low);
    json["expected_high"] = number(check.band->high);
  }
  return json;
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

OrderedJson cost_json(const Cost& cost) {
  OrderedJson phases = OrderedJson::object();
  for (const auto& [phase, seconds] : cost.phase_seconds) phases[phase] = number(seconds);
  return {{"cpu_seconds", number(cost.cpu_seconds)},
          {"steps", cost.steps},
          {"contact_updates", cost.contact_updates},
          {"ns_per_contact_update", number(cost.ns_per_contact_update)},
          {"phase_seconds", std::move(phases)}};
}

OrderedJson environment_json(const Environment& environment) {
  return {{"revision", environment.revision},
          {"toolchain", environment.toolchain},
          {"machine", environment.machine},
          {"date", environment.date}};
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

std::string optional_text(const JsonField& parent, const char* name) {
  return parent.has(name) ? parent[name].text() : std::string();
}

// Version 2 had a cause without a band, called `limit`.
std::string read_cause(const JsonField& field) {
  return optional_text(field, field.has("limit") ? "limit" : "cause");
}

std::optional<Band> read_band(const JsonField& field) {
  if (!field.has("expected_low") && !field.has("expected_high")) return std::nullopt;
  return Band{field["expected_low"].real(), field["expected_high"].real()};
}

Check read_check(const JsonField& field) {
  Check check;
  check.quantity = field["quantity"].text();
  check.unit = field["unit"].text();
  check.claim = field["claim"].text();
  check.formula = optional_text(field, "formula");
  check.source = field["source"].text();
  check.kind = field["kind"].word(parse_reference_kind);
  check.value = field["value"].real();
  check.expected = field["expected"].real();
  check.error = field["error"].real();
  check.relative = field["relative"].boolean();
  check.scale = field["scale"].real();
  check.tolerance = field["tolerance"].real();
  check.reason = field["reason"].text();
  check.digits = field["digits"].real();
  check.worst = optional_text(field, "worst");
  check.band = read_band(field);
  check.cause = read_cause(field);
  check.verdict = field["verdict"].word(parse_verdict);
  return check;
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

Cost read_cost(const JsonField& field) {
  Cost cost;
  cost.cpu_seconds = field["cpu_seconds"].real();
  cost.steps = field["steps"].count();
  cost.contact_updates = field["contact_updates"].count();
  cost.ns_per_contact_update = field["ns_per_contact_update"].real();
  if (field.has("phase_seconds")) cost.phase_seconds = field["phase_seconds"].map(read_real);
  return cost;
}

Environment read_environment(const JsonField& field) {
  return {field["revision"].text(), field["toolchain"].text(), field["machine"].text(),
          field["date"].text()};
}

Record read_record(const JsonField& field) {
  const std::uint64_t version = field["schema_version"].count();
  if (version < 1 || version > std::uint64_t{Record::kSchemaVersion}) {
    field["schema_version"].fail(
        fmt::format("version {} is not one that this program reads (1 to {})", version,
                    Record::kSchemaVersion));
  }
  Record record;
  record.case_name = field["case"].text();
  record.title = optional_text(field, "title");
  record.engine = field["engine"].text();
  if (field.has("settings")) record.settings = field["settings"].map(read_text);
  record.variant = optional_text(field, "variant");
  record.verdict = field["verdict"].word(parse_verdict);
  record.error = optional_text(field, "error");
  record.checks = field["checks"].list(read_check);
  if (field.has("notes")) record.notes = field["notes"].list(read_text);
  if (field.has("meshes")) record.meshes = field["meshes"].list(read_mesh);
  record.cost = read_cost(field["cost"]);
  record.state_hash = optional_text(field, "state_hash");
  record.environment = read_environment(field["environment"]);
  if (field.has("series")) record.series = field["series"].list(read_series);
  record.frames = optional_text(field, "frames");
  return record;
}

}  // namespace

std::string to_json_line(const Record& record) {
  OrderedJson settings = OrderedJson::object();
  for (const auto& [name, value] : record.settings) settings[name] = value;
  const OrderedJson json = {{"schema_version", Record::kSchemaVersion},
                            {"case", record.case_name},
                            {"title", record.title},
                            {"engine", record.engine},
                            {"settings", std::move(settings)},
                            {"variant", record.variant},
                            {"verdict", to_string(record.verdict)},
                            {"error", record.error},
                            {"checks", array_of(record.checks, check_json)},
                            {"notes", record.notes},
                            {"meshes", array_of(record.meshes, mesh_json)},
                            {"cost", cost_json(record.cost)},
                            {"state_hash", record.state_hash},
                            {"environment", environment_json(record.environment)},
                            {"series", array_of(record.series, series_json)},
                            {"frames", record.frames}};
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

RecordFile read_records(std::istream& stream, const std::string& name) {
  RecordFile file;
  std::string line;
  for (std::size_t number_of_line = 1; std::getline(stream, line); ++number_of_line) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string where = fmt::format("{}:{}", name, number_of_line);
    // getline meets the end of the file only on a line that has no line break.
    if (stream.eof() && !Json::accept(line)) {
      file.unfinished = where + ": the line is cut off; the records before it are complete";
      break;
    }
    file.records.push_back(from_json_line(line, where));
  }
  if (stream.bad()) throw std::runtime_error(name + ": reading failed");
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
