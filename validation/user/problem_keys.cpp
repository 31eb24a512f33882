// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/problem_keys.h"

#include <fmt/format.h>

#include "reports/screen/screen.h"
#include "reports/text/text.h"
#include "validation/observe/observe.h"
#include "validation/user/quantity.h"

namespace stiction {

namespace {

constexpr const char* kNeeded = "must be given";

// Of what changes over time; `value` is the name of its keyframes' values, `unit` theirs.
std::vector<TomlKey> keys_over_time(const std::string& value, const std::string& unit) {
  return {{"time", "s", "[0, 1, …]", "none",
           "when the keyframes are; joined by a C² smooth step, whose acceleration reaches "
           "5.77 of the distance over the square of the time"},
          {value, unit, "[[x, y, z], …]", "none", "the vector at each of those times"},
          {"constant", unit, "[x, y, z]", "zero", "the vector at all times, in place of keyframes"},
          {"amplitude", unit, "[x, y, z]", "zero",
           "of a sine on top of it: amplitude · sin(2π · frequency · (t − begins) + phase)"},
          {"frequency", "Hz", "3", "needed with `amplitude`", "of the sine"},
          {"phase_deg", "deg", "90", "0", "of the sine"},
          {"begins", "s", "0.5", "0", "when the sine begins to grow; before it is zero"},
          {"full_from", "s", "1", "`begins`", "when it has grown to its whole amplitude"}};
}

TomlKeys over_time(const char* table, const char* meaning, const char* value, const char* unit) {
  return {table, meaning, keys_over_time(value, unit)};
}

TomlKeys with(TomlKeys keys, TomlKey more) {
  keys.keys.push_back(std::move(more));
  return keys;
}

}  // namespace

namespace problem_keys {

const TomlKeys& file() {
  static const TomlKeys keys = {
      "the file",
      "What stands at the top, before the first table. All numbers are in SI units, or texts with "
      "a unit: \"5 MPa\". The z axis points up.",
      {{"title", "", "\"text\"", "the file's name", "one line for people"},
       {"duration", "s", "3", kNeeded, "how long is simulated"},
       {"gravity", "m/s²", "[x, y, z] or a table", "[0, 0, -9.81]", "see [gravity]"},
       {"friction", "1", "0.5", "0",
        "μ of all bodies against each other; of single pairs see [[pair]]"},
       {"restitution", "1", "0.5", "0",
        "of every contact, normal speed after it over before; for engines that take one: bodies of "
        "`stiction` rebound by their elasticity"},
       {"initial_overlap", "", "\"refused\" or \"allowed\"", "\"refused\"",
        "whether bodies may begin inside each other or in an obstacle"},
       {"drag", "", "a table", "no medium", "see [drag]"},
       {"engine", "", "a table", "as the engine is by default",
        "settings of the engine, by the names that `./stiction engine show NAME` lists"},
       {"obstacle", "", "tables", "none", "see [[obstacle]]"},
       {"body", "", "tables", kNeeded, "see [[body]]"},
       {"load", "", "tables", "none", "see [[load]]"},
       {"spring", "", "tables", "none", "see [[spring]]"},
       {"pair", "", "tables", "none", "see [[pair]]"},
       {"check", "", "tables", kNeeded, "see [[check]]"},
       {"series", "", "tables", "none", "see [[series]]"},
       {"threshold", "", "a table", "none", "see [threshold]"},
       {"sweep", "", "a table", "none", "see [sweep]"}}};
  return keys;
}

const TomlKeys& gravity() {
  static const TomlKeys keys = over_time(
      "[gravity]",
      "Gravity over time. Let it grow where an elastic body shall settle before it is loaded.",
      "acceleration", "m/s²");
  return keys;
}

const TomlKeys& drag() {
  static const TomlKeys keys = {
      "[drag]",
      "A medium in which the scene settles: force −rate · mass · velocity, which then fades.",
      {{"rate", "1/s", "50", kNeeded, "of the damping"},
       {"full_until", "s", "0.3", kNeeded, "when it begins to fade"},
       {"ends", "s", "0.5", kNeeded, "when it has gone"}}};
  return keys;
}

const TomlKeys& obstacle() {
  static const TomlKeys keys = {
      "[[obstacle]]",
      "A half-space that nothing moves but its own motion.",
      {{"name", "", "\"ramp\"", kNeeded, "no two the same"},
       {"point", "m", "[x, y, z]", "[0, 0, 0]", "a point of its surface"},
       {"friction", "1", "0.5", kNeeded, "μ of every body against it"},
       {"slope_deg", "deg", "20", "0", "by how much it is tilted"},
       {"slope_tan", "1", "0.36", "by `slope_deg`", "the tangent of that, in its place"},
       {"azimuth_deg", "deg", "30", "0",
        "where it is tilted to, from the x axis; given, it is \"downhill\" of a level one too"},
       {"normal", "", "[x, y, z]", "by the slope", "its outward normal, of any length"},
       {"motion", "m", "a table", "it stands still", "see [motion]"}},
      {{"shape", "an obstacle is a half-space; a body that is 'held' can have any shape"},
       {"size", "an obstacle is a half-space; a body that is 'held' can have any size"}}};
  return keys;
}

const TomlKeys& body() {
  static const TomlKeys keys = {
      "[[body]]",
      "A body: its shape, what it is made of, and where it begins.",
      {{"name", "", "\"box\"", kNeeded, "no two the same"},
       {"shape", "", "\"box\"", kNeeded,
        "box, ball, point, mesh (tetrahedra in this file) or surface (a file of triangles)"},
       {"size", "m", "[x, y, z]", "needed by a box", "its edges"},
       {"radius", "m", "0.1", "needed by a ball", ""},
       {"vertices", "m", "[[x, y, z], …]", "needed by a mesh", ""},
       {"tetrahedra", "", "[[a, b, c, d], …]", "needed by a mesh",
        "its vertices' numbers, from 0 on"},
       {"file", "", "\"part.stl\"", "needed by a surface",
        "a closed surface in OFF, OBJ, PLY or STL, from the folder of this file"},
       {"scale", "1", "1e-3", "1", "of a surface's numbers; 1e-3 for a file in mm"},
       {"cell_size", "m", "0.02", "a tenth of the surface's diagonal",
        "of the tetrahedra that fill a surface"},
       {"feature_angle_deg", "deg", "40", "40", "edges of a surface that are sharper are kept"},
       {"most_tetrahedra", "1", "200000", "200000", "a surface that needs more is refused"},
       {"time_limit", "s", "300", "300", "the mesher of a surface is stopped after it"},
       {"mass", "kg", "1", kNeeded,
        "spread evenly. `stiction` lumps it at nodes: a cube of n cells along its edge (`cells`, 2 "
        "unless "
        "[engine] sets it) turns with 1 + 2/n² times its inertia"},
       {"youngs_modulus", "Pa", "5e5", "5e5",
        "5e5 is as soft as foam, rubber has 1e6 to 1e8. The bodies of `stiction` are never rigid: "
        "a stiffer or lighter one needs smaller steps"},
       {"poisson_ratio", "1", "0.3", "0.3", ""},
       {"damping_time", "s", "1e-3", "0", "viscous stress = damping_time · elasticity · rate"},
       {"self_collision", "", "true or false", "false", "whether it may touch itself"},
       {"rests_on", "", "\"ramp\"", "it is placed by `position`",
        "an obstacle, or a body above: its lowest point is put onto it"},
       {"offset", "m", "[downhill, across, up]", "[0, 0, 0]",
        "from the middle of what it rests on (of an obstacle: its point)"},
       {"yaw_deg", "deg", "20", "0", "turn about the normal of what it rests on"},
       {"speed_downhill", "m/s", "0.5", "0", "with rests_on"},
       {"position", "m", "[x, y, z]", "needed without rests_on",
        "of the centre; of a mesh or file, of its origin"},
       {"rotation", "", "{ axis = [0, 0, 1], angle_deg = 30 }", "none",
        "about the centre; with rests_on before it is put down"},
       {"velocity", "m/s", "[x, y, z]", "[0, 0, 0]", "without rests_on"},
       {"spin", "rad/s", "[x, y, z]", "[0, 0, 0]", "angular velocity about the centre"},
       {"held", "", "{ point = [0, 0, 0], normal = [0, 0, 1] }", "none", "see [held]"},
       {"motion", "m", "a table", "it stands still",
        "moves the held part, so it needs `held`; see [motion]"}},
      {{"friction",
        "μ is an obstacle's 'friction', the file's 'friction' between all bodies, or a [[pair]]'s"},
       {"density", "give the 'mass' in kg"},
       {"fixed", "'held' holds a part of a body, or all of it"},
       {"static", "'held' holds a part of a body, or all of it"}}};
  return keys;
}

const TomlKeys& rotation() {
  static const TomlKeys keys = {"[rotation]",
                                "Of a body.",
                                {{"axis", "", "[x, y, z]", kNeeded, "of any length"},
                                 {"angle_deg", "deg", "30", kNeeded, ""}}};
  return keys;
}

const TomlKeys& held() {
  static const TomlKeys keys = {
      "[held]",
      "What lies below a plane is held, or moved by `motion`: the side opposite `normal`. The "
      "plane is told in the body's own frame, with its origin at the body's centre: a box of edge "
      "0.1 spans -0.05 to 0.05.",
      {{"point", "m", "[x, y, z]", kNeeded, "of the plane; on the body's lower face to hold that"},
       {"normal", "", "[x, y, z]", kNeeded, "of the plane, away from the held part"}}};
  return keys;
}

const TomlKeys& motion() {
  static const TomlKeys keys = with(
      over_time("[motion]",
                "Displacement of an obstacle or of a held part from where it begins. What moves "
                "carries bodies along by friction: a jaw, a table, a rail.",
                "offset", "m"),
      {"velocity", "m/s", "[x, y, z]", "zero", "steadily, on top of it"});
  return keys;
}

const TomlKeys& load() {
  static const TomlKeys keys = {
      "[[load]]",
      "A force on a body, spread like its mass, and a couple.",
      {{"body", "", "\"box\"", kNeeded, ""},
       {"force", "N", "[x, y, z] or a table", "zero", "see [force]"},
       {"couple", "N m", "[x, y, z] or a table", "zero", "see [couple]"}},
      {{"point", "a force that acts at r from the centre is its 'force' and a 'couple', r × force"},
       {"position",
        "a force that acts at r from the centre is its 'force' and a 'couple', r × force"}}};
  return keys;
}

const TomlKeys& force() {
  static const TomlKeys keys = over_time("[force]", "Of a load.", "value", "N");
  return keys;
}

const TomlKeys& couple() {
  static const TomlKeys keys = over_time("[couple]", "Of a load.", "value", "N m");
  return keys;
}

const TomlKeys& spring() {
  static const TomlKeys keys = {
      "[[spring]]",
      "Pulls a body's centre along one axis to an anchor that may move steadily.",
      {{"body", "", "\"box\"", kNeeded, ""},
       {"anchor", "m", "[x, y, z]", kNeeded, "where it is at first"},
       {"anchor_velocity", "m/s", "[x, y, z]", "[0, 0, 0]", ""},
       {"axis", "", "[x, y, z]", kNeeded, "of any length"},
       {"stiffness", "N/m", "1e3", kNeeded, ""}}};
  return keys;
}

const TomlKeys& pair() {
  static const TomlKeys keys = {
      "[[pair]]",
      "μ of one pair, in place of that of its obstacle, or of that between bodies.",
      {{"body", "", "\"box\"", kNeeded, ""},
       {"against", "", "\"ramp\"", kNeeded, "an obstacle or a body"},
       {"friction", "1", "0.3", kNeeded, "μ of the two"}}};
  return keys;
}

const TomlKeys& check() {
  static const TomlKeys keys = {
      "[[check]]",
      "What must hold: |observed − expected| ≤ tolerance.",
      {{"observable", "", "\"speed\"", kNeeded, "see OBSERVABLES"},
       {"body", "", "\"box\"", "the only body", ""},
       {"direction", "", "[x, y, z], \"downhill\" or a table", "needed where it has one",
        "\"downhill\" is that of what the body rests on; { downhill = \"ramp\" } of an obstacle"},
       {"against", "", "\"ramp\"", "all of them",
        "an obstacle or a body: of the contacts those with it alone"},
       {"relative_to", "", "\"table\"", "none",
        "an obstacle or a body over which the centre's motion is told"},
       {"from", "s", "1", "0", "where a window begins"},
       {"at", "s", "2", "the end", "when it is observed, or a window ends"},
       {"extreme", "", "\"largest\" or \"smallest\"", "none",
        "of the values at all steps from `from` to `at`, of an observable at one time: \"largest\" "
        "slip 0 says that it never slipped. Of contacts from the first step on"},
       {"settles_below", "", "1e-9", "none",
        "in the observable's unit, of one at one time: what is observed is the settling time in s, "
        "from `from` on until |value| stays at most this up to `at`; infinite where it does not"},
       {"expected", "", "0", kNeeded, "in the observable's unit"},
       {"tolerance", "", "1e-9", kNeeded, "in its unit; with `relative` a share"},
       {"relative", "", "true or false", "false",
        "whether error and tolerance are shares of `scale`, or else of what is expected"},
       {"scale", "", "3.4", "none", "in its unit: what digits count from"},
       {"reason", "", "\"text\"", kNeeded, "why the tolerance is what it is"},
       {"quantity", "", "\"text\"", "the observable, and its body", "its name in reports"},
       {"claim", "", "\"text\"", "what the observable is", "a sentence for reports"},
       {"source", "", "\"text\"", "the problem's author", "where the expected value comes from"}}};
  return keys;
}

const TomlKeys& direction() {
  static const TomlKeys keys = {
      "[direction]",
      "Of a check or a series.",
      {{"downhill", "", "\"ramp\"", kNeeded, "the obstacle whose steepest descent it is"}}};
  return keys;
}

const TomlKeys& series() {
  static const TomlKeys keys = {
      "[[series]]",
      "A curve over time, for the report. Kinetic energy and the fastest slip are always drawn.",
      {{"observable", "", "\"position\"", kNeeded,
        "one that is observed at a time, not over a window; see OBSERVABLES"},
       {"body", "", "\"box\"", "the only body", ""},
       {"direction", "", "as of a check", "needed where it has one", ""},
       {"against", "", "\"ramp\"", "all of them", "as of a check"},
       {"relative_to", "", "\"table\"", "none", "as of a check"}}};
  return keys;
}

const TomlKeys& threshold() {
  static const TomlKeys keys = {
      "[threshold]",
      "Finds by bisection the value from which on some check fails, and judges it instead of them.",
      {{"vary", "", "\"ramp.slope_deg\"", kNeeded, kVaries},
       {"holds_at", "", "20", kNeeded, "a value at which every check must hold"},
       {"fails_at", "", "30", kNeeded, "a value at which some check must fail"},
       {"within", "", "0.01", kNeeded, "how narrow the bracket shall get"},
       {"expected", "", "26.565", kNeeded, "of the threshold"},
       {"tolerance", "", "0.01", kNeeded, "at least half of `within`"},
       {"reason", "", "\"text\"", kNeeded, "why the tolerance is what it is"},
       {"claim", "", "\"text\"", "from where on a check fails", "a sentence for reports"},
       {"source", "", "\"text\"", "the problem's author", "where the expected value comes from"}}};
  return keys;
}

const TomlKeys& sweep() {
  static const TomlKeys keys = {"[sweep]",
                                "Runs the problem once a value; every check is judged at each.",
                                {{"vary", "", "\"engine.dt\"", kNeeded, "as of a threshold"},
                                 {"values", "", "[1e-4, 2e-4]", kNeeded, "at least one"}}};
  return keys;
}

std::vector<const TomlKeys*> all() {
  return {&file(), &gravity(), &drag(),      &obstacle(), &body(),      &rotation(),
          &held(), &motion(),  &load(),      &force(),    &couple(),    &spring(),
          &pair(), &check(),   &direction(), &series(),   &threshold(), &sweep()};
}

}  // namespace problem_keys

namespace {

std::string told(const TomlKey& key, std::size_t width) {
  std::string words = key.meaning;
  const bool counted = !key.unit.empty() && key.unit != "1";
  if (counted) words = fmt::format("{}{}{}", key.unit, words.empty() ? "" : "; ", words);
  words += fmt::format("{}[{}]", words.empty() ? "" : " ", key.otherwise);
  return fmt::format("  {} = {}\n", key.name, key.form) + bullet(words, width, "      ");
}

}  // namespace

std::string keys_help(const std::vector<const TomlKeys*>& tables, std::size_t width) {
  std::string text;
  for (const TomlKeys* const table : tables) {
    text += table == tables.front() ? "THE FILE\n" : table->table + "\n";
    text += bullet(table->meaning, width, "  ");
    for (const TomlKey& key : table->keys) text += told(key, width);
    text += '\n';
  }
  return text;
}

std::string problem_help(std::size_t width) {
  std::string text = keys_help(problem_keys::all(), width);
  text += "OBSERVABLES\n";
  for (const Observable& one : observables()) {
    text += bullet(fmt::format("{} ({}): {}{}", one.name, one.unit, one.meaning,
                               one.in_direction ? "; needs a direction" : ""),
                   width, "  ");
  }
  text += "\nUNITS\n";
  for (const char* unit : {"m", "s", "kg", "Pa", "N", "N m", "N/m", "J", "m/s", "m/s²", "rad/s",
                           "Hz", "1/s", "deg", "1"}) {
    text += bullet(fmt::format("{}: {}", unit, fmt::join(units_like(unit), ", ")), width, "  ");
  }
  return text;
}

}  // namespace stiction
