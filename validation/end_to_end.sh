#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What end-to-end tests check with; to be sourced in a folder that may be written to.

passed() { printf 'ok    %s\n' "$1"; }
failed() {
  printf 'FAIL  %s\n      %s\n' "$1" "$2"
  printf '      --- its output\n'
  tail -n 20 out err | sed 's/^/      /'
  exit 1
}

# exits CODE WHAT COMMAND …: runs the command, keeps its output in the files out and err.
exits() {
  local code=$1 what=$2 got
  shift 2
  "$@" >out 2>err
  got=$?
  [ "$got" -eq "$code" ] || failed "$what" "exit code $got, not $code, of: $*"
}

holds() { # holds CODE WHAT COMMAND …
  exits "$@"
  passed "$2"
}

# refuses WHAT SENTENCE COMMAND …: exit code 2, nothing but this sentence (a part of it) on one line
# of stderr.
refuses() {
  local what=$1 sentence=$2
  shift 2
  exits 2 "$what" "$@"
  [ "$(wc -l <err)" -eq 1 ] || failed "$what" "stderr is not one line"
  grep -qF -- "$sentence" err || failed "$what" "stderr lacks: $sentence"
  passed "$what: $(cut -c1-110 err)"
}

state_hashes() { # state_hashes FOLDER: case, settings, hash of each record of its last run
  sed -E 's/.*"case":"([^"]*)".*"settings":(\{[^}]*\}).*"state_hash":"([0-9a-f]{16})".*/\1 \2 \3/' \
    "$1/latest/records.jsonl" | sort
}
