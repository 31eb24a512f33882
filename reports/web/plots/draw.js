// SPDX-License-Identifier: GPL-3.0-or-later
// The one way to draw: Vega-Lite specification → Vega view, in the page and, without a browser, to SVG.
// Expressions are interpreted, not compiled to code: the page's policy forbids eval.
import { defaultLocale, parse, View, Warn } from "vega";
import { expressionInterpreter } from "vega-interpreter";
import { compile } from "vega-lite";
import { late_tips } from "./late_tips.js";
import { is_of_panels, parts_of, sized_panels, with_parts } from "./panel_size.js";
import { painted, PALETTES } from "./palette.js";

const FONT = "system-ui, -apple-system, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";

// As many of a legend's entries stand in a row as there is room for; names are the literals of the
// labels' expressions.
function legend_columns(spec, width) {
  const channels = parts_of(spec).flatMap(({ encoding }) => Object.values(encoding ?? {}));
  const names = channels.flatMap(
    ({ legend }) => legend?.labelExpr?.match(/"[^"]*"/g) ?? legend?.values ?? [],
  );
  const letters = names.reduce(
    (most, name) => Math.max(most, name.replace(/\\u.{4}/g, "x").length - 2),
    0,
  );
  return Math.max(1, Math.floor(width / (6.5 * Math.min(letters, 50) + 44)));
}

function config_of(colours, width, columns) {
  const text = {
    labelFont: FONT,
    titleFont: FONT,
    labelColor: colours.$muted,
    titleColor: colours.$ink,
  };
  return {
    background: null,
    font: FONT,
    view: { stroke: null },
    mark: { aria: false },
    axis: {
      ...text,
      aria: false,
      labelFontSize: 11,
      titleFontSize: 12,
      titleFontWeight: 500,
      gridColor: colours.$grid,
      domainColor: colours.$axis,
      tickColor: colours.$axis,
      titlePadding: 8,
      labelLimit: Math.min(300, 0.46 * width),
    },
    legend: {
      ...text,
      aria: false,
      orient: "top",
      columns,
      title: null,
      labelFontSize: 12,
      labelLimit: Math.min(320, 0.8 * width),
      symbolStrokeWidth: 2,
    },
    header: { ...text, labelColor: colours.$ink, labelFontSize: 11.5 },
    title: {
      aria: false,
      color: colours.$ink,
      font: FONT,
      fontSize: 13,
      fontWeight: 600,
      anchor: "start",
    },
    text: { font: FONT, fontSize: 11 },
    range: {
      category: [
        colours.$s0,
        colours.$s1,
        colours.$s2,
        colours.$s3,
        colours.$s4,
        colours.$s5,
        colours.$s6,
      ],
    },
  };
}

// Marks are drawn as the data have them: Vega-Lite would sort what is coloured by name, the domain's last colour first.
const in_order = (spec) =>
  with_parts(spec, (part) => {
    const { type, scale } = part.encoding?.fill ?? part.encoding?.color ?? {};
    if (type !== "nominal" || !scale?.domain) return part;
    return { ...part, encoding: { order: { value: null }, ...part.encoding } };
  });

// Nothing is fetched, whatever a specification says.
const no_loader = {
  load: () => Promise.reject(new Error("plots load nothing")),
  sanitize: () => Promise.reject(new Error("plots link nowhere")),
  http: () => Promise.reject(new Error("plots load nothing")),
  file: () => Promise.reject(new Error("plots load nothing")),
};

const quiet = {
  level: () => quiet,
  error: () => quiet,
  warn: () => quiet,
  info: () => quiet,
  debug: () => quiet,
};

/**
 * A Vega view of a specification, `width` pixels in all. `on_tip(event, tip)` is told {title: text} of a mark that is
 * pointed at, and null when it no longer is.
 */
export function view_of(spec, theme, width, { on_tip, ...options } = {}) {
  const colours = PALETTES[theme];
  const { spec: late, tip_of } = late_tips(in_order(spec), defaultLocale().format(""));
  const plain = painted(late, colours);
  const sized = is_of_panels(spec)
    ? sized_panels(plain, width)
    : { ...plain, width, autosize: { type: "fit-x", contains: "padding" } };
  const { spec: vega } = compile(sized, {
    config: config_of(colours, width, legend_columns(spec, width)),
    logger: quiet,
  });
  const view = new View(parse(vega, undefined, { ast: true }), {
    expr: expressionInterpreter,
    loader: no_loader,
    logLevel: Warn,
    ...options,
  });
  view.tooltip((handler, event, item, place) =>
    on_tip?.(event, place ? tip_of(place, item.datum) : null),
  );
  return view;
}

/** Width of a plot's SVG file, px. */
export const svg_width = ({ wide }) => (wide ? 1000 : 640);

/** The SVG text of a specification. */
export async function svg_of(spec, theme = "light", width = 640) {
  const view = view_of(spec, theme, width, { renderer: "none" });
  const svg = await view.toSVG();
  view.finalize();
  return svg;
}
