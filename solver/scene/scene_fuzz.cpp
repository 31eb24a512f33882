// SPDX-License-Identifier: BSD-3-Clause
// A description of a scene, meshes of any numbers and corners among it: a scene that can be stepped,
// or one sentence.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/bytes.h"
#include "fuzz/property.h"
#include "solver/demand.h"
#include "solver/scene/scene.h"
#include "solver/step.h"

using namespace stiction;

namespace {

Vec3 vector_of(fuzz::Bytes& bytes) {
  const double x = bytes.number(), y = bytes.number(), z = bytes.number();
  return {x, y, z};
}

BodyDescription body_of(fuzz::Bytes& bytes) {
  BodyDescription body;
  body.name = "body";
  body.mesh.vertices.resize(3, bytes.byte() % 16);
  for (Eigen::Index v = 0; v < body.mesh.vertices.cols(); ++v) {
    body.mesh.vertices.col(v) = vector_of(bytes);
  }
  body.mesh.tetrahedra.resize(4, bytes.byte() % 16);
  for (int& corner : body.mesh.tetrahedra.reshaped()) corner = bytes.take<std::int8_t>();
  if (bytes.coin()) body.material.density = bytes.number();
  if (bytes.coin()) body.material.youngs_modulus = bytes.number();
  if (bytes.coin()) body.material.poisson_ratio = bytes.number();
  if (bytes.coin()) body.material.damping_time = bytes.number();
  if (bytes.coin()) body.point_mass = bytes.number();
  if (bytes.coin()) {
    body.initial_velocity = vector_of(bytes).replicate(1, body.mesh.vertices.cols());
  }
  if (bytes.coin()) body.pinned.push_back(bytes.take<std::int8_t>());
  body.self_collision = bytes.coin();
  return body;
}

SceneDescription description_of(fuzz::Bytes& bytes) {
  SceneDescription scene;
  for (int bodies = bytes.byte() % 4; bodies > 0; --bodies) scene.bodies.push_back(body_of(bytes));
  for (int spaces = bytes.byte() % 3; spaces > 0; --spaces) {
    HalfSpace space;
    space.point = vector_of(bytes);
    if (bytes.coin()) space.normal = vector_of(bytes);
    if (bytes.coin()) space.normal.normalize();
    space.friction = bytes.number();
    scene.half_spaces.push_back(space);
  }
  for (int frames = bytes.byte() % 3; frames > 0; --frames) {
    scene.gravity.time.push_back(bytes.number());
    scene.gravity.acceleration.push_back(vector_of(bytes));
  }
  if (bytes.coin()) scene.drag = {bytes.number(), bytes.number(), bytes.number()};
  if (bytes.coin()) scene.friction = bytes.number();
  if (bytes.coin()) {
    Spring spring;
    spring.body = bytes.byte();
    spring.anchor = vector_of(bytes);
    spring.axis = vector_of(bytes);
    spring.stiffness = bytes.number();
    scene.springs.push_back(spring);
  }
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const SceneDescription description = description_of(bytes);
  const auto scene = fuzz::value_or_sentence<InputError>([&] { return build_scene(description); });
  if (!scene) return 0;
  fuzz::hold(scene->stable_time_step > 0.0,
             "a scene has a stable time step, not " + std::to_string(scene->stable_time_step));
  Options options;
  options.time_step = std::min(1e-3, 0.5 * scene->stable_time_step);
  const auto usable = fuzz::value_or_sentence<InputError>([&] {
    check_options(options, *scene);
    return true;
  });
  if (!usable) return 0;
  State state = initial_state(*scene);
  Workspace workspace;
  for (int k = 0; k < 3; ++k) step(*scene, options, state, workspace);
  return 0;
}
