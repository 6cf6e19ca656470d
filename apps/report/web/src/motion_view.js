// A body on its way: where it is, pale where it starts, touches and ends, and where the contact is.
import * as THREE from 'three';
import { Glass } from './glass.js';
import { solid } from './look.js';
import { partAt, poseOn, stepAt } from './motions.js';
import { pieceAt } from './pieces.js';
import { SceneView } from './scene_view.js';
import { placesOn } from './sights.js';

const [MOVER, OTHER] = [0, 1]; // bodies
const FAR_LARGER = 4; // sizes of the body: what is so large is around, and only the piece that is touched is B
const PIECE = 4; // sizes of the body, at most, from the contact to the end of that piece
const MEETING_SEEN = 20; // drawing order: above all other marks
const HIDDEN = 0.2;
const PARTS_OF_TRACE = 64;
const LEAST_SEEN = 3; // sizes of the body, around the way to the contact
const AROUND = 0.6; // of what is seen around a way, in its radii; the eye stands a few of them away

// A body at a part of a way.
class Ghost extends Glass {
  put(motion, t) {
    this.part = t;
    this.meshes.forEach(({ position, quaternion }) => poseOn(motion, t, position, quaternion));
  }
}

export class MotionView extends SceneView {
  // Called by the constructor of what is drawn.
  addChosen() {
    super.addChosen();
    this.motions = this.all.scene.motions;
    const geometry = this.bodies.geometries[this.all.scene.bodies.model[MOVER]];
    this.ghosts = [0, 1, 2].map(() => new Ghost(this.world, -2, {}, geometry));
    // The parts of the body that walls hide.
    this.behind = new THREE.Mesh(geometry, solid({ transparent: true, opacity: HIDDEN, depthWrite: false, depthFunc: THREE.GreaterDepth }));
    this.behind.frustumCulled = false;
    this.world.add(this.behind);
    this.traces = ['moves', 'was'].map((use) => this.addCurve(this.marks, 2, 1, false, use));
    const place = new THREE.BufferGeometry().setAttribute('position', new THREE.BufferAttribute(new Float32Array(3), 3));
    this.meeting = [15, 10].map((pixels, above) => this.addSpots(this.marks, place, pixels, MEETING_SEEN + above, {}));
  }

  paint(paper = false) {
    super.paint(paper);
    this.ghosts.forEach(({ ink }, n) => ink.color.copy(n === 1 ? this.colors.touch : this.colors.moves));
    ['halo', 'touch'].forEach((use, n) => this.meeting[n].material.color.copy(this.colors[use]));
  }

  get motion() { return this.motions[this.shown]; }

  // Where the contact is reached, of what is proved; never where there is none.
  get reached() { return this.motion?.upper ?? Infinity; }

  namedBodies() {
    return this.bodies.sizeOf(OTHER) > FAR_LARGER * this.bodies.sizeOf(MOVER) ? new Set([OTHER]) : super.namedBodies();
  }

  colorOf(body) {
    return body === MOVER && this.part > this.reached ? this.colors.was : super.colorOf(body);
  }

  // Shows motion `shown` at a part of its way.
  setPart(part) {
    this.part = part;
    this.ghosts.forEach((ghost, n) => ghost.show(ghost.part !== part && (n !== 1 || (this.motion.blocked && part !== 0))));
    poseOn(this.motion, part, this.behind.position, this.behind.quaternion);
    this.behind.material.color.copy(this.colorOf(MOVER));
    this.setStep(stepAt(this.motion, this.shown, part));
  }

  // Shows a motion at its moment.
  showMotion(k) {
    this.shown = k;
    const { motion } = this;
    this.part = motion.moment;
    if (motion.row >= 0) {
      this.showRow(motion.row, motion.row);
      this.showTouched();
      const { position } = this.meeting[0].geometry.attributes;
      position.array.set(motion.place);
      position.needsUpdate = true;
    } else {
      this.clearChosen();
      this.exact = null;
    }
    this.meeting.forEach((spot) => { spot.visible = motion.row >= 0; });
    [0, motion.moment, 1].forEach((t, n) => this.ghosts[n].put(motion, t));
    this.traces[0].show(this.traceOf(0, motion.moment), this.all.scene.size);
    this.traces[1].show(motion.moment < 1 ? this.traceOf(motion.moment, 1) : new Float32Array(0), this.all.scene.size);
    this.setPart(motion.moment);
  }

  // The way of the body's middle from one part to another, as lines.
  traceOf(from, to) {
    const places = this.placesOf(from, to, PARTS_OF_TRACE);
    return new Float32Array(places.slice(1).flatMap((place, n) => [...places[n], ...place]));
  }

  placesOf(from, to, count) {
    const [place, turn] = [new THREE.Vector3(), new THREE.Quaternion()];
    return Array.from({ length: count + 1 }, (_, n) => {
      poseOn(this.motion, from + (to - from) * n / count, place, turn);
      return place.clone();
    });
  }

  // Of what is around the way, the piece that is touched.
  showTouched() {
    const around = this.bodies.placed([]).find(({ body }) => body === OTHER);
    if (around && this.named.has(OTHER)) {
      const place = new THREE.Vector3().fromArray(this.motion.place).applyMatrix4(around.matrix.clone().invert());
      this.bodies.showSome(OTHER, (mesh) => pieceAt(mesh, place, PIECE * this.bodies.sizeOf(MOVER)));
    }
  }

  // Where the way up to the contact is seen from; the whole of it, where there is none.
  seeWay(soft = true) {
    const around = new THREE.Box3().setFromPoints(this.placesOf(0, this.motion.moment, 8)).getBoundingSphere(new THREE.Sphere());
    const size = this.bodies.sizeOf(MOVER);
    this.flyTo(around.center.toArray(), AROUND * Math.max(around.radius + size / 2, LEAST_SEEN * size), undefined, soft);
  }

  // The contact counts as much as the body.
  samplesSeen(target, along) {
    const body = placesOn(this.bodies.placed([MOVER]).find((placed) => placed.body === MOVER));
    return this.motion?.row >= 0 ? [...body, ...body.map(() => new THREE.Vector3().fromArray(this.motion.place))] : [...body, ...super.samplesSeen(target, along)];
  }

  mayBeClear(body) { return body !== MOVER; }

  seeContact() {
    const { motion, all } = this;
    this.setPart(motion.moment);
    this.flyTo(motion.place, all.contacts.reach(motion.row));
  }

  choose(k) {
    this.showMotion(k);
    this.seeWay();
  }

  showAtOnce(k) {
    this.showMotion(k);
    this.seeWay(false);
  }

  kept() { return { ...super.kept(), shown: this.shown, part: this.part }; }

  restore(kept) {
    this.showMotion(kept.shown);
    super.restore(kept);
    this.setPart(kept.part);
  }

  // The list counts motions, and a number over the picture would hide the contact.
  countedSpots() { return []; }

  setModel(k, mesh) {
    super.setModel(k, mesh);
    if (k === this.all.scene.bodies.model[MOVER]) {
      [...this.ghosts, this.behind].forEach((ghost) => { ghost.geometry = this.bodies.whole.get(k); });
    }
  }

  // Where the picture has the body, for scripts that look at the page.
  partDrawn() { return partAt(this.motion, this.shown, this.step); }
}
