// Where the eye stands to see all of something.
import * as THREE from 'three';

const MARGIN = 0.06; // of the picture, on each side
const BUTTONS = 56; // pixels above it

// The eye that looks against `toward` and sees all places, as near as that allows, and what it looks at.
export function fittedEye(places, toward, camera, height) {
  const ahead = toward.clone().negate();
  const right = new THREE.Vector3().crossVectors(ahead, camera.up).normalize();
  const up = new THREE.Vector3().crossVectors(right, ahead);
  const half = Math.tan(THREE.MathUtils.degToRad(camera.fov / 2));
  const [side, below] = [(1 - 2 * MARGIN) * half * camera.aspect, (1 - 2 * MARGIN) * half];
  const above = half * Math.max(0.2, 1 - 2 * MARGIN - 2 * Math.min(0.25, BUTTONS / Math.max(1, height)));
  // Along an axis of the picture: how near the eye may come, and where it then is, from the slopes to both sides.
  const along = (axis, low, high) => {
    const most = Math.max(...places.map((at) => at.dot(axis) - high * at.dot(ahead)));
    const least = Math.min(...places.map((at) => at.dot(axis) + low * at.dot(ahead)));
    return { depth: (least - most) / (low + high), at: (depth) => (most + high * depth + least - low * depth) / 2 };
  };
  const [across, upright] = [along(right, side, side), along(up, below, above)];
  const depth = Math.min(across.depth, upright.depth);
  const eye = right.multiplyScalar(across.at(depth)).addScaledVector(up, upright.at(depth)).addScaledVector(ahead, depth);
  const middle = new THREE.Box3().setFromPoints(places).getCenter(new THREE.Vector3());
  const target = eye.clone().addScaledVector(ahead, Math.max(1e-9, middle.sub(eye).dot(ahead)));
  return { eye, target };
}
