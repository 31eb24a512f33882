// SPDX-License-Identifier: GPL-3.0-or-later
// Where the records came from: each run's machines, toolchains and revisions, with the hosts that computed them.
import { group_by } from "../model/family.js";
import { machine_letters } from "../model/machine.js";

const counted = (records, value_of) =>
  [...group_by(records, value_of)]
    .filter(([value]) => value)
    .map(([name, { length }]) => ({ name, records: length }));

/** `entries`: [{record, run}], run an index of `heads`: [{run, machine, toolchain, revision, letter, hosts, records}]. */
export function environments_of(entries, heads) {
  const letters = machine_letters(entries.map(({ record }) => record));
  const key_of = ({ run, record: { environment } }) =>
    JSON.stringify([run, environment.machine, environment.toolchain, environment.revision]);
  return [...group_by(entries, key_of).values()].map((group) => {
    const records = group.map(({ record }) => record);
    const { machine, toolchain, revision } = records[0].environment;
    return {
      run: heads[group[0].run].name,
      ...{ machine, toolchain, revision },
      letter: letters([records[0]]),
      hosts: counted(records, ({ environment }) => environment.host),
      records: records.length,
    };
  });
}
