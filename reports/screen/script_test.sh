#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What ./stiction does around the programs: help installs nothing, tests are told in short, a signal ends what runs.
# In a tree of stand-ins: script_test.sh
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/tree
mkdir -p "$tree/reports/screen" "$tree/reports/web/make" "$tree/build/release" "$tree/build/web" "$work/bin" "$work/tmp"
cp "$root/stiction" "$root/CMakeLists.txt" "$tree"
cp "$root"/reports/screen/{help.sh,children.sh,man_page,test_lines} "$tree/reports/screen"
cp "$root/reports/web/make/arguments.mjs" "$tree/reports/web/make"
cd "$tree" || exit 1
export PATH=$work/bin:$PATH TMPDIR=$work/tmp TERM=dumb calls=$work/calls

# stand_in FILE: what stands on stdin is a program there, which tells of each call.
stand_in() {
  { printf '#!/usr/bin/env bash\nprintf "%%s\\n" "%s $*" >>"$calls"\n' "$(basename "$1")" && cat; } >"$1"
  chmod +x "$1"
}
# Sleeps as a child of its own would, and ends with what it has written.
export busy='sleep 61.25 & echo $! >>"$calls.busy"; touch "$calls.ready"; wait'

failed() {
  printf 'FAIL  %s\n      %s\n' "$what" "$1"
  tail -n 20 "$work/out" "$work/err" | sed 's/^/      /'
  exit 1
}
# exits CODE WHAT WORD …: of ./stiction.
exits() {
  local code=$1 got
  what=$2
  shift 2
  : >"$calls"
  ./stiction "$@" >"$work/out" 2>"$work/err"
  got=$?
  [ "$got" -eq "$code" ] || failed "exit code $got, not $code, of: ./stiction $*"
  [ -z "$(ls -A "$work/tmp")" ] || failed "temporary files are left: $(ls -A "$work/tmp")"
}
says() { grep -qF -- "$1" "$work/out" "$work/err" || failed "it does not say: $1"; }
called() { grep -q "^$1" "$calls"; }

# ---- help ---------------------------------------------------------------------------------------
for name in apt-get sudo cmake npm; do stand_in "$work/bin/$name" </dev/null; done
stand_in "$work/bin/node" <<<'[ "$1" != --version ] || echo v20.1.0'
stand_in "$work/bin/dpkg-query" </dev/null # nothing is installed
for words in help --help -h '' 'help test' 'test --help' 'report --help' 'report RUN -h' 'help report'; do
  # shellcheck disable=SC2086
  exits 0 "./stiction $words" $words
  grep -q '^NAME' "$work/out" || failed "it is no page"
  grep -q '^SEE ALSO' "$work/out" || failed "the page has no end"
  ! grep -q '`' "$work/out" || failed "it is no text"
  ! grep -qE '^(apt-get|sudo|cmake|npm|node) ' "$calls" || failed "it called $(head -n 1 "$calls")"
done
for command in validate compare sweep bench track engine readme; do
  for words in "$command --help" "$command some -h" "help $command"; do
    # shellcheck disable=SC2086
    exits 2 "./stiction $words, not built" $words
    says "the page of $command is printed by its program, to build which packages are missing: sudo apt-get install"
    ! grep -qE '^(apt-get|sudo|cmake|node) ' "$calls" || failed "it called $(head -n 1 "$calls")"
  done
  stand_in "build/release/$command" <<<'echo page'
  exits 0 "./stiction $command --help, built" "$command" --help
  [ "$(cat "$work/out")" = page ] || failed "it is not the program's page"
  ! grep -qE '^(apt-get|sudo|cmake|node) ' "$calls" || failed "it called $(head -n 1 "$calls")"
done
printf 'ok    help installs nothing\n'

