// SPDX-License-Identifier: GPL-3.0-or-later
// The box that tells what a mark of a plot stands for, or what a word means.
import { h, replace } from "../dom.js";

const box = h("div", { class: "tip", hidden: true, "aria-hidden": "true" });

/** Tells {name: text} beside where a pointer is. */
export function show_tip(event, texts) {
  if (!box.isConnected) document.body.append(box);
  replace(
    box,
    Object.entries(texts)
      .filter(([, text]) => text !== "")
      .map(([name, text]) => h("div", {}, h("span", { class: "tip-name" }, `${name} `), text)),
  );
  place(event);
}

/** Tells `text` beside an element. */
export function show_tip_at(element, text) {
  if (!box.isConnected) document.body.append(box);
  replace(box, text);
  const { left, bottom } = element.getBoundingClientRect();
  place({ clientX: left - 14, clientY: bottom - 14 });
}

function place({ clientX, clientY }) {
  box.hidden = false;
  const { width, height } = box.getBoundingClientRect();
  const left = Math.max(4, Math.min(clientX + 14, innerWidth - width - 8));
  const top = clientY + 18 + height > innerHeight ? clientY - height - 10 : clientY + 18;
  box.style.setProperty("transform", `translate(${left}px, ${top}px)`);
}

export function hide_tip() {
  box.hidden = true;
}
