#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# End-to-end test of the program readme: readme_test.sh BUILD_DIR
# Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: readme_test.sh BUILD_DIR}" && pwd)
readme=$build/readme
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/validation/end_to_end.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
# shellcheck source=validation/end_to_end.sh
source "$checks"

# record CASE QUANTITY VALUE VERDICT: a line of records.jsonl.
record() {
  printf '{"schema_version":2,"case":"%s","settings":{"method":"quiet"},"verdict":"%s","checks":[{"quantity":"%s","unit":"m","claim":"","source":"","kind":"analytic","value":%s,"expected":0,"error":0,"relative":false,"scale":1,"tolerance":0,"reason":"","digits":0,"verdict":"%s"}],"cost":{"cpu_seconds":0,"steps":0,"contact_updates":0,"ns_per_contact_update":0,"phase_seconds":{}},"environment":{"revision":"abc","toolchain":"g++","machine":"Example CPU","date":"2026-01-01"},"engine":"stiction"}\n' \
    "$1" "$4" "$2" "$3" "$4"
}

folder=tree/reports/documents
mkdir -p $folder/figures $folder/tables run other renamed elsewhere finer
cat >$folder/figures/validate.toml <<'TOML'
[figure.drift]
case = "slab/rest"
quantity = "drift"
TOML
printf '| drift, m |\n| --- |\n| {{drift}} |\n' >$folder/tables/drifts.md
printf '<!-- table: drifts -->\n<!-- /table -->\nIt drifts <!-- v:drift --><!-- /v --> m.\n' >tree/README.md
record slab/rest drift 3.2e-7 pass >run/records.jsonl
record slab/rest drift 5e-3 pass >other/records.jsonl
record slab/rest way 3.2e-7 pass >renamed/records.jsonl
record slab/kappa drift 3.2e-7 pass >elsewhere/records.jsonl

refuses "no figures yet" "validate.json is missing" "$readme" --root tree
holds 0 "figures from a run" "$readme" --root tree --update run
grep -qF '| 3e-7 |' tree/README.md || failed "figures from a run" "the table was not written"
grep -qF 'drifts <!-- v:drift -->3e-7<!-- /v --> m' tree/README.md ||
  failed "figures from a run" "the figure in the text was not written"
holds 0 "the documents agree with the figures" "$readme" --root tree --check
holds 0 "and with the run" "$readme" --root tree --against run
holds 1 "a run that has left the band" "$readme" --root tree --against other
grep -qF "'drift' is now 0.005" out || failed "a run that has left the band" "stdout doesn't say so"
refuses "a renamed quantity" "validate.toml:1: figure 'drift': the record of 'slab/rest' has no quantity 'drift'" \
  "$readme" --root tree --update renamed
refuses "a missing record" "these runs have none of the documents' figures" "$readme" --root tree --against elsewhere
sed 's/"settings":/"differs":{"finer":"2"},"settings":/' run/records.jsonl >finer/records.jsonl
refuses "a run of finer steps" "was run with --finer, and documents tell of the usual time steps" \
  "$readme" --root tree --against finer
refuses "a run that isn't there" "nowhere" "$readme" --root tree --update nowhere

sed -i 's/3e-7/4e-7/' tree/README.md
holds 1 "a figure changed by hand" "$readme" --root tree --check
grep -qF 'README.md differs' out || failed "a figure changed by hand" "stdout doesn't say so"
holds 0 "and written again" "$readme" --root tree
holds 0 "is as it was" "$readme" --root tree --check
printf '<!-- v:speed --><!-- /v -->\n' >>tree/README.md
refuses "an unknown figure" "README.md:7: there is no figure 'speed'" "$readme" --root tree --check
printf 'nothing\n' >tree/README.md
holds 1 "a figure that no document shows" "$readme" --root tree --check
