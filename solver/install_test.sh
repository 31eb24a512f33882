#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Programs outside this tree build against what `cmake --install` leaves: install_test.sh BUILD
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
# builds CONSUMER SAYS: configures, builds and runs what stands in the folder.
builds() {
  local folder=$work/$1 said
  cmake -S "$folder" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1 &&
    cmake --build "$folder/build" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  said=$("$folder/build/consumer")
  [[ $said == $2 ]] || { echo "the $1 says '$said', not '$2'"; exit 1; }
  echo "a $1 outside the tree builds and runs: $said"
}
builds consumer "1 contact"

mkdir "$work/validator"
sed -e 's/find_package(stiction REQUIRED)/find_package(stiction REQUIRED COMPONENTS validation)/' \
  -e 's/stiction::solver/stiction::validation/' "$work/consumer/CMakeLists.txt" >"$work/validator/CMakeLists.txt"
cat >"$work/validator/main.cpp" <<'C'
#include <cstdio>

#include "validation/core/runner.h"

int main() {
  using namespace stiction;
  const Record record =
      run_job(select_jobs(case_catalog(), {.globs = {"half-space/free-fall"}}).front(), 1.0);
  std::printf("%s: %s", record.case_name.c_str(), to_string(record.verdict).c_str());
}
C
builds validator "half-space/free-fall: pass"
