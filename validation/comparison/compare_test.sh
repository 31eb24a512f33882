#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# End-to-end test of the program compare: compare_test.sh BUILD_DIR
# Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: compare_test.sh BUILD_DIR}" && pwd)
compare=$build/compare
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/end_to_end.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
# shellcheck source=validation/end_to_end.sh
source "$checks"

# hashes_of RUN CASE RULE METHOD: the state hashes of a rule's readings in a run, whatever the order in
# which they finished.
hashes_of() {
  grep -F "\"case\":\"$2\"" "$1/latest/records.jsonl" | grep -F "\"rule\":\"$3\"" |
    grep -F "\"method\":\"$4\"" | grep -o '"state_hash":"[0-9a-f]*"' | sort
}

holds 0 "a scene is compared" "$compare" --scene rules/slab --out whole --jobs 2 --verbose
for words in '## rules/slab' '| stored-vector, 8 sweeps' '## Findings' 'Fixed point against secant' \
  'comparison.md'; do
  grep -qF -- "$words" out || failed "a scene is compared" "stdout lacks $words"
done
for file in comparison.md report.md records.csv records.jsonl; do
  [ -s "whole/latest/$file" ] || failed "a scene is compared" "$file is missing"
done
passed "its tables, findings and files are there"

holds 0 "a screen tells who wins" env COLUMNS=80 "$compare" --scene rules/slab --contacts quiet --out screen
for words in 'who wins' 'creep, 1 scene' '1e-9 m/s' 'comparison.md' '--verbose'; do
  grep -qF -- "$words" out || failed "a screen tells who wins" "stdout lacks $words"
done
[ "$(wc -l <out)" -le 24 ] || failed "a screen tells who wins" "it has $(wc -l <out) lines"
[ "$(grep -v comparison.md out | LC_ALL=C.UTF-8 wc -L)" -le 80 ] ||
  failed "a screen tells who wins" "a line is wider than 80 columns"
[ ! -s err ] || failed "a screen tells who wins" "there is progress on a pipe"
passed "it fits 80 columns and 24 lines, and a pipe gets no progress"

holds 0 "one rule alone" "$compare" --scene rules/slab --rule secant --contacts quiet --out alone
[ "$(hashes_of alone rules/slab secant quiet | wc -l)" -eq 3 ] ||
  failed "one rule alone" "it has not the hashes of three readings"
[ "$(hashes_of alone rules/slab secant quiet)" = "$(hashes_of whole rules/slab secant quiet)" ] ||
  failed "one rule alone" "its state hash differs from that of the whole scene"
passed "a scene rerun in isolation gives the same hash"

# Work and precision has each chief rule in single precision too: a row with its error and its CPU time, on
# which the page draws a curve.
holds 0 "work in single precision" "$compare" --scene 'work/slab/cells=2/dt=2e-4' --rule fixed-point \
  --contacts quiet --out work --verbose
grep -qE '^\| fixed-point, single precision +\| quiet +\| +[0-9.e+-]+ \| +[0-9.e+-]+ \|' out ||
  failed "work in single precision" "there is no row with an error and a CPU time: $(grep single out)"
for words in 'Work in single precision beside' 'speed ×' 'way slipped ×'; do
  grep -qF -- "$words" out || failed "work in single precision" "stdout lacks $words"
done
passed "its error and speed stand beside double's"

# A person's question: the cheapest setting on the screen and in comparison.md; a step beyond the stable limit
# is refused by the engine, a result and no error, and on no front.
holds 0 "cheapest settings" env COLUMNS=80 "$compare" --scene 'work-precision/acceleration/cells=1/dt=*e-[34]' \
  --contacts quiet --out cheapest
for words in 'acceleration 1e-3' 'quiet' 'Broke, and on no front: acceleration 3 of' 'CPU s/s'; do
  grep -qF -- "$words" out || failed "cheapest settings" "stdout lacks $words"
done
[ "$(grep -v comparison.md out | LC_ALL=C.UTF-8 wc -L)" -le 80 ] ||
  failed "cheapest settings" "a line is wider than 80 columns"
grep -q '^### Front of acceleration: 3 of' cheapest/latest/comparison.md ||
  failed "cheapest settings" "comparison.md has no front"
python3 - cheapest/latest/records.jsonl <<'PY' || failed "cheapest settings" "the records do not tell what it cost"
import json, sys
records = [json.loads(line) for line in open(sys.argv[1])]
refused = [r for r in records if r["case"].endswith("/dt=1e-3")]
ran = [r for r in records if r not in refused]
sys.exit(not (len(refused) == 3 and all("stability limit" in r["failures"][0]["reason"] for r in refused)
              and ran and all(r["cost"]["simulated_seconds"] > 0 and r["cost"]["cpu_seconds"] > 0 for r in ran)))
PY
passed "cheapest settings stand on the screen; what the engine refuses is on no front"

# At each effort at which double stands on a curve, so does single precision.
holds 0 "engines in single precision" env COLUMNS=80 "$compare" engines --quick --engine stiction \
  --engine stiction_single --question accelerates --out engines
for words in 'stiction_single · quiet beside stiction · quiet' 'accelerates' '… effort 2' 'speed' '× '; do
  grep -qF -- "$words" out || failed "engines in single precision" "stdout lacks $words"
done
[ "$(grep -v engines.md out | LC_ALL=C.UTF-8 wc -L)" -le 80 ] ||
  failed "engines in single precision" "a line is wider than 80 columns"
grep -q '^| accelerates | *2 |' engines/latest/engines.md ||
  failed "engines in single precision" "engines.md has no row of each effort"
python3 - engines/latest/records.jsonl <<'PY' || failed "engines in single precision" "the curves differ in length"
import json, sys
records = [json.loads(line) for line in open(sys.argv[1])]
curves = {r["engine"]: r["series"][0]["x"] for r in records if r["case"] == "engines/accelerates"}
sys.exit(len(curves["stiction"]) != 3 or len(curves["stiction_single"]) != 3)
PY
passed "they have a curve of the same efforts, and a table beside double's"

holds 0 "--list" "$compare" --list
for scene in load/lost/cells=2/r=0.35 load/released/cells=3/r=0.1 falling-box/r=0.73 poses/slope=3 rules/slab rules/clamp rules/box-pyramid rules/four-balls rules/membrane rules/basket hard/noise; do
  grep -q "^$scene " out || failed "--list" "it lacks $scene"
done
holds 0 "--help" "$compare" --help
for word in --quick --scene --rule stored-vector conjugate-vector 'EXIT STATUS' EXAMPLES; do
  grep -qF -- "$word" out || failed "--help" "it lacks $word"
done

refuses "an unknown rule" "unknown friction rule 'magic'; there are:" "$compare" --rule magic
refuses "an unknown scene" "no case matches 'rules/mars'" "$compare" --scene rules/mars
refuses "a rule that a scene does not compare" "no comparison has such a rule" \
  "$compare" --scene 'alpha/*' --rule none
refuses "a folder that cannot be made" "Cannot create folder" "$compare" --scene rules/slab --rule none --out /proc/none
