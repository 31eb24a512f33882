#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs are interrupted in the middle: finished records stay whole and are told of, and no engine goes on.
#   interrupt_test.sh BUILD_DIR
set -uo pipefail

build=$(cd "${1:?usage: interrupt_test.sh BUILD_DIR}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
# An engine of a name that no other test's has, to be looked for; it does not end by itself.
engine=$work/engine_of_this_test
ln -s "$build/hosted_engine" "$engine"
cat >deaf_engine.sh <<SH
#!/bin/sh
trap '' TERM
"$engine"
sleep 600 &
while :; do sleep 1; done
SH
chmod +x deaf_engine.sh

failed() {
  printf 'FAIL  %s\n      %s\n' "$what" "$1"
  tail -n 20 out err | sed 's/^/      /'
  exit 1
}

# Until COMMAND holds, 60 s at most.
until_holds() {
  local tick
  for ((tick = 0; tick < 1200; ++tick)); do
    "$@" && return
    sleep 0.05
  done
  failed "in vain was waited for: $*"
}

records() { cat "$1"/2*/records.jsonl 2>/dev/null | wc -l; }
has_records() { [ "$(records "$1")" -ge "$2" ]; }
has_engine() { pgrep -f "$work/" >/dev/null; }
has_no_engine() { ! has_engine; }

# interrupted SIGNAL NUMBER WHAT READY … -- COMMAND …: sends the signal once READY holds.
interrupted() {
  local signal=$1 number=$2 ready=() code=0 began
  what=$3
  shift 3
  while [ "$1" != -- ]; do ready+=("$1") && shift; done
  shift
  env --default-signal=INT "$@" >out 2>err &
  until_holds "${ready[@]}"
  began=$SECONDS
  kill -s "$signal" $!
  wait $! || code=$?
  [ "$code" -eq $((128 + number)) ] || failed "exit code $code, not $((128 + number))"
  [ $((SECONDS - began)) -le 6 ] || failed "it took $((SECONDS - began)) s to end"
  has_no_engine || failed "left running: $(pgrep -fa "$work/")"
}

# kept FOLDER: its records are whole, and told of.
kept() {
  local file count
  file=$(echo "$1"/2*/records.jsonl)
  count=$(grep -c '^{.*}$' "$file")
  [ "$count" -eq "$(wc -l <"$file")" ] && [ -z "$(tail -c 1 "$file")" ] || failed "a record is cut off"
  ! grep -q '"verdict":"error"' "$file" || failed "what was interrupted is a record"
  grep -qE "interrupted; $count finished records? (is|are) in $work/$file; ./stiction report '$work/$(dirname "$file")' makes a page of (it|them)" err ||
    failed "not told: $count records in $file"
  printf 'ok    %s: %s\n' "$what" "$(cut -c1-60 err)"
}

# A record now and then while another case goes on for long.
many=(--no-page --jobs 2 --case slab/rest/many/20 --case 'incline/threshold/*')
for one in 'INT 2' 'TERM 15' 'HUP 1'; do
  read -r name number <<<"$one"
  interrupted "$name" "$number" "validate, SIG$name" has_records "v$number" 2 -- \
    "$build/validate" "${many[@]}" --out "v$number"
  kept "v$number"
done
has_both() { has_engine && has_records engine 2; }
interrupted INT 2 "validate of an engine" has_both -- \
  "$build/validate" "${many[@]}" --engine "$engine" --out engine
kept engine
has_deaf_engine() { pgrep -f "sh $work/deaf" >/dev/null; } # which validate's own words do not match
interrupted TERM 15 "an engine that is deaf, with a child of its own" has_deaf_engine -- \
  "$build/validate" "${many[@]}" --engine "$work/deaf_engine.sh" --out deaf
grep -q 'stiction validate: interrupted$' err || failed "it does not say so"
printf 'ok    %s\n' "$what"
has_run() { [ -d nothing ]; }
interrupted INT 2 "before anything is finished" has_run -- \
  "$build/validate" --no-page --case 'paper/fig6-basket/objects=112' --jobs 1 --out nothing
grep -q 'interrupted before anything was finished$' err || failed "it does not say so"
[ -z "$(ls nothing)" ] || failed "an empty run was left: $(ls nothing)"
printf 'ok    %s\n' "$what"
interrupted TERM 15 "compare" has_records compared 2 -- "$build/compare" --no-page --jobs 2 --scene rules/slab --out compared
kept compared
for one in 'INT 2' 'TERM 15'; do
  read -r name number <<<"$one"
  interrupted "$name" "$number" "bench, SIG$name" has_records "bench$number" 1 -- \
    "$build/bench" --benchmark_filter=/plane/ --benchmark_min_time=0.01 --out "bench$number"
  kept "bench$number"
done
what="a signal that the caller ignores"
env --ignore-signal=HUP "$build/validate" "${many[@]}" --out ignored >out 2>err &
until_holds has_records ignored 1
kill -HUP $!
until_holds has_records ignored $(($(records ignored) + 2))
kill -TERM $!
wait $!
[ $? -eq 143 ] || failed "it ended the run, or another did not"
kept ignored
