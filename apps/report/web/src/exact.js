// Meshes and poses as they are: what queries run on. The drawn ones are rounded.
import { Packed } from './packed.js';

export function bytesOf(base64) {
  const raw = atob(base64);
  const bytes = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; ++k) {
    bytes[k] = raw.charCodeAt(k);
  }
  return bytes;
}

export const unpackDoubles = (bytes) => {
  const view = new DataView(bytes.buffer);
  return Float64Array.from({ length: bytes.length / 8 }, (_, k) => view.getFloat64(8 * k, true));
};

// Triangles corner by corner: 0 and the coordinates of a new vertex, or how many vertices ago it came.
export function unpackExact(bytes, floats) {
  const numbers = new Packed(bytes);
  const view = new DataView(bytes.buffer);
  const size = floats ? 4 : 8;
  const vertices = [];
  const triangles = [];
  let count = 0;
  while (!numbers.done) {
    const back = numbers.next();
    if (back > 0) {
      triangles.push(count - back);
      continue;
    }
    triangles.push(count++);
    for (let axis = 0; axis < 3; ++axis) {
      vertices.push(floats ? view.getFloat32(numbers.at, true) : view.getFloat64(numbers.at, true));
      numbers.at += size;
    }
  }
  return { vertices: Float64Array.from(vertices), triangles: Uint32Array.from(triangles) };
}
