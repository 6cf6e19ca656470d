// The scene in three dimensions. Drawn when something changed, and only then.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Bodies } from './bodies.js';
import { SpotCounts } from './counts.js';
import { Curve, joined, trianglesOf } from './curves.js';
import { GapLines } from './gaps.js';
import { calm, colors, whenSchemeChanges } from './look.js';

const FLIGHT = 700; // milliseconds
const AROUND = 4; // distance of the eye, in reaches of a contact
const NEAR_POINTER = 14; // pixels
const ALWAYS_SEEN = 10; // drawing order of what no wall may hide
const SLOW = 90; // milliseconds of a whole picture from which motion is drawn coarsely
const STILL = 250; // milliseconds without motion
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

export function roundSpot() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext('2d');
  pen.fillStyle = '#fff';
  pen.beginPath();
  pen.arc(16, 16, 14, 0, 2 * Math.PI);
  pen.fill();
  return new THREE.CanvasTexture(canvas);
}

export class View {
  constructor(canvas, all) {
    this.canvas = canvas;
    this.all = all;
    this.step = 0;
    this.exact = null; // a step, and the poses of two bodies at it: those of what is chosen
    this.chosenBodies = [];
    this.shownRow = -1;
    this.shownContact = -1;
    this.movedAt = -Infinity;
    this.slow = false; // until a whole picture was
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.world = new THREE.Scene();
    this.marks = new THREE.Group(); // contacts of the report, and what is chosen
    this.world.add(this.marks);
    this.layers = []; // what others draw over the picture
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1000);
    this.camera.up.set(0, all.scene.up === 'y' ? 1 : 0, all.scene.up === 'y' ? 0 : 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.drawMotion());
    this.controls.addEventListener('start', () => { this.flight = null; });
    this.controls.enableZoom = false; // until the reader means the picture, not the page
    canvas.addEventListener('pointerdown', () => canvas.focus({ preventScroll: true }), true);
    canvas.addEventListener('focus', () => { this.controls.enableZoom = true; });
    canvas.addEventListener('blur', () => { this.controls.enableZoom = false; });
    this.addLights();
    this.bodies = new Bodies(this.world, all.scene);
    this.addCurves();
    this.addSpots();
    this.addChosen();
    this.gapLines = new GapLines(all);
    this.spotCounts = new SpotCounts();
    this.paint();
    this.fit();
    this.whole(false);
    whenSchemeChanges(() => { this.paint(); this.setStep(this.step); });
    new ResizeObserver(() => this.fit()).observe(canvas);
  }

  addLights() {
    this.sky = new THREE.HemisphereLight(0xffffff, 0x8a8578, 1);
    this.sky.position.copy(this.camera.up);
    this.sun = new THREE.DirectionalLight(0xffffff, 1);
    this.sun.position.set(0.5, 0.35, 0.8);
    if (this.all.scene.up === 'y') {
      this.sun.position.set(0.5, 0.8, 0.35);
    }
    this.world.add(this.sky, this.sun);
  }

  addCurves() {
    const { scene } = this.all;
    this.past = new Curve(this.marks, 2, 2, false);
    this.now = new Curve(this.marks, 3.5, 4, false);
    this.chosenCurve = new Curve(this.marks, 4, ALWAYS_SEEN + 5, true);
    this.shownCurves = '';
    // Where there is one step alone, all that the page holds of where the two cross.
    const lines = [];
    for (let n = 0; n < scene.contacts.pairs && scene.steps.count < 2; ++n) {
      lines.push(this.all.contacts.crossing(n));
    }
    this.crossings = new Curve(this.marks, 3, ALWAYS_SEEN + 3, true);
    this.crossings.show(joined(lines), scene.size);
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

  addSpots() {
    this.spotsAt = this.makeSpots();
    const places = new Float32Array(3 * this.spotsAt.length);
    this.spotsAt.forEach(({ place }, n) => places.set(place, 3 * n));
    const geometry = trianglesOf(places);
    this.spotColors = new THREE.BufferAttribute(new Float32Array(4 * this.spotsAt.length), 4);
    this.haloColors = new THREE.BufferAttribute(new Float32Array(4 * this.spotsAt.length), 4);
    const size = this.spotsAt.length > 2000 ? 6 : 9;
    const layer = (colors, pixels, order) => {
      const points = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({
        size: pixels * this.renderer.getPixelRatio(), sizeAttenuation: false, vertexColors: true, transparent: true, depthTest: false, map: roundSpot(), alphaTest: 0.05,
      }));
      points.geometry.setAttribute('position', geometry.getAttribute('position'));
      points.geometry.setAttribute('color', colors);
      points.frustumCulled = false;
      points.renderOrder = order;
      this.marks.add(points);
      return points;
    };
    layer(this.haloColors, size + 4, ALWAYS_SEEN);
    layer(this.spotColors, size, ALWAYS_SEEN + 1);
  }

  addChosen() {
    const fill = () => new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, transparent: true, opacity: 0.3, depthTest: false });
    const line = (opacity) => new THREE.LineBasicMaterial({ depthTest: false, transparent: true, opacity });
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
    this.colors = colors(paper);
    this.world.background = this.colors.paper;
    this.sky.intensity = this.colors.sky;
    this.sun.intensity = this.colors.sun;
    this.bodies.stillMaterial.color.copy(this.colors.still);
    this.chosenParts[0].mesh.material.color.copy(this.colors.moves);
    this.chosenParts[1].mesh.material.color.copy(this.colors.still);
    this.chosenParts.forEach(({ edges }) => edges.material.color.copy(this.colors.line));
    this.box.material.color.copy(this.colors.frame);
    this.past.paint(this.colors.was, this.colors.halo);
    [this.now, this.chosenCurve, this.crossings].forEach((curve) => curve.paint(this.colors.touch, this.colors.halo));
    this.layers.forEach((layer) => layer.paint(this.colors));
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width > 0 && height > 0) {
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      [this.past, this.now, this.chosenCurve, this.crossings, ...this.layers].forEach((layer) => layer.fit(width));
      this.draw();
    }
  }

  // Shows the bodies and contacts of a step.
  setStep(step) {
    this.step = step;
    this.gapLines.step = Math.floor(step);
    const exact = this.exact?.step === step ? this.exact : null;
    this.bodies.place(step, exact, (body) => this.colorOf(body));
    this.draw();
  }

  // A layer has `paint(colors)`, `fit(width)` and `draw(camera, width, height)`.
  addLayer(layer) {
    this.layers.push(layer);
    layer.paint(this.colors);
    layer.fit(this.canvas.clientWidth);
  }

  // While the reader moves a body, contacts of the report are not drawn: they are those of other poses.
  setMoved(moved) {
    this.bodies.moved = moved;
    this.marks.visible = moved === null;
    this.setStep(this.step);
  }

  // Where the middle of a body is seen.
  middleOnCanvas(body) {
    const at = this.bodies.placeOf(body).project(this.camera);
    return [(at.x + 1) * this.canvas.clientWidth / 2, (1 - at.y) * this.canvas.clientHeight / 2];
  }

  isNow({ begin, end }) {
    const now = Math.floor(this.step);
    return begin <= now && now <= end;
  }

  // Large curves are drawn, of the others spots.
  markContacts() {
    const { curves, scene } = this.all;
    const pixels = this.canvas.clientHeight / (2 * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)));
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
      const hidden = row === this.shownRow;
      if (!hidden && !large) {
        this.smallSpots.push(spot);
      }
      this.spotColors.setXYZW(n, color.r, color.g, color.b, hidden || large ? 0 : active ? 1 : 0.6);
      this.haloColors.setXYZW(n, this.colors.halo.r, this.colors.halo.g, this.colors.halo.b, hidden || large ? 0 : active ? 1 : 0.6);
    });
    this.spotColors.needsUpdate = this.haloColors.needsUpdate = true;
    const drawn = near.sort((a, b) => a.distance - b.distance).slice(0, MOST_CURVES).map(({ spot }) => spot)
      .filter(({ row }) => row !== this.shownRow);
    if (curves.count === 0) {
      this.showCrossings();
      return;
    }
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

  // Two movers that are chosen are told apart by the colors of A and B.
  colorOf(body) {
    return body === this.chosenBodies[1] ? this.colors.still : this.colors.moves;
  }

  // Shows contact k, or row r: the curve of its step of most pairs, or what is known of its first.
  // Says where to look, and how much around it is worth seeing.
  showRow(r, k) {
    const { contacts, rows, curves } = this.all;
    const curve = k < 0 ? curves.ofRow.get(r) : undefined;
    const members = k >= 0 ? [k]
      : [...rows.contacts(r)].filter((member) => contacts.begin(member) === rows.begin(r));
    this.chosenBodies = [rows.a(r), rows.b(r)];
    this.shownRow = r;
    this.shownContact = k;
    this.gapLines.chosen = -1;
    const first = members[0];
    if (curve !== undefined) {
      this.exact = { step: rows.mostStep(r), bodies: this.chosenBodies, poses: [0, 1].map((side) => curves.pose(curve, side)) };
    } else {
      this.exact = first === undefined ? null : {
        step: contacts.begin(first), bodies: [contacts.a(first), contacts.b(first)], poses: [0, 1].map((side) => contacts.pose(first, side)),
      };
    }
    const pairs = curve === undefined ? members.flatMap((member) => Array.from(
      { length: contacts.pairCount(member) }, (_, n) => contacts.firstPair(member) + n)) : [];
    this.chosenCurve.show(curve === undefined ? joined(pairs.map((n) => contacts.crossing(n))) : curves.lines[curve], this.all.scene.size);
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
      mesh.visible = all.length > 0;
      edges.visible = mesh.visible && k >= 0; // of many triangles they would hide all else
    });
    this.frameRow(r, k < 0 && curve === undefined);
    this.setStep(k >= 0 ? contacts.begin(k) : rows.moment(r));
    return k >= 0 ? { place: contacts.focus(k), reach: contacts.reach(k) } : this.sightOf(r);
  }

  sightOf(r) {
    const { curves, rows } = this.all;
    const curve = curves.ofRow.get(r);
    return curve === undefined ? { place: rows.center(r), reach: this.reachOf(r) }
      : { place: curves.place(curve), reach: curves.reach(curve) };
  }

  choose(r, k) {
    const { place, reach } = this.showRow(r, k);
    this.flyTo(place, reach);
  }

  // A picture of a row for paper, on a canvas of its own; the view stays as it is.
  pictureOf(r, width, height) {
    const kept = {
      eye: this.camera.position.clone(), target: this.controls.target.clone(), step: this.step, exact: this.exact, row: this.shownRow, contact: this.shownContact, gap: this.gapLines.chosen, bodies: this.chosenBodies,
    };
    const ratio = this.renderer.getPixelRatio();
    this.flight = null;
    this.paint(true);
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const { place, reach } = this.showRow(r, -1);
    this.flyTo(place, reach, undefined, false);
    this.bodies.setCoarse(false);
    this.render();
    const picture = document.createElement('canvas');
    [picture.width, picture.height] = [width, height];
    picture.getContext('2d').drawImage(this.canvas, 0, 0, width, height);
    this.paint();
    this.renderer.setPixelRatio(ratio);
    if (kept.row >= 0) {
      this.showRow(kept.row, kept.contact);
    } else {
      this.clearChosen();
    }
    this.gapLines.chosen = kept.gap;
    this.exact = kept.exact;
    this.chosenBodies = kept.bodies;
    this.setStep(kept.step);
    this.fly(kept.target, kept.eye, false);
    this.fit();
    return picture;
  }

  // Nothing of the list is chosen.
  clearChosen() {
    this.chosenBodies = [];
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
    const target = new THREE.Vector3().fromArray(place);
    const distance = Math.max(AROUND * this.narrow() * reach, 1e-5 * this.all.scene.size);
    this.fly(target, target.clone().addScaledVector(this.clearDirection(target, distance, along), distance), soft);
  }

  // How much around the place of a row is worth seeing: more than its box, less than the scene.
  reachOf(r) {
    const { contacts, rows, scene } = this.all;
    const size = Math.hypot(...rows.half(r));
    const member = rows.contacts(r)[0];
    return Math.min(Math.max(4 * size, member === undefined ? 0 : 0.3 * contacts.reach(member)), 0.4 * scene.size);
  }

  // The box of a row: around all places where the two touch.
  frameRow(r, visible) {
    this.box.visible = visible;
    this.box.position.fromArray(this.all.rows.center(r));
    const least = 1e-4 * this.all.scene.size;
    this.box.scale.fromArray([...this.all.rows.half(r)].map((half) => 2 * Math.max(half, least)));
  }

  // A direction from which nothing that stands still hides the target, if there is one: near the
  // present one first, then around it, then steeper. A segment `along` is looked at from aside.
  clearDirection(target, distance, along) {
    const { up } = this.camera;
    const away = this.camera.position.clone().sub(this.controls.target);
    away.addScaledVector(up, -away.dot(up));
    if (away.lengthSq() < 1e-12 * this.all.scene.size ** 2) {
      away.set(1, 0.3, 0.2).addScaledVector(up, -new THREE.Vector3(1, 0.3, 0.2).dot(up));
    }
    away.normalize();
    const ray = new THREE.Raycaster();
    const candidates = along?.lengthSq() > 0 ? this.asideOf(along.normalize(), away) : [35, 60].flatMap((rise) => [0, 90, -90, 180].map((turn) => {
      const level = away.clone().applyAxisAngle(up, THREE.MathUtils.degToRad(turn));
      const angle = THREE.MathUtils.degToRad(rise);
      return level.multiplyScalar(Math.cos(angle)).addScaledVector(up, Math.sin(angle));
    }));
    const clear = candidates.find((direction) => {
      ray.set(target.clone().addScaledVector(direction, distance), direction.clone().negate());
      ray.far = 0.98 * distance;
      return ray.intersectObjects(this.bodies.stillMeshes, false).length === 0;
    });
    return clear ?? candidates[4];
  }

  // Directions at right angles to a segment but for some rise, those from above first.
  asideOf(along, away) {
    const { up } = this.camera;
    const first = away.clone().addScaledVector(along, -away.dot(along));
    if (first.lengthSq() < 1e-6) {
      first.crossVectors(along, up);
    }
    first.normalize();
    return [0, 45, -45, 90, -90, 135, -135, 180].map((turn) => first.clone()
      .applyAxisAngle(along, THREE.MathUtils.degToRad(turn)).addScaledVector(up, 0.2).normalize())
      .sort((a, b) => (b.dot(up) > 0.1) - (a.dot(up) > 0.1));
  }

  // The camera goes to `eye` and looks at `target`, in an instant for who wants no motion.
  fly(target, eye, soft = true) {
    if (!soft || calm()) {
      this.flight = null;
      this.controls.target.copy(target);
      this.camera.position.copy(eye);
      this.controls.update();
      this.draw();
      return;
    }
    this.flight = {
      since: performance.now(), fromTarget: this.controls.target.clone(), fromEye: this.camera.position.clone(), target, eye,
    };
    this.draw();
  }

  followFlight() {
    const { since, fromTarget, fromEye, target, eye } = this.flight;
    const share = Math.min(1, (performance.now() - since) / FLIGHT);
    const smooth = share * share * (3 - 2 * share);
    this.controls.target.lerpVectors(fromTarget, target, smooth);
    this.camera.position.lerpVectors(fromEye, eye, smooth);
    if (share === 1) {
      this.flight = null;
    }
    this.controls.update();
  }

  // How much farther away a picture must be seen from that is higher than wide.
  narrow() {
    return Math.max(1, 1.1 / this.camera.aspect);
  }

  whole(soft = true) {
    const { up } = this.all.scene;
    const size = this.all.scene.size * this.narrow();
    this.fly(new THREE.Vector3(), up === 'y' ? new THREE.Vector3(0.25, 0.4, 0.6).multiplyScalar(size)
      : new THREE.Vector3(0.25, -0.6, 0.45).multiplyScalar(size), soft);
  }

  above() {
    const { up } = this.all.scene;
    const size = this.all.scene.size * this.narrow();
    this.fly(new THREE.Vector3(), up === 'y' ? new THREE.Vector3(0, 0.95 * size, 1e-4 * size)
      : new THREE.Vector3(0, -1e-4 * size, 0.95 * size));
  }

  // By keys: turn, move sideways, come closer.
  turn(around, rise) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.camera.up, around);
    const side = new THREE.Vector3().crossVectors(this.camera.up, offset).normalize();
    const raised = offset.clone().applyAxisAngle(side, rise);
    const angle = raised.angleTo(this.camera.up);
    this.place(angle > 0.02 && angle < Math.PI - 0.02 ? raised : offset);
  }

  closer(factor) {
    this.place(this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor));
  }

  shift(right, upwards) {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const by = new THREE.Vector3(right, upwards, 0).multiplyScalar(distance).applyQuaternion(this.camera.quaternion);
    this.controls.target.add(by);
    this.camera.position.add(by);
    this.controls.update();
  }

  place(offset) {
    this.flight = null;
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  // The spot nearest to a place on the canvas; undefined if none is near.
  spotAt(x, y) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const at = new THREE.Vector3();
    let best;
    let least = NEAR_POINTER;
    for (const spot of this.spotsAt) {
      at.fromArray(spot.place).project(this.camera);
      const distance = Math.hypot((at.x + 1) * width / 2 - x, (1 - at.y) * height / 2 - y);
      if (distance < least && Math.abs(at.z) <= 1) {
        least = distance;
        best = spot;
      }
    }
    return best;
  }

  // The gap at a place on the canvas; -1 if none is near.
  gapAt(x, y) {
    return this.gapLines.at(x, y, this.camera, this.canvas.clientWidth, this.canvas.clientHeight);
  }

  // The whole of a model that was coarse so far.
  setModel(k, mesh) {
    this.bodies.setModel(k, mesh);
    this.draw();
  }

  // The camera moves: whole models wait until it is still, where they would hold it up.
  drawMotion() {
    this.movedAt = performance.now();
    clearTimeout(this.whenStill);
    this.whenStill = setTimeout(() => this.draw(), STILL);
    this.draw();
  }

  // Asks for one picture; many wishes before it are one.
  draw() {
    if (this.asked) {
      return;
    }
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.flight) {
        this.followFlight();
      }
      const moves = Boolean(this.flight) || performance.now() - this.movedAt < 0.9 * STILL;
      const changed = this.bodies.setCoarse(this.slow && moves);
      this.render();
      this.measure(changed && !moves);
      const size = [this.canvas.clientWidth, this.canvas.clientHeight];
      this.gapLines.draw(this.camera, ...size);
      this.spotCounts.draw(this.smallSpots, (spot) => this.isNow(spot), this.camera, ...size);
      this.layers.forEach((layer) => layer.draw(this.camera, ...size));
      if (this.flight) {
        this.drawMotion();
      }
    });
  }

  render() {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(0.02 * distance, 1e-6 * this.all.scene.size);
    this.camera.far = distance + 3 * this.all.scene.size;
    this.camera.updateProjectionMatrix();
    this.bodies.sort(this.camera, this.canvas.clientHeight || 1);
    this.markContacts();
    this.renderer.render(this.world, this.camera);
  }

  // The first picture, when it is seen, and how long the first whole one takes.
  measure(whole) {
    const since = performance.now();
    const first = this.firstPicture === undefined;
    if (first) {
      this.firstPicture = { triangles: this.renderer.info.render.triangles };
    }
    if (first || (whole && !this.slow)) {
      requestAnimationFrame(() => requestAnimationFrame((now) => {
        this.slow ||= whole && now - since > SLOW;
        if (first) {
          this.firstPicture.at = now;
          this.onFirst?.();
        }
      }));
    }
  }
}
