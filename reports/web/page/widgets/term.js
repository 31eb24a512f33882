// SPDX-License-Identifier: GPL-3.0-or-later
// Words that the glossary explains: the meaning shows under the pointer, on focus, and when touched. Any
// element can have one: it names its word in data-term.
import { glossary_entry } from "../../model/glossary.js";
import { h } from "../dom.js";
import { hide_tip, show_tip_at } from "./tip.js";

/** `text` with the meaning of `word`, reached by the Tab key; plain text where the glossary has none. */
export function term(word, text = word) {
  const entry = glossary_entry(word);
  if (!entry) return document.createTextNode(text);
  return h(
    "span",
    {
      class: "term",
      tabindex: "0",
      role: "note",
      "aria-label": `${text}: ${entry.meaning}`,
      "data-term": word,
    },
    text,
  );
}

/** Shows the meanings of all words of the page, those of later views too. */
export function start_terms() {
  let shown = null;
  const end = () => {
    if (shown) hide_tip();
    shown = null;
  };
  const show = ({ target }) => {
    const element = target.closest?.("[data-term]");
    if (element === shown) return;
    end();
    const entry = element && glossary_entry(element.dataset.term);
    if (!entry) return;
    shown = element;
    show_tip_at(element, entry.meaning);
  };
  for (const event of ["pointerover", "focusin", "click"]) document.addEventListener(event, show);
  document.addEventListener("focusout", end);
  document.addEventListener("scroll", end, { capture: true, passive: true });
  document.addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape" || !shown) return;
      end();
      event.stopPropagation(); // or the page would go back to its table
    },
    { capture: true },
  );
}
