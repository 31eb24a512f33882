#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What each case costs, as the table case_costs.cpp by which shards are balanced.

case_costs.py RECORDS.jsonl…          prints the table: CPU seconds of a case in a configuration, on average
case_costs.py --check RECORDS.jsonl…  whether the committed table still balances shards of that run
"""
import collections
import json
import pathlib
import re
import sys

TABLE = pathlib.Path(__file__).with_name("case_costs.cpp")
HEAD = """// SPDX-License-Identifier: GPL-3.0-or-later
// Written by case_costs.py from records; not by hand.
#include "validation/shards/job_costs.h"

namespace stiction {

namespace {

constexpr CaseCost kCosts[] = {
    // clang-format off
"""
TAIL = """    // clang-format on
};

}  // namespace

std::span<const CaseCost> case_costs() { return kCosts; }

}  // namespace stiction
"""
ROW = re.compile(r'^    \{"((?:[^"\\]|\\.)*)", "((?:[^"\\]|\\.)*)", ([0-9.e+-]+)\},$', re.M)
SHARDS = 8
# Graham's rule leaves at most 4/3 of the best; costs measured on another machine differ by as much again.
MOST = (4 / 3) ** 2


def costs_of(files):
    """CPU seconds by (case, configuration), the mean of a configuration's variants."""
    sums = collections.defaultdict(list)
    for file in files:
        for line in pathlib.Path(file).read_text().splitlines():
            record = json.loads(line)
            if "job" in record and record["engine"] == "stiction":
                sums[record["case"], record["configuration"]].append(record["cost"]["cpu_seconds"])
    return {key: sum(all_of) / len(all_of) for key, all_of in sums.items()}


def quoted(text):
    return json.dumps(text, ensure_ascii=False)


def table(costs):
    rows = (f"    {{{quoted(case)}, {quoted(name)}, {seconds:.2g}}},\n" for (case, name), seconds in sorted(costs.items()))
    return HEAD + "".join(rows) + TAIL


def heaviest(measured, estimated):
    """The heaviest shard by what was measured, over what it could be at best; shared out by what is estimated."""
    by_case = collections.Counter()
    guess = collections.Counter()
    for (case, name), seconds in measured.items():
        by_case[case] += seconds
        guess[case] += estimated.get((case, name), 0.0)
    loads = [0.0] * SHARDS
    told = [0.0] * SHARDS
    for case, seconds in sorted(guess.items(), key=lambda item: (-item[1], item[0])):
        least = told.index(min(told))
        told[least] += seconds
        loads[least] += by_case[case]
    best = max(sum(loads) / SHARDS, max(by_case.values()))
    return max(loads) / best


def check(files):
    measured = costs_of(files)
    committed = {(case, name): float(seconds) for case, name, seconds in ROW.findall(TABLE.read_text())}
    ratio = heaviest(measured, committed)
    missing = sorted({case for case, _ in measured} - {case for case, _ in committed})
    print(f"{SHARDS} shards by the table: the heaviest has {ratio:.2f} of the best it could have (at most {MOST:.2f})")
    for case in missing:
        print(f"the table has no cost of '{case}': write it anew with {pathlib.Path(__file__).name}")
    return ratio <= MOST and not missing


def main():
    words = sys.argv[1:]
    if words[:1] == ["--check"]:
        return 0 if check(words[1:]) else 1
    sys.stdout.write(table(costs_of(words)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
