// The scene in three dimensions. Drawn when something changed, and only then.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GapLines } from './gaps.js';
import { calm, colors, whenSchemeChanges } from './look.js';
import { Poses } from './poses.js';

const FLIGHT = 700; // milliseconds
const AROUND = 4; // distance of the eye, in reaches of a contact
const NEAR_POINTER = 14; // pixels
const ALWAYS_SEEN = 10; // drawing order of what no wall may hide

function geometryOf(model) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(model.positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(model.indices, 1));
  return geometry;
}

function trianglesOf(corners) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
  return geometry;
}

function joined(arrays) {
  const all = new Float32Array(arrays.reduce((sum, a) => sum + a.length, 0));
  let at = 0;
  for (const array of arrays) {
    all.set(array, at);
    at += array.length;
  }
  return all;
}

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

function roundSpot() {
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
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1000);
    this.camera.up.set(0, all.scene.up === 'y' ? 1 : 0, all.scene.up === 'y' ? 0 : 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => { this.flight = null; });
    this.controls.enableZoom = false; // until the reader means the picture, not the page
    canvas.addEventListener('pointerdown', () => canvas.focus({ preventScroll: true }), true);
    canvas.addEventListener('focus', () => { this.controls.enableZoom = true; });
    canvas.addEventListener('blur', () => { this.controls.enableZoom = false; });
    this.addLights();
    this.addBodies();
    this.addTouched();
    this.addSpots();
    this.addChosen();
    this.gapLines = new GapLines(all);
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

  addBodies() {
    const { scene } = this.all;
    this.geometries = scene.models.map(geometryOf);
    const material = () => new THREE.MeshLambertMaterial({ flatShading: true, side: THREE.DoubleSide });
    this.stillMaterial = material();
    this.movingMaterial = material();
    this.stillMeshes = [];
    this.poses = new Poses(scene);
    this.slots = []; // of each body: the instances that hold it, and its place there
    const counts = scene.models.map(() => 0);
    scene.bodies.model.forEach((model, body) => {
      if (scene.bodies.moves[body]) {
        this.slots[body] = { model, at: counts[model]++ };
      } else {
        const mesh = new THREE.Mesh(this.geometries[model], this.stillMaterial);
        this.poses.still(body, mesh.position, mesh.quaternion);
        mesh.userData.body = body;
        this.stillMeshes.push(mesh);
        this.world.add(mesh);
      }
    });
    this.instances = counts.map((count, model) => {
      if (count === 0) {
        return null;
      }
      const mesh = new THREE.InstancedMesh(this.geometries[model], this.movingMaterial, count);
      mesh.frustumCulled = false;
      this.world.add(mesh);
      return mesh;
    });
  }

  // The triangles of contacts, on the bodies that stand still: sharp at this step, faint at others.
  // Where there is one step alone they would cover both bodies: the lines in which they cross are drawn.
  addTouched() {
    const { scene, contacts } = this.all;
    const corners = [];
    this.touchedContact = [];
    const oneStep = scene.steps.count < 2;
    for (let k = 0; k < contacts.count && !oneStep; ++k) {
      const sides = [0, 1].filter((side) => !scene.bodies.moves[side === 0 ? contacts.a(k) : contacts.b(k)]);
      for (let n = 0; n < contacts.pairCount(k); ++n) {
        for (const side of sides) {
          corners.push(contacts.corners(contacts.firstPair(k) + n, side));
          this.touchedContact.push(k);
        }
      }
    }
    const geometry = trianglesOf(joined(corners));
    this.touchedColors = new THREE.BufferAttribute(new Float32Array(9 * corners.length), 3);
    geometry.setAttribute('color', this.touchedColors);
    const material = new THREE.MeshBasicMaterial({
      vertexColors: true, side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4,
    });
    this.touched = new THREE.Mesh(geometry, material);
    this.touched.frustumCulled = false;
    this.world.add(this.touched);
    const lines = [];
    for (let n = 0; n < scene.contacts.pairs && oneStep; ++n) {
      lines.push(contacts.crossing(n));
    }
    this.crossings = new THREE.LineSegments(trianglesOf(joined(lines)), new THREE.LineBasicMaterial({ depthTest: false, transparent: true }));
    this.crossings.frustumCulled = false;
    this.crossings.renderOrder = ALWAYS_SEEN + 5;
    this.world.add(this.crossings);
  }

  // Where there is no time a spot a row; else one a contact, and one for each row without any.
  makeSpots() {
    const { scene, contacts, rows } = this.all;
    const spots = [];
    const oneStep = scene.steps.count < 2;
    for (let k = 0; k < contacts.count && !oneStep; ++k) {
      spots.push({
        place: contacts.focus(k), row: contacts.row(k), contact: k, begin: contacts.begin(k), end: contacts.end(k),
      });
    }
    for (let r = 0; r < rows.count; ++r) {
      if (oneStep || rows.contacts(r).length === 0) {
        spots.push({ place: rows.center(r), row: r, contact: -1, begin: rows.begin(r), end: rows.end(r) });
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
    geometry.setAttribute('color', this.spotColors);
    this.spots = new THREE.Points(geometry, new THREE.PointsMaterial({
      size: (this.spotsAt.length > 500 ? 5 : 8) * this.renderer.getPixelRatio(), sizeAttenuation: false, vertexColors: true, transparent: true, depthTest: false, map: roundSpot(), alphaTest: 0.05,
    }));
    this.spots.frustumCulled = false;
    this.spots.renderOrder = ALWAYS_SEEN;
    this.world.add(this.spots);
  }

  addChosen() {
    const fill = () => new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, transparent: true, opacity: 0.75, depthTest: false });
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
      this.world.add(mesh, edges);
    });
    this.box = new THREE.LineSegments(new THREE.EdgesGeometry(new THREE.BoxGeometry(1, 1, 1)), line(1));
    this.box.renderOrder = ALWAYS_SEEN + 4;
    this.box.visible = this.box.frustumCulled = false;
    this.world.add(this.box);
  }

  paint() {
    this.colors = colors();
    this.world.background = this.colors.paper;
    this.sky.intensity = this.colors.sky;
    this.sun.intensity = this.colors.sun;
    this.stillMaterial.color.copy(this.colors.still);
    this.chosenParts[0].mesh.material.color.copy(this.colors.moves);
    this.chosenParts[1].mesh.material.color.copy(this.colors.still);
    this.chosenParts.forEach(({ edges }) => edges.material.color.copy(this.colors.line));
    this.box.material.color.copy(this.colors.frame);
    this.crossings.material.color.copy(this.colors.touch);
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width > 0 && height > 0) {
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      this.draw();
    }
  }

  // Shows the bodies and contacts of a step.
  setStep(step) {
    this.step = step;
    this.gapLines.step = Math.floor(step);
    const { contacts } = this.all;
    const touching = new Set();
    const now = Math.floor(step);
    for (let k = 0; k < contacts.count; ++k) {
      const active = contacts.begin(k) <= now && now <= contacts.end(k);
      if (active) {
        touching.add(contacts.a(k)).add(contacts.b(k));
      }
    }
    this.spotsAt.forEach(({ begin, end }, n) => {
      const active = begin <= now && now <= end;
      const color = active ? this.colors.touch : this.colors.was;
      this.spotColors.setXYZW(n, color.r, color.g, color.b, active ? 1 : 0.35);
    });
    this.touchedContact.forEach((k, n) => {
      const active = contacts.begin(k) <= now && now <= contacts.end(k);
      const color = active ? this.colors.touch : this.colors.was;
      for (let corner = 0; corner < 3; ++corner) {
        this.touchedColors.setXYZ(3 * n + corner, color.r, color.g, color.b);
      }
    });
    this.touchedColors.needsUpdate = this.spotColors.needsUpdate = true;
    this.placeBodies(step, touching);
    this.draw();
  }

  placeBodies(step, touching) {
    const place = new THREE.Vector3();
    const turn = new THREE.Quaternion();
    const size = new THREE.Vector3(1, 1, 1);
    const matrix = new THREE.Matrix4();
    const exact = this.exact?.step === step ? this.exact : null;
    this.slots.forEach((slot, body) => {
      const side = exact ? exact.bodies.indexOf(body) : -1;
      if (side >= 0) {
        const pose = exact.poses[side];
        place.fromArray(pose, 0);
        turn.fromArray(pose, 3);
      } else {
        this.poses.at(body, step, place, turn);
      }
      const mesh = this.instances[slot.model];
      mesh.setMatrixAt(slot.at, matrix.compose(place, turn, size));
      mesh.setColorAt(slot.at, this.colorOf(body, touching));
    });
    for (const mesh of this.instances) {
      if (mesh) {
        mesh.instanceMatrix.needsUpdate = mesh.instanceColor.needsUpdate = true;
      }
    }
  }

  // What is chosen steps back, so that its triangles stand out.
  colorOf(body, touching) {
    if (this.chosenBodies.includes(body)) {
      return this.colors.chosen;
    }
    return touching.has(body) && this.all.scene.steps.count > 1 ? this.colors.touch : this.colors.moves;
  }

  // Lights up the triangles of contact k, or of those of row r that begin with it, and flies there.
  choose(r, k) {
    const { contacts, rows } = this.all;
    const members = k >= 0 ? [k]
      : [...rows.contacts(r)].filter((member) => contacts.begin(member) === rows.begin(r));
    this.chosenBodies = [rows.a(r), rows.b(r)];
    const first = members[0];
    this.exact = first === undefined ? null : {
      step: contacts.begin(first), bodies: [contacts.a(first), contacts.b(first)], poses: [0, 1].map((side) => contacts.pose(first, side)),
    };
    this.gapLines.chosen = -1;
    this.chosenParts.forEach(({ mesh, edges }, side) => {
      const corners = [];
      const seen = new Set();
      for (const member of members) {
        for (let n = contacts.firstPair(member); n < contacts.firstPair(member) + contacts.pairCount(member); ++n) {
          const triangle = contacts.triangleOf(n, side);
          if (!seen.has(triangle)) {
            seen.add(triangle);
            corners.push(contacts.corners(n, side));
          }
        }
      }
      const all = joined(corners);
      mesh.geometry.dispose();
      edges.geometry.dispose();
      mesh.geometry = trianglesOf(all);
      edges.geometry = trianglesOf(edgesOf(all));
      mesh.visible = all.length > 0;
      edges.visible = mesh.visible && k >= 0; // of many triangles they would hide all else
    });
    this.frameRow(r, k < 0);
    this.setStep(k >= 0 ? contacts.begin(k) : rows.begin(r));
    this.flyTo(k >= 0 ? contacts.focus(k) : rows.center(r), k >= 0 ? contacts.reach(k) : this.reachOf(r));
  }

  // Shows gap g and flies there.
  chooseGap(g) {
    const { gaps } = this.all;
    this.chosenBodies = [];
    this.exact = { step: gaps.nearest(g), bodies: [gaps.a(g), gaps.b(g)], poses: [0, 1].map((side) => gaps.pose(g, side)) };
    this.gapLines.chosen = g;
    this.box.visible = false;
    this.chosenParts.forEach(({ mesh, edges }) => { mesh.visible = edges.visible = false; });
    this.setStep(gaps.nearest(g));
    const [a, b] = [0, 1].map((side) => new THREE.Vector3().fromArray(gaps.point(g, side)));
    this.flyTo(gaps.middle(g), gaps.reach(g), b.sub(a));
  }

  flyTo(place, reach, along) {
    const target = new THREE.Vector3().fromArray(place);
    const distance = Math.max(AROUND * this.narrow() * reach, 1e-5 * this.all.scene.size);
    this.fly(target, target.clone().addScaledVector(this.clearDirection(target, distance, along), distance));
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
      return ray.intersectObjects(this.stillMeshes, false).length === 0;
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
      const distance = this.camera.position.distanceTo(this.controls.target);
      this.camera.near = Math.max(0.02 * distance, 1e-6 * this.all.scene.size);
      this.camera.far = distance + 3 * this.all.scene.size;
      this.camera.updateProjectionMatrix();
      this.renderer.render(this.world, this.camera);
      this.gapLines.draw(this.camera, this.canvas.clientWidth, this.canvas.clientHeight);
      if (this.flight) {
        this.draw();
      }
    });
  }
}
