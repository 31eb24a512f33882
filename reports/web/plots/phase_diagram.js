// SPDX-License-Identifier: GPL-3.0-or-later
// Who holds where: the verdicts of a sweep's points over its axes.
import { group_by } from "../model/family.js";
import { format_count, to_number } from "../model/number.js";
import { counted, rank } from "../model/verdict.js";
import { rounded } from "./axes.js";
import { tip, tip_number } from "./names.js";
import { VERDICT_LABELS, verdict_encoding } from "./palette.js";
import { drawn_of, mark_size, over_words, sweep_place, SWEEP_MARK } from "./sweep_layout.js";
import { axis_tips, sweep_spec } from "./sweep_panels.js";

/** "2 fail, 4 hold" */
export function tally(records) {
  const groups = group_by(records, ({ verdict }) => verdict);
  return [...groups]
    .sort(([a], [b]) => rank(a) - rank(b))
    .map(([verdict, group]) => counted(verdict, group.length, format_count(group.length)))
    .join(", ");
}

// Where marks lie on each other, the worst are seen.
const worst_last = (records) => [...records].sort((a, b) => rank(b.verdict) - rank(a.verdict));

/** The diagram of a sweep's `records`; `name` is what their configuration is called. */
export function phase_diagram(name, records, layout) {
  const { shown, words } = drawn_of(layout, records);
  const overlaid = layout.pairs.length > 1;
  const values = (overlaid ? worst_last(shown) : shown).flatMap((record) => {
    const place = sweep_place(layout, record);
    if (!place) return [];
    return {
      ...place,
      verdict: record.verdict,
      ...(record.checks.length > 0 && { value: rounded(to_number(record.checks[0].value)) }),
    };
  });
  const measured = records.find(({ checks }) => checks.length > 0)?.checks[0].quantity;
  const present = [...new Set(values.map(({ verdict }) => verdict))];
  const told = tally(records);
  return {
    kind: "phase-diagram",
    title: `${name}: over ${over_words(layout)}`,
    wide: layout.panels > 1,
    caption: `${[told, words].filter(Boolean).join("; ")}.`,
    description: `Verdicts over ${over_words(layout)}: ${told}`,
    spec: sweep_spec(layout, values, ({ x, y }) => ({
      mark: {
        type: "point",
        filled: true,
        opacity: overlaid ? 0.75 : 1,
        size: mark_size(layout, values.length),
        ...SWEEP_MARK,
      },
      encoding: {
        x,
        y,
        ...verdict_encoding({ labelExpr: VERDICT_LABELS, values: present }),
        tooltip: [
          ...axis_tips(layout),
          tip("verdict", "verdict"),
          ...(measured ? [tip_number("value", measured)] : []),
        ],
      },
    })),
  };
}
