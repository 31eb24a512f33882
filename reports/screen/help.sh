# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Pages of help of ./stiction, which sources this. None of them installs anything.

usage() {
  cat <<'TXT'
NAME
       stiction - does your contact solver hold, or does it creep?

SYNOPSIS
       ./stiction [--yes] COMMAND [OPTIONS]

DESCRIPTION
       Measures static friction: every figure comes with its error, its cost and
       its source. The first call installs what is missing (Debian packages) and
       builds; later calls only rebuild what changed.

       Validate
         validate              cases with known answers; a report
         validate my.toml      problems of your own
         validate --suite stability
                               hard cases: digits that survive, where it breaks
         compare               friction rules side by side: speed against error
         compare engines       engines side by side: who holds, who creeps
         sweep study.toml      thousands of points: parameters and engines; goes on
                               where it was, in parts on several machines
         merge DIR...          parts of a run (--shard 1/8 ...) as the whole

       Engines
         engine list | show | check
                               what there is; whether an adapter speaks right

       Cost
         bench                 what a contact costs, and how that grows
         track --against REF   what a change made slower, or less accurate

       Documents
         report RUN...         one HTML page of runs
         readme                the measured figures of README and documents

       Development
         test                  unit tests, planted faults, programs end to end
         help [COMMAND]        this text, or a command's manual page

OPTIONS
       --yes  Install missing packages with sudo without asking; stands before
              the command.

EXIT STATUS
       0      what was asked holds
       1      something does not
       2      it could not run: bad input, missing packages, a failed build
       130    interrupted by Ctrl-C (143: by SIGTERM); what was finished is kept

FILES
       build/ builds: release/ of the programs, web/ of the page

EXAMPLES
       ./stiction validate
              who holds, who creeps, how accurately, at what cost
       ./stiction compare --quick
              which iteration finds static friction
       ./stiction help compare
              the manual page of a command

SEE ALSO
       README.md, validation/user/TUTORIAL.md (eleven minutes: your own ramp,
       push, mesh, engine and friction rule)
TXT
}

test_usage() {
  cat <<'TXT'
NAME
       stiction-test - unit tests, planted faults, the programs end to end

SYNOPSIS
       ./stiction test [CTEST OPTIONS]

DESCRIPTION
       Builds everything and runs every test with ctest: units, variants of the
       programs with planted faults that cases must catch, and the programs as a
       person calls them. What stands behind it is given to ctest.

EXIT STATUS
       0      all pass
       2      the build failed, or packages are missing
       other  ctest's: some fail

FILES
       build/release/Testing/Temporary/LastTest.log
              what each test printed

EXAMPLES
       ./stiction test
              everything, four to eight minutes; some forty with the first build
       ./stiction test -R '^solver\.'
              the solver's unit tests
       ./stiction test --rerun-failed
              what failed the last time

SEE ALSO
       ./stiction help validate, CONTRIBUTING.md, ctest(1)
TXT
}

# Of the page's program, whether there is a node to run it or not.
report_usage() { sed -n '/^export const USAGE = `/,/^`;$/{s/^export const USAGE = `//;/^`;$/d;p}' "$root/reports/web/make/arguments.mjs"; }

# page COMMAND …: its manual page on a terminal that has man, else the text.
page() {
  local text
  text=$(COLUMNS=${COLUMNS:-80} "$@" --help)
  if [ -t 1 ] && [ "${TERM:-dumb}" != dumb ] && [ -z "${NO_COLOR:-}" ] && command -v man >/dev/null && command -v groff >/dev/null; then
    "$root/reports/screen/man_page" "$(sed -n 's/^project(stiction VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")" \
      <<<"$text" | LC_ALL=C.UTF-8 man -E UTF-8 -l -
  else
    show printf '%s\n' "$text"
  fi
}

# Whether one of the words asks for the page.
asks_for_help() {
  local word
  for word in "$@"; do
    case $word in -h | --help) return 0 ;; esac
  done
  return 1
}

# program_with_page NAME: it prints its page itself, so it is built where it has not been yet; packages
# are not installed for that.
program_with_page() {
  [ ! -x "$build/$1" ] || return 0
  local missing
  missing=$(missing_of "${packages[@]}")
  if [ -n "$missing" ]; then
    say "the page of $1 is printed by its program, to build which packages are missing: sudo apt-get install -y --no-install-recommends $missing"
    exit 2
  fi
  build "$1"
}

help_on() {
  case "${1:-}" in
    '' | help | -h | --help) show usage ;;
    test) page "$root/stiction" test ;;
    report) page "$root/stiction" report ;;
    validate | compare | sweep | merge | engine | bench | track | readme)
      program_with_page "$1"
      page "$build/$1" "${@:2}"
      ;;
    *)
      say "there is no command '$1'; ./stiction help lists them"
      exit 2
      ;;
  esac
}
