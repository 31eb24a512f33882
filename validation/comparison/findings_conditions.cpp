// SPDX-License-Identifier: GPL-3.0-or-later
// Findings about hard conditions, gains, and work against precision.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/comparison/comparison.h"
#include "validation/comparison/findings.h"

namespace stiction {

Sentences hard_conditions(const Figures& figures) {
  Sentences sentences;
  for (const std::string& scene : figures.cases("hard/")) {
    const std::vector<RuleOnContacts> rules = figures.rules(scene);
    std::map<std::string, RuleOnContacts> best, worst;  // by contacts
    std::size_t failures = 0;
    for (const RuleOnContacts& who : rules) {
      if (figures.failed(scene, who)) {
        ++failures;
        continue;
      }
      const double slipped = figures.of(scene, who, kSlipped);
      const auto keep = [&](std::map<std::string, RuleOnContacts>& kept, bool least) {
        const auto [entry, is_first] = kept.try_emplace(who.contacts, who);
        const double other = figures.of(scene, entry->second, kSlipped);
        if (!is_first && (least ? slipped < other : slipped > other)) entry->second = who;
      };
      keep(best, true);
      keep(worst, false);
    }
    std::string text = scene + ":";
    for (const auto& [contacts, who] : best) {
      const RuleOnContacts& last = worst.at(contacts);
      text += fmt::format(" least slipped on {} contacts by {} ({:.2g} m), most by {} ({:.2g} m);",
                          contacts, who.rule, figures.of(scene, who, kSlipped), last.rule,
                          figures.of(scene, last, kSlipped));
    }
    text += failures == 0 ? " none fails." : fmt::format(" {} of {} fail.", failures, rules.size());
    sentences.push_back(text);
  }
  return sentences;
}

Sentences frozen_steps(const Figures& figures) {
  std::vector<double> root, across, bias, dominance, mismatch, rate;
  for (const std::string& name : figures.cases("frozen/")) {
    for (const RuleOnContacts& who : figures.rules(name)) {
      root.push_back(figures.of(name, who, kRootSlip));
      across.push_back(figures.of(name, who, kAcrossSlip));
      bias.push_back(figures.of(name, who, kBiasSlip));
      dominance.push_back(figures.of(name, who, kDominance));
      rate.push_back(figures.of(name, who, kPredictedRate));
      const double observed = figures.of(name, who, kObservedRate);
      if (std::isfinite(observed)) mismatch.push_back(std::abs(observed - rate.back()));
    }
  }
  if (root.empty()) return {};
  const auto dominant =
      std::count_if(dominance.begin(), dominance.end(), [](double least) { return least > 1.0; });
  const auto roots =
      std::count_if(root.begin(), root.end(), [](double slip) { return slip <= 1e-12; });
  return {fmt::format(
      "(15) on {} frozen steps: GSL finds a root (slip along ũ ≤ 1e-12 m/s) on {}, and there "
      "{:.1g} "
      "to {:.1g} m/s of slip across ũ are left, which no scalar a contact can act on; 2N unknowns "
      "leave {:.1g} m/s at most. The Jacobian is diagonally dominant, as the paper assumes, in {} "
      "of them. The fixed point's rate at g = 0.7 is {:.2g} to {:.2g} a step; observed on the "
      "frozen step it differs from the spectral radius by {:.1g} at most.",
      root.size(), roots, spread_of(across).least, spread_of(across).most, spread_of(bias).most,
      dominant, spread_of(rate).least, spread_of(rate).most, spread_of(mismatch).most)};
}

Sentences gain_sweeps(const Figures& figures) {
  struct Sweep {
    std::string parameter, rule;
    double from = 0.0, to = 0.0;      // of the parameter
    std::vector<double> best, least;  // a sweep each: the best parameter, its creep, m/s
    double most = 0.0;                // m/s, of all
  };
  std::map<std::string, Sweep> sweeps;
  for (const Record& record : figures.records()) {
    const std::string parameter = record.case_name.substr(0, record.case_name.find('/'));
    for (const Series& series : record.series) {
      if (series.name != kCreep || series.x_name != parameter || series.y.empty()) continue;
      const auto least = std::min_element(series.y.begin(), series.y.end());
      Sweep& sweep = sweeps[parameter + record.settings.at("rule")];
      sweep.parameter = parameter;
      sweep.rule = record.settings.at("rule");
      sweep.from = series.x.front();
      sweep.to = series.x.back();
      sweep.best.push_back(series.x[static_cast<std::size_t>(least - series.y.begin())]);
      sweep.least.push_back(*least);
      sweep.most = std::max(sweep.most, *std::max_element(series.y.begin(), series.y.end()));
    }
  }
  Sentences sentences;
  for (const auto& [key, sweep] : sweeps) {
    const Spread best = spread_of(sweep.best), least = spread_of(sweep.least);
    sentences.push_back(
        fmt::format("{} over [{:.2g}, {:.2g}], {}, {} scenes and contacts: least creep {:.2g} to "
                    "{:.2g} m/s at {:.2g} "
                    "to {:.2g}; at worst {:.2g} m/s.",
                    sweep.parameter, sweep.from, sweep.to, sweep.rule, sweep.best.size(),
                    least.least, least.most, best.least, best.most, sweep.most));
  }
  return sentences;
}

Sentences pareto_front(const Figures& figures) {
  struct Point {
    double seconds, share;
    std::string words;
  };
  std::vector<Point> points;
  std::size_t failures = 0;
  for (const std::string& name : figures.cases("work/")) {
    for (const RuleOnContacts& who : figures.rules(name)) {
      const Point point{figures.of(name, who, kCpuTime), figures.of(name, who, kSlippedShare),
                        who.words() + " at " + name.substr(name.find("cells"))};
      if (std::isnan(point.share) && !figures.failed(name, who)) continue;  // not compared
      if (std::isfinite(point.share)) {
        points.push_back(point);
      } else {
        ++failures;
      }
    }
  }
  if (points.empty()) return {};
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.seconds < b.seconds; });
  std::vector<std::string> front;
  double least = std::numeric_limits<double>::infinity();
  for (const Point& point : points) {
    if (point.share >= least) continue;
    least = point.share;
    front.push_back(fmt::format("{} ({:.2g} s, {:.2g})", point.words, point.seconds, point.share));
  }
  return {
      fmt::format("Work and precision (CPU time for 0.2 s, way slipped over a free slide), the "
                  "Pareto front of {} runs: {}. {}",
                  points.size(), listed(front),
                  failures == 0 ? "None failed." : fmt::format("{} failed.", failures))};
}

}  // namespace stiction
