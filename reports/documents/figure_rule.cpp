// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/documents/figure_rule.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <set>
#include <stdexcept>

namespace stiction {

namespace {

using Settings = std::map<std::string, std::string>;

// One table of the file, which knows what was asked of it.
class Reader {
 public:
  Reader(std::string file, const toml::table& table) : file_(std::move(file)), table_(table) {}

  std::string where(const toml::node& node) const {
    return fmt::format("{}:{}", file_, node.source().begin.line);
  }

  [[noreturn]] void refuse(const toml::node& node, const std::string& sentence) const {
    throw std::runtime_error(where(node) + ": " + sentence);
  }

  const toml::node* node(const std::string& key) {
    known_.insert(key);
    return table_.get(key);
  }

  template <class Value>
  void read(const std::string& key, Value& value) {
    const toml::node* found = node(key);
    if (found == nullptr) return;
    const auto given = found->value<Value>();
    if (!given) refuse(*found, fmt::format("'{}' has a value of another kind", key));
    value = *given;
  }

  void read(const std::string& key, Taken& taken) {
    static const std::map<std::string, Taken> kWords = {{"least", Taken::kLeast},
                                                        {"most", Taken::kMost},
                                                        {"range", Taken::kRange},
                                                        {"count", Taken::kCount}};
    std::string word;
    read(key, word);
    if (word.empty()) return;
    const auto found = kWords.find(word);
    if (found == kWords.end()) {
      refuse(*node(key),
             fmt::format("'{}' is one of least, most, range, count, not '{}'", key, word));
    }
    taken = found->second;
  }

  Settings settings(const std::string& key) {
    Settings all;
    const toml::node* found = node(key);
    if (found == nullptr) return all;
    if (!found->is_table()) refuse(*found, fmt::format("'{}' is a table of settings", key));
    for (const auto& [name, value] : *found->as_table()) {
      const auto text = value.value<std::string>();
      if (!text) refuse(value, fmt::format("the setting '{}' is a text", std::string(name.str())));
      all[std::string(name.str())] = *text;
    }
    return all;
  }

  // One number, or a list of them.
  std::vector<double> numbers(const std::string& key) {
    std::vector<double> all;
    const toml::node* found = node(key);
    if (found == nullptr) return all;
    const auto add = [&](const toml::node& element) {
      const auto number = element.value<double>();
      if (!number) refuse(element, fmt::format("'{}' is a number or a list of numbers", key));
      all.push_back(*number);
    };
    if (found->is_array()) {
      for (const toml::node& element : *found->as_array()) add(element);
    } else {
      add(*found);
    }
    return all;
  }

  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> all;
    const toml::node* found = node(key);
    if (found == nullptr) return all;
    if (!found->is_array()) refuse(*found, fmt::format("'{}' is a list of texts", key));
    for (const toml::node& element : *found->as_array()) {
      const auto text = element.value<std::string>();
      if (!text) refuse(element, fmt::format("'{}' is a list of texts", key));
      all.push_back(*text);
    }
    return all;
  }

  void finish() const {
    for (const auto& [key, value] : table_) {
      const std::string name(key.str());
      if (!known_.count(name)) refuse(value, fmt::format("there is no key '{}' here", name));
    }
  }

  const std::string& file() const { return file_; }
  const toml::table& table() const { return table_; }

