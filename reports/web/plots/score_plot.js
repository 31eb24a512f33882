// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison at a glance: a row a rule, a column a case, the figure as number and colour, one picture
// for each kind of contacts. Rules are ordered by how they do over all cases.
import { compared_quantities, failure_of, figure_of, figure_text, WORK } from "../model/figure.js";
import { group_by } from "../model/family.js";
import { name_with_unit } from "../model/number.js";
import { rounded } from "./axes.js";
import { name_axis, numbered, tip } from "./names.js";
import { variants_by_machine, with_timings } from "./machine_marks.js";
import { is_rule_work } from "./rule_work_plot.js";
import { on_contacts } from "./rule_channels.js";

const LEAST = 3; // rules and cases that make a picture
const TELLING = 10; // largest ÷ least
const ROW = 21; // px
const LETTERS = 11; // in a line of a column's name
const ROOMY = 8; // columns that stand in half a page's width
const MOST_NUMBERED = 16; // columns whose numbers can be read

const folder_of = (name) => name.split("/")[0];
const end_of = (name) => name.slice(folder_of(name).length + 1);

// "switching-triangles" in lines that fit a column, divided by "|".
const in_lines = (name) =>
  name
    .replace(/[|]/g, "/")
    .split(/(?<=[-/])/)
    .reduce((lines, part) => {
      const joined = (lines.at(-1) ?? "") + part;
      return lines.length > 0 && joined.length <= LETTERS
        ? [...lines.slice(0, -1), joined]
        : [...lines, part];
    }, [])
    .join("|");

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted.length > 0 ? sorted[sorted.length >> 1] : Infinity;
}

// Rows in order, best first: the median place over all cases and contacts, failures last.
function order_of(cells) {
  const places = new Map(cells.map(({ words }) => [words, []]));
  for (const group of group_by(cells, (cell) => `${cell.case} ${cell.contacts}`).values()) {
    const size = ({ value, failure }) => (failure || Number.isNaN(value) ? Infinity : value);
    for (const cell of group)
      places.get(cell.words).push(group.filter((other) => size(other) < size(cell)).length);
  }
  const of = (words) => {
    const list = places.get(words);
    return [median(list), list.reduce((a, b) => a + b, 0) / list.length];
  };
  return [...places.keys()].sort((a, b) => of(a)[0] - of(b)[0] || of(a)[1] - of(b)[1]);
}

// As few letters as fit a cell: 3.3e-4.
const cell_text = (value) =>
  value !== 0 && Math.abs(value) < 0.01
    ? value.toExponential(1).replace(".0e", "e")
    : figure_text(value);

// The numbers of what held, of what failed, and of the best, as they look.
const texts_of = (values) => [
  { values: values.filter((one) => !one.best && one.failure === "held"), color: "$ink" },
  { values: values.filter((one) => one.failure !== "held"), color: "$fail" },
  { values: values.filter((one) => one.best), color: "$ink", fontWeight: 700 },
];

