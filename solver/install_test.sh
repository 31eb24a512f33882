#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A program outside this tree builds against what `cmake --install` leaves: install_test.sh BUILD
set -euo pipefail
build=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
mkdir "$work/consumer"
cat >"$work/consumer/CMakeLists.txt" <<'C'
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(stiction REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE stiction::solver)
C
cat >"$work/consumer/main.cpp" <<'C'
#include <cstdio>

#include "solver/step.h"

int main() {
  using namespace stiction;
  SceneDescription description;
  BodyDescription point;
  point.name = "point";
  point.mesh.vertices = Vec3::Zero();
  point.point_mass = 1.0;
  description.bodies.push_back(point);
  description.half_spaces.push_back({.name = "ground", .friction = 0.5});
  description.gravity = {{0.0}, {Vec3(0.0, 0.0, -9.81)}};
  const Scene scene = build_scene(description);
  const Options options;
  State state = initial_state(scene);
  Workspace workspace;
  for (int k = 0; k < 100; ++k) step(scene, options, state, workspace);
  std::printf("%d contact\n", static_cast<int>(workspace.contacts.size()));
}
C
cmake -S "$work/consumer" -B "$work/consumer/build" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1 &&
  cmake --build "$work/consumer/build" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
said=$("$work/consumer/build/consumer")
[ "$said" = "1 contact" ] || { echo "the consumer says '$said', not '1 contact'"; exit 1; }
echo "a program outside the tree builds and runs: $said"
