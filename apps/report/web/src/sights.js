// From where a contact is seen: directions are tried, and that counts from which the most of it is not hidden.
import * as THREE from 'three';

const SAMPLES = 16; // places of a curve
const MOST = 20000; // triangles that may hide it
const OFF = 0.005; // of the way to the eye: surfaces that meet in a curve do not hide it
const RISES = [32, 50, 70]; // degrees
const TURNS = [0, 35, -35, 75, -75, 120, -120, 180];
const ON_BODY = 32; // places of a body
const MOST_HIDDEN = 0.5; // share of what is looked at
const TOO_LARGE = 10; // sizes of the other body: what is so large is where both are
const FAMILIAR = 0.004; // share of the samples that a direction may see less, for each step away from the present one

// Corners of the triangles of meshes that come near a place, nine floats each.
export function trianglesNear(meshes, middle, radius) {
  const found = [];
  const [a, b, c] = [0, 1, 2].map(() => new THREE.Vector3());
  const own = new THREE.Vector3();
  for (const { geometry, matrix } of meshes) {
    own.copy(middle).applyMatrix4(matrix.clone().invert());
    const { array } = geometry.getAttribute('position');
    for (let at = 0; at < array.length && found.length < 9 * MOST; at += 9) {
      let near = true;
      for (let axis = 0; axis < 3 && near; ++axis) {
        const [p, q, r] = [array[at + axis], array[at + 3 + axis], array[at + 6 + axis]];
        near = Math.min(p, q, r) <= own.getComponent(axis) + radius && Math.max(p, q, r) >= own.getComponent(axis) - radius;
      }
      if (near) {
        [a, b, c].forEach((corner, k) => {
          corner.fromArray(array, at + 3 * k).applyMatrix4(matrix);
          found.push(corner.x, corner.y, corner.z);
        });
      }
    }
  }
  return new Float32Array(found);
}

// Places of a curve, evenly taken, each in the middle of its line.
export function samplesOf(lines) {
  const count = Math.floor(lines.length / 6);
  return Array.from({ length: Math.min(SAMPLES, count) }, (_, n) => {
    const at = 6 * Math.floor((n + 0.5) * count / Math.min(SAMPLES, count));
    return new THREE.Vector3((lines[at] + lines[at + 3]) / 2, (lines[at + 1] + lines[at + 4]) / 2, (lines[at + 2] + lines[at + 5]) / 2);
  });
}

// Corners of a body, evenly taken.
export function placesOn({ geometry, matrix }) {
  const corners = geometry.getAttribute('position');
  return Array.from({ length: Math.min(ON_BODY, corners.count) }, (_, n, count = Math.min(ON_BODY, corners.count)) => (
    new THREE.Vector3().fromBufferAttribute(corners, Math.floor((n + 0.5) * corners.count / count)).applyMatrix4(matrix)));
}

// Whether a triangle is met on the way; in plain numbers, as there are millions of pairs to test.
// From Moeller, Trumbore 1997.
function isHidden({ origin, direction }, corners, far) {
  const { x: dx, y: dy, z: dz } = direction;
  const { x: ox, y: oy, z: oz } = origin;
  for (let k = 0; k < corners.length; k += 9) {
    const [ax, ay, az] = [corners[k], corners[k + 1], corners[k + 2]];
    const [ux, uy, uz] = [corners[k + 3] - ax, corners[k + 4] - ay, corners[k + 5] - az];
    const [vx, vy, vz] = [corners[k + 6] - ax, corners[k + 7] - ay, corners[k + 8] - az];
    const [px, py, pz] = [dy * vz - dz * vy, dz * vx - dx * vz, dx * vy - dy * vx];
    const size = ux * px + uy * py + uz * pz;
    const [sx, sy, sz] = [ox - ax, oy - ay, oz - az];
    const u = (sx * px + sy * py + sz * pz) / size;
    if (u >= 0 && u <= 1) {
      const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
      const v = (dx * qx + dy * qy + dz * qz) / size;
      const t = (vx * qx + vy * qy + vz * qz) / size;
      if (v >= 0 && u + v <= 1 && t > 0 && t < far) {
        return true;
      }
    }
  }
  return false;
}

// How many of the samples an eye at that distance in a direction sees.
export function seenFrom(direction, samples, distance, corners) {
  const ray = new THREE.Ray();
  return samples.filter((sample) => {
    ray.direction.copy(direction);
    ray.origin.copy(sample).addScaledVector(direction, OFF * distance);
    return !isHidden(ray, corners, distance);
  }).length;
}

// Directions around the present one, `away` level: the nearer to it, the earlier.
function directionsAround(away, up) {
  return RISES.flatMap((rise) => TURNS.map((turn) => {
    const [level, angle] = [away.clone().applyAxisAngle(up, THREE.MathUtils.degToRad(turn)), THREE.MathUtils.degToRad(rise)];
    return level.multiplyScalar(Math.cos(angle)).addScaledVector(up, Math.sin(angle));
  }));
}

// Directions at right angles to a segment but for some rise, those from above first.
function directionsAside(along, away, up) {
  const first = away.clone().addScaledVector(along, -away.dot(along));
  if (first.lengthSq() < 1e-6) {
    first.crossVectors(along, up);
  }
  first.normalize();
  return [0, 45, -45, 90, -90, 135, -135, 180].map((turn) => first.clone()
    .applyAxisAngle(along, THREE.MathUtils.degToRad(turn)).addScaledVector(up, 0.2).normalize())
    .sort((a, b) => (b.dot(up) > 0.1) - (a.dot(up) > 0.1));
}

// The direction from which most of the samples are seen; `along` is a segment that is looked at from aside.
export function clearDirection({ samples, distance, corners, away, up, along }) {
  const directions = along?.lengthSq() > 0 ? directionsAside(along.clone().normalize(), away, up) : directionsAround(away, up);
  let [best, most] = [directions[0], -Infinity];
  directions.forEach((direction, n) => {
    const score = seenFrom(direction, samples, distance, corners) / samples.length - FAMILIAR * n;
    if (score > most) {
      [best, most] = [direction, score];
    }
  });
  return best;
}

// The one of two bodies that hides most of the samples, or of the other body, in a direction: the eye should see through
// it. Undefined where at least half of all is seen.
export function hiderOf(pair, { direction, samples, distance, target }) {
  const sizes = pair.map(({ geometry }) => geometry.boundingSphere.radius);
  const hides = (body, places) => 1 - seenFrom(direction, places, distance, trianglesNear([body], target, distance)) / places.length;
  const found = pair.length < 2 ? [] : pair.map((body, side) => ({
    body, large: !body.isPart && sizes[side] > TOO_LARGE * sizes[1 - side], share: Math.max(hides(body, samples), hides(body, placesOn(pair[1 - side]))),
  })).filter(({ large, share }) => !large && share > MOST_HIDDEN);
  return found.sort((a, b) => b.share - a.share)[0]?.body;
}
