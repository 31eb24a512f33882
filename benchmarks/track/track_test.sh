#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# End-to-end tests of `track` on a project of stand-ins (testdata/): track_test.sh BUILD_DIR
# Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: track_test.sh BUILD_DIR}" && pwd)
data=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/testdata
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/project" "$work/bin" && cd "$work/project" || exit 1
cp "$data"/CMakeLists.txt "$data"/*.sh . && cp "$data/valgrind" "$work/bin"
# The stand-ins carry this clone's history in build/, and the word of no other git configuration.
export STICTION_RUN_FILE=/dev/null COLUMNS=200 PATH=$work/bin:$PATH GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
export GIT_AUTHOR_NAME=t GIT_AUTHOR_EMAIL=t@example.org GIT_COMMITTER_NAME=t \
  GIT_COMMITTER_EMAIL=t@example.org
friction=friction:fixed-point/slab/contacts:1000

failed() {
  printf 'FAIL  %s\n      %s\n' "$1" "$2"
  tail -n 20 "$work/out" "$work/err" | sed 's/^/      /'
  exit 1
}

# holds CODE WHAT ARGUMENT …: runs track, demands the exit code, keeps its output.
holds() {
  local code=$1 what=$2 got
  last=$what
  shift 2
  "$build/track" "$@" >"$work/out" 2>"$work/err"
  got=$?
  [ "$got" -eq "$code" ] || failed "$what" "exit code $got, not $code, of: track $*"
  printf 'ok    %s\n' "$what"
}

# says WORDS …: each stands in the output.
says() {
  local words
  for words in "$@"; do
    grep -qF -- "$words" "$work/out" || failed "$last" "the output lacks: $words"
  done
}

# refuses WHAT SENTENCE ARGUMENT …: exit code 2; the last line of stderr holds the sentence.
refuses() {
  local what=$1 sentence=$2
  shift 2
  holds 2 "$what" "$@"
  tail -n 1 "$work/err" | grep -qF -- "$sentence" || failed "$what" "stderr lacks: $sentence"
}

# sql FILE WORDS …: runs these as one statement after the other, in a process of its own.
sql() { python3 -c 'import sqlite3, sys
base = sqlite3.connect(sys.argv[1], isolation_level=None)
for words in sys.argv[2:]: base.execute(words)' "$@"; }

# present TIME UPDATES ERROR DIGITS VERDICT FLAGS: builds a present tree of these numbers.
present() {
  printf '# %s %s %s %s\n' "$1" "$2" "$3" "$6" >bench.numbers
  printf '# %s %s %s\n' "$4" "$5" "$6" >validate.numbers
  cmake --build build/release --target bench validate >/dev/null || exit 1
}

commit() { git add -A && git commit -qm "$1"; }

# row CHANGE METRIC: the table has this line.
row() { grep -qE "^$1 +$2( |\$)" "$work/out" || failed "$last" "no row: $1 $2"; }

printf 'build/\n' >.gitignore
git init -q . && printf '# 50 1000 1e-9 -O3\n' >bench.numbers && printf '# 6 pass -O3\n' >validate.numbers
commit one && cmake -G Ninja -B build/release >/dev/null && present 50 1000 1e-9 6 pass -O3

# ---- decisions and exit codes -------------------------------------------------------------------
holds 0 "the same against itself: nothing is worse" --against HEAD
says "nothing is worse, 0 better" "1 of 1 cases equal to the last bit"
present 54 1000 1e-9 6 pass -O3
holds 1 "8 % slower is worse" --against HEAD
row worse "$friction#time"
grep -q 'once more, to be sure' "$work/err" || failed "$last" "it was not confirmed"
present 46 1000 1e-9 6 pass -O3
holds 0 "8 % faster is nothing worse" --against HEAD
row better "$friction#time"
holds 3 "and is told when asked for" --against HEAD --report-improvement
present 50 1000 1e-9 5 pass -O3
holds 1 "a digit less is worse" --against HEAD --no-times
row worse "slab/creep#digits: creep"
says "again: ./stiction validate --case 'slab/creep'" '--all (here: --verbose)'
present 40 1000 1e-9 5 pass -O3
holds 1 "a speed-up that costs a digit is worse" --against HEAD --report-improvement
present 50 1000 1e-9 6 fail -O3
holds 1 "a check that fails is worse" --against HEAD --no-times
row worse "slab/creep#verdict: creep"
present 50 1010 1e-9 6 pass -O3
holds 1 "1 % more contact updates and instructions are worse" --against HEAD --no-times
row worse "$friction#instructions" && row worse "$friction#contact updates"
present 50 1000 1e-8 6 pass -O3
holds 1 "a workload that is less accurate is worse" --against HEAD --no-times
row worse "$friction#digits: error"
present 50 1000 1e-9 6 pass -O0
refuses "other flags are refused" "flags: -O3 / -O0" --against HEAD --no-times
refuses "of benchmarks alone too" "flags: -O3 / -O0" --against HEAD --no-times --no-accuracy
holds 0 "unless asked for" --against HEAD --no-times --any-machine
sed -i 's/--machine)/--no-machine)/' bench.sh && present 50 1000 1e-9 6 pass -O0
refuses "a bench that does not tell leaves it to the cases" "flags: -O3 / -O0" \
  --against HEAD --no-times --no-accuracy
git checkout -q bench.sh

# ---- output -------------------------------------------------------------------------------------
present 50 1000 1e-9 5 pass -O3
holds 1 "--verbose tells what did not change too" --against HEAD --no-times --verbose
row same "$friction#instructions"
holds 1 "--json" --against HEAD --no-times --json
says '"worse": 1' '"metric": "slab/creep#digits: creep"' '"direction": "higher is better"' \
  '"before": 6.0' '"after": 5.0' '"change": "worse"'
holds 1 "--markdown" --against HEAD --no-times --markdown
says '| worse | `slab/creep#digits: creep` | 6.00 digits | 5.00 digits | -1.00 digits | higher |'

# ---- what cannot be measured --------------------------------------------------------------------
refuses "an unknown revision" "git knows no revision 'nonsense'" --against nonsense
env PATH=/nowhere "$build/track" --against HEAD 2>"$work/err" && failed "without git" "exit code 0"
grep -qF 'git is missing' "$work/err" || failed "without git" "$(cat "$work/err")"
refuses "no such benchmark" "no benchmark of this name" --against HEAD --benchmark nonsense
refuses "none to record" "no benchmark of this name" record --benchmark nonsense --history n.sqlite
refuses "nothing to measure" "there is nothing to measure" \
  --against HEAD --no-times --no-counts --no-accuracy
present 50 1000 1e-9 6 pass -O3
sed -i 's/--list-fixed)/--list-none)/' bench.sh && commit "old bench" && git tag old
git checkout -q HEAD~1 -- . && commit "new bench"
refuses "a revision whose bench has no --list-fixed" "cannot be measured: its bench" --against old
printf 'broken\n' >CMakeLists.txt && commit broken && git tag broken
git checkout -q HEAD~1 -- . && commit repaired
refuses "a revision that cannot be built" "broken cannot be configured" --against broken
cd "$work" && refuses "no clone" "is in no clone" --against HEAD
cd project || exit 1
refuses "no build" "is not built" --build "$work" --against HEAD
holds 2 "no command" && holds 2 "an unknown option" --bogus
holds 2 "too few rounds" --against HEAD --rounds 3

# ---- bisect -------------------------------------------------------------------------------------
good=$(git rev-parse HEAD)
for k in 1 2 3; do printf '%s\n' "$k" >note && commit "note $k"; done
printf '# 6 pass -O3\n# 4 pass -O3\n' >validate.numbers && commit "costs two digits"
printf '# 50 1200 1e-9 -O3\n' >bench.numbers && commit "costs instructions"
for k in 4 5; do printf '%s\n' "$k" >note && commit "note $k"; done
holds 1 "bisect finds the revision that cost digits" \
  bisect --metric 'slab/creep#digits: creep' --good "$good"
says "costs two digits"
holds 1 "bisect finds the revision that cost instructions" \
  bisect --metric "$friction#instructions" --good "$good" --bad HEAD
says "costs instructions: 100 → 120"
holds 0 "bisect tells what did not move" bisect --metric "$friction#allocations" --good "$good"
says "did not move"
refuses "the wrong way round" "does not come before" \
  bisect --metric "$friction#time" --good HEAD --bad "$good"
# unknown METRIC WORDS …: it is refused before anything is built, and these metrics are listed.
unknown() {
  local metric=$1 words
  shift
  rm -rf build/track/*/build
  holds 2 "an unknown metric: $metric" bisect --metric "$metric" --good "$good"
  grep -qF "there is no metric '$metric'; there are:" "$work/err" || failed "$last" "it does not say so"
  for words in "$@"; do
    grep -qF -- "$words" "$work/err" || failed "$last" "it lists no $words"
  done
  [ -z "$(find build/track -name bench)" ] || failed "$last" "a revision was built"
}
unknown "$friction#colour" "  $friction#time" "  $friction#instructions" "  $friction#digits: error"
unknown 'slab/creep#digits: crep' "  slab/creep#digits: creep" "  slab/creep#verdict"
unknown 'friction:none/slab/contacts:7#time' "  $friction#WHAT, WHAT being time, instructions" "CASE#digits: CHECK"
holds 0 "a metric that only the history knows" record --no-times --history known.sqlite
sql known.sqlite "INSERT INTO metric (name, subject, what, unit, kind, direction) VALUES ('$friction#colour', '', '', '', '', '')"
refuses "… is looked for" "'$friction#colour' is not measured by" \
  bisect --metric "$friction#colour" --good "$good" --history known.sqlite
