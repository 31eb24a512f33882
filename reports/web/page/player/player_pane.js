// SPDX-License-Identifier: GPL-3.0-or-later
import { format_value } from "../../model/number.js";
import { PALETTES } from "../../plots/palette.js";
import { code_of } from "../asset.js";
import { h, replace } from "../dom.js";
import { count_contacts, instant } from "./playback.js";
import { still } from "./still.js";
import { current_theme } from "../widgets/theme.js";

/** One recording: a canvas, or a drawing where WebGL is missing, and its contacts in words. */
export function make_pane(recording, label) {
  const canvas = h("canvas", {
    role: "img",
    "aria-label": `Recorded scene${label ? `, ${label}` : ""}`,
  });
  const flat = h("div", { class: "flat", hidden: true });
  const paper = h("div", { class: "paper" });
  const words = h("p", { class: "contact-words" });
  const element = h(
    "div",
    { class: "pane" },
    label && h("p", { class: "pane-label" }, label),
    canvas,
    flat,
    paper,
    words,
  );
  let scene = null;
  return {
    element,
    recording,
    async start(view) {
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
    show(time) {
      const now = instant(recording, time);
      if (scene) scene.show(now);
      else replace(flat, still(recording, now));
      const { sticking, slipping, normal, friction } = count_contacts(now.contacts);
      const short = (force) => `${format_value(Number(force.toPrecision(2)))} N`;
      const last = recording.times.at(-1);
      words.textContent =
        `${sticking} stick, ${slipping} slip · ${short(normal)} normal, ${short(friction)} friction` +
        (time > last ? ` · the run ended at ${format_value(Number(last.toPrecision(3)))} s` : "");
    },
    // A canvas comes out empty on paper: what it shows is drawn beside it.
    print: (time) => scene && replace(paper, still(recording, instant(recording, time))),
  };
}
