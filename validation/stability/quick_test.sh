#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The quick part of the suite of stability holds, is a part of each kind, can fail, and gives the same
# states however many cases run at a time: quick_test.sh BUILD_DIR
# Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: quick_test.sh BUILD_DIR}" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# shellcheck source=validation/end_to_end.sh
source "$here/../end_to_end.sh"

holds 0 "the quick part of the suite passes" \
  "$build/validate" --suite stability --quick --jobs 2 --no-page --out quick
for kind in perturbed ladder gauntlet; do
  grep -q "\"case\":\"$kind/" quick/latest/records.jsonl || failed "the quick part" "nothing of $kind/ is in it"
done
passed "something of perturbed/, of ladder/ and of gauntlet/ is in it"

# What the ingredients of a method do is no matter of luck: with the slip of one moment in the worst pose these
# two turned claims red.
for change in ulp/1 mirrored; do
  holds 0 "what each ingredient does is claimed of no one seed: $change" \
    "$build/validate" --case slab/ablation --perturb "$change" --no-page --out luck
done

# Some of it again, one at a time. (mutants_test.sh has the planted faults that the suite finds.)
again=(--case 'gauntlet/*/thrown' --case gauntlet/cliff/falls --case 'ladder/cone/load=0.9' --case 'ladder/overlap/share=0.01'
       --case 'perturbed/half-space/free-fall' --case 'perturbed/paper/appendix-a-momentum/crossed-bars')
holds 1 "the same fails where the reaction of crossing edges is 2 % too small" \
  "$build/validate_edge_reaction" "${again[@]}" --no-page --out faulty
exits 0 "one at a time" "$build/validate" "${again[@]}" --jobs 1 --no-page --out one
state_hashes one | cut -d' ' -f1 >cases
state_hashes one >out
state_hashes quick | grep -wFf cases >err
[ "$(wc -l <out)" -ge 7 ] || failed "state hashes" "too few records to tell"
cmp -s out err || failed "state hashes" "--jobs 1 and --jobs 2 differ, or not all of these are in the quick part"
passed "the same $(wc -l <out) state hashes with --jobs 1 and --jobs 2"
