#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The proof that cases of contact between bodies bite: mutants_test.sh BUILD_DIR
# Each planted fault (CMakeLists.txt) turns a named check of a named method red that the correct program
# doesn't. Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: mutants_test.sh BUILD_DIR}" && pwd)
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/end_to_end.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# shellcheck source=validation/end_to_end.sh
source "$checks"
# Without --set, because bands of what is expected to fall short hold for a case's own variants only.
# shellcheck source=validation/mutants.sh
source "$(dirname "$checks")/mutants.sh"

boxes=paper/appendix-a-momentum/two-boxes
bars=paper/appendix-a-momentum/crossed-bars
rest=slab/rest/one
kappa=slab/kappa
again=slab/convergence/half-step
drift=slab/rest/drift

run validate correct "$boxes" "$bars" "$rest" "$kappa" "$again" "$drift"

mutant friction_scaled "$boxes" "$bars"
for method in quiet paper; do bites "$boxes" $method 'largest friction over normal force'; done
bites "$bars" quiet 'largest friction over normal force'

mutant friction_sign "$boxes" "$bars"
for method in quiet paper; do bites "$boxes" $method 'friction work, if above 0'; done
bites "$bars" quiet 'friction work, if above 0'

mutant gain_reversed "$boxes" "$rest" "$drift"
bites "$boxes" quiet 'friction work, if above 0'
bites "$rest" quiet 'share of configurations at rest'
bites "$drift" paper 'drift over 10 s'

# A case that forgets friction on purpose finds no slip where a method remembers what it should not.
# (stale_memory is the paper's other reading, memory=keep: validate_test.sh, on half-spaces.)
mutant stale_pair_memory "$rest" "$again"
bites "$rest" quiet 'fastest contact slip'
bites "$again" 'quiet rule=stored-vector' error

for mutation in friction_reaction normal_reaction weight_sum; do
  mutant $mutation "$boxes"
  for method in quiet paper; do bites "$boxes" $method 'linear momentum, largest change'; done
done

mutant lever_arm "$boxes" # the paper's weights have an arm, which its audit counts
bites "$boxes" quiet 'angular momentum, largest change in a step'

mutant half_left_out "$rest" "$kappa" # the ½ is the paper's alone
bites "$rest" paper 'kinetic energy'
bites "$kappa" paper 'largest κ above its bound'

mutant load_uncounted "$rest" "$kappa"
for method in quiet paper; do bites "$kappa" $method 'largest κ above its bound'; done
bites "$rest" paper 'kinetic energy'

mutant lost_contact "$rest" "$kappa"
bites "$rest" quiet 'fastest contact slip'
for method in quiet paper; do
  bites "$kappa" $method 'vertices inside the other body without a contact'
done

mutant depth_flipped "$boxes"
for method in quiet paper; do bites "$boxes" $method error; done

mutant edge_reaction "$bars" # only quiet has contacts of crossing edges
bites "$bars" quiet 'linear momentum, largest change'

# ---- no fault of the build is left out ----------------------------------------------------------
here=$(dirname "$checks")
rest=$(untried "$here/mutants_test.sh" "$here/validate_test.sh" "$here/stability/mutants_test.sh")
[ -z "$rest" ] || failed "planted faults" "nothing tries: $rest"
passed "every planted fault of the build is tried, here, in validate_test.sh or in stability/mutants_test.sh"
