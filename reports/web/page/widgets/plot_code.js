// SPDX-License-Identifier: GPL-3.0-or-later
// The bundle that draws plots, read by the page when the first plot comes into view.
import { svg_of, svg_width, view_of } from "../../plots/draw.js";

globalThis.stiction_plot = { svg_of, svg_width, view_of };
