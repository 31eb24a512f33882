// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/track/sizes/yardstick.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "benchmarks/track/measure/child.h"

namespace stiction::track {

namespace {

using nlohmann::json;

// A million contacts of an old revision settle in most of an hour.
constexpr double kLongestAnswer = 4.0 * 3600.0;  // s

std::vector<std::string> words_of(const Way& way, const Workload& workload) {
  std::vector<std::string> words;
  if (way.width > 0) words = {"env", fmt::format("STICTION_WIDTH={}", way.width)};
  for (const std::string& word : {way.program, workload.family, std::to_string(workload.contacts),
                                  std::to_string(way.threads)}) {
    words.push_back(word);
  }
  return words;
}

// What a yardstick answers.
class Answer {
 public:
  Answer(const std::string& what, const std::string& line) : what_(what), line_(line) {
    json_ = json::parse(line, nullptr, false);
    if (!json_.is_object()) refuse();
  }

  /// A number that is finite and not negative.
  double number(const char* key) const { return number(json_, key); }
  bool truth(const char* key) const {
    if (!json_.contains(key) || !json_[key].is_boolean()) refuse();
    return json_[key].get<bool>();
  }
  std::string text(const char* key) const {
    if (!json_.contains(key) || !json_[key].is_string()) refuse();
    return json_[key].get<std::string>();
  }
  std::map<std::string, double> numbers(const char* key) const {
    if (!json_.contains(key) || !json_[key].is_object()) refuse();
    std::map<std::string, double> all;
    for (const auto& [name, value] : json_[key].items()) {
      all[name] = number(json_[key], name.c_str());
    }
    return all;
  }

 private:
  double number(const json& object, const char* key) const {
    if (!object.contains(key) || !object[key].is_number() || object[key].get<double>() < 0.0)
      refuse();
    return object[key].get<double>();
  }
  [[noreturn]] void refuse() const {
    throw TrackError(fmt::format("{}: its yardstick answers '{}'", what_, line_));
  }

  std::string what_, line_;
  json json_;
};

template <class Read>
void for_each_line(const std::string& yardstick, const char* question, const Read& read) {
  const std::string what = fmt::format("{} {} cannot be run", yardstick, question);
  std::istringstream stream(demand_run(what, {yardstick, question}));
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    if (!read(words)) throw TrackError(fmt::format("{}: it says '{}'", what, line));
  }
}

}  // namespace

std::vector<Workload> workloads_of(const std::string& yardstick) {
  std::vector<Workload> all;
  for_each_line(yardstick, "--list", [&](std::istringstream& words) {
    Workload& one = all.emplace_back();
    return static_cast<bool>(words >> one.family >> one.contacts >> one.is_long);
  });
  return all;
}

std::vector<int> widths_of(const std::string& yardstick) {
  std::vector<int> all;
  for_each_line(yardstick, "--widths", [&](std::istringstream& words) {
    return static_cast<bool>(words >> all.emplace_back());
  });
  return all;
}

Yardstick::Yardstick(const Way& way, const Workload& workload)
    : what_(fmt::format("{} cannot be measured {}", workload.name(), way.name)),
      conversation_(words_of(way, workload), {.reply_seconds = kLongestAnswer, .memory_bytes = 0}) {
}

Yardstick::Settled Yardstick::settle() {
  const Answer answer(what_, conversation_.ask("settle"));
  const Settled settled{answer.number("contacts"), answer.truth("at_rest"), answer.number("error")};
  if (settled.contacts < 1.0) throw TrackError(what_ + ": it has no contacts");
  return settled;
}

Yardstick::Steps Yardstick::steps() {
  const Answer answer(what_, conversation_.ask("steps"));
  return {answer.number("cpu"), answer.number("wall"), answer.numbers("phases"),
          answer.text("hash")};
}

void Yardstick::stay_on(int processor) {
  Answer(what_, conversation_.ask(fmt::format("on {}", processor)));
}

Yardstick::Limits Yardstick::limits() {
  const Answer answer(what_, conversation_.ask("limits"));
  return {answer.number("bandwidth"), answer.number("arithmetic")};
}

}  // namespace stiction::track
