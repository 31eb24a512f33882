#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Stands for `bench` in track's own tests: the same interface, made-up numbers. Its last line, added
# when it is "built", holds the time per contact in ns, the contact updates of a batch, the error, and
# the build flags that it tells.
set -euo pipefail
read -r _ nanoseconds updates error flags < <(tail -n 1 "$0")
[ -z "${STICTION_RUN_FILE:-}" ] || exit 9 # it would be told of a run that is nobody's
# Told that it was called, and what shall happen meanwhile.
[ -z "${STICTION_TEST_CALLS:-}" ] || printf '%s\n' "$1" >>"$STICTION_TEST_CALLS"
eval "${STICTION_TEST_HOOK:-}"
name=friction:fixed-point/slab/contacts:1000
case $1 in
  --list-fixed) echo $name ;;
  --machine) printf '{"machine":"Example CPU, 2 cores","toolchain":"GCC 12, %s"}\n' "$flags" ;;
  --fixed)
    printf '{"name":"%s","batches":%d,"contacts":1000,"contact_updates":%d,"allocations":0,' \
      "$2" "$4" $((updates * $4))
    printf '"hash":7,"error":%s}\n' "$error"
    ;;
  *)
    for word in "$@"; do
      case $word in --benchmark_out=*) out=${word#*=} ;; esac
    done
    # ± 1 % of noise, as a small shared machine has it.
    awk -v ns="$nanoseconds" -v name="$name" -v seed="$RANDOM" 'BEGIN {
      srand(seed)
      for (k = 0; k < 5; ++k) {
        time = ns * (0.99 + 0.02 * rand()) * 1e-9
        line = line sprintf("%s{\"name\":\"%s\",\"run_name\":\"%s\",\"run_type\":\"iteration\"," \
          "\"cpu_time\":1,\"time_unit\":\"ns\",\"time_per_contact\":%.6g}", k ? "," : "", name, name, time)
      }
      printf "{\"context\":{},\"benchmarks\":[%s]}\n", line
    }' >"$out"
    ;;
esac
exit 0
