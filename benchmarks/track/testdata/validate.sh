#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Stands for `validate` in track's own tests: one record. Its last line, added when it is "built",
# holds the digits, the verdict and the build flags that it tells.
set -euo pipefail
read -r _ digits verdict flags < <(tail -n 1 "$0")
while [ "$1" != --out ]; do shift; done
mkdir -p "$2/run" && ln -sfn run "$2/latest"
cat >"$2/run/records.jsonl" <<JSON
{"schema_version":2,"case":"slab/creep","engine":"stiction","verdict":"$verdict","checks":[{"quantity":"creep","unit":"m","claim":"","source":"","kind":"analytic","value":1,"expected":1,"error":0,"relative":true,"scale":1,"tolerance":1,"reason":"","digits":$digits,"verdict":"$verdict"}],"cost":{"cpu_seconds":0,"steps":100,"contact_updates":100,"ns_per_contact_update":0},"state_hash":"0123456789abcdef","environment":{"revision":"","toolchain":"GCC 12, $flags","machine":"Example CPU, 2 cores","date":""}}
JSON
exit 0
