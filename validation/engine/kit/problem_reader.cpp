// SPDX-License-Identifier: BSD-3-Clause
#include "validation/engine/kit/problem_reader.h"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "validation/engine/kit/array_json.h"

namespace stiction::kit {

namespace {

using nlohmann::json;

using Three = std::array<double, 3>;

struct Keyframes {
  std::vector<double> time;
  std::vector<Three> value;
  Three velocity{};
  stiction_oscillation oscillation{};
  stiction_keyframes view() const {
    return {time.size(),
            time.data(),
            reinterpret_cast<const double(*)[3]>(value.data()),
            {velocity[0], velocity[1], velocity[2]},
            oscillation};
  }
};

const json& field(const json& object, const char* name, const std::string& of) {
  if (!object.is_object() || !object.contains(name)) {
    throw std::runtime_error(of + " has no '" + name + "'");
  }
  return object.at(name);
}

double number(const json& object, const char* name, const std::string& of, double fallback) {
  if (!object.contains(name)) return fallback;
  if (!object.at(name).is_number()) {
    throw std::runtime_error("'" + std::string(name) + "' of " + of + " is no number");
  }
  return object.at(name).get<double>();
}

int count(const json& object, const std::string& name) {
  if (!object.contains(name)) return 0;
  return static_cast<int>(
      read_count(object.at(name), "'" + name + "'", std::numeric_limits<int>::max()));
}

template <std::size_t Count>
void fill(const json& object, const char* name, const std::string& of, double (&out)[Count]) {
  if (!object.contains(name)) return;
  const std::vector<double> all =
      read_array(object.at(name), "'" + std::string(name) + "' of " + of);
  if (all.size() != Count) {
    throw std::runtime_error("'" + std::string(name) + "' of " + of + " needs " +
                             std::to_string(Count) + " numbers");
  }
  std::copy(all.begin(), all.end(), out);
}

std::vector<Three> triples(const json& value, const std::string& what) {
  const std::vector<double> all = read_array(value, what);
  if (all.size() % 3 != 0) throw std::runtime_error(what + " is no list of vectors");
  std::vector<Three> out(all.size() / 3);
  for (std::size_t k = 0; k < all.size(); ++k) out[k / 3][k % 3] = all[k];
  return out;
}

Keyframes keyframes(const json& object, const char* name, const std::string& of) {
  Keyframes out;
  if (!object.contains(name)) return out;
  const json& frames = object.at(name);
  const std::string what = "'" + std::string(name) + "' of " + of;
  out.time = read_array(field(frames, "time", what), "'time' of " + what);
  out.value = triples(field(frames, "value", what), "'value' of " + what);
  if (out.time.size() != out.value.size()) {
    throw std::runtime_error(what + " has not as many values as times");
  }
  double velocity[3] = {};
  fill(frames, "velocity", what, velocity);
  std::copy(velocity, velocity + 3, out.velocity.begin());
  if (frames.contains("oscillation")) {
    const json& sine = frames.at("oscillation");
    const std::string of_it = "the oscillation of " + what;
    fill(sine, "amplitude", of_it, out.oscillation.amplitude);
    out.oscillation.frequency = number(sine, "frequency", of_it, 0.0);
    out.oscillation.phase = number(sine, "phase", of_it, 0.0);
    out.oscillation.begins = number(sine, "begins", of_it, 0.0);
    out.oscillation.full_from = number(sine, "full_from", of_it, 0.0);
  }
  return out;
}

class Owned final : public OwnedProblem {
 public:
  explicit Owned(const json& message) {
    const json& problem = field(message, "problem", "the message");
    problem_.name = keep(problem.value("name", ""));
    for (const json& body : field(problem, "bodies", "the problem")) add_body(body);
    const json obstacles = problem.value("obstacles", json::array());
    for (const json& obstacle : obstacles) add_obstacle(obstacle);
    problem_.body_count = bodies_.size();
    problem_.bodies = bodies_.data();
    problem_.obstacle_count = obstacles_.size();
    problem_.obstacles = obstacles_.data();
    problem_.gravity = keep_frames(keyframes(problem, "gravity", "the problem"));
    const json drag = problem.value("drag", json::object());
    problem_.drag_rate = number(drag, "rate", "drag", 0.0);
    problem_.drag_full_until = number(drag, "full_until", "drag", 0.0);
    problem_.drag_ends = number(drag, "ends", "drag", 0.0);
    problem_.friction = number(problem, "friction", "the problem", 0.0);
    problem_.duration = number(problem, "duration", "the problem", 1.0);
    const json loads = problem.value("loads", json::array());
    for (const json& load : loads) {
      loads_.push_back({body_index(load, "a load"), keep_frames(keyframes(load, "force", "a load")),
                        keep_frames(keyframes(load, "couple", "a load"))});
    }
    const json springs = problem.value("springs", json::array());
    for (const json& spring : springs) add_spring(spring);
    problem_.load_count = loads_.size();
    problem_.loads = loads_.data();
    problem_.spring_count = springs_.size();
    problem_.springs = springs_.data();
    const json pairs = problem.value("pair_friction", json::array());
    for (const json& pair : pairs) add_pair_friction(pair);
    problem_.pair_friction_count = pair_friction_.size();
    problem_.pair_friction = pair_friction_.data();
    problem_.restitution = number(problem, "restitution", "the problem", 0.0);
    const json accuracy = message.value("accuracy", json::object());
    problem_.fineness = count(accuracy, "fineness");
    problem_.roundness = count(accuracy, "roundness");
    problem_.time = accuracy.value("time", 0.0);
    problem_.finer = accuracy.value("finer", 1.0);
  }

