// Where bodies cross: curves with a halo, as thick on every screen, however far away.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { chained } from './chains.js';

const HALO = 4; // pixels around the ink
const HIDDEN = 0.6; // of the width, behind walls
const DASH = 8; // pixels
const GAP = 7; // pixels
const PALE = 0.65; // opacity of dashes
const MANY = 300; // lines
const NOTHING = new Float32Array(6);
const NO_LINES = new Float32Array(0);

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

// Lines are brought nearer to the eye by their width: else the surfaces that cross in them would cover half of it.
const LIFTED = `
  vec4 held = position.y < 0.5 ? start : end;
  vec4 lifted = projectionMatrix * vec4(held.xyz * (1.0 - 1.5 * LIFT / (resolution.y * projectionMatrix[1][1])), 1.0);
  if (clip.w > 0.0) {
    clip.z = lifted.z / lifted.w * clip.w;
  }
  gl_Position = clip;`;

function lineMaterial(linewidth, lift, more) {
  const made = new LineMaterial({ linewidth, depthWrite: false, transparent: true, ...more });
  made.vertexShader = made.vertexShader.replace('gl_Position = clip;', LIFTED);
  made.defines.LIFT = lift.toFixed(1);
  return made;
}

// One set of lines. `through`: what walls hide of it is pale and dashed; else it is not seen.
export class Curve {
  constructor(world, width, order, through) {
    this.width = width;
    this.lines = NO_LINES;
    this.isSeen = true;
    const [halo, ink] = [width + HALO, width].map((wide) => lineMaterial(wide, width + HALO, {}));
    this.parts = [halo, ink];
    if (through) {
      this.parts.push(lineMaterial(HIDDEN * width, width + HALO, {
        dashed: true, dashSize: DASH, gapSize: GAP, depthFunc: THREE.GreaterDepth, opacity: PALE,
      }));
    }
    this.parts = this.parts.map((made, above) => {
      const part = new LineSegments2(new LineSegmentsGeometry(), made);
      part.renderOrder = order + (above + 1) % 3; // what is hidden comes first
      part.frustumCulled = false;
      part.visible = false;
      world.add(part);
      return part;
    });
  }

  // Six floats a line.
  show(lines, size) {
    const some = lines.length > 0;
    this.lines = lines;
    const positions = some ? withLength(lines, 1e-6 * size) : NOTHING;
    this.parts.forEach((part) => part.geometry.dispose());
    const geometry = new LineSegmentsGeometry().setPositions(positions);
    for (const part of this.parts) {
      part.geometry = geometry;
      part.visible = some;
    }
    if (this.parts[2] && some) {
      this.parts[2].geometry = new LineSegmentsGeometry().setPositions(chained(positions, 1e-5 * size));
      this.parts[2].computeLineDistances();
    }
  }

  // Behind what one sees through, hidden lines are whole and have the color of the others.
  setBehindGlass(behind) {
    if (this.parts[2]) {
      this.parts[2].material.dashed = !behind;
      this.parts[2].material.color.copy(behind ? this.parts[1].material.color : this.hidden);
    }
  }

  // Where drawing is slow, a camera that moves sees the ink of long curves alone.
  setCoarse(coarse) {
    const bare = coarse && this.lines.length > 6 * MANY;
    this.parts.forEach((part, k) => { part.visible = this.lines.length > 0 && this.isSeen && (k === 1 || !bare); });
  }

  // Dashes are as long on every screen: lengths are so many pixels where the eye looks.
  setScale(pixels) {
    if (this.parts[2]) {
      this.parts[2].material.dashScale = pixels;
    }
  }

  // Thinner in a picture that is narrower than 700 pixels.
  fit(picture) {
    const share = Math.min(1, Math.max(0.5, picture / 700));
    this.parts[0].material.linewidth = share * (this.width + HALO);
    this.parts[1].material.linewidth = share * this.width;
    if (this.parts[2]) {
      this.parts[2].material.linewidth = share * HIDDEN * this.width;
    }
  }

  paint(ink, halo, hidden) {
    this.parts[0].material.color.copy(halo);
    this.parts[1].material.color.copy(ink);
    this.hidden = hidden;
    this.setBehindGlass(this.parts[2]?.material.dashed === false);
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
