// The parts of a clash page in three dimensions: the two that are chosen in color, the others pale and cut
// away before the clash. Drawn when something changed, and only then.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Curve } from './curves.js';
import { calm, colors, whenSchemeChanges } from './look.js';
import { roundSpot } from './view.js';

const FLIGHT = 600; // milliseconds
const DISTANCE = 2.62; // of the eye, in reaches: all within the reach is seen at 45 degrees
const CUT = 0.1; // reaches from the middle of the clash toward the eye
const GLASS = 0.4;
const HIDDEN = 0.45; // of parts that others hide all the same
const NO_LINES = new Float32Array(0);

// Parts as one mesh, each at its place.
function joinedGeometry(parts) {
  const counts = parts.reduce(([vertices, corners], { mesh }) => [vertices + mesh.positions.length / 3, corners + mesh.indices.length], [0, 0]);
  const positions = new Float32Array(3 * counts[0]);
  const indices = new Uint32Array(counts[1]);
  let [vertex, corner] = [0, 0];
  for (const { mesh, place } of parts) {
    for (let k = 0; k < mesh.positions.length; ++k) {
      positions[3 * vertex + k] = mesh.positions[k] + place[k % 3];
    }
    for (let k = 0; k < mesh.indices.length; ++k) {
      indices[corner + k] = mesh.indices[k] + vertex;
    }
    vertex += mesh.positions.length / 3;
    corner += mesh.indices.length;
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}

export class ClashView {
  constructor(canvas, all) {
    this.canvas = canvas;
    this.all = all;
    this.row = -1;
    this.isCut = true;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.localClippingEnabled = true;
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1000);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => { this.flight = null; });
    this.controls.enableZoom = false; // until the reader means the picture, not the page
    canvas.addEventListener('pointerdown', () => canvas.focus({ preventScroll: true }), true);
    canvas.addEventListener('focus', () => { this.controls.enableZoom = true; });
    canvas.addEventListener('blur', () => { this.controls.enableZoom = false; });
    this.sky = new THREE.HemisphereLight(0xffffff, 0x8a8578, 1);
    this.sky.position.set(0, 0, 1);
    this.sun = new THREE.DirectionalLight(0xffffff, 1);
    this.sun.position.set(0.5, -0.35, 0.8);
    this.world.add(this.sky, this.sun);
    this.addParts();
    this.paint();
    this.fit();
    this.whole(false);
    whenSchemeChanges(() => { this.paint(); this.draw(); });
    new ResizeObserver(() => this.fit()).observe(canvas);
  }

  addParts() {
    this.plane = new THREE.Plane();
    const solid = (more) => new THREE.MeshLambertMaterial({ flatShading: true, side: THREE.DoubleSide, ...more });
    this.rest = new THREE.Mesh(joinedGeometry(this.all.parts), solid());
    this.rest.frustumCulled = false;
    this.world.add(this.rest);
    const mesh = (material, order) => {
      const made = new THREE.Mesh(new THREE.BufferGeometry(), material);
      made.frustumCulled = false;
      made.visible = false;
      made.renderOrder = order;
      this.world.add(made);
      return made;
    };
    // In front of the pale part that they are themselves.
    const before = { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2 };
    this.small = mesh(solid({ transparent: true, ...before }), 2); // after what shines through, which it hides
    // Of what one sees through, only the nearest surface is drawn: its depth first, then its color.
    this.glassDepth = mesh(new THREE.MeshBasicMaterial({ colorWrite: false, side: THREE.DoubleSide, transparent: true, ...before }), 3);
    this.glass = mesh(solid({ transparent: true, opacity: GLASS, depthFunc: THREE.LessEqualDepth, ...before }), 4);
    // Where other parts are before the two, these shine through.
    const behind = { transparent: true, depthFunc: THREE.GreaterDepth, depthWrite: false };
    this.smallBehind = mesh(solid({ ...behind, opacity: HIDDEN }), 1);
    this.glassBehind = mesh(solid({ ...behind, opacity: HIDDEN * GLASS }), 1);
    this.curve = new Curve(this.world, 3.5, 6, true);
    this.mark = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ size: 12 * this.renderer.getPixelRatio(), sizeAttenuation: false, depthTest: false, transparent: true, map: roundSpot(), alphaTest: 0.05 }));
    this.mark.renderOrder = 9;
    this.mark.visible = false;
    this.mark.frustumCulled = false;
    this.world.add(this.mark);
  }

  paint(paper = false) {
    this.colors = colors(paper);
    this.world.background = this.colors.paper;
    this.sky.intensity = this.colors.sky;
    this.sun.intensity = this.colors.sun;
    this.rest.material.color.copy(this.colors.rest);
    this.curve.paint(this.colors.touch, this.colors.halo);
    this.mark.material.color.copy(this.colors.touch);
    this.paintParts();
  }

  paintParts() {
    const [a, b] = [this.colors.moves, this.colors.still];
    const aIsGlass = this.row >= 0 && this.all.sights.aIsLarger(this.row);
    [this.glass, this.glassBehind].forEach(({ material }) => material.color.copy(aIsGlass ? a : b));
    [this.small, this.smallBehind].forEach(({ material }) => material.color.copy(aIsGlass ? b : a));
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width > 0 && height > 0) {
      this.renderer.setSize(width, height, false);
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      this.curve.fit(width);
      this.draw();
    }
  }

  // Shows a row, or with -1 none.
  show(r) {
    this.row = r;
    const { rows, parts, scene, sights, curves } = this.all;
    const [a, b] = r < 0 ? [] : [rows[r].a, rows[r].b].map((side) => parts[scene.of_sides[side]]);
    const [large, little] = r >= 0 && sights.aIsLarger(r) ? [a, b] : [b, a];
    for (const [meshes, part] of [[[this.small, this.smallBehind], little], [[this.glass, this.glassBehind, this.glassDepth], large]]) {
      meshes[0].geometry.dispose();
      const geometry = part === undefined ? new THREE.BufferGeometry() : joinedGeometry([part]);
      for (const mesh of meshes) {
        mesh.visible = part !== undefined;
        mesh.geometry = geometry;
      }
    }
    this.curve.show(r < 0 ? NO_LINES : curves.get(r) ?? NO_LINES, scene.size);
    this.mark.visible = r >= 0 && sights.reach(r) > 0;
    if (this.mark.visible) {
      this.mark.geometry.dispose();
      this.mark.geometry = new THREE.BufferGeometry();
      this.mark.geometry.setAttribute('position', new THREE.BufferAttribute(sights.place(r).slice(), 3));
    }
    this.paintParts();
  }

  // Where the eye stands to see a row; null where it has no place.
  sightOf(r) {
    const { sights } = this.all;
    if (!(sights.reach(r) > 0)) {
      return null;
    }
    const focus = new THREE.Vector3().fromArray(sights.focus(r));
    const toward = new THREE.Vector3().fromArray(sights.toward(r));
    return { focus, eye: focus.clone().addScaledVector(toward, DISTANCE * this.narrow() * sights.reach(r)) };
  }

  choose(r) {
    this.show(r);
    const sight = this.sightOf(r);
    if (sight) {
      this.fly(sight.focus, sight.eye);
    } else {
      this.draw();
    }
  }

  setCut(cut) {
    this.isCut = cut;
    this.draw();
  }

  // What is nearer to the eye than the clash is cut away, from wherever it is looked at.
  placePlane() {
    const cuts = this.isCut && this.row >= 0 && this.all.sights.reach(this.row) > 0;
    this.rest.material.clippingPlanes = cuts ? [this.plane] : [];
    if (cuts) {
      const { sights } = this.all;
      const away = this.camera.getWorldDirection(new THREE.Vector3());
      const at = new THREE.Vector3().fromArray(sights.focus(this.row)).addScaledVector(away, -CUT * sights.reach(this.row));
      this.plane.setFromNormalAndCoplanarPoint(away, at);
    }
  }

  // A picture of a row for paper, on a canvas of its own; the view stays as it is.
  pictureOf(r, width, height) {
    const kept = { eye: this.camera.position.clone(), target: this.controls.target.clone(), row: this.row, aspect: this.camera.aspect };
    this.show(r);
    this.paint(true);
    this.camera.aspect = width / height;
    const sight = this.sightOf(r);
    if (sight) {
      this.camera.position.copy(sight.eye);
      this.camera.lookAt(sight.focus);
    }
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.curve.fit(width);
    this.render(sight?.focus ?? this.controls.target);
    const picture = document.createElement('canvas');
    picture.width = width;
    picture.height = height;
    picture.getContext('2d').drawImage(this.canvas, 0, 0);
    this.renderer.setPixelRatio(ratio);
    this.camera.aspect = kept.aspect;
    this.show(kept.row);
    this.paint();
    this.camera.position.copy(kept.eye);
    this.controls.target.copy(kept.target);
    this.controls.update();
    this.fit();
    return picture;
  }

  narrow() {
    return Math.max(1, 1 / this.camera.aspect);
  }

  whole(soft = true) {
    const size = this.all.scene.size * this.narrow();
    this.fly(new THREE.Vector3(), new THREE.Vector3(0.35, -0.75, 0.6).multiplyScalar(size), soft);
  }

  fly(target, eye, soft = true) {
    if (!soft || calm()) {
      this.flight = null;
      this.controls.target.copy(target);
      this.camera.position.copy(eye);
      this.controls.update();
    } else {
      this.flight = {
        since: performance.now(), fromTarget: this.controls.target.clone(), fromEye: this.camera.position.clone(), target, eye,
      };
    }
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

  // By keys: turn, move sideways, come closer.
  turn(around, rise) {
    const offset = this.camera.position.clone().sub(this.controls.target).applyAxisAngle(this.camera.up, around);
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
    this.draw();
  }

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
      this.render(this.controls.target);
      if (this.flight) {
        this.draw();
      }
    });
  }

  render(target) {
    const distance = this.camera.position.distanceTo(target);
    this.camera.near = Math.max(0.02 * distance, 1e-6 * this.all.scene.size);
    this.camera.far = distance + 3 * this.all.scene.size;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.placePlane();
    this.renderer.render(this.world, this.camera);
  }
}