  const stiction_problem& problem() const override { return problem_; }

 private:
  const char* keep(const std::string& text) { return texts_.emplace_back(text).c_str(); }

  stiction_keyframes keep_frames(Keyframes frames) {
    return frames_.emplace_back(std::move(frames)).view();
  }

  static std::size_t index_of(const json& object, const char* name, std::size_t count,
                              const std::string& of) {
    const json& index = field(object, name, of);
    if (!index.is_number_unsigned() || index.get<std::size_t>() >= count) {
      throw std::runtime_error("'" + std::string(name) + "' of " + of + " names what is not there");
    }
    return index.get<std::size_t>();
  }

  std::size_t body_index(const json& object, const std::string& of) const {
    return index_of(object, "body", bodies_.size(), of);
  }

  void add_pair_friction(const json& pair) {
    const std::string of = "a pair's friction";
    stiction_pair_friction one{};
    one.body = body_index(pair, of);
    one.against_body = pair.value("against_body", false);
    one.other = index_of(pair, "other", one.against_body ? bodies_.size() : obstacles_.size(), of);
    field(pair, "friction", of);
    one.friction = number(pair, "friction", of, 0.0);
    pair_friction_.push_back(one);
  }

  void add_spring(const json& spring) {
    const std::string of = "a spring";
    stiction_spring one{};
    one.body = body_index(spring, of);
    fill(spring, "anchor", of, one.anchor);
    fill(spring, "anchor_velocity", of, one.anchor_velocity);
    fill(spring, "axis", of, one.axis);
    one.stiffness = number(spring, "stiffness", of, 0.0);
    springs_.push_back(one);
  }

  void add_body(const json& body) {
    stiction_body one{};
    one.name = keep(body.value("name", ""));
    const std::string of = "body '" + std::string(one.name) + "'";
    one.mass = number(body, "mass", of, 1.0);
    const json elasticity = body.value("elasticity", json::object());
    one.youngs_modulus = number(elasticity, "youngs_modulus", of, 5e5);
    one.poisson_ratio = number(elasticity, "poisson_ratio", of, 0.3);
    one.damping_time = number(elasticity, "damping_time", of, 0.0);
    one.rotation[0] = 1.0;
    fill(body, "position", of, one.position);
    fill(body, "rotation", of, one.rotation);
    fill(body, "velocity", of, one.velocity);
    fill(body, "angular_velocity", of, one.angular_velocity);
    if (body.contains("held")) {
      one.held = 1;
      fill(body.at("held"), "point", of, one.held_point);
      fill(body.at("held"), "normal", of, one.held_normal);
    }
    one.motion = keep_frames(keyframes(body, "motion", of));
    one.self_collision = body.value("self_collision", false);
    one.must_deform = body.value("must_deform", false);
    add_shape(field(body, "shape", of), of, one);
    bodies_.push_back(one);
  }

