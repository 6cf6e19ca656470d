// What the page carries for moving bodies: models and poses as they are, taken from it when the first body is moved.
import { takeText } from './data.js';
import { bytesOf, unpackDoubles } from './exact.js';
import { number } from './words.js';
import { moved, poseOf } from './pose.js';

const NUMBERS = 12; // of a pose

// Why bodies cannot be moved on this page; empty where they can.
export function whyNot({ scene }) {
  const { live } = scene;
  if (live.models.length === 0) {
    return `the exact triangles of its models take more than the ${number(live.room / 1e6)} MB that a page has room for`;
  }
  const missing = [['WebAssembly', 'WebAssembly'], ['Worker', 'workers'], ['DecompressionStream', 'DecompressionStream']]
    .filter(([name]) => !(name in globalThis)).map(([, words]) => words);
  return missing.length > 0 ? `this browser has no ${missing.join(', ')}` : '';
}

export class LiveData {
  constructor({ scene }) {
    this.scene = scene;
    this.poses = unpackDoubles(bytesOf(takeText('exact-poses')));
    this.models = scene.live.models.map(({ floats }, k) => ({ floats, block: takeText(`exact-${k}`) }));
    this.module = takeText('module');
    this.rank = []; // of each body among those that stand still, or that move
    const seen = [0, 0];
    scene.bodies.moves.forEach((moves) => this.rank.push(seen[moves]++));
    [this.still, this.moving] = seen;
  }

  // The pose of a body at a step, as it is; null where the page has only a rounded one.
  exact(body, step) {
    const { bodies, live, steps } = this.scene;
    const k = bodies.moves[body] ? steps.kept.indexOf(step) : 0;
    if (bodies.moves[body] && (k < 0 || !live.movers)) {
      return null;
    }
    const at = bodies.moves[body] ? this.still + k * this.moving + this.rank[body] : this.rank[body];
    return this.poses.slice(NUMBERS * at, NUMBERS * (at + 1));
  }

  middle(body) {
    return this.scene.live.models[this.scene.bodies.model[body]].middle;
  }

  // A pose as it is drawn: the place of the model's middle, in units of the page, and the turning x, y, z, w.
  poseDrawn(body, place, turn) {
    const { origin, scale } = this.scene;
    const middle = this.middle(body);
    const turned = poseOf(turn, [0, 0, 0]);
    const t = [0, 1, 2].map((axis) => origin[axis] + place[axis] / scale
      - (turned[4 * axis] * middle[0] + turned[4 * axis + 1] * middle[1] + turned[4 * axis + 2] * middle[2]));
    return poseOf(turn, t);
  }

  // How far around a body at a pose all exact triangles are on the page; negative where some at it may be missing. The
  // body is taken as the ball around its middle.
  known(body, pose, radius) {
    const { near } = this.scene.live;
    if (near.length === 0) {
      return Infinity;
    }
    const middle = moved(pose, this.middle(body));
    const around = near.map((box) => Math.min(...middle.flatMap((at, axis) => [at - box[axis], box[axis + 3] - at])));
    const rounding = 1e-9 * (radius + Math.hypot(...middle));
    return Math.max(...around) - radius - rounding;
  }

  // A point of the scene, in units of the page.
  onPage(at) {
    const { origin, scale } = this.scene;
    return at.map((value, axis) => (value - origin[axis]) * scale);
  }
}
