// SPDX-License-Identifier: GPL-3.0-or-later
// Specifications of several panels, and how much they draw. Vega-Lite doesn't fit these to a width, so their sizes are worked out here.

const LEAST = 150; // px, of a panel
const MOST = 400;
const GAP = 22;
const SHARED_AXIS = 62; // left of all panels with a common axis
const OWN_AXIS = 66; // left of each panel with its own
const MARGIN = 14;
const SQUAT = 0.8; // height ÷ width

/** Whether a specification is of several panels. */
export const is_of_panels = (spec) => Boolean(spec.facet || spec.concat);

/** The parts of a specification that have marks and encodings of their own. */
export const parts_of = (spec) =>
  [spec, spec.spec, ...(spec.concat ?? [])]
    .filter(Boolean)
    .flatMap((part) => [part, ...(part.layer ?? [])]);

/** The specification with each of its parts, itself among them, as `change(part)` gives it. */
export function with_parts(spec, change) {
  const all = (parts) => parts.map((part) => with_parts(part, change));
  const { layer, concat, spec: inner } = spec;
  return {
    ...change(spec),
    ...(layer && { layer: all(layer) }),
    ...(concat && { concat: all(concat) }),
    ...(inner && { spec: with_parts(inner, change) }),
  };
}

/** About how many marks a specification draws. */
export const mark_count = (spec) =>
  (spec.concat?.length ?? 1) *
  parts_of(spec).reduce((sum, { data }) => sum + (data?.values?.length ?? 0), 0);

/** `spec` with as many panels in a row as there is room for in `width`, px. */
export function sized_panels(spec, width) {
  const count = spec.usermeta.panels;
  const own = spec.concat ? OWN_AXIS : 0;
  const room = width - MARGIN - (spec.concat ? 0 : SHARED_AXIS);
  const fit = Math.max(1, Math.min(count, Math.floor((room + GAP) / (LEAST + own + GAP))));
  const columns = Math.ceil(count / Math.ceil(count / fit)); // rows of about the same length
  const inner = Math.floor((room - GAP * (columns - 1)) / columns) - own;
  const size = { width: Math.min(MOST, inner), height: Math.round(SQUAT * Math.min(MOST, inner)) };
  const panel = (part) => ({ ...part, ...size });
  return {
    ...spec,
    columns,
    spacing: GAP,
    ...(spec.concat ? { concat: spec.concat.map(panel) } : { spec: panel(spec.spec) }),
  };
}
