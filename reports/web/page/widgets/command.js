// SPDX-License-Identifier: GPL-3.0-or-later
// A command line to take along.
import { h } from "../dom.js";

const SHOWN = 1500; // ms

// Without leave for the clipboard the command is selected: Ctrl+C does the rest.
async function copied(text, code) {
  try {
    await navigator.clipboard.writeText(text);
    return "Copied";
  } catch {
    getSelection().selectAllChildren(code);
    return "Selected";
  }
}

/** `name` tells a screen reader which of several it is. */
export function command(text, name) {
  const code = h("code", {}, text);
  const word = h("span", {}, "Copy");
  const copy = async () => {
    word.textContent = await copied(text, code);
    setTimeout(() => (word.textContent = "Copy"), SHOWN);
  };
  return h(
    "span",
    { class: "command" },
    code,
    h(
      "button",
      { type: "button", class: "quiet", onclick: copy },
      word,
      h("span", { class: "sr" }, `: ${name}`),
    ),
  );
}