# ---- test ---------------------------------------------------------------------------------------
# From here on everything is installed and built.
stand_in "$work/bin/dpkg-query" <<<'for name in "$@"; do printf "installed %s\n" "$name"; done'
touch build/release/build.ninja
result() { printf '%s/4 Test #%s: %s ....%s    0.5%s sec\n' "$1" "$1" "$2" "$3" "$1"; }
{
  printf 'Test project /tree\n    Start 1: solver.a\n    Start 2: solver.b/0\n'
  result 1 solver.a '   Passed'
  result 2 solver.b/0 '***Failed'
  printf 'one\n\n100%% tests passed, 0 tests failed out of 9\ntwo\xff\n\n    Start 3: reports.c\n'
  result 3 reports.c '   Passed'
  printf '    Start 4: reports.d\n'
  result 4 reports.d '***Timeout '
  printf '\n75%% tests passed, 2 tests failed out of 4\n\nTotal Test time (real) =   1.01 sec\n'
  printf '\nThe following tests FAILED:\n\t  2 - solver.b/0 (Failed)\n'
} >"$work/lines"
stand_in "$work/bin/ctest" <<<"cat '$work/lines'; exit 8"
exits 8 "tests that fail" test -R some
called 'ctest .*--output-on-failure.* -R some$' || failed "ctest is not told the options"
says 'solver.b/0 ....***Failed' && says 'reports.d ....***Timeout' && says '  2 - solver.b/0 (Failed)'
! grep -q 'Passed\|Start' "$work/out" || failed "what passes is told too"
LC_ALL=C grep -zaqP 'Failed    0.52 sec\none\n\n100% tests passed, 0 tests failed out of 9\ntwo\xff\n\n' "$work/out" ||
  failed "the output of what failed is not whole"
grep -qE '^FAIL  solver +2 tests +1\.0 s  1 did not pass$' "$work/out" || failed "no line of the component"
[ "$(tail -n 1 "$work/out")" = '75% tests passed, 2 tests failed out of 4' ] || failed "ctest's line is not the last"
{
  for k in 1 2 3 4; do result "$k" "solver.t$k" '   Passed'; done
  printf '\n100%% tests passed, 0 tests failed out of 4\n\nTotal Test time (real) =   1.01 sec\n'
} >"$work/lines"
stand_in "$work/bin/ctest" <<<"cat '$work/lines'"
exits 0 "tests that pass" test
[ "$(wc -l <"$work/out")" -eq 3 ] || failed "there are not three lines"
[ "$(tail -n 1 "$work/out")" = '100% tests passed, 0 tests failed out of 4' ] || failed "ctest's line is not the last"
exits 0 "tests with all they say" test --verbose
[ "$(grep -c Passed "$work/out")" -eq 4 ] || failed "they do not"
printf 'ok    tests are told in short\n'

# ---- signals ------------------------------------------------------------------------------------
# interrupted SIGNAL NUMBER WHAT WORD …: sends it to the script alone, once a stand-in is busy.
interrupted() {
  local signal=$1 number=$2 code=0 process began
  what="$3, SIG$1"
  shift 3
  rm -f "$calls".*
  env --default-signal=INT ./stiction "$@" >"$work/out" 2>"$work/err" <"$work/lines" &
  until [ -e "$calls.ready" ]; do
    kill -0 $! 2>/dev/null || failed "it ended before"
    sleep 0.02
  done
  began=$SECONDS
  kill -s "$signal" $!
  wait $! || code=$?
  [ $((SECONDS - began)) -le 7 ] || failed "it took $((SECONDS - began)) s to end"
  [ "$code" -eq $((128 + number)) ] || failed "exit code $code, not $((128 + number))"
  while read -r process; do
    # Its end was asked for, and may still be on its way.
    for _ in {1..50}; do
      grep -q sleep "/proc/$process/cmdline" 2>/dev/null || continue 2
      sleep 0.02
    done
    failed "what it started runs on"
  done <"$calls.busy"
  [ -z "$(ls -A "$work/tmp")" ] || failed "temporary files are left: $(ls -A "$work/tmp")"
}
# As the programs do: they end their own children, and say what they have kept.
heeds='for name in INT TERM HUP; do trap "kill \$!; echo kept >&2; exit \$((128 + $(kill -l $name)))" $name; done'
for one in 'INT 2' 'TERM 15' 'HUP 1'; do
  read -r name number <<<"$one"
  stand_in "$work/bin/cmake" <<<"$busy"
  interrupted "$name" "$number" "a build" validate
  interrupted "$name" "$number" "a build of tests" test
  stand_in "$work/bin/cmake" </dev/null
  for command in validate compare sweep bench track engine readme; do
    stand_in "build/release/$command" <<<"$heeds; $busy"
    interrupted "$name" "$number" "$command" "$command" word
    says kept
  done
  stand_in "$work/bin/ctest" <<<"$busy"
  interrupted "$name" "$number" "tests" test
  stand_in build/release/validate <<<'echo "$PWD/run of mine" >"$STICTION_RUN_FILE"; exit 1'
  stand_in "$work/bin/node" <<<'[ "$1" = --version ] && echo v20.1.0 && exit; '"$busy"
  interrupted "$name" "$number" "the page" validate
  says "interrupted; the records are in $tree/run of mine; ./stiction report '$tree/run of mine' makes a page of them"
  stand_in "$work/bin/node" <<<'[ "$1" != --version ] || echo v20.1.0'
