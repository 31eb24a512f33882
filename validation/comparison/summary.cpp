// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/comparison/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "reports/formats/work_precision.h"
#include "reports/text/check_text.h"
#include "reports/text/number.h"
#include "reports/text/text.h"
#include "validation/comparison/comparison.h"
#include "validation/comparison/figures.h"

namespace stiction {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// What counts as friction found, in the scenes of work/: the way slipped over that of a free slide.
constexpr double kFound = 1e-6;

// With at most so many rules and contacts in a run more than the best are placed, in so many lines.
constexpr std::size_t kFew = 8, kPlaced = 16;

const RuleOnContacts kPaper{"fixed-point", "paper"};

// With the paper's own depth, where it was compared with that alone.
bool is_papers(const RuleOnContacts& who) {
  return who.rule == kPaper.rule && who.contacts.rfind(kPaper.contacts, 0) == 0;
}

// How well a rule answered: the smaller, the better, first by `first`.
struct Score {
  double first = kNever, second = 0.0;
  std::string figure;
  auto key() const { return std::pair(first, second); }
};

// Median in which what failed, or never got there, counts as the worst.
double median_of(std::vector<double> values) {
  for (double& value : values) value = std::isnan(value) ? kNever : value;
  return spread_of(std::move(values)).median;
}

std::vector<double> values_of(const Figures& figures, const std::vector<std::string>& cases,
                              const RuleOnContacts& who, const char* quantity) {
  std::vector<double> values;
  for (const std::string& name : cases) {
    values.push_back(figures.failed(name, who) ? kNever : figures.of(name, who, quantity));
  }
  return values;
}

using Cases = std::vector<std::string>;
using Ask = std::function<Score(const Figures&, const Cases&, const RuleOnContacts&)>;

// The median of a quantity over the scenes.
Ask least(const char* quantity, const char* unit) {
  return [quantity, unit](const Figures& figures, const Cases& cases, const RuleOnContacts& who) {
    const double value = median_of(values_of(figures, cases, who, quantity));
    return Score{value, 0.0, std::isinf(value) ? "fails" : format_error(value) + " " + unit};
  };
}

// In how many scenes a number of steps was enough, then how many they were.
Ask soonest(const char* quantity) {
  return [quantity](const Figures& figures, const Cases& cases, const RuleOnContacts& who) {
    std::vector<double> steps = values_of(figures, cases, who, quantity);
    std::erase_if(steps, [](double value) { return !std::isfinite(value); });
    const double count = static_cast<double>(steps.size());
    if (steps.empty()) return Score{kNever, 0.0, "never"};
    const double median = spread_of(steps).median;
    return Score{-count, median,
                 fmt::format("{} of {} in {:.0f}", steps.size(), cases.size(), median)};
  };
}

Score most_poses(const Figures& figures, const Cases& cases, const RuleOnContacts& who) {
  double rest = 0.0, all = 0.0;
  for (const std::string& name : cases) {
    rest += figures.of(name, who, kPosesAtRest);
    all += figures.of(name, who, kPoses);
  }
  return {std::isnan(rest) ? kNever : -rest, 0.0, fmt::format("{:.0f} of {:.0f}", rest, all)};
}

// The least CPU time with which friction was found.
Score least_work(const Figures& figures, const Cases& cases, const RuleOnContacts& who) {
  double seconds = kNever;
  for (const std::string& name : cases) {
    if (figures.failed(name, who) || !(figures.of(name, who, kSlippedShare) <= kFound)) continue;
    seconds = std::min(seconds, figures.of(name, who, kCpuTime));
  }
  return {seconds, 0.0, std::isinf(seconds) ? "never" : format_error(seconds) + " s"};
}

struct Asked {
  const char* prefix;  // of the cases
  const char* words;
  const char* count;  // what is counted behind it; none: nothing
  Ask ask;
};

const std::vector<Asked>& questions() {
  static const std::vector<Asked> all = {
      {"rules/", "creep", "scene", least(kCreep, "m/s")},
      {"rules/", "… steps", nullptr, soonest(kStepsTo9)},
      {"load/lost/", "steps", "load", soonest(kStepsTo9)},
      {"load/released/", "… from a slide", nullptr, soonest(kFrom3)},
      {"falling-box/", "… from a fall", nullptr, soonest(kFrom3)},
      {"poses/", "poses at rest", nullptr, most_poses},
      {"hard/", "slip", "hard case", least(kSlipped, "m")},
      {"work/", "CPU to slip ≤ 1e-6", nullptr, least_work},
  };
  return all;
}

// "conjugate-vector" of "conjugate-vector, at most 64 sweeps", its only reading.
std::string short_rule(const std::string& rule) { return rule.substr(0, rule.find(", at most")); }

std::string cost_of(const Figures& figures, const RuleOnContacts& who) {
  const double ratio = figures.of("cost/plate", who, kFrictionRatio);
  return std::isnan(ratio) ? "–" : fmt::format("{:.1f} ×", ratio);
}

std::size_t rules_in(const std::vector<Record>& records) {
  std::set<RuleOnContacts> all;
  for (const Record& record : records) all.insert(who_of(record));
  return all.size();
}

// "'none' 7, 'secant' 1": whose runs failed. Those of work and precision are told with its table.
std::string failures_text(const std::vector<Record>& records) {
  std::map<std::string, std::size_t> counts;
  std::size_t all = 0;
  for (const Record& record : records) {
    if (record.case_name.starts_with(kWorkPrecision)) continue;
    if (record.failures.empty() || record.verdict == Verdict::kError) continue;
    ++counts[rule_words(record.settings)];
    ++all;
  }
  if (all == 0) return "";
  std::vector<std::pair<std::size_t, std::string>> most;
  for (const auto& [rule, count] : counts) most.emplace_back(count, rule);
  std::sort(most.begin(), most.end(), [](const auto& a, const auto& b) {
    return std::pair(b.first, a.second) < std::pair(a.first, b.second);
  });
  std::vector<std::string> words;
  for (const auto& [count, rule] : most)
    words.push_back(fmt::format("{} {}", short_rule(rule), count));
  return fmt::format("{} of {} runs do not hold their scene, which is a result: {}.", all,
                     records.size(), listed(words));
}

// The sentence of the findings that begins so, up to where it becomes detail.
std::string finding(const Record& found, const std::string& begin, const std::string& end) {
  for (const std::string& sentence : found.notes) {
    if (sentence.rfind(begin, 0) != 0) continue;
    const std::size_t at = sentence.find(end);
    return at == std::string::npos ? sentence : sentence.substr(0, at + end.size());
  }
  return "";
}

}  // namespace

