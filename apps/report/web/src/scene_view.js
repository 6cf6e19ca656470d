// Bodies at the steps of a scene, their contacts and gaps, and what is chosen of them.
import * as THREE from 'three';
import { Bodies } from './bodies.js';
import { joined, trianglesOf } from './curves.js';
import { GapLines } from './gaps.js';
import { clearDirection, hiderOf, samplesOf, trianglesNear } from './sights.js';
import { Spots } from './spots.js';
import { View } from './view.js';
import { NO_PART } from './words.js';

const AROUND = 4; // distance of the eye, in reaches of a contact
const LARGER = 0.8; // of the larger body's radius is seen around a contact
const WIDER = 1.25; // reaches at most, for that
const ALWAYS_SEEN = 10; // drawing order of what no wall may hide
const CURVE_SEEN = 6; // pixels: smaller curves are spots
const MOST_CURVES = 300; // drawn at a time, beside the chosen one

// Edges of triangles given by nine numbers each.
function edgesOf(corners) {
  const edges = [];
  for (let at = 0; at < corners.length; at += 9) {
    for (const [from, to] of [[0, 3], [3, 6], [6, 0]]) {
      edges.push(...corners.subarray(at + from, at + from + 3), ...corners.subarray(at + to, at + to + 3));
    }
  }
  return new Float32Array(edges);
}

export class SceneView extends View {
  constructor(canvas, all) {
    super(canvas, all, [0.25, 0.6, 0.45], [-0.5, 0.35, 0.85]);
    this.step = 0;
    this.exact = null; // a step, and the poses of two bodies at it: those of what is chosen
    this.chosenBodies = [];
    this.shownRow = -1;
    this.shownContact = -1;
    this.marks = new THREE.Group(); // contacts of the report, and what is chosen
    this.world.add(this.marks);
    this.bodies = new Bodies(this.world, all.scene);
    this.named = this.namedBodies();
    this.addCurves();
    this.addContacts();
    this.addChosen();
    this.gapLines = new GapLines(all);
    this.layers.push(this.gapLines);
    this.spotCounts = new Spots(this, () => this.countedSpots(), (spot) => this.isNow(spot));
    this.begin();
  }

  addCurves() {
    const { scene } = this.all;
    this.past = this.addCurve(this.marks, 2, 2, false, 'was');
    this.now = this.addCurve(this.marks, 3.5, 4, false);
    this.chosenCurve = this.addCurve(this.marks, 4, ALWAYS_SEEN + 5, true);
    this.shownCurves = '';
    // Where there is one step alone, all that the page holds of where the two cross.
    const lines = [];
    for (let n = 0; n < scene.contacts.pairs && scene.steps.count < 2; ++n) {
      lines.push(this.all.contacts.crossing(n));
    }
    this.addCurve(this.marks, 3, ALWAYS_SEEN + 3, true).show(joined(lines), scene.size);
  }

  // A spot a row: on its curve, or in the middle of what is known of it. Contacts at poses that have no
  // curves are at another place in each: a spot each.
  makeSpots() {
    const { rows, contacts, curves, scene } = this.all;
    const spots = [];
    const each = curves.count === 0 && scene.steps.count > 1;
    for (let k = 0; k < contacts.count && each; ++k) {
      spots.push({
        place: contacts.focus(k), row: contacts.row(k), contact: k, begin: contacts.begin(k), end: contacts.end(k),
      });
    }
    for (let r = 0; r < rows.count; ++r) {
      const curve = curves.ofRow.get(r);
      if (!each || rows.contacts(r).length === 0) {
        spots.push({
          place: curve === undefined ? rows.center(r) : curves.place(curve), row: r, contact: -1, curve, begin: rows.begin(r), end: rows.end(r),
        });
      }
    }
    return spots;
  }

  addContacts() {
    this.spotsAt = this.makeSpots();
    const count = this.spotsAt.length;
    const places = new THREE.BufferAttribute(Float32Array.from(this.spotsAt.flatMap(({ place }) => [...place])), 3);
    const size = count > 2000 ? 6 : 9;
    [this.haloColors, this.spotColors] = [size + 4, size].map((pixels, above) => {
      const ink = new THREE.BufferAttribute(new Float32Array(4 * count), 4);
      const geometry = new THREE.BufferGeometry().setAttribute('position', places).setAttribute('color', ink);
      this.addSpots(this.marks, geometry, pixels, ALWAYS_SEEN + above, { vertexColors: true });
      return ink;
    });
  }