refuses "no name of a metric" "is no metric: its name is SUBJECT#WHAT" bisect --metric time --good "$good"

# ---- folders of other revisions -------------------------------------------------------------------
commit "a revision of its own"
tree=build/track/$(git rev-parse HEAD | cut -c1-12)
branch=$(git symbolic-ref HEAD)
# unharmed: the person's clone stands where it stood, with what it had.
unharmed() {
  [ "$(git symbolic-ref HEAD)" = "$branch" ] || failed "$last" "the clone's own branch was left"
  [ "$(cat note)" = mine ] || failed "$last" "a change of the clone's own is lost"
}
printf 'mine' >note
anew=(--against HEAD --no-times --no-accuracy)
holds 0 "a revision is built" "${anew[@]}"
rm "$tree/.git"
holds 0 "one that lost its .git is made anew" "${anew[@]}" && unharmed
[ -f "$tree/.git" ] || failed "$last" "it was not"
rm "$tree/.git" && mkdir "$tree/.git"
holds 0 "one whose .git is empty" "${anew[@]}" && unharmed
[ -f "$tree/.git" ] || failed "$last" "it is so still"
printf 'gitdir: /nowhere\n' >"$tree/.git"
holds 0 "one whose .git leads nowhere" "${anew[@]}" && unharmed
rm -rf ".git/worktrees/$(basename "$tree")"
holds 0 "one that git has forgotten" "${anew[@]}" && unharmed
GIT_DIR=$PWD/.git GIT_WORK_TREE=$PWD holds 0 "from a hook of git" "${anew[@]}" && unharmed
git worktree add -q --detach "$work/mine" && mv "$work/mine" "$work/away"
git worktree add -q --detach build/track/0123456789ab && rm -r build/track/0123456789ab
holds 0 "entries of worktrees whose folder is gone" "${anew[@]}" && unharmed
git worktree list | grep -q "^$work/mine " || failed "$last" "a person's was removed"
git worktree list | grep -q 0123456789ab && failed "$last" "track's own was left"
mv "$work/away" "$work/mine" && git -C "$work/mine" status >/dev/null || failed "$last" "a person's is broken"
STICTION_TEST_HOOK="touch $work/started; sleep 2" "$build/track" "${anew[@]}" >/dev/null 2>&1 &
first=$!
until [ -e "$work/started" ]; do sleep 0.05; done
refuses "two at once" "another ./stiction track is at work in $PWD/build/track" "${anew[@]}"
refuses "a record beside it" "another ./stiction track is at work" record --history n.sqlite
{ kill -KILL "$first" && wait "$first"; } 2>/dev/null
holds 0 "once the first has ended, however that was" "${anew[@]}"
git checkout -q note

