// Geometry that a surface of look.js draws its sharp edges on: triangles with corners of their own, and of each corner
// how far it is from the edges of its triangle that are drawn.
import * as THREE from 'three';

const SHARP = Math.cos(THREE.MathUtils.degToRad(28));
const NONE = 0xffffffff;

// Unit normals of triangles, three floats each; zeros where a triangle has no area.
function normalsOf(positions, indices) {
  const normals = new Float32Array(indices.length);
  for (let at = 0; at < indices.length; at += 3) {
    const [a, b, c] = [3 * indices[at], 3 * indices[at + 1], 3 * indices[at + 2]];
    const [ux, uy, uz] = [positions[b] - positions[a], positions[b + 1] - positions[a + 1], positions[b + 2] - positions[a + 2]];
    const [vx, vy, vz] = [positions[c] - positions[a], positions[c + 1] - positions[a + 1], positions[c + 2] - positions[a + 2]];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const size = Math.sqrt(x * x + y * y + z * z) || 1;
    normals[at] = x / size;
    normals[at + 1] = y / size;
    normals[at + 2] = z / size;
  }
  return normals;
}

// Which sides of triangles are drawn: those where surfaces bend, begin, or meet as more than two. Side k leads from corner
// k to the next one.
export function sharpSides(positions, indices) {
  const normals = normalsOf(positions, indices);
  const sharp = new Uint8Array(indices.length).fill(1); // until another triangle is found behind
  let room = 16;
  while (room < 2 * indices.length) {
    room *= 2;
  }
  const first = new Uint32Array(room).fill(NONE); // a side by its hash
  const met = new Uint8Array(indices.length); // how many other triangles it has
  for (let side = 0; side < indices.length; ++side) {
    const [from, to] = [indices[side], indices[side % 3 === 2 ? side - 2 : side + 1]];
    const [low, high] = from < to ? [from, to] : [to, from];
    let slot = (Math.imul(low, 0x9e3779b1) ^ Math.imul(high, 0x85ebca6b)) >>> 0;
    slot = (slot ^ (slot >>> 15)) & (room - 1);
    for (; first[slot] !== NONE; slot = (slot + 1) & (room - 1)) {
      const other = first[slot];
      const [start, end] = [indices[other], indices[other % 3 === 2 ? other - 2 : other + 1]];
      if ((start === low && end === high) || (start === high && end === low)) {
        break;
      }
    }
    const other = first[slot];
    if (other === NONE) {
      first[slot] = side;
      continue;
    }
    const [a, b] = [side - side % 3, other - other % 3];
    const bend = Math.abs(normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2]);
    sharp[side] = sharp[other] = met[other]++ > 0 || bend < SHARP ? 1 : 0;
  }
  return sharp;
}

// A mesh of the page. A corner is 1 away from the side that it does not lie on; from sides that are not drawn, all are.
export function creased({ positions, indices }) {
  const sharp = sharpSides(positions, indices);
  const places = new Float32Array(3 * indices.length);
  const away = new Uint8Array(4 * indices.length);
  for (let corner = 0; corner < indices.length; ++corner) {
    const [at, k] = [3 * indices[corner], corner % 3];
    places[3 * corner] = positions[at];
    places[3 * corner + 1] = positions[at + 1];
    places[3 * corner + 2] = positions[at + 2];
    for (let side = 0; side < 3; ++side) {
      away[4 * corner + side] = !sharp[corner - k + side] || (side + 2) % 3 === k ? 1 : 0;
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(places, 3));
  geometry.setAttribute('away', new THREE.BufferAttribute(away, 4));
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  return geometry;
}
