// Motions of a page: at which steps they are shown, and where the law puts the body. A motion has three steps, its
// start, the moment that is shown first, and its end; times lie between them.
import * as THREE from 'three';

const STEPS = 3;

// The step of motion k at a part t of the way.
export function stepAt({ moment }, k, t) {
  const share = t < moment ? t / moment : 1 + (moment < 1 ? (t - moment) / (1 - moment) : 0);
  return STEPS * k + share;
}

// The part of the way at a step of motion k.
export function partAt({ moment }, k, step) {
  const share = step - STEPS * k;
  return share < 1 ? share * moment : moment + (share - 1) * (1 - moment);
}

const mixed = (from, to, t) => from.map((value, axis) => value + t * (to[axis] - value));

// The rotation of q0 + t (q1 - q0), made of length 1, and the middle of the body, at a part t of the way.
export function poseOn({ way, turns, arm }, t, place, turn) {
  turn.fromArray(mixed(turns[0], turns[1], t)).normalize();
  place.fromArray(arm).applyQuaternion(turn).add(new THREE.Vector3().fromArray(mixed(way[0], way[1], t)));
}

// Where the body is, in the form of poses of a scene.
export class MotionPoses {
  constructor(poses, motions) {
    this.poses = poses;
    this.motions = motions;
    this.rank = poses.rank;
  }

  still(body, place, turn) { this.poses.still(body, place, turn); }

  at(body, step, place, turn) {
    const k = Math.min(this.motions.length - 1, Math.floor(step / STEPS));
    poseOn(this.motions[k], partAt(this.motions[k], k, step), place, turn);
  }
}
