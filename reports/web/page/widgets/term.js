// SPDX-License-Identifier: GPL-3.0-or-later
// A word that the glossary explains: its meaning shows under the pointer, on focus, and when touched.
import { glossary_entry } from "../../model/glossary.js";
import { h } from "../dom.js";
import { hide_tip, show_tip_at } from "./tip.js";

/** `text` with the meaning of `word`; plain text where the glossary has none. */
export function term(word, text = word) {
  const entry = glossary_entry(word);
  if (!entry) return document.createTextNode(text);
  const element = h(
    "span",
    {
      class: "term",
      tabindex: "0",
      role: "note",
      "aria-label": `${text}: ${entry.meaning}`,
    },
    text,
  );
  const show = () => show_tip_at(element, entry.meaning);
  element.addEventListener("pointerenter", show);
  element.addEventListener("focus", show);
  element.addEventListener("click", show);
  for (const end of ["pointerleave", "blur"]) element.addEventListener(end, hide_tip);
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    hide_tip();
    event.stopPropagation(); // or the page would go back to its table
  });
  return element;
}
