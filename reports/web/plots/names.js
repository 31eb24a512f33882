// SPDX-License-Identifier: GPL-3.0-or-later
// Names from records in specifications. Vega uses some strings as keys of plain objects, where a name
// such as "constructor" breaks it: so scales run over numbers, and the names are only ever shown.

// A string of Vega's expression language, of plain letters whatever it holds. The space, which is not
// seen, keeps "toString" from being taken for the function.
const literal = (text) =>
  `"${`${text} `.replace(/[^\w .:/=+-]/g, (sign) => `\\u${sign.charCodeAt(0).toString(16).padStart(4, "0")}`)}"`;

/**
 * For a list of distinct names: {key_of(name): number, keys: [number], labels: Vega's expression for
 * the name of datum.value}.
 */
export function numbered(names) {
  const places = new Map(names.map((name, place) => [name, place]));
  return {
    key_of: (name) => places.get(name),
    keys: names.map((_, place) => place),
    labels: `[${names.map(literal).join(",")}][datum.value]`,
  };
}

/** An axis' ticks at some places, each with a text of its own. */
export const labelled = (places, texts) => ({
  values: places,
  labelExpr: `[${texts.map(literal).join(",")}][indexof([${places.join(",")}], datum.value)]`,
});

/** A tooltip's entry; the colon keeps a name from being a key that objects have already. */
export const tip = (field, name, type = "nominal") => ({ field, title: `${name}:`, type });
export const tip_number = (field, name) => tip(field, name, "quantitative");

/** A row for each name on a vertical axis, in the order of `rows` (as numbered() gives them). */
export const name_axis = (field, rows, axis = {}) => ({
  field,
  type: "ordinal",
  sort: null,
  scale: { domain: rows.keys },
  axis: {
    title: null,
    ticks: false,
    domain: false,
    labelExpr: rows.labels,
    ...axis,
  },
});