function panel(cells, contacts, { quantity, rows, columns, range }) {
  const best = new Map();
  for (const { case: name, value, failure } of cells)
    if (!failure && value >= 0) best.set(name, Math.min(best.get(name) ?? Infinity, value));
  const values = cells.map(({ words, case: name, value, failure }) => ({
    rule: words,
    row_key: rows.key_of(words),
    column_key: columns.key_of(in_lines(end_of(name))),
    case: name,
    size: failure || !(value > 0) || !Number.isFinite(value) ? null : rounded(value),
    text: failure ? "✕" : cell_text(value),
    best: !failure && Number.isFinite(value) && value === best.get(name),
    failed: failure !== "" || value === Infinity,
    failure: failure || "held",
  }));
  const crowded = columns.keys.length > MOST_NUMBERED;
  const x = {
    field: "column_key",
    type: "ordinal",
    sort: null,
    scale: { domain: columns.keys, paddingInner: 0.04, paddingOuter: 0 },
    axis: {
      title: null,
      labelExpr: crowded ? `replace(${columns.labels}, '|', '')` : `split(${columns.labels}, '|')`,
      labelAngle: crowded ? -60 : 0,
      labelFontSize: crowded ? 9 : 10.5,
      labelOverlap: crowded,
      ticks: false,
      domain: false,
      labelLimit: 150,
    },
  };
  const y = name_axis("row_key", rows);
  const tooltip = [
    tip("rule", "rule"),
    tip("case", "case"),
    tip("text", quantity.quantity),
    tip("failure", "held"),
  ];
  const failed = values.filter((one) => one.failure !== "held").length;
  return {
    kind: "scores",
    quantity: quantity.quantity,
    wide: columns.keys.length > ROOMY,
    title: `${name_with_unit(quantity.quantity, quantity.unit)}${on_contacts(contacts)}`,
    caption:
      `Best rule on top. Green is little. ${crowded ? "The numbers stand in the data and under the pointer. " : "Bold: least of a column. "}` +
      (failed > 0 ? `✕: ${failed} of ${values.length} failed.` : "None failed."),
    description: `${quantity.quantity} of ${rows.keys.length} rules in ${columns.keys.length} cases${on_contacts(contacts)}.`,
    spec: {
      height: { step: ROW },
      layer: [
        {
          data: { values },
          mark: { type: "rect", cursor: "pointer" },
          encoding: {
            x,
            y,
            color: {
              condition: { test: "datum.failed", value: "$score_none" },
              field: "size",
              type: "quantitative",
              scale: {
                type: "log",
                domain: range,
                range: ["$score_least", "$score_middle", "$score_most"],
                clamp: true,
                interpolate: "rgb",
              },
              legend: null,
            },
            tooltip,
          },
        },
        ...(crowded
          ? [{ values: values.filter((one) => one.failure !== "held"), color: "$fail" }]
          : texts_of(values)
        ).map(({ values: some, ...look }) => ({
          data: { values: some },
          mark: { type: "text", fontSize: 11, ...look },
          encoding: { x, y, text: { field: "text" }, tooltip },
        })),
      ],
    },
  };
}

function plots_of(quantity, entries) {
  const cells = entries
    .map(({ record, variant }) => ({
      case: record.case,
      words: variant.name,
      contacts: variant.contacts,
      value: figure_of(record, quantity.quantity),
      failure: failure_of(record),
    }))
    .filter(({ value, failure }) => !Number.isNaN(value) || failure);
  const sizes = cells
    .filter(({ failure, value }) => !failure && value > 0 && Number.isFinite(value))
    .map(({ value }) => value);
  const range = [
    sizes.reduce((a, b) => Math.min(a, b), Infinity),
    sizes.reduce((a, b) => Math.max(a, b), 0),
  ];
  if (!(range[1] / range[0] >= TELLING)) return [];
  const rows = numbered(order_of(cells));
  const columns = numbered([...new Set(cells.map((cell) => in_lines(end_of(cell.case))))]);
  if (rows.keys.length < LEAST || columns.keys.length < LEAST) return [];
  const middle = Math.sqrt(range[0] * range[1]);
  const shared = { quantity, rows, columns, range: [range[0], middle, range[1]] };
  return [...group_by(cells, ({ contacts }) => contacts)]
    .sort(([a], [b]) => (a < b ? -1 : 1))
    .map(([contacts, own]) => panel(own, contacts, shared));
}

/**
 * [{folder, plots}] for folders of three cases or more that were compared in the same figures: "rules",
 * "hard". `entries`: [{record, variant}]. The figures that have a unit come first.
 */
export function score_plots(entries) {
  const folders = group_by(entries, ({ record }) => folder_of(record.case));
  return [...folders]
    .map(([folder, own]) => {
      const quantities = compared_quantities(own.map(({ record }) => record));
      const first = [
        ...quantities.filter(({ unit }) => unit !== "1"),
        ...quantities.filter(({ unit }) => unit === "1"),
      ];
      if (is_rule_work(own.map(({ record }) => record))) return { folder, plots: [] };
      const records = own.map(({ record }) => record);
      const by_machine = variants_by_machine(own);
      const plots = first.flatMap((quantity) =>
        quantity.quantity === WORK
          ? plots_of(quantity, by_machine).map((plot) => with_timings(plot, records))
          : plots_of(quantity, own),
      );
      return {
        folder,
        plots: plots.map((plot, i) => ({ ...plot, id: `${folder}/scores-${i + 1}` })),
      };
    })
    .filter(({ plots }) => plots.length > 0);
}
