// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the frames files that reports/recording/frames.h describes. All sizes are checked against the bytes that
// are there before anything is allocated: a file may be cut off or made by someone else.

const MAGIC = "STFR";
const NEWEST_VERSION = 1;
const CONTACT_BYTES = 20;
const QUANTA = 65535;

const is_count = (value) => Number.isSafeInteger(value) && value >= 0 && value < 2 ** 32;
const is_triple = (value) =>
  Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);

function demand(condition, what) {
  if (!condition) throw new Error(`cannot be read: ${what}`);
}

// The unit vector against gravity at each frame; where nothing weighs, that of the next frame at which
// something does, else of the one before, else z.
function ups_of(gravity) {
  const ups = gravity.map((vector) => {
    const size = Math.hypot(...vector);
    return size > 1e-9 ? vector.map((x) => 0 - x / size) : null;
  });
  for (let i = ups.length - 2; i >= 0; --i) ups[i] ??= ups[i + 1];
  for (let i = 1; i < ups.length; ++i) ups[i] ??= ups[i - 1];
  return ups.map((up) => up ?? [0, 0, 1]);
}

function checked_header(bytes) {
  demand(bytes.byteLength >= 12, "it is cut off");
  const view = new DataView(bytes);
  demand(String.fromCharCode(...new Uint8Array(bytes, 0, 4)) === MAGIC, "it is no frames file");
  const version = view.getUint32(4, true);
  demand(version <= NEWEST_VERSION, `its version, ${version}, is newer than this program's`);
  const size = view.getUint32(8, true);
  demand(size % 4 === 0 && 12 + size <= bytes.byteLength, "it is cut off");
  let header;
  try {
    header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 12, size)));
  } catch {
    demand(false, "its header is not JSON");
  }
  const { bodies, planes, times, gravity, contacts, low, high, force } = header;
  demand(
    Array.isArray(bodies) &&
      bodies.every(
        (body) =>
          typeof body.name === "string" && is_count(body.vertices) && is_count(body.triangles),
      ),
    "its bodies are not as they must be",
  );
  demand(
    Array.isArray(planes) &&
      planes.every((plane) => is_triple(plane.point) && is_triple(plane.normal)),
    "its planes are not as they must be",
  );
  demand(
    Array.isArray(times) && times.length > 0 && times.every(Number.isFinite),
    "it has no frame",
  );
  demand(
    Array.isArray(gravity) && gravity.length === times.length && gravity.every(is_triple),
    "its gravity is not as it must be",
  );
  demand(
    Array.isArray(contacts) && contacts.length === times.length && contacts.every(is_count),
    "its contacts are not as they must be",
  );
  demand(
    is_triple(low) && is_triple(high) && Number.isFinite(force) && force >= 0,
    "its scales are no numbers",
  );
  return { header, start: 12 + size };
}

/**
 * {title, bodies: [{name, vertices, triangles: Uint32Array}], planes, times, ups, low, high, step, frame(i)};
 * `ups` are unit vectors against gravity, one a frame; positions are multiples of `step` (m, an axis). frame(i) gives {positions: Float32Array of 3 × vertices, contacts: [{position, normal_force,
 * friction_force, sticks}]}: m and N. Throws an Error that completes "The recording …".
 */
export function decode_frames(bytes) {
  const { header, start } = checked_header(bytes);
  const { bodies, planes, times, contacts: counts, low, high, force } = header;
  const vertices = bodies.reduce((sum, body) => sum + body.vertices, 0);
  const triangles = bodies.reduce((sum, body) => sum + body.triangles, 0);
  const contacts = counts.reduce((sum, count) => sum + count, 0);
  const expected = start + 12 * triangles + 6 * vertices * times.length + CONTACT_BYTES * contacts;
  demand(bytes.byteLength === expected, `it has ${bytes.byteLength} bytes instead of ${expected}`);

  const view = new DataView(bytes);
  let place = start;
  const meshes = bodies.map((body) => {
    const list = new Uint32Array(3 * body.triangles);
    for (let i = 0; i < list.length; ++i, place += 4) {
      list[i] = view.getUint32(place, true);
      demand(list[i] < body.vertices, "a triangle has a corner that is not there");
    }
    return { name: body.name, vertices: body.vertices, triangles: list };
  });

  // Absolute again: each frame stands as its difference to the one before.
  const width = 3 * vertices;
  const quanta = new Uint16Array(width * times.length);
  const contacts_start = [];
  for (let frame = 0; frame < times.length; ++frame) {
    for (let i = 0; i < width; ++i, place += 2) {
      const before = frame === 0 ? 0 : quanta[(frame - 1) * width + i];
      quanta[frame * width + i] = before + view.getUint16(place, true);
    }
    contacts_start.push(place);
    place += CONTACT_BYTES * counts[frame];
  }

  const step = low.map((value, axis) => (high[axis] - value) / QUANTA);
  const position = (quantum, axis) => low[axis] + quantum * step[axis];
  const triple = (read) => [read(0), read(1), read(2)];

  function contact_at(at) {
    const vector = (offset) =>
      triple((axis) => (view.getInt16(at + offset + 2 * axis, true) / 32767) * force);
    return {
      position: triple((axis) => position(view.getUint16(at + 2 * axis, true), axis)),
      normal_force: vector(6),
      friction_force: vector(12),
      sticks: view.getUint16(at + 18, true) === 1,
    };
  }

  return {
    title: typeof header.title === "string" ? header.title : "",
    bodies: meshes,
    planes,
    times,
    ups: ups_of(header.gravity),
    low,
    high,
    step,
    frame(i) {
      const positions = new Float32Array(width);
      for (let j = 0; j < width; ++j) positions[j] = position(quanta[i * width + j], j % 3);
      return {
        positions,
        contacts: Array.from({ length: counts[i] }, (_, k) =>
          contact_at(contacts_start[i] + CONTACT_BYTES * k),
        ),
      };
    },
  };
}
