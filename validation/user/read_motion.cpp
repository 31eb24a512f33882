// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/user/read_motion.h"

#include <fmt/format.h>

#include <numbers>

#include "validation/user/problem_keys.h"

namespace stiction {

namespace {

Oscillation read_oscillation(TomlTable& table) {
  Oscillation one;
  if (!table.has("amplitude")) return one;
  one.amplitude = table.vector("amplitude");
  one.frequency = table.number("frequency");
  if (!(one.frequency > 0.0)) table.refuse("frequency", "'frequency' must be positive");
  one.phase = table.number("phase_deg", 0.0) * std::numbers::pi / 180.0;
  one.begins = table.number("begins", 0.0);
  one.full_from = table.number("full_from", one.begins);
  if (!(one.begins <= one.full_from)) {
    table.refuse("full_from", "'full_from' must not come before 'begins'");
  }
  return one;
}

// `value` is the key of the keyframes' vectors.
VectorOverTime read_over_time(TomlTable& table, const std::string& value) {
  VectorOverTime out;
  if (table.has("constant")) {
    out.time = {0.0};
    out.value = {table.vector("constant")};
  } else if (table.has("time") || table.has(value)) {
    out.time = table.numbers("time");
    out.value = table.vectors(value);
    if (out.time.size() != out.value.size() || out.time.empty()) {
      table.refuse("time",
                   fmt::format("'time' and '{}' must have as many entries, at least one", value));
    }
    for (std::size_t k = 1; k < out.time.size(); ++k) {
      if (!(out.time[k - 1] < out.time[k])) table.refuse("time", "the times must increase");
    }
  }
  out.oscillation = read_oscillation(table);
  return out;
}

}  // namespace

Motion read_motion(TomlTable table) {
  const VectorOverTime offset = read_over_time(table, "offset");
  Motion motion{offset.time, offset.value, table.vector("velocity", Eigen::Vector3d::Zero()),
                offset.oscillation};
  if (!motion.at(0.0).isZero(0.0)) {
    table.refuse("offset",
                 "a motion must begin where the problem puts it: its offset at 0 s is not zero");
  }
  const Oscillation& swings = motion.oscillation;
  if (swings.moves() && swings.phase != 0.0 && !(swings.begins < swings.full_from)) {
    table.refuse(
        "phase_deg",
        "a motion must not jump: with a 'phase_deg' it needs a 'full_from' after 'begins'");
  }
  table.finish();
  return motion;
}

Gravity read_gravity(TomlTable& top) {
  if (!top.is_table("gravity")) {
    return {{0.0}, {top.vector("gravity", Eigen::Vector3d(0.0, 0.0, -9.81))}};
  }
  TomlTable table = top.table("gravity", problem_keys::gravity());
  const VectorOverTime read = read_over_time(table, "acceleration");
  if (read.time.empty() && !read.oscillation.moves()) {
    top.refuse("gravity", "[gravity] lacks 'time' and 'acceleration', or 'constant'");
  }
  table.finish();
  return {read.time, read.value, read.oscillation};
}

VectorOverTime read_force(TomlTable& load, const std::string& key, const TomlKeys& keys) {
  if (!load.has(key)) return {};
  if (!load.is_table(key)) return {{0.0}, {load.vector(key)}};
  TomlTable table = load.table(key, keys);
  VectorOverTime read = read_over_time(table, "value");
  table.finish();
  return read;
}

}  // namespace stiction
