// SPDX-License-Identifier: GPL-3.0-or-later
// Where the time went: wall-clock time by phase, one bar a variant.
import { to_number } from "../model/number.js";
import { rounded } from "./axes.js";
import { name_axis, numbered, tip, tip_number } from "./names.js";
import { cut_words, MOST_VARIANTS, variant_channels } from "./variant_channels.js";

// In the order of a time step; phases of other engines come after, by name.
const ORDER = [
  "predict",
  "detect",
  "normal force",
  "depth",
  "friction",
  "post-correct",
  "forces",
  "integrate",
];

/** `entries`: [{label, configuration, record}] of one case. Null when no phase was timed. */
export function phase_plot(entries) {
  const timed = entries
    .slice(0, MOST_VARIANTS)
    .filter(({ record }) => Object.keys(record.cost.phase_seconds).length > 0)
    .map((entry) => ({ ...entry, label: entry.label || "all phases" }));
  const values = timed.flatMap(({ label, record }) =>
    Object.entries(record.cost.phase_seconds).map(([phase, seconds]) => ({
      variant: label,
      phase,
      seconds: rounded(to_number(seconds)),
    })),
  );
  if (values.length === 0) return null;
  const place = (phase) => (ORDER.includes(phase) ? ORDER.indexOf(phase) : ORDER.length);
  const phases = [...new Set(values.map(({ phase }) => phase))].sort(
    (a, b) => place(a) - place(b) || (a < b ? -1 : 1),
  );
  const rows = numbered(phases);
  const channels = variant_channels(timed);
  const variants = channels.names;
  for (const value of values)
    Object.assign(value, {
      phase_key: rows.key_of(value.phase),
      variant_key: variants.key_of(value.variant),
    });
  const single = variants.keys.length === 1;
  return {
    title: "Wall-clock time by phase",
    caption: cut_words(entries.length),
    description: `Wall-clock seconds of ${phases.join(", ")}.`,
    spec: {
      height: { step: single ? 20 : 9 },
      data: { values },
      mark: { type: "bar", cornerRadiusEnd: 2 },
      encoding: {
        y: name_axis("phase_key", rows),
        x: {
          field: "seconds",
          type: "quantitative",
          axis: { title: "wall-clock time (s)", tickCount: 5 },
        },
        ...(single
          ? { color: { value: channels.colours[0] } }
          : {
              yOffset: { field: "variant_key", type: "ordinal", scale: { domain: variants.keys } },
              color: channels.channel(channels.colours),
              opacity: channels.channel(channels.opacities),
            }),
        tooltip: [
          tip("variant", "variant"),
          tip("phase", "phase"),
          tip_number("seconds", "wall-clock s"),
        ],
      },
    },
  };
}
