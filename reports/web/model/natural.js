// SPDX-License-Identifier: GPL-3.0-or-later

// A name as text and numbers, alternating.
function tokens_of(text) {
  const tokens = [];
  const numbers = /\d+(?:\.\d+)?(?:e[+-]?\d+)?/gi;
  let end = 0;
  for (const match of text.matchAll(numbers)) {
    tokens.push(text.slice(end, match.index), Number(match[0]));
    end = match.index + match[0].length;
  }
  tokens.push(text.slice(end));
  return tokens;
}

const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);

/** Sorts in place by `name_of`, numbers within names by value: dt=1e-4 before dt=1e-3. */
export function natural_sort(items, name_of) {
  const cache = new Map();
  const tokens = (text) => {
    if (!cache.has(text)) cache.set(text, tokens_of(text));
    return cache.get(text);
  };
  return items.sort((x, y) => {
    const [a, b] = [name_of(x), name_of(y)];
    if (a === b) return 0;
    const [left, right] = [tokens(a), tokens(b)];
    for (let i = 0; i < Math.min(left.length, right.length); ++i) {
      const order = compare(left[i], right[i]);
      if (order !== 0) return order;
    }
    return left.length - right.length || compare(a, b);
  });
}
