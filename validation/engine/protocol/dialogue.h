// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reference/process/conversation.h"
#include "reports/record/json_field.h"
#include "validation/engine/engine.h"

namespace stiction {

/// How an engine that is a program is started, and how long it may take.
struct ProgramLimits {
  double reply_seconds = 60.0;  ///< for each answer, wall-clock
  double memory_gib = 4.0;      ///< of its data
};

/// Answers a line with a line; throws reference::ChildError.
using Answers = std::function<std::string(const std::string&)>;

/// The protocol with one engine process. Every complaint is an InputError of one sentence that names
/// the program, the request and what came instead of an answer.
class Dialogue {
 public:
  Dialogue(const std::vector<std::string>& words, const ProgramLimits& limits);
  /// With what stands in for a process, in tests.
  Dialogue(const std::vector<std::string>& words, Answers answers);

  Dialogue(const Dialogue&) = delete;
  Dialogue& operator=(const Dialogue&) = delete;

  /// The answer to a request, {"do": verb, …}. Throws NotApplicable for {"lacks": …}.
  nlohmann::json ask(const char* verb, nlohmann::json request = nlohmann::json::object());

  /// Fields of such an answer, for complaints in words.
  JsonField fields(const nlohmann::json& answer, const char* verb) const;

  double cpu_seconds() const { return conversation_ ? conversation_->cpu_seconds() : 0.0; }
  std::optional<std::int64_t> resident_memory() const {
    return conversation_ ? conversation_->resident_memory() : std::nullopt;
  }

 private:
  std::string name_;                                       // of the program, as it was called
  std::unique_ptr<reference::Conversation> conversation_;  // null: `answers_` stands in for it
  Answers answers_;
};

/// A finite number, else JsonField's complaint.
double finite(const JsonField& field);

}  // namespace stiction
