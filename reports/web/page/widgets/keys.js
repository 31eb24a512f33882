// SPDX-License-Identifier: GPL-3.0-or-later
import { keys_enabled, show_help } from "./help.js";
import { hash_of } from "../route.js";

const is_typing = (target) =>
  target.closest?.("input, select, textarea, dialog, .player") !== null &&
  target.closest?.("input, select, textarea, dialog, .player") !== undefined;

/** `page`: {views: [name], view(): name, cases: cases_view, back()}. */
export function start_keys(page) {
  const actions = {
    "/": () => {
      location.hash = page.view() === "cases" ? location.hash : hash_of("cases");
      setTimeout(() => page.cases.search.focus());
    },
    "?": show_help,
    j: () => page.view() === "cases" && page.cases.table.move(1),
    k: () => page.view() === "cases" && page.cases.table.move(-1),
    n: () => document.querySelector(".neighbours [rel=next]")?.click(),
    p: () => document.querySelector(".neighbours [rel=prev]")?.click(),
    Escape: () => page.view() !== "cases" && page.back(),
  };
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape" && event.target === page.cases.search) {
      event.target.blur();
      return;
    }
    if (is_typing(event.target) || !keys_enabled()) return;
    const number = Number(event.key);
    if (number >= 1 && number <= page.views.length) location.hash = hash_of(page.views[number - 1]);
    else if (actions[event.key]) actions[event.key]();
    else return;
    event.preventDefault();
  });
}
