// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are parts of one, as run.json in their folders says: they are shown as the run that they are of.
import { existsSync, readdirSync, readFileSync, realpathSync, statSync } from "node:fs";
import { join } from "node:path";
import { newest_first } from "./run_order.mjs";

/** What a run set out to do: {plan, jobs, shard: {number, count}}; null where it does not say. */
export function read_plan(folder) {
  try {
    const { plan, jobs, shard } = JSON.parse(readFileSync(join(folder, "run.json"), "utf8"));
    const counts = [jobs, shard.number, shard.count];
    return typeof plan === "string" && counts.every(Number.isSafeInteger)
      ? { plan, jobs, shard }
      : null;
  } catch {
    return null;
  }
}

/** Whether a folder is of a part that had nothing to do, or has not finished anything yet. */
export function is_empty_part(folder) {
  const records = join(folder, "records.jsonl");
  return (
    (read_plan(folder)?.shard.count ?? 1) > 1 && existsSync(records) && statSync(records).size === 0
  );
}

/** Of an out-dir whose newest run is a part: all parts in it; else the folder itself. */
export function parts_in(folder) {
  const link = join(folder, "latest");
  if (!existsSync(link) || !statSync(link).isDirectory()) return [folder];
  const newest = read_plan(link);
  if (!newest || newest.shard.count === 1) return [folder];
  return readdirSync(folder, { withFileTypes: true })
    .filter(
      (entry) => entry.isDirectory() && read_plan(join(folder, entry.name))?.plan === newest.plan,
    )
    .map(({ name }) => realpathSync(join(folder, name)));
}

// One of several parts. Of a job that stands twice, as merge does: one that did not break off, and then the newest.
function joined(parts, warnings) {
  const runs = [...parts].sort((a, b) => newest_first(a.name, b.name));
  const of_job = new Map();
  for (const record of runs.flatMap(({ records }) => records)) {
    if (!Number.isSafeInteger(record.job)) continue;
    const known = of_job.get(record.job);
    if (!known || (known.verdict === "error" && record.verdict !== "error"))
      of_job.set(record.job, record);
  }
  const { jobs } = runs[0].plan;
  if (of_job.size < jobs)
    warnings.push(
      `${jobs - of_job.size} of ${jobs} jobs have no record: some part is missing, or was interrupted.`,
    );
  return {
    ...runs[0],
    records: [...of_job].sort(([a], [b]) => a - b).map(([, record]) => record),
  };
}

/**
 * The runs, those that are parts of the same run as one at the place of the first. Their recordings must
 * have been read: these stand in the parts' own folders.
 */
export function join_parts(runs, warnings) {
  const groups = new Map();
  for (const run of runs) {
    const plan = read_plan(run.folder);
    const is_part = plan !== null && plan.shard.count > 1;
    const key = is_part ? `part of ${plan.plan}` : run;
    groups.set(key, [...(groups.get(key) ?? []), { ...run, plan }]);
  }
  return [...groups].map(([key, group]) =>
    typeof key === "string" ? joined(group, warnings) : group[0],
  );
}
