#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Engine processes are killed at random times: the run ends, each case that lost its engine is an error that says
# so, and every record is whole.
#   kills_test.sh BUILD [KILLS]
set -euo pipefail
build=$1
kills=${2:-40}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
trap 'printf "kills_test: line %s ended with %s\n" "$LINENO" "$?" >&2' ERR

fail() {
  printf 'kills_test: %s\n' "$*" >&2
  exit 1
}

cases=(--case 'slope/accelerates/*' --case 'slope/stops/*' --case 'incline/above/*' --case 'incline/threshold/mu=0.5/*')
expected=$("$build/validate" --engine "$build/hosted_engine" "${cases[@]}" --list | wc -l)
RANDOM=7
done=0 runs=0 errors=0
while [ "$done" -lt "$kills" ]; do
  runs=$((runs + 1))
  [ "$runs" -le "$kills" ] || fail "$kills runs were not enough for $kills kills"
  code=0
  "$build/validate" --engine "$build/hosted_engine" "${cases[@]}" --no-page --jobs 2 --out "$out/run" \
    >"$out/table" 2>"$out/said" &
  suite=$!
  while kill -0 "$suite" 2>/dev/null && [ "$done" -lt "$kills" ]; do
    sleep "0.0$((RANDOM % 90 + 10))"
    # While its adapter is still tried a kill ends the run: now and then.
    [ -d "$out/run" ] || [ $((RANDOM % 8)) -eq 0 ] || continue
    engine=$(pgrep -P "$suite" -x hosted_engine | shuf -n 1 --random-source=<(yes) || true)
    [ -z "$engine" ] || ! kill -KILL "$engine" 2>/dev/null || done=$((done + 1))
  done
  wait "$suite" || code=$?
  records=$out/run/latest/records.jsonl
  if [ ! -f "$records" ]; then
    # Killed while its adapter was tried: then nothing is graded, and that is said.
    grep -q 'signal 9 (Killed)' "$out/said" || fail "no records, and no word of why: $(cat "$out/said")"
    continue
  fi
  [ "$code" -eq 2 ] || [ "$code" -eq 1 ] || [ "$code" -eq 0 ] || fail "exit code $code"
  whole=$(grep -c '^{.*}$' "$records" || true)
  [ "$whole" -eq "$expected" ] || fail "$whole whole records where $expected cases were run"
  here=$(grep -c '"verdict":"error"' "$records" || true)
  errors=$((errors + here))
  killed=$(grep -c 'was ended by signal 9 (Killed)' "$records" || true)
  [ "$here" -eq "$killed" ] || fail "$here errors, of which $killed say that the engine was killed"
  rm -rf "$out/run"
done
[ "$errors" -gt 0 ] || fail "no kill met a case"
printf '%s kills in %s runs of %s cases: %s errors, each told, every record whole\n' "$done" "$runs" "$expected" "$errors"
