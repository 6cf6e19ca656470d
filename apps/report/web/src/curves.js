// Where bodies cross: curves with a halo, as thick on every screen, however far away.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

const HALO = 4; // pixels around the ink
const NOTHING = new Float32Array(6);

// A line without length has no direction, and would not be drawn: the length it gets is not seen.
function withLength(lines, least) {
  const all = lines.slice();
  for (let at = 0; at < all.length; at += 6) {
    if (all[at] === all[at + 3] && all[at + 1] === all[at + 4] && all[at + 2] === all[at + 5]) {
      all[at] += least;
    }
  }
  return all;
}

// One set of lines. `through`: no wall hides it.
export class Curve {
  constructor(world, width, order, through) {
    this.width = width;
    const material = (linewidth) => new LineMaterial({
      linewidth, depthTest: !through, depthWrite: false, transparent: true, polygonOffset: !through, polygonOffsetFactor: -4, polygonOffsetUnits: -8,
    });
    this.parts = [material(width + HALO), material(width)].map((made, above) => {
      const part = new LineSegments2(new LineSegmentsGeometry(), made);
      part.renderOrder = order + above;
      part.frustumCulled = false;
      part.visible = false;
      world.add(part);
      return part;
    });
  }

  // Six floats a line.
  show(lines, size) {
    const some = lines.length > 0;
    const positions = some ? withLength(lines, 1e-6 * size) : NOTHING;
    this.parts[0].geometry.dispose();
    const geometry = new LineSegmentsGeometry().setPositions(positions);
    for (const part of this.parts) {
      part.geometry = geometry;
      part.visible = some;
    }
  }

  // Thinner in a picture that is narrower than 700 pixels.
  fit(picture) {
    const share = Math.min(1, Math.max(0.5, picture / 700));
    this.parts[0].material.linewidth = share * (this.width + HALO);
    this.parts[1].material.linewidth = share * this.width;
  }

  paint(ink, halo) {
    this.parts[0].material.color.copy(halo);
    this.parts[1].material.color.copy(ink);
  }
}

export function joined(arrays) {
  const all = new Float32Array(arrays.reduce((sum, a) => sum + a.length, 0));
  let at = 0;
  for (const array of arrays) {
    all.set(array, at);
    at += array.length;
  }
  return all;
}

export const trianglesOf = (corners) => {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
  return geometry;
};
