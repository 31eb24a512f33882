// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of a case, one or two side by side, with one clock and one camera.
import { decode_frames } from "../model/frames.js";
import { format_value } from "../model/number.js";
import { PALETTES } from "../plots/palette.js";
import { bytes_of, code_of } from "./asset.js";
import { h, replace } from "./dom.js";
import { count_contacts, instant, place_at, view_of } from "./playback.js";
import { still } from "./still.js";
import { current_theme } from "./theme.js";

const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5];
const SHORTEST = 4; // s that a recording shall take to play

// One recording: a canvas, or a drawing where WebGL is missing, and its contacts in words.
async function make_pane(recording, label) {
  const canvas = h("canvas", { role: "img", "aria-label": `Recorded scene${label ? `, ${label}` : ""}` });
  const flat = h("div", { class: "flat", hidden: true });
  const paper = h("div", { class: "paper" });
  const words = h("p", { class: "contact-words" });
  const element = h("div", { class: "pane" }, label && h("p", { class: "pane-label" }, label), canvas, flat, paper, words);
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
      words.textContent = `${sticking} stick, ${slipping} slip · ${short(normal)} normal, ${short(friction)} friction` +
        (time > last ? ` · the run ended at ${format_value(Number(last.toPrecision(3)))} s` : "");
    },
    // A canvas comes out empty on paper: what it shows is drawn beside it.
    print: (time) => scene && replace(paper, still(recording, instant(recording, time))),
  };
}

