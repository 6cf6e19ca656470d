// Where bodies are: those that stand still, and those that move, between the steps that the page
// holds.
import * as THREE from 'three';

const NUMBERS = 7; // place, then x y z w of the turning

export class Poses {
  constructor(scene) {
    this.scene = scene;
    this.rank = []; // of each body among those that move, or that stand still
    const seen = [0, 0];
    scene.bodies.moves.forEach((moves) => this.rank.push(seen[moves]++));
    this.later = new THREE.Vector3();
    this.laterTurn = new THREE.Quaternion();
  }

  still(body, place, turn) {
    const at = NUMBERS * this.rank[body];
    place.fromArray(this.scene.still, at);
    turn.fromArray(this.scene.still, at + 3);
  }

  // Number of the last kept step that is not after `step`.
  keptBefore(step) {
    const { kept } = this.scene.steps;
    let low = 0;
    let high = kept.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (kept[middle] <= step) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  at(body, step, place, turn) {
    const { kept, smooth } = this.scene.steps;
    const k = this.keptBefore(step);
    const at = NUMBERS * (k * this.scene.moving + this.rank[body]);
    place.fromArray(this.scene.poses, at);
    turn.fromArray(this.scene.poses, at + 3);
    if (smooth && k + 1 < kept.length && step > kept[k]) {
      const share = (step - kept[k]) / (kept[k + 1] - kept[k]);
      const next = at + NUMBERS * this.scene.moving;
      place.lerp(this.later.fromArray(this.scene.poses, next), share);
      turn.slerp(this.laterTurn.fromArray(this.scene.poses, next + 3), share);
    }
    turn.normalize();
  }
}
