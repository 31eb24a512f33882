// SPDX-License-Identifier: GPL-3.0-or-later

// What runs are called beside their records: "this run" and "earlier" where one is compared with one,
// else their names without the date that all share, numbered where they are the same.
function short_names(runs, against) {
  if (runs.length === 1 && against.length === 1) return ["this run", "earlier"];
  const names = [...runs, ...against].map(({ name }) => name);
  const starts = names.map((name) => name.slice(0, name.indexOf("T") + 1));
  const short = names.map((name) =>
    starts.every((start) => start === starts[0]) ? name.slice(starts[0].length) : name,
  );
  return short.map((name, i) => {
    const place = short.slice(0, i + 1).filter((other) => other === name).length;
    return place > 1 ? `${name} (${place})` : name;
  });
}

/** Of each run: name, short name, role ("shown" or "against"), how many records, environment. */
export function run_heads(runs, against) {
  const short = short_names(runs, against);
  const head = (run, role, place) => {
    const environment = run.records[0].environment;
    return {
      name: run.name,
      short: short[place],
      role,
      records: run.records.length,
      ...environment,
    };
  };
  return [
    ...runs.map((run, i) => head(run, "shown", i)),
    ...against.map((run, i) => head(run, "against", runs.length + i)),
  ];
}
