// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark: as the system says until the reader chooses; always light on paper.
import { h } from "../dom.js";

const dark = matchMedia("(prefers-color-scheme: dark)");
const paper = matchMedia("print");
const listeners = new Set();
let chosen = null;

export const current_theme = () =>
  paper.matches ? "light" : (chosen ?? (dark.matches ? "dark" : "light"));

/** Tells `listener` of changes; gives the function that ends it. */
export function on_theme(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

function tell() {
  document.documentElement.dataset.theme = chosen ?? (dark.matches ? "dark" : "light");
  for (const listener of listeners) listener();
}

export function start_theme() {
  dark.addEventListener("change", tell);
  paper.addEventListener("change", tell);
  document.documentElement.dataset.theme = current_theme();
}

export function theme_button() {
  const name = () => (current_theme() === "dark" ? "Light" : "Dark");
  const button = h(
    "button",
    {
      type: "button",
      class: "quiet",
      title: "Switch between light and dark",
      onclick: () => {
        chosen = current_theme() === "dark" ? "light" : "dark";
        tell();
      },
    },
    name(),
  );
  on_theme(() => (button.textContent = name()));
  return button;
}
