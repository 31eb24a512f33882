// SPDX-License-Identifier: GPL-3.0-or-later
import { h } from "../dom.js";
import { show_help } from "./help.js";
import { theme_button } from "./theme.js";

/** The bar on top: {element, mark(view)}. `views`: [[name, word]]. */
export function page_header(title, views) {
  const links = views.map(([name, word]) => h("a", { href: `#${name}`, "data-view": name }, word));
  const element = h(
    "header",
    { class: "bar" },
    h(
      "a",
      {
        class: "skip",
        href: "#",
        onclick: (event) => {
          event.preventDefault();
          document.querySelector("main").focus();
        },
      },
      "Skip to the content",
    ),
    h("span", { class: "brand" }, "stiction"),
    h("span", { class: "page-title", title }, title),
    h("nav", { class: "views", "aria-label": "Views" }, links),
    h(
      "div",
      { class: "bar-tools" },
      theme_button(),
      h(
        "button",
        { type: "button", class: "quiet", onclick: show_help, title: "Keys (?)" },
        "Keys",
      ),
    ),
  );
  return {
    element,
    mark(view) {
      for (const link of links) {
        if (link.dataset.view === view) link.setAttribute("aria-current", "page");
        else link.removeAttribute("aria-current");
      }
    },
  };
}

/** What the reader must know first: broken lines, runs that were cut off. Null when there is nothing. */
export const warnings_box = (warnings) =>
  warnings.length === 0
    ? null
    : h(
        "aside",
        { class: "warnings", role: "status", "aria-label": "Warnings" },
        h(
          "ul",
          {},
          warnings.map((warning) => h("li", {}, warning)),
        ),
      );
