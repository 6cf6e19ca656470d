// Numbers that take as few bytes as they need: seven bits a byte, the lowest first.

export class Packed {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }

  get done() { return this.at >= this.bytes.length; }

  next() {
    let value = 0;
    for (let unit = 1; ; unit *= 128) {
      const byte = this.bytes[this.at++];
      value += (byte & 127) * unit;
      if (!(byte & 128)) {
        return value;
      }
    }
  }

  // 0, 1, 2, 3, 4 are 0, -1, 1, -2, 2.
  signed() {
    const value = this.next();
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }
}

// A mesh, corner by corner: 0 and a vertex, as its difference from the one before, or how many
// vertices ago the corner's vertex came.
export function unpackMesh(bytes, triangles, step) {
  const numbers = new Packed(bytes);
  return { ...unpackNextMesh(numbers, triangles, step), parts: unpackParts(numbers, triangles) };
}

// Of each triangle, the number of its part plus 1, or 0; nothing where no row names a part.
function unpackParts(numbers, triangles) {
  if (numbers.done) {
    return undefined;
  }
  const parts = new Uint32Array(triangles);
  for (let at = 0; at < triangles;) {
    const [length, part] = [numbers.next(), numbers.next()];
    parts.fill(part, at, at + length);
    at += length;
  }
  return parts;
}

// The same where more follows.
export function unpackNextMesh(numbers, triangles, step) {
  const indices = new Uint32Array(3 * triangles);
  const positions = [];
  let [x, y, z, count] = [0, 0, 0, 0];
  for (let corner = 0; corner < indices.length; ++corner) {
    const back = numbers.next();
    if (back === 0) {
      x += numbers.signed();
      y += numbers.signed();
      z += numbers.signed();
      positions.push(x * step, y * step, z * step);
      indices[corner] = count++;
    } else {
      indices[corner] = count - back;
    }
  }
  return { positions: new Float32Array(positions), indices };
}

// Places and turnings, body after body, as one step after the other: seven floats for each body.
export function unpackPoses(bytes, moving, steps, unit, turns) {
  const numbers = new Packed(bytes);
  const poses = new Float32Array(7 * moving * steps);
  for (let body = 0; body < moving; ++body) {
    const now = new Float64Array(7);
    const change = new Float64Array(7);
    for (let k = 0; k < steps; ++k) {
      const at = 7 * (k * moving + body);
      for (let n = 0; n < 7; ++n) {
        const by = numbers.signed() + change[n];
        now[n] += by;
        change[n] = k === 0 ? 0 : by;
        poses[at + n] = n < 3 ? now[n] * unit : now[n] / turns;
      }
    }
  }
  return poses;
}

// Pairs of triangles: their numbers, then ends of the crossing and corners of both as 24 floats.
export function unpackPairs(bytes, count, unit) {
  const packed = new Packed(bytes);
  const numbers = new Uint32Array(2 * count);
  const points = new Float32Array(24 * count);
  const at = new Float64Array(3);
  for (let pair = 0; pair < count; ++pair) {
    numbers[2 * pair] = packed.next();
    numbers[2 * pair + 1] = packed.next();
    at.fill(0);
    for (let n = 0; n < 24; ++n) {
      at[n % 3] += packed.signed();
      points[24 * pair + n] = at[n % 3] * unit;
    }
  }
  return { numbers, points };
}

// Lines around a place, six floats each, of the next curve.
export function unpackLines(packed, count, place, unit) {
  const lines = new Float32Array(6 * count);
  const start = [0, 0, 0];
  for (let line = 0; line < count; ++line) {
    for (let n = 0; n < 3; ++n) {
      start[n] += packed.signed();
      lines[6 * line + n] = place[n] + start[n] * unit;
    }
    for (let n = 0; n < 3; ++n) {
      lines[6 * line + 3 + n] = place[n] + (start[n] + packed.signed()) * unit;
    }
  }
  return lines;
}
