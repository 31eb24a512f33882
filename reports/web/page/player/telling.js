// SPDX-License-Identifier: GPL-3.0-or-later
// What a player shows first: the recordings that tell most, and the moment at which they do.
import { margin } from "../../model/check_text.js";
import { is_expected } from "../../model/verdict.js";
import { place_at } from "./playback.js";

const MOST_SAMPLES = 80; // frames that are looked at
const VISIBLE = 1e-3; // of the bodies' size: less is not seen

// From the worst on: what broke off, failed, fell short, lies beyond a tolerance, holds; then by how much.
function badness({ record }) {
  const order = { error: 5, fail: 4 };
  const worst = Math.max(
    0,
    ...record.checks.map(margin).map((x) => (Number.isNaN(x) ? Infinity : x)),
  );
  const class_of = order[record.verdict] ?? (is_expected(record.verdict) ? 3 : worst > 1 ? 2 : 1);
  return [class_of, worst];
}

const is_worse = ([a, x], [b, y]) => a > b || (a === b && x > y);

/** The places of the worst and of the best of some recorded entries [{record}] of the runs shown. */
export function telling_pair(recorded, runs) {
  const all = recorded.map((_, place) => place);
  const shown = all.filter((place) => runs[recorded[place].record.run]?.role === "shown");
  const places = shown.length > 1 ? shown : all;
  const bad = recorded.map(badness);
  const worst = places.reduce((a, b) => (is_worse(bad[b], bad[a]) ? b : a));
  const others = places.filter((place) => place !== worst);
  // Of equals the last: the newest method stands there.
  const best = others.reduce((a, b) => (is_worse(bad[b], bad[a]) ? a : b), others[0] ?? worst);
  return [worst, best];
}

function samples_of(times) {
  const step = Math.max(1, Math.ceil(times.length / MOST_SAMPLES));
  return times.map((_, i) => i).filter((i) => i % step === 0 || i === times.length - 1);
}

function farthest(a, b) {
  let most = 0;
  for (let i = 0; i < a.length; i += 3)
    most = Math.max(most, Math.hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]));
  return most;
}

function size_of(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return Math.max(1e-12, Math.hypot(...low.map((x, axis) => high[axis] - x)));
}

// Where two recordings of the same bodies lie farthest apart; the first such moment.
function parting([a, b]) {
  const size = size_of(a.frame(0).positions);
  let best = { time: 0, apart: VISIBLE * size };
  for (const frame of samples_of(a.times)) {
    const time = a.times[frame];
    const other = place_at(b.times, time);
    const apart = farthest(a.frame(frame).positions, b.frame(other.frame).positions);
    if (apart > best.apart * 1.01) best = { time, apart };
  }
  return best.apart > VISIBLE * size ? best.time : null;
}

// Where a recording's bodies are fastest, when they visibly move at all.
function fastest(recording) {
  const frames = samples_of(recording.times);
  const size = size_of(recording.frame(0).positions);
  let best = { time: null, speed: 0 };
  let before = recording.frame(frames[0]).positions;
  let way = 0;
  for (let k = 1; k < frames.length; ++k) {
    const now = recording.frame(frames[k]).positions;
    const step = farthest(now, before);
    way = Math.max(way, step);
    const speed = step / (recording.times[frames[k]] - recording.times[frames[k - 1]]);
    if (speed > best.speed) best = { time: recording.times[frames[k]], speed };
    before = now;
  }
  return way > VISIBLE * size ? best.time : null;
}

/** The time at which recordings side by side differ most, or one moves fastest; else the end. */
export function telling_moment(recordings) {
  const same =
    recordings.length === 2 &&
    recordings[0].frame(0).positions.length === recordings[1].frame(0).positions.length;
  const end = Math.max(...recordings.map(({ times }) => times.at(-1)));
  return (same ? parting(recordings) : null) ?? fastest(recordings[0]) ?? end;
}