std::string compare_command(const Record& record) {
  const auto of = [&](const char* name) {
    const auto found = record.settings.find(name);
    return found == record.settings.end() ? std::string() : found->second;
  };
  return fmt::format("./stiction compare --scene '{}' --rule {} --contacts {}", record.case_name,
                     of("rule"), of("method"));
}

std::vector<Placing> placings(const std::vector<Record>& records, std::size_t places) {
  const Figures figures(records);
  std::vector<Placing> all;
  for (const Asked& asked : questions()) {
    const Cases cases = figures.cases(asked.prefix);
    if (cases.empty()) continue;
    std::vector<std::pair<Score, RuleOnContacts>> scores;
    std::string paper = "–";
    // Work is compared at several efforts, not all of which every rule was given.
    const std::vector<RuleOnContacts> rules = figures.rules(asked.prefix);
    for (const RuleOnContacts& who : rules) {
      Score score = asked.ask(figures, cases, who);
      if (is_papers(who) && (paper == "–" || who == kPaper)) paper = score.figure;
      scores.emplace_back(std::move(score), who);
    }
    const auto cost = [&](const RuleOnContacts& who) {
      const double ratio = figures.of("cost/plate", who, kFrictionRatio);
      return std::isnan(ratio) ? kNever : ratio;
    };
    std::stable_sort(scores.begin(), scores.end(), [&](const auto& a, const auto& b) {
      if (a.first.key() != b.first.key()) return a.first.key() < b.first.key();
      return cost(a.second) < cost(b.second);
    });
    std::string words = asked.words;
    if (asked.count) words += ", " + counted(cases.size(), asked.count);
    for (std::size_t k = 0; k < std::min(places, scores.size()); ++k) {
      const auto& [score, who] = scores[k];
      const bool none = places == 1 && std::isinf(score.first);
      all.push_back(
          {.question = words,
           .rule =
               none ? "none" : short_rule(who.rule) + (who.build.empty() ? "" : ", " + who.build),
           .contacts = none ? "–" : who.contacts,
           .figure = none ? "–" : score.figure,
           .cost = none ? "–" : cost_of(figures, who),
           .paper = paper});
      words.clear();
    }
  }
  return all;
}

