// SPDX-License-Identifier: GPL-3.0-or-later
import { configuration_of } from "./configuration.js";
import { OURS } from "./engine.js";

/** What a column is called: the configuration, with its engine where there are several. */
export function column_names(records) {
  const several = new Set(records.map(({ engine }) => engine)).size > 1;
  return (record) => {
    const name = configuration_of(record);
    return several && record.engine !== OURS && name !== record.engine
      ? `${record.engine} · ${name}`
      : name;
  };
}
