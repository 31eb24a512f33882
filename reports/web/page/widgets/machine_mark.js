// SPDX-License-Identifier: GPL-3.0-or-later
// On which machines something was timed, where a view shows several.
import { letters_sentence } from "../../model/machine.js";
import { h } from "../dom.js";

/** Behind a CPU time: "A" or "A + B"; nothing for "". */
export const machine_mark = (letters) =>
  letters ? [" ", h("span", { class: "machine" }, letters)] : "";

/** Which machines the letters of a view are; null below two. */
export function machines_note(letters) {
  const sentence = letters_sentence(letters.filter(Boolean));
  return sentence ? h("p", { class: "machines-note" }, sentence) : null;
}