done
exits 1 "what is not interrupted" validate
called 'node .*report.mjs .*/run of mine$' || failed "it makes no page"
# Whose parent is gone may wait for as long as one likes until somebody asks after it: here nobody does.
stand_in "$work/bin/cmake" <<<"$busy"
rm -f "$calls".*
what="a build, of which something waits to be asked after"
python3 - "$calls.ready" <<'PYTHON' || failed "it waits for what has ended"
import ctypes, os, subprocess, sys, time
ctypes.CDLL(None).prctl(36, 1)  # PR_SET_CHILD_SUBREAPER: orphans are this process's
script = subprocess.Popen(["./stiction", "validate"], stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
while not os.path.exists(sys.argv[1]):
    time.sleep(0.02)
began = time.monotonic()
script.terminate()
sys.exit(script.wait() != 143 or time.monotonic() - began > 5)
PYTHON
stand_in "$work/bin/cmake" </dev/null
# ---- two at once --------------------------------------------------------------------------------
exec 9>>build/release/stiction.lock && flock 9
stand_in build/release/validate <<<'exit 1'
waits='another ./stiction builds in build/release; this one waits until that is done'
rm -f "$calls".* && : >"$calls"
./stiction validate --no-page >"$work/out" 2>"$work/err" 9>&- &
what="a build while another builds"
until grep -qF "$waits" "$work/err"; do
  kill -0 $! 2>/dev/null || failed "it does not wait"
  sleep 0.02
done
! called 'validate' || failed "it has run before"
exec 9>&-
wait $! && failed "exit code 0"
called 'validate --no-page' || failed "it does not run once the other is done"
[ "$(grep -cF "$waits" "$work/err")" -eq 1 ] || failed "it says so more than once"
stand_in build/release/compare <<<"$heeds; $busy"
rm -f "$calls".* && : >"$calls"
env --default-signal=INT ./stiction compare >"$work/out" 2>"$work/err" &
running=$!
until [ -e "$calls.ready" ]; do sleep 0.02; done
what="a build while another only runs"
./stiction validate --no-page >"$work/out" 2>"$work/err" && failed "exit code 0"
called 'validate --no-page' || failed "it does not run"
! grep -qF "$waits" "$work/err" || failed "it waits"
kill "$running" && wait "$running"
exec 9>>build/release/stiction.lock && flock 9
for one in 'INT 2' 'TERM 15'; do
  read -r name number <<<"$one"
  what="SIG$name while it waits"
  : >"$work/err" # what the last one said is not this one's
  env --default-signal=INT ./stiction validate >"$work/out" 2>"$work/err" 9>&- &
  running=$!
  until grep -qF "$waits" "$work/err"; do sleep 0.02; done
  kill -s "$name" "$running"
  wait "$running"
  got=$?
  [ "$got" -eq $((128 + number)) ] || failed "exit code $got"
  [ -z "$(ls -A "$work/tmp")" ] || failed "temporary files are left"
done
exec 9>&-
printf 'ok    two builds at once wait for each other\n'

stand_in build/release/track <<<'cat'
exits 0 "stdin of a program" track import - < <(echo told)
says told
printf 'ok    a signal ends what runs, and leaves no file\n'
