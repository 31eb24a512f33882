// SPDX-License-Identifier: GPL-3.0-or-later
#include "validation/engine/protocol/dialogue.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "reports/text/text.h"
#include "solver/demand.h"

namespace stiction {

namespace {

// A program that is built like this one, with the address sanitizer, maps terabytes of shadow: then
// there is no limit.
std::uint64_t bytes(double gib) {
#ifdef STICTION_SANITIZES_MEMORY
  gib = 0.0;
#endif
  return static_cast<std::uint64_t>(gib * 1024.0 * 1024.0 * 1024.0);
}

std::string named(const std::vector<std::string>& words) {
  std::string name;
  for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
  return name;
}

}  // namespace

Dialogue::Dialogue(const std::vector<std::string>& words, const ProgramLimits& limits)
    : name_(named(words)),
      conversation_(std::make_unique<reference::Conversation>(
          words, reference::ConversationLimits{.reply_seconds = limits.reply_seconds,
                                               .memory_bytes = bytes(limits.memory_gib)})),
      answers_([this](const std::string& line) { return conversation_->ask(line); }) {}

Dialogue::Dialogue(const std::vector<std::string>& words, Answers answers)
    : name_(named(words)), answers_(std::move(answers)) {}

nlohmann::json Dialogue::ask(const char* verb, nlohmann::json request) {
  request["do"] = verb;
  std::string line;
  try {
    line = answers_(request.dump());
  } catch (const reference::ChildError& what) {
    throw InputError(fmt::format("the engine '{}', asked to {}, {}", name_, verb, what.what()));
  }
  nlohmann::json answer = nlohmann::json::parse(line, nullptr, false);
  if (!answer.is_object()) {
    constexpr std::size_t kQuoted = 80;
    const bool more = line.size() > kQuoted;
    throw InputError(
        fmt::format("the engine '{}', asked to {}, answered what is no JSON object: '{}{}'", name_,
                    verb, one_line(line.substr(0, kQuoted)), more ? "…" : ""));
  }
  if (answer.contains("lacks")) {
    throw NotApplicable(one_line(fields(answer, verb)["lacks"].text()));
  }
  if (answer.contains("error")) {
    throw InputError(fmt::format("the engine '{}', asked to {}, says: {}", name_, verb,
                                 one_line(fields(answer, verb)["error"].text())));
  }
  return answer;
}

JsonField Dialogue::fields(const nlohmann::json& answer, const char* verb) const {
  return {answer, fmt::format("the engine '{}', asked to {}", name_, verb), ""};
}

double finite(const JsonField& field) {
  const double value = field.real();
  if (!std::isfinite(value)) field.fail("is not a finite number");
  return value;
}

}  // namespace stiction
