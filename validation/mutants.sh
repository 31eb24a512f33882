#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What tests of planted faults check with, beside end_to_end.sh; BUILD_DIR stands in $build.

options=() # of the runs that follow

run() { # run PROGRAM FOLDER CASE …: one JSON a record in FOLDER.jsonl
  local program=$1 folder=$2 arguments=()
  shift 2
  for name in "$@"; do arguments+=(--case "$name"); done
  "$build/$program" "${arguments[@]}" "${options[@]}" --no-page --out "$folder" >out 2>err
  cp "$folder/latest/records.jsonl" "$folder.jsonl" 2>>err ||
    failed "$program on $*" "it wrote no records"
}

# The verdict of a check: the record of the case and variant, cut at its quantities.
verdict() { # verdict FOLDER CASE VARIANT QUANTITY
  if [ "$4" = error ]; then
    grep -F "\"case\":\"$2\"" "$1.jsonl" | grep -F "\"variant\":\"$3\"" |
      sed -nE 's/.*"verdict":"([a-z-]+)","error":.*/\1/p'
    return
  fi
  grep -F "\"case\":\"$2\"" "$1.jsonl" | grep -F "\"variant\":\"$3\"" |
    sed 's/{"quantity":/\n&/g' | grep -F "{\"quantity\":\"$4\"" |
    sed -nE 's/.*"verdict":"([a-z-]+)".*/\1/p'
}

mutated=
mutant() { # mutant FAULT CASE …: runs these cases with the fault
  mutated=$1
  run "validate_$1" "$@"
}

correct=correct # the folder of the correct program's run
# bites CASE METHOD QUANTITY: the last mutant's check is red, the correct program's is not. METHOD is
# empty where the options choose it: then a record is of no variant.
bites() {
  local without with variant=${2:+method=$2}
  without=$(verdict "$correct" "$1" "$variant" "$3")
  with=$(verdict "$mutated" "$1" "$variant" "$3")
  case $without in
    pass | expected-shortfall | refuted) ;;
    *) failed "$mutated" "$3 of $1, ${variant:-${options[*]}}, is '$without' without it" ;;
  esac
  case $with in
    fail | error) passed "$mutated turns $1, ${variant:-${options[*]}}, red: $3" ;;
    *) failed "$mutated" "$3 of $1, ${variant:-${options[*]}}, is '$with' with it" ;;
  esac
}

# untried SCRIPT …: the faults of the build, a line each, that none of the scripts runs or names.
untried() {
  [ "$(wc -l <"$build/planted_faults")" -ge 15 ] || failed "planted faults" "the build's list is not read rightly"
  while IFS=: read -r fault words; do # grep -q would break the pipe
    sed 's/#.*//' "$@" | grep -w -e "$fault" -e "validate_$fault" >/dev/null || printf '%s:%s\n' "$fault" "$words"
  done <"$build/planted_faults"
}
