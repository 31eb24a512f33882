// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the summary, which its table and its plot share.
import { is_bad, is_expected } from "./verdict.js";

const MOST_FAMILIES = 40;
const ROOMY = 20; // as many families stand on one screen in rows of ordinary height

/** Whether rows are set closely, so that all of them stand on one screen. */
export const is_dense = (families) => families > ROOMY;

/** px */
export const row_height = (families) => (is_dense(families) ? 18 : 26);

/**
 * The families to show of `families`, each with what verdicts_of(family) gives: those that fail first,
 * then those that fall short as expected, else as they come.
 */
export function overview_rows(families, verdicts_of) {
  const place = new Map(
    families.map((family) => {
      const verdicts = verdicts_of(family);
      return [family, verdicts.some(is_bad) ? 0 : verdicts.some(is_expected) ? 1 : 2];
    }),
  );
  return [...families].sort((a, b) => place.get(a) - place.get(b)).slice(0, MOST_FAMILIES);
}
