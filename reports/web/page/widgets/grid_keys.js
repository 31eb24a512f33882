// SPDX-License-Identifier: GPL-3.0-or-later
// A table of links as one stop of the Tab key: arrow keys, Home and End go from link to link, and the
// last one visited is where the Tab key comes back to.

const STEPS = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] };

// The next link from a place in a step's direction, over cells without one.
function next_link(links, row, column, [down, right]) {
  for (let r = row + down, c = column + right; links[r] && c >= 0 && c < links[r].length;) {
    if (links[r][c]) return links[r][c];
    r += down;
    c += right;
  }
  return null;
}

/** Gives the table back. */
export function with_grid_keys(table) {
  const links = [...table.rows].map((row) => [...row.cells].map((cell) => cell.querySelector("a")));
  for (const link of links.flat()) link?.setAttribute("tabindex", "-1");
  let current = links.flat().find(Boolean);
  current?.setAttribute("tabindex", "0");
  table.addEventListener("focusin", ({ target }) => {
    const link = target.closest("a");
    if (!link) return;
    current.setAttribute("tabindex", "-1");
    link.setAttribute("tabindex", "0");
    current = link;
  });
  table.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const row = links.findIndex((line) => line.includes(current));
    const line = links[row] ?? [];
    let next = null;
    if (STEPS[event.key]) next = next_link(links, row, line.indexOf(current), STEPS[event.key]);
    else if (event.key === "Home") next = line.find(Boolean);
    else if (event.key === "End") next = line.findLast(Boolean);
    else return;
    event.preventDefault();
    next?.focus();
  });
  return table;
}
