# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# What ./stiction, which sources this, runs; and how that ends when the script is told to end.

# A folder for files that are gone at the end, named before it is made so that no moment is left out.
temporary=${TMPDIR:-/tmp}/stiction-$$-$RANDOM$RANDOM
finished= # a run whose page is not made yet
trap 'rm -rf "$temporary"' EXIT

# run COMMAND …: a signal to this script alone ends it too, at once; Ctrl-C reaches it by itself.
run() {
  local code=0
  # What stands in the background would else be deaf to Ctrl-C, and have no stdin.
  (trap - INT QUIT && exec "$@") <&0 &
  wait $! || code=$?
  return "$code"
}

# run_group COMMAND …: for what starts processes of its own, or is a function: all of them end. No stdin.
run_group() {
  local code=0
  set -m # a process group of its own
  "$@" </dev/null &
  set +m
  wait $! 2>/dev/null || code=$?
  return "$code"
}

# runs PROCESS: whether it does, or any of its group. What has ended but waits to be asked after, as orphans may for
# seconds in a container, does not run.
runs() {
  local stat line words
  kill -0 "$1" 2>/dev/null && return 0 # a bare `return` in a trap has an earlier status
  kill -0 -- "-$1" 2>/dev/null || return 1
  [ -e /proc/self/stat ] || return 0
  for stat in /proc/[0-9]*/stat; do
    { read -r line <"$stat"; } 2>/dev/null || continue
    read -r -a words <<<"${line##*) }" # its state, its parent, its group
    [ "${words[2]-}" != "$1" ] || [ "${words[0]}" = Z ] || return 0
  done
  return 1
}

# interrupted SIGNAL NUMBER: ends what runs, waits for it, and says what there is.
interrupted() {
  local process tick
  trap '' INT TERM HUP
  for process in $(jobs -p); do
    # Of a group some may be deaf to Ctrl-C, as what stands in a shell's background is.
    kill -TERM -- "-$process" 2>/dev/null || kill -s "$1" "$process" 2>/dev/null || continue
    for ((tick = 0; tick < 100; ++tick)); do
      runs "$process" || break
      sleep 0.1
    done
    kill -KILL -- "-$process" 2>/dev/null || kill -KILL "$process" 2>/dev/null || true
  done
  [ -z "$finished" ] || say "interrupted; the records are in $finished; ./stiction report '$finished' makes a page of them"
  exit $((128 + $2))
}
trap 'interrupted INT 2' INT
trap 'interrupted TERM 15' TERM
trap 'interrupted HUP 1' HUP
# Once signals are heeded, so that it is removed whenever one comes.
if ! reason=$(mkdir -m 700 "$temporary" 2>&1); then
  say "${reason#mkdir: }"
  exit 2
fi