# ---- signals --------------------------------------------------------------------------------------
mkdir "$work/tmp" && rm -f "$work/started"
TMPDIR=$work/tmp STICTION_TEST_HOOK="case \$1 in --benchmark*) touch $work/started; sleep 61.5;; esac" \
  env --default-signal=INT "$build/track" record --no-counts --no-accuracy --history n.sqlite >"$work/out" 2>"$work/err" &
last="interrupted while it times"
until [ -e "$work/started" ]; do sleep 0.05; done
[ -n "$(ls "$work/tmp")" ] || failed "$last" "it has no temporary folder yet"
kill -INT $!
wait $!
[ $? -eq 130 ] || failed "$last" "its exit code is not 130"
grep -q 'stiction track: interrupted; nothing of it is in the history' "$work/err" || failed "$last" "it does not say so"
[ -z "$(ls "$work/tmp")" ] || failed "$last" "it left a temporary folder"
! pgrep -f "sleep 61.5" >/dev/null || failed "$last" "what it started runs on"
printf 'ok    %s\n' "$last"

# ---- a history that cannot be written -----------------------------------------------------------
# measured: whether a program was run since the last call.
export STICTION_TEST_CALLS=$work/calls
measured() { [ -s "$work/calls" ] && rm "$work/calls"; }
sql other.sqlite 'CREATE TABLE notes (text)' && cp other.sqlite kept.sqlite
printf '{"benchmarks": [{"name": "BM_x", "cpu_time": 5}]}' >given.json
for command in record history 'compare 1' 'export e.json' 'import given.json' '--against HEAD'; do
  # shellcheck disable=SC2086 # words
  refuses "another program's file: $command" "is another program's SQLite file" $command --history other.sqlite
  cmp -s other.sqlite kept.sqlite || failed "$last" "it was written to"
