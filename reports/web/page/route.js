// SPDX-License-Identifier: GPL-3.0-or-later
// What the page shows stands in its address, so that every view can be linked to:
// #summary, #cases&q=incline&verdict=fail,error&sort=-margin, #case=incline/threshold/mu=0.3, …

/** {view, value, options}: "#case=a&b=c" is {view: "case", value: "a", options: {b: "c"}}. */
export function parse_hash(hash) {
  const text = (encoded) => {
    try {
      return decodeURIComponent(encoded);
    } catch {
      return encoded;
    }
  };
  const [head, ...rest] = hash.replace(/^#/, "").split("&");
  const split = (part) => {
    const equals = part.indexOf("=");
    return equals < 0 ? [part, ""] : [part.slice(0, equals), text(part.slice(equals + 1))];
  };
  const [view, value] = split(head);
  return { view: view || "summary", value, options: Object.fromEntries(rest.map(split)) };
}

// Slashes and "=" stay readable; all that could end or split the address is encoded.
const encoded = (value) => encodeURIComponent(value).replace(/%2F/g, "/").replace(/%3D/g, "=");

export function hash_of(view, value = "", options = {}) {
  const rest = Object.entries(options)
    .filter(([, entry]) => entry !== "" && entry !== undefined)
    .map(([name, entry]) => `&${name}=${encoded(String(entry))}`);
  return `#${view}${value === "" ? "" : `=${encoded(value)}`}${rest.join("")}`;
}

export const case_hash = (name) => hash_of("case", name);
