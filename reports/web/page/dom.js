// SPDX-License-Identifier: GPL-3.0-or-later
// Elements from data. Text always goes in as text nodes: a record's string can never become markup.

const SVG = "http://www.w3.org/2000/svg";

function fill(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name === "style")
      for (const [key, entry] of Object.entries(value)) element.style.setProperty(key, entry);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(
    ...children
      .flat(Infinity)
      .filter((child) => child !== null && child !== undefined && child !== false && child !== ""),
  );
  return element;
}

/** h("a", {href: "#summary"}, "text", node, [more]). */
export const h = (tag, attributes = {}, ...children) =>
  fill(document.createElement(tag), attributes, children);

export const svg = (tag, attributes = {}, ...children) =>
  fill(document.createElementNS(SVG, tag), attributes, children);

export const replace = (element, ...children) =>
  element.replaceChildren(...children.flat(Infinity).filter(Boolean));

/** Text with a chance to break a long path-like name at its slashes. */
export function breakable(text) {
  return text.split(/(?<=[/=])/).flatMap((part, i) => (i === 0 ? [part] : [h("wbr"), part]));
}

/** A tree of sketch/tree.js as an element; what stands in an <svg> is one too. */
export function from_tree(node, within = false) {
  if (typeof node !== "object") return document.createTextNode(node);
  const { tag, attributes, children } = node;
  const is_svg = within || tag === "svg";
  return (is_svg ? svg : h)(
    tag,
    attributes,
    children.map((child) => from_tree(child, is_svg)),
  );
}
