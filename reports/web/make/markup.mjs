// SPDX-License-Identifier: GPL-3.0-or-later
// A tree of elements (sketch/tree.js) as HTML text. Text is escaped: a record's string never becomes markup.

const ESCAPES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
export const escaped = (text) => String(text).replace(/[&<>"']/g, (sign) => ESCAPES[sign]);

const VOID = new Set(["br", "hr", "img", "meta", "link"]);

function attributes_text(attributes) {
  return Object.entries(attributes)
    .filter(([, value]) => value !== undefined && value !== null && value !== false)
    .map(([name, value]) => (value === true ? ` ${name}` : ` ${name}="${escaped(value)}"`))
    .join("");
}

export function markup_of(node) {
  if (typeof node !== "object") return escaped(node);
  const { tag, attributes, children } = node;
  const start = `<${tag}${attributes_text(attributes)}>`;
  return VOID.has(tag) ? start : `${start}${children.map(markup_of).join("")}</${tag}>`;
}
