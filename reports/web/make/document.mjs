// SPDX-License-Identifier: GPL-3.0-or-later
// A document for print: one HTML file without JavaScript.
import { createHash } from "node:crypto";
import { escaped, markup_of } from "./markup.mjs";

/** `body`: trees of elements (sketch/tree.js), one after the other. */
export function document_html(title, style, body) {
  const hash = createHash("sha256").update(style).digest("base64");
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'sha256-${hash}'; img-src data:; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="referrer" content="no-referrer">
<link rel="icon" href="data:,">
<title>${escaped(title)}</title>
<style>${style}</style>
</head>
<body>
<main>
${body.map(markup_of).join("\n")}
</main>
</body>
</html>
`;
}