  void add_shape(const json& shape, const std::string& of, stiction_body& one) {
    if (shape.contains("box")) {
      one.shape = STICTION_BOX;
      fill(shape.at("box"), "size", of, one.size);
      for (int i = 0; i < 3; ++i) {
        const double a = one.size[(i + 1) % 3], b = one.size[(i + 2) % 3];
        one.inertia[i][i] = one.mass / 12.0 * (a * a + b * b);
      }
    } else if (shape.contains("ball")) {
      one.shape = STICTION_BALL;
      one.radius = number(shape.at("ball"), "radius", of, 0.0);
      for (int i = 0; i < 3; ++i) one.inertia[i][i] = 0.4 * one.mass * one.radius * one.radius;
    } else if (shape.contains("mesh")) {
      add_mesh(shape.at("mesh"), of, one);
    } else if (shape.contains("point")) {
      one.shape = STICTION_POINT;
    } else {
      throw std::runtime_error(of + " has a shape that is none of box, ball, mesh and point");
    }
  }

  void add_mesh(const json& mesh, const std::string& of, stiction_body& one) {
    one.shape = STICTION_MESH;
    one.convex = mesh.value("convex", false);
    const std::vector<Three>& vertices =
        vertices_.emplace_back(triples(field(mesh, "vertices", of), "'vertices' of " + of));
    const std::vector<double> corners =
        read_array(field(mesh, "tetrahedra", of), "'tetrahedra' of " + of);
    std::vector<std::uint32_t>& tetrahedra = tetrahedra_.emplace_back();
    for (const double corner : corners) {
      if (!(corner >= 0.0) || corner >= static_cast<double>(vertices.size())) {
        throw std::runtime_error("'tetrahedra' of " + of + " name vertices that are not there");
      }
      tetrahedra.push_back(static_cast<std::uint32_t>(corner));
    }
    if (tetrahedra.size() % 4 != 0) {
      throw std::runtime_error("'tetrahedra' of " + of + " are no list of four each");
    }
    one.vertex_count = vertices.size();
    one.vertices = reinterpret_cast<const double(*)[3]>(vertices.data());
    one.tetrahedron_count = tetrahedra.size() / 4;
    one.tetrahedra = reinterpret_cast<const std::uint32_t(*)[4]>(tetrahedra.data());
    add_mesh_inertia(one);
  }

  // Of a tetrahedron of mass m with corners a about the origin: ∫ x xᵀ dm = m/20 (Σ a aᵀ + s sᵀ),
  // s = Σ a; the inertia is tr(C) 1 − C.
  static void add_mesh_inertia(stiction_body& one) {
    double volume = 0.0, second[3][3] = {};
    for (std::size_t e = 0; e < one.tetrahedron_count; ++e) {
      const double* a[4];
      for (int k = 0; k < 4; ++k) a[k] = one.vertices[one.tetrahedra[e][k]];
      double d[3][3];
      for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) d[k][i] = a[k + 1][i] - a[0][i];
      }
      const double part = (d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
                           d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
                           d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0])) /
                          6.0;
      volume += part;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          double sum =
              (a[0][i] + a[1][i] + a[2][i] + a[3][i]) * (a[0][j] + a[1][j] + a[2][j] + a[3][j]);
          for (int k = 0; k < 4; ++k) sum += a[k][i] * a[k][j];
          second[i][j] += part / 20.0 * sum;
        }
      }
    }
    const double density = volume > 0.0 ? one.mass / volume : 0.0;
    const double trace = second[0][0] + second[1][1] + second[2][2];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        one.inertia[i][j] = density * ((i == j ? trace : 0.0) - second[i][j]);
      }
    }
  }

  void add_obstacle(const json& obstacle) {
    stiction_obstacle one{};
    one.name = keep(obstacle.value("name", ""));
    const std::string of = "obstacle '" + std::string(one.name) + "'";
    one.normal[2] = 1.0;
    fill(obstacle, "point", of, one.point);
    fill(obstacle, "normal", of, one.normal);
    one.friction = number(obstacle, "friction", of, 0.0);
    one.motion = keep_frames(keyframes(obstacle, "motion", of));
    obstacles_.push_back(one);
  }

  // Deques, so that what is pointed to stays where it is.
  std::deque<std::string> texts_;
  std::deque<Keyframes> frames_;
  std::deque<std::vector<Three>> vertices_;
  std::deque<std::vector<std::uint32_t>> tetrahedra_;
  std::vector<stiction_body> bodies_;
  std::vector<stiction_obstacle> obstacles_;
  std::vector<stiction_body_load> loads_;
  std::vector<stiction_spring> springs_;
  std::vector<stiction_pair_friction> pair_friction_;
  stiction_problem problem_{};
};

}  // namespace

std::unique_ptr<OwnedProblem> read_problem(const json& message) {
  return std::make_unique<Owned>(message);
}

}  // namespace stiction::kit
