#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The kit as a person gets it: installed alone, its examples built with nothing else, tried and validated.
#   kit_test.sh BUILD
set -euo pipefail
build=$1
kit=$(mktemp -d)
trap 'rm -rf "$kit"' EXIT

fail() {
  printf 'kit_test: %s\n' "$*" >&2
  exit 1
}

cmake --install "$build" --component engine --prefix "$kit" >/dev/null
share=$kit/share/stiction/engine
eigen=$(pkg-config --cflags eigen3 2>/dev/null || echo -I/usr/include/eigen3)
library=$(dirname "$(find "$kit" -name libstiction_engine.a)")
sanitizers=$(sed -n 's/^STICTION_SANITIZERS:STRING=//p' "$build/CMakeCache.txt")
# shellcheck disable=SC2086 # one word an option
g++ -std=c++20 -O1 $eigen -I "$kit/include" ${sanitizers:+-fsanitize=$sanitizers} \
  "$share/examples/minimal_engine.cpp" -L "$library" -lstiction_engine -o "$kit/minimal_engine"
for engine in "$kit/minimal_engine" "python3 $share/examples/minimal_engine.py"; do
  "$build/engine" check "$engine" >"$kit/said" || fail "$engine fails its check: $(cat "$kit/said")"
  grep -q '^9 checks hold, 0 fail' "$kit/said" || fail "$engine: $(tail -n 1 "$kit/said")"
  "$build/validate" --engine "$engine" --case 'slope/*/azimuth=30' --no-page --out "$kit/run" >"$kit/said" ||
    fail "$engine does not hold on a slope: $(cat "$kit/said")"
  grep -q '^0 fail, 0 broke off · 4 hold' "$kit/said" || fail "$engine: $(grep hold "$kit/said" | head -n 1)"
done
echo 'the kit works alone, in C++ and in Python'