/** `entries`: [{record, label}] with a recording each; of more than two the `pair` is shown first. */
export function player_figure(entries, pair = [0, entries.length - 1]) {
  const place = h("div", { class: "panes" }, h("p", { class: "message" }, "Reading the recording …"));
  const message = h("p", { class: "message", hidden: true, role: "status" });
  const play = h("button", { type: "button", class: "play", "aria-pressed": "false" }, "Play");
  const scrub = h("input", { type: "range", min: 0, max: 0, step: 1, value: 0, "aria-label": "Time" });
  const clock = h("output", { class: "clock" }, "0 s");
  const speed = h("select", { "aria-label": "Speed" }, SPEEDS.map((value) => h("option", { value }, `× ${value}`)));
  const forces = h("input", { type: "checkbox" });
  const contacts = h("input", { type: "checkbox" });
  forces.checked = contacts.checked = true;
  const choose = (side, wanted) => h("select", { "aria-label": side, "data-side": side }, entries.map(({ label }, i) => h("option", { value: i, selected: i === wanted }, label || `recording ${i + 1}`)));
  const choices = entries.length > 2 ? [choose("left", pair[0]), choose("right", pair[1])] : [];
  const element = h("figure", { class: "player", tabindex: "0", "aria-label": "Recorded scene: Space plays, arrows step" },
    place, message,
    h("div", { class: "player-bar" }, play, scrub, clock, speed),
    h("div", { class: "player-bar" }, choices,
      h("span", { class: "player-parts" }, h("label", {}, contacts, " contacts"), h("label", {}, forces, " forces")),
      h("span", { class: "player-key" }, h("span", { class: "mark-stick" }, "● "), "sticks ", h("span", { class: "mark-slip" }, "◆ "), "slips ", h("span", { class: "mark-normal" }, "→ "), "normal force ", h("span", { class: "mark-friction" }, "→ "), "friction")));

  let panes = [];
  let times = [0];
  let time = 0;
  let running = false;

  function show(at) {
    time = Math.max(times[0], Math.min(times.at(-1), at));
    for (const pane of panes) pane.show(time);
    const { frame } = place_at(times, time);
    scrub.value = String(frame);
    clock.textContent = `${format_value(Number(time.toPrecision(3)))} s`;
    scrub.setAttribute("aria-valuetext", clock.textContent);
    element.dataset.frame = String(frame);
  }

  function pause() {
    running = false;
    play.textContent = "Play";
    play.setAttribute("aria-pressed", "false");
  }

  function start_playing() {
    if (time >= times.at(-1)) show(times[0]);
    running = true;
    play.textContent = "Pause";
    play.setAttribute("aria-pressed", "true");
    let before = performance.now();
    const tick = (now) => {
      if (!running) return;
      if (!element.isConnected) return pause();
      show(time + ((now - before) / 1000) * Number(speed.value));
      before = now;
      if (time >= times.at(-1)) pause();
      else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  const step = (frames) => {
    pause();
    const { frame } = place_at(times, time);
    show(times[Math.max(0, Math.min(times.length - 1, frame + frames))]);
  };
  play.addEventListener("click", () => (running ? pause() : start_playing()));
  scrub.addEventListener("input", () => {
    pause();
    show(times[Number(scrub.value)]);
  });
  const set_parts = () => {
    for (const pane of panes) pane.scene()?.set({ forces: forces.checked, contacts: contacts.checked });
  };
  forces.addEventListener("change", set_parts);
  contacts.addEventListener("change", set_parts);
  for (const [name, inside] of [["focusin", true], ["focusout", false]]) {
    element.addEventListener(name, () => panes.forEach((pane) => pane.scene()?.zoomable(inside)));
  }
  element.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches("select, input[type=checkbox]")) return;
    const actions = { " ": () => (running ? pause() : start_playing()), ArrowRight: () => step(1), ArrowLeft: () => step(-1), Home: () => show(times[0]), End: () => show(times.at(-1)) };
    if (!actions[event.key] || (event.key === " " && event.target === play)) return;
    event.preventDefault();
    actions[event.key]();
  });

  async function load(chosen) {
    pause();
    for (const pane of panes) pane.scene()?.dispose();
    panes = await Promise.all(chosen.map(async ({ record, label }) => make_pane(decode_frames(await bytes_of(`frames/${record.frames}`)), label)));
    times = panes.map(({ recording }) => recording.times).reduce((a, b) => (b.length > a.length ? b : a));
    scrub.max = String(times.length - 1);
    speed.value = String(SPEEDS.findLast((value) => value <= 1 && (times.at(-1) - times[0]) / value >= SHORTEST) ?? SPEEDS[0]);
    place.className = `panes panes-${panes.length}`;
    replace(place, panes.map((pane) => pane.element));
    const view = view_of(panes.map(({ recording }) => recording));
    const scenes = await Promise.all(panes.map((pane) => pane.start(view)));
    message.hidden = scenes.every(Boolean);
    message.textContent = message.hidden ? "" : "This browser gives no WebGL, so the scene is drawn flat, without arrows and turning.";
    if (scenes.length === 2 && scenes.every(Boolean)) {
      scenes[0].on_look(() => scenes[1].look_like(scenes[0]));
      scenes[1].on_look(() => scenes[0].look_like(scenes[1]));
    }
    const sizes = new ResizeObserver(() => panes.forEach((pane) => pane.resize()));
    for (const pane of panes) {
      pane.resize();
      sizes.observe(pane.element);
    }
    set_parts();
    show(times[0]);
    element.dataset.loaded = "true";
  }

  addEventListener("beforeprint", () => {
    if (element.isConnected) for (const pane of panes) pane.print(time);
  });
  const fail = (error) => replace(place, h("p", { class: "message" }, `The recording cannot be shown: ${error.message}`));
  for (const choice of choices) choice.addEventListener("change", () => load(choices.map((one) => entries[Number(one.value)])).catch(fail));
  const seen = new IntersectionObserver((list) => {
    if (!list.some(({ isIntersecting }) => isIntersecting)) return;
    seen.disconnect();
    load(entries.length > 2 ? pair.map((i) => entries[i]) : entries).catch(fail);
  });
  seen.observe(element);
  element.stiction_positions = () => panes.map((pane) => pane.scene()?.positions() ?? null);
  return element;
}
