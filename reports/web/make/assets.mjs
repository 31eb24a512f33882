// SPDX-License-Identifier: GPL-3.0-or-later
import { gzipSync } from "node:zlib";

const WORTH_PACKING = 4096; // bytes

/** JSON that can stand inside an HTML <script>: no "<", and no line separators. */
export function json_for_html(value) {
  const escapes = { "<": "\\u003c", "\u2028": "\\u2028", "\u2029": "\\u2029" };
  return JSON.stringify(value).replace(/[<\u2028\u2029]/g, (sign) => escapes[sign]);
}

// "<" never occurs in `text` of packed assets: base64.
function element(name, encoding, text) {
  return `<script type="text/plain" data-asset="${name}" data-encoding="${encoding}">${text}</script>\n`;
}

/** An inert element of the page that holds bytes (page/asset.js reads it). `name` is the program's own. */
export function asset_element(name, bytes) {
  return element(name, "gzip", gzipSync(bytes, { level: 6 }).toString("base64"));
}

/** As above for JSON; small ones stay readable. */
export function json_asset(name, value) {
  const text = json_for_html(value);
  return text.length < WORTH_PACKING
    ? element(name, "json", text)
    : asset_element(name, Buffer.from(text));
}