  addChosen() {
    const fill = () => new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, transparent: true, opacity: 0.3, depthTest: false, fog: false });
    const line = (opacity) => new THREE.LineBasicMaterial({ depthTest: false, fog: false, transparent: true, opacity });
    this.chosenParts = [0, 1].map(() => ({
      mesh: new THREE.Mesh(new THREE.BufferGeometry(), fill()),
      edges: new THREE.LineSegments(new THREE.BufferGeometry(), line(0.3)),
    }));
    this.chosenParts.forEach(({ mesh, edges }, side) => {
      mesh.renderOrder = ALWAYS_SEEN + 2 - side; // what is touched is often the larger: below
      edges.renderOrder = ALWAYS_SEEN + 3;
      mesh.frustumCulled = edges.frustumCulled = false;
      mesh.visible = edges.visible = false;
      this.marks.add(mesh, edges);
    });
    this.box = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry(1, 1, 1)), line(1));
    this.box.renderOrder = ALWAYS_SEEN + 4;
    this.box.visible = this.box.frustumCulled = false;
    this.marks.add(this.box);
  }

  paint(paper = false) {
    super.paint(paper);
    this.chosenParts[0].mesh.material.color.copy(this.colors.moves);
    this.chosenParts[1].mesh.material.color.copy(this.colors.still);
    this.chosenParts.forEach(({ edges }) => edges.material.color.copy(this.colors.line));
    this.box.material.color.copy(this.colors.frame);
    this.placeBodies();
  }

  // Shows the bodies and contacts of a step.
  setStep(step) {
    this.step = step;
    this.gapLines.step = Math.floor(step);
    this.placeBodies();
    this.draw();
  }

  placeBodies() {
    this.bodies.partColor.copy(this.colors.still);
    this.bodies.place(this.step, this.exact?.step === this.step ? this.exact : null, (body) => this.colorOf(body));
    this.stage.changed();
  }

  // While the reader moves a body, contacts of the report are not drawn: they are those of other poses.
  setMoved(moved) {
    this.bodies.moved = moved;
    this.marks.visible = moved === null;
    this.setStep(this.step);
  }

  isNow({ begin, end }) {
    const now = Math.floor(this.step);
    return begin <= now && now <= end;
  }

  // Large curves are drawn, of the others spots.
  markContacts() {
    const { curves, scene } = this.all;
    const pixels = this.pixels();
    const at = new THREE.Vector3();
    const near = [];
    this.smallSpots = [];
    this.spotsAt.forEach((spot, n) => {
      const { curve, place, row } = spot;
      const distance = at.fromArray(place).distanceTo(this.camera.position);
      const large = curve !== undefined && this.all.rows.half(row).reduce((sum, half) => Math.max(sum, half), 0) * 2 * pixels > CURVE_SEEN * distance;
      if (large) {
        near.push({ spot, distance });
      }
      const active = this.isNow(spot);
      const color = active ? this.colors.touch : this.colors.was;
      const isCurve = large || curve === undefined;
      const hidden = row === this.shownRow && isCurve && this.all.rows.after(row) === 0; // a passage is a point: its spot stays
      if (row === this.shownRow && spot.curve !== undefined) {
        this.chosenCurve.isSeen = large; // from afar it is a spot
      }
      this.smallSpots.push(...(hidden || large ? [] : [spot]));
      for (const [ink, { r, g, b }] of [[this.spotColors, color], [this.haloColors, this.colors.halo]]) {
        ink.setXYZW(n, r, g, b, hidden || large ? 0 : active ? 1 : 0.6);
      }
    });
    this.spotColors.needsUpdate = this.haloColors.needsUpdate = true;
    if (curves.count === 0) {
      this.showCrossings();
      return;
    }
    const drawn = near.sort((a, b) => a.distance - b.distance).slice(0, MOST_CURVES).map(({ spot }) => spot).filter(({ row }) => row !== this.shownRow);
    const key = drawn.map((spot) => `${spot.curve}${this.isNow(spot) ? '!' : ''}`).join();
    if (key !== this.shownCurves) {
      this.shownCurves = key;
      const linesOf = (some) => joined(some.map(({ curve }) => curves.lines[curve]));
      this.now.show(linesOf(drawn.filter((spot) => this.isNow(spot))), scene.size);
      this.past.show(linesOf(drawn.filter((spot) => !this.isNow(spot))), scene.size);
    }
  }

  // Without curves: where the triangles of contacts cross that are known at this step.
  showCrossings() {
    const { contacts, scene } = this.all;
    if (scene.steps.count < 2 || this.shownCurves === String(Math.floor(this.step))) {
      return;
    }
    this.shownCurves = String(Math.floor(this.step));
    const lines = [];
    for (let k = 0; k < contacts.count; ++k) {
      for (let n = 0; n < contacts.pairCount(k) && this.isNow({ begin: contacts.begin(k), end: contacts.end(k) }); ++n) {
        lines.push(contacts.crossing(contacts.firstPair(k) + n));
      }
    }
    this.now.show(joined(lines), scene.size);
  }

  // What moves is A, of two that are chosen the second is B. A body whose parts rows name is what is around; of it the
  // chosen part is B.
  colorOf(body) {
    if (this.all.scene.bodies.moves[body]) {
      return body === this.chosenBodies[1] ? this.colors.still : this.colors.moves;
    }
    return this.named.has(body) ? this.colors.rest : body === this.chosenBodies[0] ? this.colors.moves : this.colors.still;
  }

  // Bodies among many whose parts rows name.
  namedBodies() {
    const { rows, scene } = this.all;
    const named = new Set();
    for (let r = 0; r < rows.count && scene.bodies.model.length > 2; ++r) {
      [rows.a(r), rows.b(r)].forEach((body, side) => {
        if (rows.part(r, side) !== NO_PART) {
          named.add(body);
        }
      });
    }
    return named;
  }

  // Shows contact k, or row r: the curve of its step of most pairs, or what is known of its first.
  // Says where to look, and how much around it is worth seeing.
  showRow(r, k) {
    const { contacts, rows, curves } = this.all;
    const curve = k < 0 ? curves.ofRow.get(r) : undefined;
    const members = k >= 0 ? [k]
      : [...rows.contacts(r)].filter((member) => contacts.begin(member) === rows.begin(r));
    this.chosenBodies = [rows.a(r), rows.b(r)];
    this.seeThrough(-1);
    this.bodies.showPart(rows.b(r), rows.part(r, 1));
    this.shownRow = r;
    this.shownContact = k;
    this.gapLines.chosen = -1;
    const first = members[0];
    if (curve !== undefined) {
      this.exact = { step: rows.mostStep(r), bodies: this.chosenBodies, poses: [0, 1].map((side) => curves.pose(curve, side)) };
    } else {
      this.exact = first === undefined ? null : {
        step: contacts.begin(first) + rows.after(r), bodies: [contacts.a(first), contacts.b(first)], poses: [0, 1].map((side) => contacts.pose(first, side)),
      };
    }
    const pairs = curve === undefined ? members.flatMap((member) => Array.from(
      { length: contacts.pairCount(member) }, (_, n) => contacts.firstPair(member) + n)) : [];
    const isPoint = rows.after(r) > 0;
    this.chosenCurve.isSeen = true;
    this.chosenCurve.show(curve === undefined ? joined(isPoint ? [] : pairs.map((n) => contacts.crossing(n))) : curves.lines[curve], this.all.scene.size);
    this.chosenParts.forEach(({ mesh, edges }, side) => {
      const seen = new Map();
      for (const n of pairs) {
        seen.set(contacts.triangleOf(n, side), contacts.corners(n, side));
      }
      const all = joined([...seen.values()]);
      mesh.geometry.dispose();
      edges.geometry.dispose();
      mesh.geometry = trianglesOf(all);
      edges.geometry = trianglesOf(edgesOf(all));
      mesh.visible = edges.visible = k >= 0 && all.length > 0; // of many triangles they would hide all else
    });
    this.frameRow(r, k < 0 && curve === undefined && pairs.length === 0);
    this.setStep(k >= 0 ? contacts.begin(k) + rows.after(r) : rows.moment(r));
    return k >= 0 ? { place: contacts.focus(k), reach: contacts.reach(k) } : this.sightOf(r);
  }

  sightOf(r) {
    const { curves, rows } = this.all;
    const curve = curves.ofRow.get(r);
    return curve === undefined ? { place: rows.center(r), reach: this.reachOf(r) }
      : { place: curves.place(curve), reach: this.wider(curves.reach(curve), rows.a(r), rows.b(r)) };
  }

  // So much around a contact that the larger of two bodies is known again, unless it is far larger than the other.
  wider(reach, a, b) {
    const larger = Math.max(this.bodies.sizeOf(a), this.bodies.sizeOf(b)) / 2;
    return Math.max(reach, Math.min(LARGER * larger, WIDER * reach));
  }

  choose(r, k) {
    const { place, reach } = this.showRow(r, k);
    this.flyTo(place, reach);
  }

  showAtOnce(r) {
    const { place, reach } = this.showRow(r, -1);
    this.flyTo(place, reach, undefined, false);
  }

  kept() {
    return {
      ...super.kept(), step: this.step, exact: this.exact, row: this.shownRow, contact: this.shownContact, gap: this.gapLines.chosen, bodies: this.chosenBodies, clear: this.bodies.clear, clearsPart: this.bodies.clearsPart,
    };
  }

  restore(kept) {
    if (kept.row >= 0) {
      this.showRow(kept.row, kept.contact);
    } else {
      this.clearChosen();
    }
    this.gapLines.chosen = kept.gap;
    this.exact = kept.exact;
    this.chosenBodies = kept.bodies;
    this.seeThrough(kept.clear, kept.clearsPart);
    this.setStep(kept.step);
    super.restore(kept);
  }

  // Nothing of the list is chosen.
  clearChosen() {
    this.chosenBodies = [];
    this.seeThrough(-1);
    this.bodies.showPart();
    this.shownRow = -1;
    this.shownContact = -1;
    this.box.visible = false;
    this.chosenParts.forEach(({ mesh, edges }) => { mesh.visible = edges.visible = false; });
    this.chosenCurve.show(new Float32Array(0), this.all.scene.size);
  }

  // Shows gap g and flies there.
  chooseGap(g) {
    const { gaps } = this.all;
    this.clearChosen();
    this.exact = { step: gaps.nearest(g), bodies: [gaps.a(g), gaps.b(g)], poses: [0, 1].map((side) => gaps.pose(g, side)) };
    this.gapLines.chosen = g;
    this.setStep(gaps.nearest(g));
    const [a, b] = [0, 1].map((side) => new THREE.Vector3().fromArray(gaps.point(g, side)));
    this.flyTo(gaps.middle(g), gaps.reach(g), b.sub(a));
  }

  flyTo(place, reach, along, soft = true) {
    this.framed = [place, reach, along]; // until the reader looks elsewhere
    const target = new THREE.Vector3().fromArray(place);
    const distance = Math.max(AROUND * this.narrow() * reach, 1e-5 * this.all.scene.size);
    const samples = this.samplesSeen(target, along);
    const direction = this.clearDirection(target, distance, along, samples);
    const hider = hiderOf(this.bodies.shownOf(this.chosenBodies), { direction, samples, distance, target });
    const clears = hider && this.mayBeClear(hider.body);
    this.seeThrough(clears ? hider.body : -1, clears && hider.isPart);
    this.fly(target, target.clone().addScaledVector(direction, distance), soft);
  }

  mayBeClear() { return true; }

  // One sees through a body that hides what is chosen, or the part of it that is shown; with -1 through none.
  seeThrough(body, ofPart = false) {
    this.bodies.setClear(body, ofPart);
    this.curves.forEach(({ curve }) => curve.setBehindGlass(body >= 0));
    this.placeBodies();
  }

  // What should be seen of what is chosen.
  samplesSeen(target, along) {
    const samples = along ? [] : samplesOf(this.chosenCurve.lines);
    return samples.length > 0 ? samples : [target];
  }

  // How much around the place of a row is worth seeing: more than its box, less than the scene.
  reachOf(r) {
    const { contacts, rows, scene } = this.all;
    const size = Math.hypot(...rows.half(r));
    const member = rows.contacts(r)[0];
    if (rows.after(r) > 0) {
      return contacts.reach(member);
    }
    return Math.min(Math.max(4 * size, member === undefined ? 0 : 0.3 * contacts.reach(member)), 0.4 * scene.size);
  }

  // The box of a row: around all places where the two touch.
  frameRow(r, visible) {
    this.box.visible = visible;
    this.box.position.fromArray(this.all.rows.center(r));
    const least = 1e-4 * this.all.scene.size;
    this.box.scale.fromArray([...this.all.rows.half(r)].map((half) => 2 * Math.max(half, least)));
  }

  // A direction from which the most of what is chosen is seen.
  clearDirection(target, distance, along, samples) {
    const { up } = this.camera;
    const away = this.offset();
    away.addScaledVector(up, -away.dot(up));
    if (away.lengthSq() < 1e-12 * this.all.scene.size ** 2) {
      away.set(1, 0.3, 0.2).addScaledVector(up, -new THREE.Vector3(1, 0.3, 0.2).dot(up));
    }
    return clearDirection({
      samples, distance, away: away.normalize(), up, along, corners: trianglesNear(this.bodies.placed(this.chosenBodies), target, distance),
    });
  }

  spotAt(x, y) { return this.spotCounts.at(this.spotsAt, x, y); }

  countedSpots() { return this.smallSpots; }

  // The gap at a place on the canvas; -1 if none is near.
  gapAt(x, y) {
    return this.gapLines.at(x, y, this.camera, this.canvas.clientWidth, this.canvas.clientHeight);
  }

  // The whole of a model that was coarse so far.
  setModel(k, mesh) {
    this.bodies.setModel(k, mesh);
    this.stage.changed();
    if (this.framed) {
      this.flyTo(...this.framed, false); // what was coarse may hide what is chosen
    }
    this.draw();
  }

  // Whole models wait until the camera is still, where they would hold it up.
  prepare() {
    this.isWhole = this.bodies.setCoarse(this.slow && this.isMoving) && !this.isMoving;
    this.bodies.sort(this.camera, this.pixels());
    this.markContacts();
  }
}
