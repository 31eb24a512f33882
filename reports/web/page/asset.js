// SPDX-License-Identifier: GPL-3.0-or-later
// Data and code that stand in the page as inert elements (make/assets.mjs) and are read when needed.

const loading = new Map();

function element_of(name) {
  const element = document.querySelector(`script[data-asset="${name}"]`);
  if (!element) throw new Error(`the page holds no part "${name}": the file is damaged or cut off`);
  return element;
}

// A plain loop: Uint8Array.from() with a function takes ten times as long, and that is most of a large page's start.
function decoded(text) {
  const signs = atob(text);
  const bytes = new Uint8Array(signs.length);
  for (let i = 0; i < signs.length; ++i) bytes[i] = signs.charCodeAt(i);
  return bytes;
}

async function unpacked(element) {
  const packed = decoded(element.textContent);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

function once(key, load) {
  if (!loading.has(key)) loading.set(key, load());
  return loading.get(key);
}

/** Bytes of an asset, as an ArrayBuffer. */
export const bytes_of = (name) => once(`bytes ${name}`, () => unpacked(element_of(name)));

/** A JSON asset's value. */
export function json_of(name) {
  return once(`json ${name}`, async () => {
    const element = element_of(name);
    if (element.dataset.encoding === "json") return JSON.parse(element.textContent);
    return JSON.parse(new TextDecoder().decode(await unpacked(element)));
  });
}

/** Runs a code asset, whose hash the page's policy allows, and gives what it left in `global_name`. */
export function code_of(name, global_name) {
  return once(`code ${name}`, async () => {
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(await unpacked(element_of(name)));
    document.head.append(script);
    const code = globalThis[global_name];
    if (!code) throw new Error(`the browser refused the page's part "${name}"`);
    return code;
  });
}
