// SPDX-License-Identifier: GPL-3.0-or-later
import { format_value } from "../../model/number.js";
import { configuration_styles } from "../../plots/configuration_style.js";
import { PALETTES } from "../../plots/palette.js";
import { code_of } from "../asset.js";
import { h, replace } from "../dom.js";
import { style_mark } from "../widgets/style_mark.js";
import { count_contacts, exaggerated, instant, place_at, settled_frame } from "./playback.js";
import { still } from "./still.js";
import { current_theme } from "../widgets/theme.js";

const short = (value) => format_value(Number(value.toPrecision(2)));

/**
 * One recording: a canvas, or a drawing where WebGL is missing, and its contacts in words. `label` is written
 * in the colour of its `configuration`.
 */
export function make_pane(recording, label, configuration) {
  const { colour } = configuration_styles([configuration]).get(configuration);
  const canvas = h("canvas", {
    role: "img",
    "aria-label": `Recorded scene${label ? `, ${label}` : ""}`,
  });
  const flat = h("div", { class: "flat", hidden: true });
  const paper = h("div", { class: "paper" });
  const words = h("p", { class: "contact-words" });
  const scale_words = h("p", { class: "scale-words", hidden: true });
  const element = h(
    "div",
    { class: "pane", style: { "--own": `var(--${colour.slice(1)})` } },
    label && h("p", { class: "pane-label" }, style_mark(configuration), h("span", {}, label)),
    h("div", { class: "pane-picture" }, canvas, flat, paper, scale_words),
    words,
  );
  let scene = null;
  let factor = 1;
  let shown = null;
  let reference = settled_frame(recording);

  function now_at(time) {
    const now = instant(recording, time);
    if (factor === 1) return now;
    const rest = recording.frame(reference).positions;
    return { ...now, positions: exaggerated(now.positions, rest, factor, recording.step) };
  }
  return {
    element,
    recording,
    async start(view) {
      shown = view;
      try {
        const { make_scene } = await code_of("code/player", "stiction_player");
        scene = make_scene(canvas, recording, view, PALETTES[current_theme()]);
        return scene;
      } catch (error) {
        canvas.hidden = true;
        flat.hidden = false;
        return null;
      }
    },
    scene: () => scene,
    resize() {
      if (scene && canvas.clientWidth > 0) scene.resize(canvas.clientWidth, canvas.clientHeight);
    },
    /** How much larger displacements are drawn, and from which time on where that is given. */
    exaggerate(wanted, from) {
      factor = wanted;
      if (from !== undefined) reference = place_at(recording.times, from).frame;
      scale_words.hidden = factor === 1;
      const finest = Math.max(...recording.step);
      scale_words.textContent = `displacements × ${format_value(factor)} since ${short(recording.times[reference])} s; recorded to ${short(finest)} m`;
    },
    show(time) {
      const now = now_at(time);
      if (scene) scene.show(now);
      else replace(flat, still(recording, now, shown));
      const { sticking, slipping, normal, friction } = count_contacts(now.contacts);
      const last = recording.times.at(-1);
      words.textContent =
        `${sticking} stick, ${slipping} slip · ${short(normal)} N normal, ${short(friction)} N friction` +
        (time > last ? ` · the run ended at ${format_value(Number(last.toPrecision(3)))} s` : "");
    },
    // A canvas comes out empty on paper: what it shows is drawn beside it.
    print: (time) => scene && replace(paper, still(recording, now_at(time), shown)),
  };
}
