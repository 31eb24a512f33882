// SPDX-License-Identifier: BSD-3-Clause
#include "validation/engine/kit/session.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "validation/engine/kit/array_json.h"
#include "validation/engine/kit/problem_reader.h"
#include "validation/engine/kit/rounding.h"
#include "validation/engine/kit/run_settings.h"

namespace stiction::kit {

namespace {

using nlohmann::json;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string text_or(const char* text, const char* fallback) { return text ? text : fallback; }

// "dt=0.01 iterations=50" as an object.
json settings_object(const char* words) {
  json object = json::object();
  std::istringstream stream(text_or(words, ""));
  for (std::string word; stream >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) throw std::runtime_error("'" + word + "' is no NAME=VALUE");
    object[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return object;
}

json words_of(const char* text) {
  json words = json::array();
  std::istringstream stream(text_or(text, ""));
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace

class Session::Dealings {
 public:
  explicit Dealings(const stiction_engine& engine) : engine_(engine) {}
  ~Dealings() { drop(); }
  Dealings(const Dealings&) = delete;
  Dealings& operator=(const Dealings&) = delete;

  json answer(const json& request) {
    const std::string verb = request.value("do", "");
    if (verb == "hello") return hello();
    if (verb == "load") return load(request);
    if (verb == "quit") return json::object();
    if (!loaded_) throw std::runtime_error("'" + verb + "' came before a problem was loaded");
    if (verb == "advance") return advance(request);
    if (verb == "observe") return observe(request);
    if (verb == "save" && engine_.save) return save(request);
    if (verb == "restore" && engine_.restore) return restore(request);
    throw std::runtime_error("this engine does not know '" + verb + "'");
  }

 private:
  json hello() const {
    json can = words_of(engine_.can);
    if (engine_.save && engine_.restore) can.push_back("snapshots");
    if (engine_.contacts) can.push_back("contacts");
    if (engine_.energies) can.push_back("energies");
    if (engine_.momenta) can.push_back("momenta");
    if (engine_.surface && engine_.vertices) can.push_back("surface");
    json settings = json::object(), configurations = json::array(), ladder = json::array();
    settings[kRounding] = kRoundingHelp;  // an engine's own of that name goes before it
    for (const stiction_setting* one = engine_.settings; one && one->name; ++one) {
      settings[one->name] = text_or(one->help, "");
    }
    for (const stiction_configuration* one = engine_.configurations; one && one->name; ++one) {
      configurations.push_back({{"name", one->name},
                                {"settings", settings_object(one->settings)},
                                {"source", text_or(one->source, "")}});
    }
    for (const char* const* one = engine_.ladder; one && *one; ++one) {
      ladder.push_back(settings_object(*one));
    }
    return {{"protocol", STICTION_PROTOCOL},
            {"name", text_or(engine_.name, "")},
            {"version", text_or(engine_.version, "")},
            {"description", text_or(engine_.description, "")},
            {"can", can},
            {"settings", settings},
            {"configurations", configurations},
            {"ladder", ladder},
            {"symplectic_euler", engine_.symplectic_euler != 0}};
  }

  json load(const json& request) {
    drop();
    told() = {};
    const json settings = request.value("settings", json::object());
    rounding_ = rounding_mode(kNearest);
    for (const auto& [name, value] : settings.items()) {
      const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
      if (has_setting(name)) {
        told().given[name] = text;
      } else if (name == kRounding) {
        rounding_ = rounding_mode(text);
        told().resolved.insert_or_assign(name, text);
      } else {
        throw std::runtime_error("there is no setting '" + name + "'");
      }
    }
    problem_ = read_problem(request);
    {
      const Rounds rounds(rounding_);
      self_ = engine_.load(&problem_->problem());
    }
    if (!self_) throw std::runtime_error("the engine could not take the problem");
    loaded_ = true;
    steps_ = 0;
    cpu_ = 0.0;
    told().resolved.emplace("dt", json(engine_.time_step(self_)).dump());
    return {{"time_step", engine_.time_step(self_)}, {"settings", told().resolved}};
  }

  bool has_setting(const std::string& name) const {
    for (const stiction_setting* one = engine_.settings; one && one->name; ++one) {
      if (name == one->name) return true;
    }
    return false;
  }

  json advance(const json& request) {
    const auto steps = read_count(request.at("steps"), "'steps'");
    const double before = cpu_seconds();
    if (steps > 0) {
      const Rounds rounds(rounding_);
      engine_.advance(self_, steps);
    }
    cpu_ += cpu_seconds() - before;
    steps_ += steps;
    return {{"steps", steps_}, {"time", time()}, {"cpu", cpu_}};
  }

  double time() const {
    return engine_.time ? engine_.time(self_)
                        : static_cast<double>(steps_) * engine_.time_step(self_);
  }

  json observe(const json& request) {
    json seen = json::object();
    for (const json& one : request.at("what")) {
      const auto what = one.get<std::string>();
      if (what == "bodies") {
        seen[what] = bodies();
      } else if (what == "contacts" && engine_.contacts) {
        seen[what] = contacts();
      } else if (what == "energies" && engine_.energies) {
        double kinetic = 0.0, gravity = 0.0, elastic = 0.0;
        engine_.energies(self_, &kinetic, &gravity, &elastic);
        seen[what] = {{"kinetic", kinetic}, {"gravity", gravity}, {"elastic", elastic}};
      } else if (what == "momenta" && engine_.momenta) {
        double linear[3] = {}, angular[3] = {};
        engine_.momenta(self_, linear, angular);
        seen[what] = {{"linear", linear}, {"angular", angular}};
      } else if (what == "surface" && engine_.surface && engine_.vertices) {
        seen[what] = surfaces();
      } else if (what == "vertices" && engine_.vertices) {
        seen[what] = vertices();
      } else {
        throw std::runtime_error("this engine does not tell '" + what + "'");
      }
    }
    return seen;
  }

  json bodies() const {
    std::vector<double> position, velocity, rotation, angular_velocity;
    for (std::size_t k = 0; k < problem_->problem().body_count; ++k) {
      stiction_body_state state{};
      state.rotation[0] = 1.0;
      engine_.body(self_, k, &state);
      position.insert(position.end(), state.position, state.position + 3);
      velocity.insert(velocity.end(), state.velocity, state.velocity + 3);
      rotation.insert(rotation.end(), state.rotation, state.rotation + 4);
      angular_velocity.insert(angular_velocity.end(), state.angular_velocity,
                              state.angular_velocity + 3);
    }
    const auto array = [](const std::vector<double>& all) {
      return write_array(all.data(), all.size());
    };
    return {{"position", array(position)},
            {"velocity", array(velocity)},
            {"rotation", array(rotation)},
            {"angular_velocity", array(angular_velocity)}};
  }

  json contacts() const {
    std::vector<stiction_contact> all(64);
    std::size_t count = engine_.contacts(self_, all.data(), all.size());
    if (count > all.size()) {
      all.resize(count);
      count = std::min(count, engine_.contacts(self_, all.data(), all.size()));
    }
    json list = json::array();
    for (std::size_t k = 0; k < count; ++k) {
      const stiction_contact& one = all[k];
      list.push_back({{"body", one.body},
                      {one.against_body ? "other_body" : "obstacle", one.other},
                      {"normal", one.normal},
                      {"gap", one.gap},
                      {"normal_force", one.normal_force},
                      {"friction_force", one.friction_force},
                      {"slip", one.slip},
                      {"position", one.position},
                      {"sticks", one.sticks != 0}});
    }
    return list;
  }

  json surfaces() const {
    json all = json::array();
    for (std::size_t k = 0; k < problem_->problem().body_count; ++k) {
      std::vector<std::uint32_t> triangles(3 * engine_.surface(self_, k, nullptr, 0));
      engine_.surface(self_, k, reinterpret_cast<std::uint32_t(*)[3]>(triangles.data()),
                      triangles.size() / 3);
      all.push_back(triangles);
    }
    return all;
  }

  json vertices() const {
    json all = json::array();
    for (std::size_t k = 0; k < problem_->problem().body_count; ++k) {
      std::vector<double> positions(3 * engine_.vertices(self_, k, nullptr, 0));
      engine_.vertices(self_, k, reinterpret_cast<double(*)[3]>(positions.data()),
                       positions.size() / 3);
      all.push_back(write_array(positions.data(), positions.size()));
    }
    return all;
  }

  struct Saved {
    void* state;
    std::uint64_t steps;
  };

  json save(const json& request) {
    for (const json& one : request.value("forget", json::array())) {
      const auto found = saved_.find(read_count(one, "a state to forget"));
      if (found == saved_.end()) continue;
      forget(found->second);
      saved_.erase(found);
    }
    const std::size_t index = next_saved_++;
    saved_[index] = {engine_.save(self_), steps_};
    return {{"state", index}};
  }

  void forget(const Saved& one) {
    if (engine_.forget) engine_.forget(self_, one.state);
  }

  json restore(const json& request) {
    const auto found = saved_.find(read_count(request.at("state"), "'state'"));
    if (found == saved_.end()) throw std::runtime_error("no such state was saved");
    engine_.restore(self_, found->second.state);
    steps_ = found->second.steps;
    return {{"steps", steps_}, {"time", time()}};
  }

  void drop() {
    for (const auto& [index, one] : saved_) forget(one);
    saved_.clear();
    if (loaded_ && engine_.end) engine_.end(self_);
    loaded_ = false;
    self_ = nullptr;
  }

  const stiction_engine& engine_;
  std::unique_ptr<OwnedProblem> problem_;
  void* self_ = nullptr;
  bool loaded_ = false;
  std::uint64_t steps_ = 0;
  double cpu_ = 0.0;
  int rounding_ = 0;  // mode of what the engine computes, as fesetround has it
  std::map<std::size_t, Saved> saved_;
  std::size_t next_saved_ = 0;
};

Session::Session(const stiction_engine& engine) : dealings_(std::make_unique<Dealings>(engine)) {}
Session::~Session() = default;

std::string Session::reply(const std::string& line) {
  json answer;
  try {
    const json request = json::parse(line);
    answer = dealings_->answer(request);
    over_ = request.value("do", "") == "quit";
  } catch (const Lacking& words) {
    answer = {{"lacks", words.what()}};
  } catch (const std::exception& error) {
    answer = {{"error", error.what()}};
  }
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace stiction::kit
