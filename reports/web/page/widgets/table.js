// SPDX-License-Identifier: GPL-3.0-or-later
// A table for many rows: beyond a few hundred only those in view are in the page. All rows have one
// height, which the style sheet sets.
import { h, replace } from "../dom.js";

const MOST_PLAIN = 300;
const MARGIN = 12; // rows above and below the view

/**
 * `columns`: [{key, label, unit, class, term, sortable, cell(row)}]. `on_sort(key)` is told of headings,
 * `open(row)` of rows. Gives {element, show(rows, order), focus(place)}.
 */
export function big_table({ columns, label, on_sort, open }) {
  let rows = [];
  let first = 0;
  let last = 0;
  let active = -1;

  const headings = columns.map((column) => {
    const text = [column.label, column.unit && h("span", { class: "unit" }, ` ${column.unit}`)];
    const content = column.sortable
      ? h(
          "button",
          { type: "button", "data-term": column.term, onclick: () => on_sort(column.key) },
          text,
          h("span", { class: "arrow", "aria-hidden": "true" }),
        )
      : text;
    return h("th", { scope: "col", role: "columnheader", class: column.class }, content);
  });
  const above = h(
    "tr",
    { class: "spacer", "aria-hidden": "true" },
    h("td", { colspan: columns.length }),
  );
  const below = h(
    "tr",
    { class: "spacer", "aria-hidden": "true" },
    h("td", { colspan: columns.length }),
  );
  const body = h("tbody", { role: "rowgroup" });
  const table = h(
    "table",
    { class: "big", role: "table", "aria-label": label },
    h("thead", { role: "rowgroup" }, h("tr", { role: "row" }, headings)),
    body,
  );
  const element = h(
    "div",
    { class: "table-scroll", tabindex: "0", role: "region", "aria-label": label },
    table,
  );

  function row_element(row, place) {
    const cells = columns.map((column) =>
      h("td", { role: "cell", class: column.class }, column.cell(row)),
    );
    const line = h(
      "tr",
      { role: "row", "aria-rowindex": place + 2, class: place === active ? "active" : "" },
      cells,
    );
    line.stiction_place = place;
    return line;
  }

  function row_height() {
    const value = getComputedStyle(table).getPropertyValue("--row");
    return Number.parseFloat(value) || 32;
  }

  const is_plain = () => rows.length <= MOST_PLAIN;

  function render(force) {
    if (is_plain()) {
      if (force) replace(body, rows.map(row_element));
      return;
    }
    const height = row_height();
    const top = element.scrollTop;
    const visible = Math.ceil(element.clientHeight / height);
    const from = Math.max(0, Math.floor(top / height) - MARGIN);
    const to = Math.min(rows.length, from + visible + 2 * MARGIN);
    if (!force && from === first && to === last) return;
    [first, last] = [from, to];
    above.firstChild.style.setProperty("height", `${from * height}px`);
    below.firstChild.style.setProperty("height", `${(rows.length - to) * height}px`);
    const had_focus = body.contains(document.activeElement);
    replace(
      body,
      above,
      rows.slice(from, to).map((row, i) => row_element(row, from + i)),
      below,
    );
    if (had_focus) line_of(active)?.querySelector("a")?.focus({ preventScroll: true });
  }

  const line_of = (place) => [...body.children].find((line) => line.stiction_place === place);

  function focus(place) {
    if (rows.length === 0) return;
    active = Math.max(0, Math.min(rows.length - 1, place));
    if (!is_plain()) {
      const height = row_height();
      const top = active * height;
      const view = element.clientHeight - 2 * height;
      if (top < element.scrollTop) element.scrollTop = top;
      else if (top > element.scrollTop + view) element.scrollTop = top - view;
    }
    render(true);
    const line = line_of(active);
    line?.querySelector("a")?.focus({ preventScroll: !is_plain() });
    if (is_plain()) line?.scrollIntoView({ block: "nearest" });
  }

  let scheduled = false;
  element.addEventListener("scroll", () => {
    if (scheduled) return;
    scheduled = true;
    requestAnimationFrame(() => {
      scheduled = false;
      render(false);
    });
  });
  new ResizeObserver(() => render(false)).observe(element);
  body.addEventListener("click", (event) => {
    const line = event.target.closest("tr");
    if (line?.stiction_place !== undefined && !event.target.closest("a"))
      open(rows[line.stiction_place]);
  });
  body.addEventListener("focusin", (event) => {
    active = event.target.closest("tr")?.stiction_place ?? active;
  });
  element.addEventListener("keydown", (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 12, PageUp: -12 }[event.key];
    if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    focus(active + step);
  });

  return {
    element,
    focus,
    move: (step) => focus(active + step),
    show(list, order) {
      rows = list;
      active = -1;
      element.classList.toggle("virtual", !is_plain());
      table.setAttribute("aria-rowcount", rows.length + 1);
      columns.forEach((column, i) => {
        const sorted = order.replace(/^-/, "") === column.key;
        headings[i].setAttribute(
          "aria-sort",
          sorted ? (order.startsWith("-") ? "descending" : "ascending") : "none",
        );
      });
      element.scrollTop = 0;
      render(true);
    },
    // On paper all rows stand, up to what paper is for.
    expand(most) {
      replace(body, rows.slice(0, most).map(row_element));
      first = last = -1;
    },
    collapse: () => render(true),
  };
}
