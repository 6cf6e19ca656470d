// The one view in three dimensions of all pages: camera, light, frame, keys, and pictures for paper. What is
// drawn is the page's own (scene_view.js, clash_view.js). Drawn when something changed, and only then.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { Curve } from './curves.js';
import { fittedEye } from './framing.js';
import { calm, colors, whenSchemeChanges } from './look.js';
import { Stage } from './stage.js';

const FLIGHT = 700; // milliseconds
const STILL = 250; // milliseconds without motion
const TURN = 0.12; // radians, for a key
const SHIFT = 0.1; // distances of the eye, for a key
const CLOSER = 0.85; // of that distance, for a key
const SLOW = 90; // milliseconds of a whole picture from which motion is drawn coarsely
const COARSE = 0.5; // of the pixels along a side, then

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

// A page's own view adds what it draws to `world`, then calls `begin`. It may have more to do where these
// have: `paint`, `prepare` before each picture, `drawn` after one on the screen, `kept` and `restore`. Its
// `showAtOnce(row)` shows a row without a flight.
export class View {
  // To the right, toward the reader and up: `home` is where the eye stands to see all, in sizes of the scene; the
  // light comes from `sun`.
  constructor(canvas, all, home, sun) {
    this.canvas = canvas;
    this.all = all;
    this.home = home;
    this.curves = []; // each with the use of its color
    this.spots = []; // each with its size in pixels
    this.layers = []; // what lies over the picture: each with `draw(camera, width, height)`
    this.movedAt = -Infinity;
    this.slow = false; // until a whole picture was
    this.isWhole = true; // what is drawn is not a stand-in
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.ratio = Math.min(window.devicePixelRatio, 2);
    this.world = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1000);
    this.camera.up.copy(this.toward(0, 0, 1));
    this.stage = new Stage(this.world, this.renderer, all.scene, this.camera.up, this.toward(...sun));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.drawMotion());
    this.controls.addEventListener('start', () => { this.flight = this.framed = null; });
    this.controls.enableZoom = false; // until the reader means the picture, not the page
    canvas.addEventListener('pointerdown', () => canvas.focus({ preventScroll: true }), true);
    canvas.addEventListener('focus', () => { this.controls.enableZoom = true; });
    canvas.addEventListener('blur', () => { this.controls.enableZoom = false; });
  }

  begin() {
    this.paint();
    this.fit();
    this.whole(false);
    whenSchemeChanges(() => { this.paint(); this.draw(); });
    new ResizeObserver(() => this.fit()).observe(this.canvas);
  }

  // A direction to the right, toward the reader and up.
  toward(right, near, up) {
    return this.all.scene.up === 'y' ? new THREE.Vector3(right, up, near) : new THREE.Vector3(right, -near, up);
  }

  addCurve(parent, width, order, through, use = 'touch') {
    const curve = new Curve(parent, width, order, through);
    this.curves.push({ curve, use });
    if (this.colors) {
      curve.paint(this.colors[use], this.colors.halo, this.colors.was);
      curve.fit(this.canvas.clientWidth);
    }
    return curve;
  }

  // Round spots of so many pixels that nothing hides.
  addSpots(parent, geometry, pixels, order, more) {
    const points = new THREE.Points(geometry, new THREE.PointsMaterial({
      sizeAttenuation: false, transparent: true, fog: false, depthTest: false, map: roundSpot(), alphaTest: 0.05, ...more,
    }));
    points.frustumCulled = false;
    points.renderOrder = order;
    parent.add(points);
    this.spots.push({ points, pixels });
    return points;
  }

  paint(paper = false) {
    this.colors = colors(paper);
    this.world.background = this.colors.paper;
    this.stage.paint(this.colors);
    this.curves.forEach(({ curve, use }) => curve.paint(this.colors[use], this.colors.halo, this.colors.was));
  }

  fit() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width > 0 && height > 0) {
      this.resize(width, height, this.ratio);
      this.draw();
    }
  }

  resize(width, height, ratio) {
    this.renderer.setDrawingBufferSize(width, height, ratio);
    this.drawnRatio = ratio;
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.curves.forEach(({ curve }) => curve.fit(width));
    this.spots.forEach(({ points, pixels }) => { points.material.size = pixels * ratio; });
  }

  // Lengths at distance 1 are so many pixels high.
  pixels() {
    return (this.canvas.clientHeight || 1) / (2 * Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2)));
  }

  // Where a place is seen: pixels from the upper left corner, and its depth, between -1 and 1 in the picture.
  onCanvas(place) {
    const { x, y, z } = new THREE.Vector3(...place).project(this.camera);
    return [(x + 1) * this.canvas.clientWidth / 2, (1 - y) * this.canvas.clientHeight / 2, z];
  }

  // A picture of a row for paper, on a canvas of its own; the view stays as it is.
  pictureOf(r, width, height) {
    const kept = this.kept();
    this.flight = null;
    this.isMoving = false;
    this.paint(true);
    this.resize(width, height, 1);
    this.showAtOnce(r);
    this.render();
    const picture = document.createElement('canvas');
    [picture.width, picture.height] = [width, height];
    picture.getContext('2d').drawImage(this.canvas, 0, 0, width, height);
    this.paint();
    this.restore(kept);
    return picture;
  }

  kept() { return { eye: this.camera.position.clone(), target: this.controls.target.clone() }; }

  restore({ eye, target }) {
    this.fly(target, eye, false);
    this.fit();
  }

  // The camera goes to `eye` and looks at `target`, in an instant for who wants no motion.
  fly(target, eye, soft = true) {
    const isSoft = soft && !calm();
    this.flight = isSoft ? {
      since: performance.now(), fromTarget: this.controls.target.clone(), fromEye: this.camera.position.clone(), target, eye,
    } : null;
    if (!isSoft) {
      this.controls.target.copy(target);
      this.camera.position.copy(eye);
      this.controls.update();
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

  // How much farther away a picture must be seen from that is higher than wide.
  narrow() { return Math.max(1, 1.1 / this.camera.aspect); }

  // All of the scene is seen from there, whatever the shape of the picture.
  flyHome(home, soft = true) {
    this.framed = null;
    const toward = this.toward(...home).normalize();
    const { eye, target } = fittedEye(this.corners(), toward, this.camera, this.canvas.clientHeight);
    this.fly(target, eye, soft);
  }

  // Places around the whole scene.
  corners() {
    const { half } = this.all.scene;
    return Array.from({ length: 8 }, (_, k) => new THREE.Vector3(...half.map((part, axis) => (k >> axis & 1 ? part : -part))));
  }

  whole(soft = true) { this.flyHome(this.home, soft); }

  above() { this.flyHome([0, 1e-4, 0.95]); }

  // `more`: keys of the page, besides those that turn, move and zoom.
  addKeys(more) {
    const keys = {
      ArrowLeft: (shift) => (shift ? this.shift(-SHIFT, 0) : this.turn(-TURN, 0)),
      ArrowRight: (shift) => (shift ? this.shift(SHIFT, 0) : this.turn(TURN, 0)),
      ArrowUp: (shift) => (shift ? this.shift(0, SHIFT) : this.turn(0, -TURN)),
      ArrowDown: (shift) => (shift ? this.shift(0, -SHIFT) : this.turn(0, TURN)),
      '+': () => this.closer(CLOSER),
      '=': () => this.closer(CLOSER),
      '-': () => this.closer(1 / CLOSER),
      Home: () => this.whole(),
      ...more,
    };
    this.canvas.addEventListener('keydown', (event) => {
      const key = event.key.length === 1 ? event.key.toLowerCase() : event.key; // N is n with Caps Lock
      if (key in keys && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        keys[key](event.shiftKey);
      }
    });
  }

  offset() { return this.camera.position.clone().sub(this.controls.target); }

  turn(around, rise) {
    const offset = this.offset().applyAxisAngle(this.camera.up, around);
    const side = new THREE.Vector3().crossVectors(this.camera.up, offset).normalize();
    const raised = offset.clone().applyAxisAngle(side, rise);
    const angle = raised.angleTo(this.camera.up);
    this.place(angle > 0.02 && angle < Math.PI - 0.02 ? raised : offset);
  }

  closer(factor) { this.place(this.offset().multiplyScalar(factor)); }

  shift(right, upwards) {
    const offset = this.offset();
    this.controls.target.add(new THREE.Vector3(right, upwards, 0).multiplyScalar(offset.length()).applyQuaternion(this.camera.quaternion));
    this.place(offset);
  }

  place(offset) {
    this.flight = this.framed = null;
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
  }

  // The camera moves: what is slow to draw may wait until it is still.
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
      this.isMoving = Boolean(this.flight) || performance.now() - this.movedAt < 0.9 * STILL;
      this.setSharpness();
      this.render();
      this.drawn();
      this.layers.forEach((layer) => layer.draw(this.camera, this.canvas.clientWidth, this.canvas.clientHeight));
      if (this.flight) {
        this.drawMotion();
      }
    });
  }

  render() {
    const distance = this.offset().length();
    this.camera.near = Math.max(0.02 * distance, 1e-6 * this.all.scene.size);
    this.camera.far = distance + 6 * this.all.scene.size;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.prepare();
    this.curves.forEach(({ curve }) => {
      curve.setScale(this.pixels() / distance);
      curve.setCoarse(this.slow && this.isMoving);
    });
    this.stage.aim(this.controls.target, distance);
    this.renderer.render(this.world, this.camera);
  }

  // Where drawing is slow, fewer pixels are drawn as long as the camera moves.
  setSharpness() {
    const ratio = this.ratio * (this.slow && this.isMoving ? COARSE : 1);
    if (ratio !== this.drawnRatio && this.canvas.clientWidth > 0) {
      this.resize(this.canvas.clientWidth, this.canvas.clientHeight, ratio);
    }
  }

  prepare() {}

  // Measures the first picture, when it is seen, and how long the first whole one takes. The first has no shadows.
  drawn() {
    const since = performance.now();
    const whole = this.isWhole && !this.isMoving;
    const first = this.firstPicture === undefined;
    if (first) {
      this.firstPicture = { triangles: this.renderer.info.render.triangles };
    }
    if (first || (whole && !this.slow)) {
      requestAnimationFrame(() => requestAnimationFrame((now) => {
        this.slow ||= whole && !first && now - since > SLOW;
        if (first) {
          this.firstPicture.at = now;
          this.stage.addShadows();
          this.onFirst?.();
          this.draw();
        }
      }));
    }
  }
}
