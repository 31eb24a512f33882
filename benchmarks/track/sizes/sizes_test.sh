#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# End-to-end tests of `track sizes` on a project with a stand-in of the yardstick (testdata/sizes/), and of the
# yardstick itself: sizes_test.sh BUILD_DIR
# Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: sizes_test.sh BUILD_DIR}" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/project" && cd "$work/project" || exit 1
# shellcheck source=validation/end_to_end.sh
source "$root/validation/end_to_end.sh"
export STICTION_RUN_FILE=/dev/null COLUMNS=200 GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
export GIT_AUTHOR_NAME=t GIT_AUTHOR_EMAIL=t@example.org GIT_COMMITTER_NAME=t GIT_COMMITTER_EMAIL=t@example.org

says() { # says WORDS …: each stands in the output
  local words
  for words in "$@"; do grep -qF -- "$words" out || failed "it says what it found" "the output lacks: $words"; done
}
lines() { # lines LINE …: the output has lines that begin so, however far apart their cells are
  local words
  for words in "$@"; do tr -s ' ' <out | grep -q "^ $words" || failed "its table" "the output lacks: $words"; done
}
commit() { git add -A && git commit -qm "$1"; }
# solver NANOSECONDS AT_REST HASH: what the stand-in is built with.
solver() {
  printf 'constexpr double kNanoseconds = %s;\nconst char kAtRest[] = "%s", kHash[] = "%s";\n' "$@" >solver/solver.h
}
present() { # present NANOSECONDS AT_REST HASH: builds a present tree of these
  solver "$@" && cmake --build build/release --target yardstick >/dev/null || exit 1
}
sizes=("$build/track" sizes --against before)

mkdir -p solver benchmarks/yardstick benchmarks/workloads
cp "$root/benchmarks/track/testdata/sizes/CMakeLists.txt" .
cp "$root/benchmarks/track/testdata/sizes/yardstick.cpp" "$root/benchmarks/yardstick/beside.cmake" benchmarks/yardstick
printf '/build/\n/sizes-report/\n/out\n/err\n' >.gitignore
git init -q . && solver 100 true 1 && commit one && git tag before
cmake -G Ninja -B build/release >/dev/null && present 40 true 1

# ---- what is measured ---------------------------------------------------------------------------
STICTION_TEST_CALLS=$work/turns holds 0 "whole steps of all sizes, before and now" "${sizes[@]}" --threads 2
there="100/8/1 40/8/1 40/2/1 40/4/1 40/8/2" back="40/8/2 40/4/1 40/2/1 40/8/1 100/8/1"
[[ $(<"$work/turns") == "$there $there $back $there $back $there "* ]] ||
  failed "turns there and back" "it takes turns so: $(cut -c -200 "$work/turns")"
says "a step takes 0.40 of what it took" "the same state, to the bit, of 3 of 3 workloads" \
  "lie at most 0 % apart" "Records: $PWD/sizes-report/"
lines "slab whole step 100 → 40 100 → 40 *$" "slab … now ÷ before 0.40 0.40" "wall whole step 100 → 40 –" \
  "slab elastic forces 50 → 20 50 → 20" "slab detection and depth 25 → 10 25 → 10" \
  "slab step, registers of 2 160 160" "slab step, registers of 4 80 80" "slab 2 threads, × faster 2.00 2.00" \
  "slab … an answer < 400 ns \(–\|[0-9].[0-9][0-9]\) \(–\|[0-9].[0-9][0-9]\)" \
  "slab … arithmetic, × faster [0-9].[0-9][0-9] [0-9].[0-9][0-9]" \
  "slab … an answer, core to core [0-9][0-9]* ns [0-9][0-9]* ns" \
  "slab least by bandwidth 10 10" "slab least by arithmetic 20 20"
grep -qF '1 000 000' out && failed "default sizes" "a long workload was measured unasked"
grep -F '"configuration":"before"' sizes-report/latest/records.jsonl | grep -qF \
  '"name":"whole step per contact","unit":"s","x_name":"contacts","x_unit":"1","x":[100.0,1000.0],"y":[1.0' ||
  failed "its records" "none has the steps of before"
holds 0 "one of them" "${sizes[@]}" --benchmark 'step/wall/*' --full --out "$work/one"
says "Records: $work/one/" && lines "wall whole step 100 → 40 100 → 40"
grep -qF slab out && failed "one of them" "another was measured"

# ---- what fails, and what cannot be measured ----------------------------------------------------
present 40 false 1
holds 1 "what is not at rest fails" "${sizes[@]}"
says "FAILS: all that is timed is at rest" "now, 3 workloads that are not at rest, for one step/wall/contacts:100"
present 40 true 2
holds 1 "registers that leave another state fail" "${sizes[@]}"
says "FAILS: the width of registers and threads inside a step don't change a bit: registers of 4, 3 workloads"
present 40 '?' 1
refuses "a yardstick that answers nonsense" "its yardstick answers '{" "${sizes[@]}"
present 40 true 1
refuses "no such workload" "no workload of this name" "${sizes[@]}" --benchmark nonsense
refuses "an unknown revision" "git knows no revision" "$build/track" sizes --against nonsense --out "$work/none"
[ ! -e "$work/none" ] || failed "an unknown revision" "it left an empty run"
refuses "sizes of nothing" "compared with --against REF" "$build/track" sizes
holds 2 "no threads" "${sizes[@]}" --threads 0
STICTION_TEST_NEVER=wall "${sizes[@]}" --out "$work/ended" 2>"$work/ended.err" &
child=$!
for _ in {1..600}; do # a minute, on a busy machine
  [ "$(cat "$work"/ended/*/records.jsonl 2>/dev/null | wc -l)" -ge 7 ] && break
  sleep 0.1
done
kill -TERM $child
holds 143 "ended in the middle" wait $child
grep -qF "interrupted; 7 finished records are in $work/ended/" "$work/ended.err" ||
  failed "ended in the middle" "it says: $(cat "$work/ended.err")"
printf 'project(stiction CXX)\n' >CMakeLists.txt && commit "without workloads" && git tag without
exits 2 "a revision without workloads" "$build/track" sizes --against without
grep -qF "without cannot be" err || failed "a revision without workloads" "stderr lacks it"
passed "a revision without workloads"

# ---- the real one takes the steps that bench counts ---------------------------------------------
bits() { sed 's/.*"hash":"*\([0-9a-f]*\).*/\1/'; }
counted=$("$build/bench" --fixed steps:32/flush/contacts:100 --batches 1 | bits)
for threads in 1 2; do
  taken=$(printf 'settle\nsteps\n' | "$build/yardstick" flush 100 "$threads" | tail -n 1 | bits)
  if [ "${#taken}" -ne 16 ] || [ $((16#$taken & 0xffffffff)) -ne "$counted" ]; then
    failed "the yardstick takes the steps that bench counts" "by $threads threads: $taken is not $counted"
  fi
done
passed "the yardstick takes the steps that bench counts"
for words in "nonsense 100" "slab 1e3" "slab 100 0" "slab"; do
  # shellcheck disable=SC2086 # one word each
  refuses "of the yardstick: $words" "yardstick: " "$build/yardstick" $words
done
