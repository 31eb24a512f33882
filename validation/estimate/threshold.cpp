// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/estimate/threshold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stiction {

double Bracket::width() const { return std::abs(fails - holds); }

bool Bracket::contains(double value) const {
  return value >= std::min(holds, fails) && value <= std::max(holds, fails);
}

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool is_between(double value, double one, double other) {
  return (value - one) * (value - other) < 0.0;
}

bool ask(Bracket& bracket, double at, const HoldingAt& holds_at) {
  const Holding answer = holds_at(at);
  ++bracket.evaluations;
  if (answer.holds) {
    bracket.holds = at;
    bracket.held = {at, answer.excess};
    return true;
  }
  bracket.fails = at;
  if (answer.excess > 0.0) {
    bracket.next = bracket.nearest;
    bracket.nearest = {at, answer.excess};
  }
  return false;
}

// Excess for each unit beyond the critical value: between the two that fail, or by theory.
double slope_of(const Bracket& bracket) {
  const Bracket::Tried& near = bracket.nearest;
  const Bracket::Tried& next = bracket.next;
  const double measured = (next.excess - near.excess) / std::abs(next.at - near.at);
  return std::isnan(measured) ? bracket.slope : measured;
}

// Where the excess comes to 0, with 1 or −1 for `towards` what fails; no number: nobody knows.
double critical(const Bracket& bracket, double towards) {
  const auto& [at, excess] = bracket.nearest;
  const double slope = slope_of(bracket);
  if (!(slope > 0.0)) return kNone;
  // What held may lie on the line too, and then it is between the two; or it rests, and how far it is
  // from the critical value nobody can tell from that.
  constexpr double kOnLine = 0.05;
  const double held = -bracket.held.excess;
  const double told = slope * towards * (at - bracket.held.at) - excess;
  if (held > 0.0 && std::abs(held - told) < kOnLine * excess) {
    return bracket.held.at + (at - bracket.held.at) * held / (held + excess);
  }
  return at - towards * excess / slope;
}

// The places before and behind it, as far from it as half a bracket, or `margin` times that.
struct Sides {
  double before, behind;
};
Sides sides(double critical, double width, double towards, double margin = 1.0) {
  constexpr double kHalf = 0.45;  // so that rounding doesn't make it wider
  const double way = std::copysign(kHalf * margin * width, towards);
  return {critical - way, critical + way};
}

// Where in the bracket to look next, and whether that should hold; no number: nowhere in particular.
struct Promise {
  double at = kNone;
  bool holds = false;
};
Promise promising(const Bracket& bracket, double width, double margin) {
  const double towards = std::copysign(1.0, bracket.fails - bracket.holds);
  const auto [before, behind] = sides(critical(bracket, towards), width, towards, margin);
  const bool first = is_between(before, bracket.holds, bracket.fails);
  const bool second = is_between(behind, bracket.holds, bracket.fails);
  if (second && (!first || std::abs(behind - bracket.holds) <= width)) return {behind, false};
  return first ? Promise{before, true} : Promise{};
}

}  // namespace

Bracket narrow(Bracket bracket, double width, const HoldingAt& holds_at) {
  constexpr int kMostPromises = 4;          // until one has halved the bracket
  constexpr double kFartherOff = 4.0;       // after one that was wrong
  int looked = 0, wait = 0, next_wait = 1;  // runs: promised; that only halve, now and next time
  double margin = 1.0, half = 0.5 * bracket.width();
  while (bracket.width() > width) {
    Promise promise;
    if (wait == 0 && looked < kMostPromises) promise = promising(bracket, width, margin);
    const bool promised = !std::isnan(promise.at);
    if (!promised && looked > 0) {
      wait = std::exchange(next_wait, 2 * next_wait);
      looked = 0;
      margin = 1.0;
    }
    const double at = promised ? promise.at : bracket.middle();
    if (at == bracket.holds || at == bracket.fails) break;  // no number lies between
    const bool holds = ask(bracket, at, holds_at);
    if (promised) {
      ++looked;
      margin = holds == promise.holds ? 1.0 : kFartherOff * margin;
    } else if (wait > 0) {
      --wait;
    }
    if (bracket.width() > half) continue;
    looked = 0;
    half = 0.5 * bracket.width();
  }
  return bracket;
}

Bracket find_threshold(double first, double last, double width, const HoldingAt& holds_at) {
  Bracket bracket;
  if (!ask(bracket, first, holds_at) || ask(bracket, last, holds_at)) {
    return {kNone, kNone, bracket.evaluations};
  }
  return narrow(bracket, width, holds_at);
}

Bracket find_threshold_near(double guess, double step, double reach, double width,
                            const HoldingAt& holds_at, double slope) {
  Bracket bracket{.slope = slope};
  const bool holds = ask(bracket, guess, holds_at);
  if (!holds) step = -step;
  const double towards = std::copysign(1.0, holds ? step : -step);
  const double end = guess + std::copysign(reach, step);
  double trusted = INFINITY;  // excess below which the next place is that which the excess tells
  for (double inner = guess; inner != end;) {
    const double told = sides(critical(bracket, towards), width, towards).before;
    const bool leads = !holds && bracket.nearest.excess < trusted && is_between(told, inner, end);
    const double next = inner + step;
    const double outer = leads ? told : std::abs(next - guess) < reach ? next : end;
    // It must lead there by three quarters of the way each time.
    trusted = leads ? 0.25 * bracket.nearest.excess : INFINITY;
    if (!leads) step *= 4.0;
    if (ask(bracket, outer, holds_at) != holds) return narrow(bracket, width, holds_at);
    inner = outer;
  }
  return {kNone, kNone, bracket.evaluations};
}

}  // namespace stiction
