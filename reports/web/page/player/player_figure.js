// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of a case, one or two side by side, with one clock and one camera.
import { decode_frames } from "../../model/frames.js";
import { format_value } from "../../model/number.js";
import { bytes_of } from "../asset.js";
import { h, replace } from "../dom.js";
import { place_at, view_of } from "./playback.js";
import { player_bar, speed_for } from "./player_bar.js";
import { make_pane } from "./player_pane.js";
import { telling_moment } from "./telling.js";
import { configuration_of } from "../../model/configuration.js";
import { on_theme } from "../widgets/theme.js";

/**
 * `entries`: [{record, label}] with a recording each; of more than two the `pair` is shown first. The
 * element's stiction_end() gives back what it holds of the graphics card.
 */
export function player_figure(entries, pair = [0, entries.length - 1]) {
  const place = h(
    "div",
    { class: "panes" },
    h("p", { class: "message" }, "Reading the recording …"),
  );
  const message = h("p", { class: "message", hidden: true, role: "status" });
  const { play, scrub, clock, speed, factor, from_here, forces, contacts, choices, bars } =
    player_bar(entries, pair);
  const element = h(
    "figure",
    { class: "player", tabindex: "0", "aria-label": "Recorded scene: Space plays, arrows step" },
    place,
    message,
    bars,
  );

  let panes = [];
  let times = [0];
  let time = 0;
  let running = false;
  let ended = false;

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
    for (const pane of panes)
      pane.scene()?.set({ forces: forces.checked, contacts: contacts.checked });
  };
  const exaggerate = (from) => {
    for (const pane of panes) pane.exaggerate(Number(factor.value), from);
    show(time);
  };
  factor.addEventListener("change", () => exaggerate());
  from_here.addEventListener("click", () => exaggerate(time));
  forces.addEventListener("change", set_parts);
  contacts.addEventListener("change", set_parts);
  for (const [name, inside] of [
    ["focusin", true],
    ["focusout", false],
  ]) {
    element.addEventListener(name, () => panes.forEach((pane) => pane.scene()?.zoomable(inside)));
  }
  element.addEventListener("keydown", (event) => {
    if (
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      event.target.matches("select, input[type=checkbox]")
    )
      return;
    const actions = {
      " ": () => (running ? pause() : start_playing()),
      ArrowRight: () => step(1),
      ArrowLeft: () => step(-1),
      Home: () => show(times[0]),
      End: () => show(times.at(-1)),
    };
    if (!actions[event.key] || (event.key === " " && event.target === play)) return;
    event.preventDefault();
    actions[event.key]();
  });

  const sizes = new ResizeObserver(() => panes.forEach((pane) => pane.resize()));

  function clear() {
    pause();
    sizes.disconnect();
    for (const pane of panes) pane.scene()?.dispose();
    panes = [];
  }

  async function load(chosen, at) {
    const recordings = await Promise.all(
      chosen.map(async ({ record }) => decode_frames(await bytes_of(`frames/${record.frames}`))),
    );
    if (ended) return;
    clear();
    panes = recordings.map((recording, i) =>
      make_pane(recording, chosen[i].label, configuration_of(chosen[i].record)),
    );
    times = recordings
      .map((recording) => recording.times)
      .reduce((a, b) => (b.at(-1) > a.at(-1) ? b : a));
    scrub.max = String(times.length - 1);
    speed.value = String(speed_for(times.at(-1) - times[0]));
    place.className = `panes panes-${panes.length}`;
    replace(
      place,
      panes.map((pane) => pane.element),
    );
    const moment = telling_moment(recordings);
    const view = view_of(recordings, moment);
    const scenes = await Promise.all(panes.map((pane) => pane.start(view)));
    message.hidden = scenes.every(Boolean);
    message.textContent = message.hidden
      ? ""
      : "This browser gives no WebGL, so the scene is drawn flat, without arrows and turning.";
    if (scenes.length === 2 && scenes.every(Boolean)) {
      scenes[0].on_look(() => scenes[1].look_like(scenes[0]));
      scenes[1].on_look(() => scenes[0].look_like(scenes[1]));
    }
    for (const pane of panes) {
      pane.resize();
      sizes.observe(pane.element);
    }
    set_parts();
    for (const pane of panes) pane.exaggerate(Number(factor.value));
    show(at ?? moment);
    if (matchMedia("print").matches) print(); // the theme of paper may have come after it
    element.dataset.loaded = "true";
  }

  const fail = (error) =>
    replace(place, h("p", { class: "message" }, `The recording cannot be shown: ${error.message}`));
  const chosen = () =>
    choices.length > 0 ? choices.map((choice) => entries[Number(choice.value)]) : entries;
  const reload = (at) => load(chosen(), at).catch(fail);
  for (const choice of choices) choice.addEventListener("change", () => reload());

  const print = () => panes.forEach((pane) => pane.print(time));
  addEventListener("beforeprint", print);
  const forget_theme = on_theme(() => element.dataset.loaded && reload(time));
  const seen = new IntersectionObserver(
    (list) => {
      if (!list.some(({ isIntersecting }) => isIntersecting)) return;
      seen.disconnect();
      reload();
    },
    { rootMargin: "600px" },
  );
  seen.observe(element);
  element.stiction_end = () => {
    ended = true;
    seen.disconnect();
    removeEventListener("beforeprint", print);
    forget_theme();
    clear();
  };
  element.stiction_positions = () => panes.map((pane) => pane.scene()?.positions() ?? null);
  return element;
}
