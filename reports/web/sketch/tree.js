// SPDX-License-Identifier: GPL-3.0-or-later
// Elements as plain data, which the page makes DOM of (page/dom.js) and the manual text (make/markup.mjs).
// Children are elements and strings; a string is text, whatever it holds.

const wanted = (child) => child !== null && child !== undefined && child !== false && child !== "";

/** e("line", {x1: 0}, "text", [more]). */
export const e = (tag, attributes = {}, ...children) => ({
  tag,
  attributes,
  children: children.flat(Infinity).filter(wanted),
});