 private:
  std::string file_;
  const toml::table& table_;
  std::set<std::string> known_;
};

Reader sub_table(const Reader& parent, const toml::node& node, const std::string& what) {
  if (!node.is_table()) parent.refuse(node, what + " is a table");
  return {parent.file(), *node.as_table()};
}

FigureStyle read_style(Reader& reader) {
  FigureStyle style;
  reader.read("digits", style.digits);
  reader.read("places", style.places);
  reader.read("times", style.times);
  reader.read("decades", style.decades);
  reader.read("sign", style.sign);
  reader.read("unit", style.unit);
  reader.read("range", style.range);
  reader.read("no-number", style.no_number);
  reader.read("never", style.never);
  if (const toml::node* words = reader.node("above")) {
    if (!words->is_table())
      reader.refuse(*words, "'above' is a table of words, {\"0.01\" = \"slips\"}");
    for (const auto& [key, value] : *words->as_table()) {
      const std::string number(key.str());
      char* end = nullptr;
      const double limit = std::strtod(number.c_str(), &end);
      const auto word = value.value<std::string>();
      if (number.empty() || *end != '\0' || !word) {
        reader.refuse(value, "'above' is a table of words, {\"0.01\" = \"slips\"}");
      }
      style.above[limit] = *word;
    }
  }
  return style;
}

// A rule is a figure, or one a column: of settings, or of places in a series.
void read_figure(Reader& reader, const std::string& name, const toml::node& node,
                 const std::map<std::string, Settings>& columns, FigureRules& rules) {
  FigureRule rule;
  rule.name = name;
  rule.where = reader.where(node);
  reader.read("case", rule.case_glob);
  reader.read("except", rule.except);
  reader.read("quantity", rule.quantity);
  reader.read("series", rule.series);
  const std::vector<double> at = reader.numbers("at");
  reader.read("within", rule.within);
  reader.read("over", rule.over);
  reader.read("may-lack", rule.may_lack);
  reader.read("factor", rule.factor);
  reader.read("floor", rule.floor);
  rule.settings = reader.settings("settings");
  rule.style = read_style(reader);
  if (rule.case_glob.empty()) reader.refuse(node, fmt::format("'{}' names no case", name));
  if (rule.quantity.empty() == rule.series.empty()) {
    reader.refuse(node, fmt::format("'{}' names either a quantity or a series", name));
  }
  const std::vector<std::string> each = reader.texts("each");
  reader.finish();
  if (rule.series.empty() != at.empty()) {
    reader.refuse(node, fmt::format("'{}' needs 'at' with a series, and with nothing else", name));
  }
  if (at.size() > 1) {
    if (!each.empty()) {
      reader.refuse(node, fmt::format("'{}' has columns by 'at' and by 'each'", name));
    }
    for (const double x : at) {
      FigureRule one = rule;
      one.at = x;
      rules.columns[name].push_back(fmt::format("{:.0f}", x));
      one.name = name + "@" + rules.columns[name].back();
      rules.figures.push_back(std::move(one));
    }
    return;
  }
  if (!at.empty()) rule.at = at.front();
  if (each.empty()) {
    rules.figures.push_back(std::move(rule));
    return;
  }
  rules.columns[name] = each;
  for (const std::string& word : each) {
    const auto column = columns.find(word);
    if (column == columns.end()) {
      reader.refuse(node, fmt::format("[columns] has no '{}'", word));
    }
    FigureRule one = rule;
    one.name = name + "@" + word;
    for (const auto& [key, value] : column->second) one.settings[key] = value;
    rules.figures.push_back(std::move(one));
  }
}

SampleRule read_sample(Reader& reader, const std::string& name, const toml::node& node) {
  SampleRule sample{.name = name, .where = reader.where(node)};
  reader.read("run-of", sample.run_of);
  if (sample.run_of.empty())
    reader.refuse(node, fmt::format("'{}' names no case in 'run-of'", name));
  std::string shows = "summary";
  reader.read("shows", shows);
  if (shows == "cheapest-settings") {
    sample.shows = Shown::kCheapestSettings;
  } else if (shows != "summary") {
    reader.refuse(node,
                  fmt::format("'shows' is one of summary, cheapest-settings, not '{}'", shows));
  }
  reader.finish();
  return sample;
}

}  // namespace

FigureRules read_figure_rules(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(fmt::format("{}:{}: {}", name, error.source().begin.line,
                                         std::string(error.description())));
  }
  FigureRules rules;
  rules.program = file.stem().string();
  Reader reader(name, table);
  std::map<std::string, Settings> columns;
  if (const toml::node* node = reader.node("columns")) {
    Reader all = sub_table(reader, *node, "[columns]");
    for (const auto& [key, value] : all.table()) {
      const std::string column(key.str());
      columns[column] = all.settings(column);
    }
  }
  if (const toml::node* node = reader.node("figure")) {
    const Reader all = sub_table(reader, *node, "[figure]");
    for (const auto& [key, value] : all.table()) {
      Reader one = sub_table(all, value, "a figure");
      read_figure(one, std::string(key.str()), value, columns, rules);
    }
  }
  if (const toml::node* node = reader.node("sample")) {
    const Reader all = sub_table(reader, *node, "[sample]");
    for (const auto& [key, value] : all.table()) {
      Reader one = sub_table(all, value, "a sample");
      rules.samples.push_back(read_sample(one, std::string(key.str()), value));
    }
  }
  reader.finish();
  return rules;
}

}  // namespace stiction
