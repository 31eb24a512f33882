#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The same states to the last bit on each machine: hash_test.sh BUILD_DIR
# Another machine is made of this one: a C library that is kept from the processor's fused products.
# (Threads: validate_test.sh, stability/quick_test.sh.)
# Prints one line a check; ends with exit code 1 at the first that fails, with 77 where the processor
# lacks what there is to try.
set -uo pipefail

build=$(cd "${1:?usage: hash_test.sh BUILD_DIR}" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# shellcheck source=validation/end_to_end.sh
source "$here/end_to_end.sh"

untried=0
has() { # has FEATURE WHAT: or says what is not tried
  grep -qw "$1" /proc/cpuinfo && return
  untried=1
  printf 'NOT TRIED, for this processor has no %s: %s\n' "$1" "$2"
  return 1
}

run() { # run FOLDER COMMAND …: hashes of the quick set, and of contacts between bodies, in FOLDER.txt
  local folder=$1
  shift
  exits 0 "$folder" "$@" --quick --no-page --out "$folder"
  state_hashes "$folder" >"$folder.txt"
  exits 0 "$folder" "$@" --case 'gauntlet/*/thrown' --case 'ladder/cone/load=0.9' \
    --case 'perturbed/paper/appendix-a-momentum/crossed-bars' --no-page --out "$folder-pairs"
  state_hashes "$folder-pairs" >>"$folder.txt"
  grep -qvE ' [0-9a-f]{16}$' "$folder.txt" && failed "$folder" "a record has no state hash"
  [ "$(wc -l <"$folder.txt")" -ge 20 ] || failed "$folder" "too few records to tell"
}

same() { # same FOLDER WHAT
  cp here.txt out
  cp "$1.txt" err
  cmp -s out err || failed "$2" "its states differ from those of the usual build in: $(diff out err | grep '^>' | cut -c3-90)"
  passed "$2: the same $(wc -l <out) state hashes"
}

run here "$build/validate"

# That a hash tells.
exits 0 "another time step" "$build/validate" --case 'gauntlet/spike-on-spike/thrown' --set dt=1e-5 --no-page --out other
other=$(state_hashes other | grep -oE '[0-9a-f]{16}$') || failed "another time step" "the record has no state hash"
! grep -q "$other" here.txt || failed "another time step" "the same state hash"
passed "another time step: another state hash"

# Registers of each width that this processor has.
widths="2$(grep -qw avx2 /proc/cpuinfo && echo " 4")$(grep -qw avx512vl /proc/cpuinfo && echo " 8")"
for width in $widths; do
  run "width-$width" env STICTION_WIDTH="$width" "$build/validate"
  same "width-$width" "registers of $width doubles"
done
exits 2 "registers of 3 doubles" env STICTION_WIDTH=3 "$build/validate" --case 'gauntlet/spike-on-spike/thrown' --no-page --out three
grep -q "STICTION_WIDTH is '3', but this processor's registers hold ${widths// /, } doubles" err \
  || failed "registers of 3 doubles" "no sentence that says so"
passed "registers of 3 doubles: refused in one sentence"

# Threads inside a step; scenes large enough to be shared are solver/step_threads_test.cpp's.
run threads "$build/validate" --threads 2
same threads "two threads inside a step"
exits 2 "no threads" env STICTION_THREADS=0 "$build/validate" --case 'gauntlet/spike-on-spike/thrown' --no-page --out none
grep -q "STICTION_THREADS is '0', but a step has 1 to [0-9]* threads" err || failed "no threads" "no sentence that says so"
passed "no threads: refused in one sentence"

# Where the C library does use fused products its last digits tell, as those of Python's functions do.
plain="a C library without fused products"
without=(env GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable)
digits() { "$@" python3 -c 'import math; print([math.exp(-k / 100) + math.pow(1.1, k / 10) + math.sin(k / 10) for k in range(2000)])'; }
if has fma "$plain"; then
  [ "$(digits env)" != "$(digits "${without[@]}")" ] || failed "$plain" "GLIBC_TUNABLES does not take them away"
  run plain "${without[@]}" "$build/validate"
  same plain "$plain"
fi
[ "$untried" -eq 0 ] || exit 77
