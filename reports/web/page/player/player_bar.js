// SPDX-License-Identifier: GPL-3.0-or-later
import { h } from "../dom.js";

const FACTORS = [1, 10, 100, 1e3, 1e4, 1e5, 1e6];
const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5];
const SHORTEST = 4; // s that a recording shall take to play

/** The speed at which `duration` (s) is worth watching: not above 1. */
export const speed_for = (duration) =>
  SPEEDS.findLast((speed) => speed <= 1 && duration / speed >= SHORTEST) ?? SPEEDS[0];

/**
 * What one works the player with: {play, scrub, clock, speed, factor, from_here, forces, contacts, choices,
 * bars}; `bars` hold them all. Of more than two entries [{label}] two can be chosen, `pair` at first.
 */
export function player_bar(entries, pair) {
  const play = h("button", { type: "button", class: "play", "aria-pressed": "false" }, "Play");
  const scrub = h("input", {
    type: "range",
    min: 0,
    max: 0,
    step: 1,
    value: 0,
    "aria-label": "Time",
  });
  const clock = h("output", { class: "clock" }, "0 s");
  const speed = h(
    "select",
    { "aria-label": "Speed" },
    SPEEDS.map((value) => h("option", { value }, `× ${value}`)),
  );
  const factor = h(
    "select",
    { "aria-label": "Displacements drawn larger" },
    FACTORS.map((value) =>
      h("option", { value }, `× ${value < 1e4 ? value : value.toExponential(0).replace("+", "")}`),
    ),
  );
  const from_here = h(
    "button",
    { type: "button", class: "quiet", title: "Displacements count from the moment shown" },
    "from here",
  );
  const forces = h("input", { type: "checkbox" });
  const contacts = h("input", { type: "checkbox" });
  forces.checked = contacts.checked = true;
  const choose = (side, wanted) =>
    h(
      "select",
      { "aria-label": side, "data-side": side },
      entries.map(({ label }, i) =>
        h("option", { value: i, selected: i === wanted }, label || `recording ${i + 1}`),
      ),
    );
  const choices = entries.length > 2 ? [choose("left", pair[0]), choose("right", pair[1])] : [];
  const mark = (name, sign, word) => [h("span", { class: `mark-${name}` }, `${sign} `), `${word} `];
  const bars = [
    h("div", { class: "player-bar" }, play, scrub, clock, speed),
    h(
      "div",
      { class: "player-bar" },
      choices,
      h("span", { class: "player-scale" }, h("label", {}, "displacements ", factor), from_here),
      h(
        "span",
        { class: "player-parts" },
        h("label", {}, contacts, " contacts"),
        h("label", {}, forces, " forces"),
      ),
      h(
        "span",
        { class: "player-key" },
        mark("stick", "●", "sticks"),
        mark("slip", "◆", "slips"),
        mark("normal", "→", "normal force"),
        mark("friction", "→", "friction"),
      ),
    ),
  ];
  return { play, scrub, clock, speed, factor, from_here, forces, contacts, choices, bars };
}