std::string comparison_summary(const std::vector<Record>& records, const Record& found,
                               const Screen& screen) {
  std::string text = cheapest_settings_screen(records, screen);
  std::vector<Placing> placed = placings(records, 1);
  const bool few = rules_in(records) <= kFew && !placed.empty();
  if (few) placed = placings(records, std::max<std::size_t>(1, kPlaced / placed.size()));
  if (!placed.empty()) {
    const auto told = [&](std::string Placing::*column) {
      return std::any_of(placed.begin(), placed.end(),
                         [&](const Placing& one) { return one.*column != "–"; });
    };
    std::vector<std::pair<const char*, std::string Placing::*>> columns = {
        {few ? "question" : "who wins", &Placing::question}, {"rule", &Placing::rule}};
    const bool same = std::all_of(placed.begin(), placed.end(), [&](const Placing& one) {
      return one.contacts == placed.front().contacts;
    });
    if (!same) columns.emplace_back("contacts", &Placing::contacts);
    std::set<std::size_t> texts;
    for (std::size_t k = 0; k < columns.size(); ++k) texts.insert(k);
    columns.emplace_back("figure", &Placing::figure);
    std::string words = same ? fmt::format("On {} contacts; ", placed.front().contacts) : "";
    words += "friction memory lost; medians; steps until the mean slip is 1e-9 m/s";
    if (told(&Placing::cost)) {
      columns.emplace_back("cost", &Placing::cost);
      words += "; cost: friction of a contact over the fixed point's";
    }
    if (told(&Placing::paper) && !few) {
      columns.emplace_back("paper's", &Placing::paper);
      words += "; paper's: its fixed point on its contacts";
    }
    Cells rows(1 + placed.size());
    for (const auto& [heading, column] : columns) {
      rows[0].push_back(heading);
      for (std::size_t k = 0; k < placed.size(); ++k) rows[k + 1].push_back(placed[k].*column);
    }
    text += plain_table(rows, texts, screen.width);
    words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    text += bullet(words + ".", screen.width, "") + "\n";
  }
  std::vector<std::string> said;
  for (const auto& [begin, end, rest] :
       {std::tuple{"Fixed point against secant on paper", "of the fixed point", ""},
        {"Rule or contacts", "scenes)", "."},
        {"(15) on", "are left", "."}}) {
    std::string sentence = finding(found, begin, end);
    if (sentence.empty()) continue;
    said.push_back(sentence + rest);
    if (*rest != '\0') continue;
    const bool confirmed = finding(found, begin, "comparable: confirmed").ends_with("confirmed");
    said.back() +=
        confirmed ? "; comparable, as the paper says." : "; not comparable, against the paper.";
  }
  const std::string beside = finding(found, "Work in ", "m/s.");
  if (!beside.empty()) said.push_back(beside);
  if (placed.empty()) said = found.notes;  // what has no winner is told in words alone
  for (const std::string& sentence : said) text += bullet(sentence, screen.width);
  const std::string failures = failures_text(records);
  if (!failures.empty()) text += bullet(failures, screen.width);
  for (const Record& record : records) {
    if (record.verdict != Verdict::kError) continue;
    text +=
        bullet(fmt::format("{}, {}: {}", record.case_name, who_of(record).words(), record.error),
               screen.width, bold("ERROR", screen) + " ");
    text += "      again: " + compare_command(record) + "\n";
  }
  return text;
}

}  // namespace stiction
