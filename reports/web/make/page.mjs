// SPDX-License-Identifier: GPL-3.0-or-later
// Page data + bundles → one HTML text. Nothing in it can reach the network: the policy allows only the
// scripts and the style sheet whose hashes it names.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { is_map } from "../model/map_kind.js";
import { asset_element, json_asset } from "./assets.mjs";

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

const escaped = (text) =>
  text.replace(
    /[&<>"']/g,
    (sign) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" })[sign],
  );

// What must not stand inside <script>, in strings of minified code.
const code_for_html = (code) =>
  code.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");

/** The bundles that build.mjs made, in `folder`. */
export function read_bundles(folder) {
  const read = (name) => readFileSync(join(folder, name), "utf8");
  return {
    page: code_for_html(read("page.js")),
    style: read("page.css"),
    plot: code_for_html(read("plot.js")),
    player: code_for_html(read("player.js")),
    licences: JSON.parse(read("licences.json")),
  };
}

function policy(bundles) {
  const scripts = [bundles.page, bundles.plot, bundles.player].map(hash).join(" ");
  return [
    "default-src 'none'",
    `script-src ${scripts}`,
    `style-src ${hash(bundles.style)}`,
    "img-src data: blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
}

// What the page is without JavaScript: the counts and where to find more.
function fallback(index) {
  const shown = index.runs.filter(({ role }) => role === "shown");
  const checks = Object.entries(index.check_counts)
    .map(([verdict, count]) => `${count} ${verdict}`)
    .join(", ");
  return `<noscript><p>${escaped(index.title)}: ${shown.reduce((sum, run) => sum + run.records, 0)} records, checks: ${checks}.
This page needs JavaScript; report.md in the run's folder has the same numbers.</p></noscript>`;
}

/**
 * Size-limited list of what is optional: [{element, size}]. Largest are left out first; gives the kept
 * elements and how many were left out.
 */
export function fit(fixed_size, optional, limit) {
  let size = fixed_size + optional.reduce((sum, one) => sum + one.size, 0);
  const left_out = new Set();
  for (const one of [...optional].sort((a, b) => b.size - a.size)) {
    if (size <= limit) break;
    size -= one.size;
    left_out.add(one);
  }
  return { kept: optional.filter((one) => !left_out.has(one)), left_out: left_out.size };
}

/** The page. `recordings`: [{name, bytes}]. */
export function html_page({ data, bundles, recordings, limit_bytes }) {
  const code = [
    asset_element("code/plot", Buffer.from(bundles.plot)),
    recordings.length > 0 ? asset_element("code/player", Buffer.from(bundles.player)) : "",
    json_asset("licences", bundles.licences),
  ];
  const records = data.parts.map((part, i) => json_asset(`records/${i}`, part.records()));
  const asset_of = (name, plots) => (plots.length > 0 ? json_asset(name, plots) : "");
  const families = data.families.flatMap(({ plots }, i) => [
    asset_of(
      `family/${i}`,
      plots.filter((plot) => !is_map(plot)),
    ),
    asset_of(`family/${i}/maps`, plots.filter(is_map)),
  ]);
  const comparison = data.comparison ? [json_asset("comparison", data.comparison)] : [];
  const stability = data.stability ? [json_asset("stability", data.stability)] : [];
  const optional = [
    ...data.parts.map((part, i) => ({
      kind: "plots",
      name: `plots/${i}`,
      element: json_asset(`plots/${i}`, part.plots()),
    })),
    ...recordings.map(({ name, bytes }) => ({
      kind: "recording",
      name: `frames/${name}`,
      element: asset_element(`frames/${name}`, bytes),
    })),
  ].map((one) => ({ ...one, size: one.element.length }));

  const needed = [...code, ...records, ...families, ...stability, ...comparison];
  const frame = bundles.page.length + bundles.style.length + JSON.stringify(data.index).length / 4;
  const { kept, left_out } = fit(
    frame + needed.reduce((sum, one) => sum + one.length, 0),
    optional,
    limit_bytes,
  );
  const warnings = [...data.index.warnings];
  if (left_out > 0) {
    warnings.push(
      `To keep the page below ${limit_bytes / 1e6} MB, ${left_out} of its ${optional.length} groups of ` +
        "series plots and recordings were left out, largest first. A higher --limit brings them back.",
    );
  }
  const index = { ...data.index, warnings, assets: kept.map(({ name }) => name) };
  const html = `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy(bundles)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="referrer" content="no-referrer">
<link rel="icon" href="data:,">
<title>${escaped(index.title)}</title>
<style>${bundles.style}</style>
</head>
<body>
${fallback(index)}
<div id="app"></div>
${json_asset("index", index)}${[...needed, ...kept.map(({ element }) => element)].join("")}
<script>${bundles.page}</script>
</body>
</html>
`;
  return { html, warnings };
}
