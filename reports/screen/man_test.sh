#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every program's page tells every option that its source defines, has every section, fits 80 columns,
# and is a manual page that `man` reads: man_test.sh BUILD_DIR
set -uo pipefail
build=$(cd "${1:?usage: man_test.sh BUILD_DIR}" && pwd)
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed() {
  printf 'FAIL  %s\n' "$*"
  exit 1
}

# has PAGE… SOURCE: each long option that the source defines stands in one of the pages.
has() {
  local source=${!#} option pages=("${@:1:$#-1}")
  # An option's words follow add_option( or add_flag( ; those of group "" are not for people.
  tr '\n' ' ' <"$root/$source" | grep -oE 'add_(option|flag)\( *"[^"]*"' | grep -oE '\-\-[a-z_-]+' |
    sort -u >"$work/options"
  [ -s "$work/options" ] || failed "$source defines no option"
  sed 's/\\-/-/g' "${pages[@]}" >"$work/pages" || failed "pages are missing"
  while read -r option; do
    [ "$option" != --root ] || continue
    grep -qE -- "(^|[ B,])$option([ ,\\]|$)" "$work/pages" ||
      failed "$option of $source stands in none of: ${pages[*]##*/}"
  done <"$work/options"
  printf 'ok    %s: %s options\n' "$source" "$(wc -l <"$work/options")"
}
man=$build/man
has "$man/stiction-validate.1" validation/validate.cpp
has "$man"/stiction-compare{,-engines}.1 validation/compare.cpp
has "$man"/stiction-engine{,-check,-list,-show}.1 validation/engine_main.cpp
has "$man"/stiction-{validate,sweep,compare-engines,engine-check}.1 validation/core/engine_options.h
has "$man"/stiction-sweep.1 validation/sweep.cpp
has "$man/stiction-bench.1" benchmarks/bench/bench.cpp
has "$man"/stiction-track*.1 benchmarks/track.cpp
has "$man/stiction-readme.1" reports/readme.cpp

for page in "$man"/*.1; do
  name=$(basename "$page" .1)
  sections=(NAME SYNOPSIS DESCRIPTION '"EXIT STATUS"' EXAMPLES '"SEE ALSO"')
  for section in "${sections[@]}"; do
    grep -qxF ".SH $section" "$page" || failed "$name has no section $section"
  done
  examples=$(sed -n '/^.SH EXAMPLES/,/^.fi/p' "$page" | grep -cE '^(\\&)?(\./stiction|[a-z_]+ .*\| \./stiction)')
  [ "$examples" -ge 3 ] || failed "$name has $examples examples, not 3"
  grep -qE "^${name//-/.-} .- " "$page" || failed "$name: its NAME is not whatis's"
done
printf 'ok    %s pages have their sections\n' "$(find "$man" -name '*.1' | wc -l)"

for program in validate compare sweep merge bench track engine readme; do
  COLUMNS=80 "$build/$program" --help >"$work/help" || failed "$program --help"
  [ "$(awk '{ if (length($0) > 80) print }' "$work/help" | grep -cvE '^ +(\./stiction|[a-z-]+/)')" -eq 0 ] ||
    failed "$program --help is wider than 80 columns: $(awk 'length($0) > 80' "$work/help" | head -n 1)"
done
printf 'ok    help fits 80 columns\n'

if command -v man >/dev/null && command -v groff >/dev/null; then
  for page in "$man"/*.1; do
    LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" >/dev/null 2>"$work/said"
    [ ! -s "$work/said" ] || failed "${page##*/}: $(head -n 1 "$work/said")"
  done
  printf 'ok    man reads them without a warning\n'
fi
