// SPDX-License-Identifier: GPL-3.0-or-later
// The bundle with three.js, read by the page when the first recording comes into view.
import { make_scene } from "./scene.js";

globalThis.stiction_player = { make_scene };