done
for command in history 'compare 1' 'export e.json'; do
  # shellcheck disable=SC2086
  refuses "a misspelt file: $command" "there is no such file" $command --history none/misspelt.sqlite
  [ ! -e none ] && [ ! -e e.json ] || failed "$last" "it was made"
done
holds 0 "record" record --no-times --history lost.sqlite
measured || failed "$last" "nothing was measured"
python3 -c 'import sqlite3, sys, time
base = sqlite3.connect(sys.argv[1], isolation_level=None)
base.execute("BEGIN EXCLUSIVE")
print("held", flush=True)
time.sleep(60)' lost.sqlite >"$work/held" &
holder=$!
until [ -s "$work/held" ]; do sleep 0.05; done
refuses "a locked history" "is locked: another program is writing to it" --against HEAD --history lost.sqlite
refuses "a locked history to record in" "is locked" record --history lost.sqlite
! measured || failed "$last" "something was measured before"
kill "$holder" && wait "$holder" 2>/dev/null
present 50 1000 1e-9 5 pass -O3
# The stand-in's own hook: what somebody does to the file in the middle of it.
export STICTION_TEST_HOOK="printf x >$PWD/lost.sqlite"
refuses "a history that breaks while it is measured" "is not in the history: lost.sqlite: file is not a database" \
  --against HEAD --no-times --history lost.sqlite
says "3 better" 'better slab/creep#digits: creep'
unset STICTION_TEST_HOOK
again=$(sed -n "s/.*by .\/stiction track import '\([^']*\)'.*/\1/p" "$work/err")
holds 0 "what it lost can be added later" import "$again" --history found.sqlite
rm lost.sqlite
export STICTION_TEST_HOOK="rm -rf $PWD/lost.sqlite && mkdir -p $PWD/lost.sqlite"
refuses "a record that cannot be kept" "is not in the history: lost.sqlite" record --no-times --history lost.sqlite
unset STICTION_TEST_HOOK && rm -r lost.sqlite
present 50 1000 1e-9 6 pass -O3

# ---- history ------------------------------------------------------------------------------------
holds 0 "record" record --history h.sqlite && holds 0 "record again" record --history h.sqlite
holds 0 "history" history --history h.sqlite --metric '*#time' --out trends
says "Machine: Example CPU, 2 cores, GCC 12, -O3" "$friction#time [s]"
[ "$(grep -c '"name":"time"' trends/latest/records.jsonl)" -eq 1 ] || failed history "no trend"
holds 0 "compare two runs" compare 1 2 --history h.sqlite
holds 0 "export" export e.json --history h.sqlite --run 1
holds 0 "import what was exported" import e.json --history h.sqlite
holds 0 "compare it with where it came from" compare 1 3 --history h.sqlite
says "nothing is worse, 0 better, of 9 metrics"
holds 0 "export what was imported" export e3.json --history h.sqlite --run 3
cmp -s e.json e3.json || failed "$last" "it differs from what was imported"
holds 0 "record without times" record --no-times --history n.sqlite
holds 0 "export it" export n.json --history n.sqlite
holds 0 "import it" import n.json --history n.sqlite
holds 0 "import a file of another program" import - --history h.sqlite <<'JSON'
{"context": {"num_cpus": 8, "date": "2026-01-01"}, "benchmarks": [
 {"name": "BM_x", "run_type": "iteration", "cpu_time": 5, "time_unit": "us"},
 {"name": "BM_x_mean", "run_type": "aggregate", "cpu_time": 5, "time_unit": "us"}]}
JSON
refuses "runs of different machines" "are of different machines" compare 1 4 --history h.sqlite
holds 0 "unless asked for" compare 1 4 --history h.sqlite --any-machine
holds 0 "of other machines the history tells" history --history h.sqlite
says "3 runs of other machines are left out"
refuses "no such run" "has no run 99" compare 1 99 --history h.sqlite
refuses "no such metric" "has no metric 'x'" history --metric x --history h.sqlite
printf 'no json' >bad.json
refuses "a file of something else" "is not Google Benchmark's JSON" import bad.json --history h.sqlite
refuses "a missing file" "cannot read missing.json" import missing.json --history h.sqlite
refuses "a file that is no history" "bad.json" history --history bad.json
