// SPDX-License-Identifier: GPL-3.0-or-later
// Keys, and the window that lists them.
import { h } from "../dom.js";

const KEYS = [
  ["/", "search"],
  ["1  2  …", "the views in the bar, from the left"],
  ["j  k  or  ↓  ↑", "next, previous row of the table"],
  ["Enter", "open the row"],
  ["n  p", "next, previous case"],
  ["Esc", "back to the table"],
  ["Space", "in the player: play, pause"],
  ["←  →", "in the player: one frame back, on"],
  ["Home  End", "in the player: first, last frame"],
  ["?", "this list"],
];

let enabled = true;

export const keys_enabled = () => enabled;

const box = h("input", {
  type: "checkbox",
  id: "keys-on",
  onchange: () => (enabled = box.checked),
});
box.checked = true;

const dialog = h(
  "dialog",
  { class: "help", "aria-labelledby": "help-title" },
  h("h2", { id: "help-title" }, "Keys"),
  h(
    "dl",
    {},
    KEYS.map(([key, meaning]) => [h("dt", {}, h("kbd", {}, key)), h("dd", {}, meaning)]),
  ),
  h("p", {}, h("label", { for: "keys-on" }, box, " single keys are on")),
  h("form", { method: "dialog" }, h("button", { type: "submit" }, "Close")),
);

export function show_help() {
  if (!dialog.isConnected) document.body.append(dialog);
  dialog.showModal();
}
