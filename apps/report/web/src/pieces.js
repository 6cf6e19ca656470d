// The piece of a mesh that is meant by a place on it.
import * as THREE from 'three';

const inBox = (corners, place, reach) => [0, 1, 2].every((axis) => {
  const values = corners.map((corner) => corner.getComponent(axis));
  return Math.min(...values) <= place.getComponent(axis) + reach && Math.max(...values) >= place.getComponent(axis) - reach;
});

// The corners of the triangles, none farther away than `reach`, that hang together with the one nearest to the place.
export function pieceAt({ positions, indices }, place, reach) {
  const near = []; // triangles
  const [found, at] = [new THREE.Triangle(), new THREE.Vector3()];
  let [nearest, least] = [-1, Infinity];
  for (let corner = 0; corner < indices.length; corner += 3) {
    const corners = [found.a, found.b, found.c].map((vector, k) => vector.fromArray(positions, 3 * indices[corner + k]));
    if (inBox(corners, place, reach)) {
      const away = found.closestPointToPoint(place, at).distanceToSquared(place);
      [nearest, least] = away < least ? [near.length, away] : [nearest, least];
      near.push(indices.subarray(corner, corner + 3));
    }
  }
  const keys = near.map((corners) => [...corners].map((vertex) => positions.subarray(3 * vertex, 3 * vertex + 3).join()));
  const around = new Map(); // triangles at a place
  keys.forEach((places, n) => places.forEach((key) => (around.get(key) ?? around.set(key, []).get(key)).push(n)));
  const piece = new Set(nearest < 0 ? [] : [nearest]);
  for (const n of piece) {
    keys[n].forEach((key) => around.get(key).forEach((other) => piece.add(other)));
  }
  return Uint32Array.from([...piece].flatMap((n) => [...near[n]]));
}
