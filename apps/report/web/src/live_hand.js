// The reader's hand on a body: dragged by the pointer along the ground or up and down, moved and turned by keys.
import * as THREE from 'three';
import { byId } from './page.js';

const LEVEL = 0.2; // sine of the eye's height over the ground below which the ground is seen too flat to drag along
const FARTHEST = 20; // sizes of the scene: pointers that meet the plane beyond it say nothing
const STEP = 0.02; // of a body's size, for a key
const TURN = 5; // degrees, for a key
const FINE = 0.1; // of that, with Shift

// `hold(body)` says that a body is held; `shift(by)` and `turn(axis, angle)` move the held one; `body()` is it.
export class Hand {
  constructor(view, held) {
    this.view = view;
    this.held = held;
    this.active = false;
    this.at = null; // the place that the pointer holds, while it does
    this.ray = new THREE.Raycaster();
    const { canvas } = view;
    const listen = (name, act) => canvas.addEventListener(name, (event) => {
      if (this.active && act(event)) {
        event.preventDefault();
        event.stopImmediatePropagation(); // neither the camera nor a choice
      }
    }, true);
    listen('pointerdown', (event) => this.take(event));
    listen('pointermove', (event) => this.drag(event));
    listen('pointerup', () => this.release());
    listen('pointercancel', () => this.release());
    listen('keydown', (event) => this.key(event));
  }

  get up() { return this.view.camera.up; }

  aim({ clientX, clientY }) {
    const frame = this.view.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(2 * (clientX - frame.left) / frame.width - 1, 1 - 2 * (clientY - frame.top) / frame.height);
    this.ray.setFromCamera(at, this.view.camera);
    return this.ray;
  }

  take(event) {
    const hit = event.isPrimary && event.button === 0 ? this.view.bodies.moverAt(this.aim(event)) : null;
    if (!hit) {
      return false;
    }
    this.view.canvas.setPointerCapture(event.pointerId);
    this.at = hit.point;
    this.last = event;
    this.held.hold(hit.body);
    byId('stage').classList.add('held');
    return true;
  }

  // Where the pointer is in the plane through the held place that it moves along.
  along(event, upwards) {
    const { camera } = this.view;
    const sight = camera.getWorldDirection(new THREE.Vector3());
    const rise = sight.dot(this.up);
    const normal = upwards ? sight.addScaledVector(this.up, -rise) : Math.abs(rise) > LEVEL ? this.up : sight;
    const place = this.aim(event).ray.intersectPlane(
      new THREE.Plane().setFromNormalAndCoplanarPoint(normal.clone().normalize(), this.at), new THREE.Vector3());
    return place && place.distanceTo(this.at) < FARTHEST * this.view.all.scene.size ? place : null;
  }

  drag(event) {
    if (!this.at) {
      return false;
    }
    const [from, to] = [this.last, event].map((which) => this.along(which, event.shiftKey));
    this.last = event;
    if (from && to) {
      const by = to.sub(from);
      if (event.shiftKey) {
        by.copy(this.up).multiplyScalar(by.dot(this.up));
      }
      this.at.add(by);
      this.held.shift(by);
    }
    return true;
  }

  release() {
    const was = this.at;
    this.at = null;
    byId('stage').classList.remove('held');
    return Boolean(was);
  }

  // Right, ahead and up as the reader sees them, along the ground.
  axes() {
    const { camera } = this.view;
    const right = new THREE.Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
    right.addScaledVector(this.up, -right.dot(this.up)).normalize();
    return { right, ahead: new THREE.Vector3().crossVectors(this.up, right), up: this.up.clone() };
  }

  key(event) {
    const { right, ahead, up } = this.axes();
    const share = event.shiftKey ? FINE : 1;
    const far = share * STEP * this.view.bodies.sizeOf(this.held.body());
    const angle = share * THREE.MathUtils.degToRad(TURN);
    const shifts = {
      ArrowLeft: [right, -far], ArrowRight: [right, far], ArrowUp: [ahead, far], ArrowDown: [ahead, -far], PageUp: [up, far], PageDown: [up, -far],
    };
    const turns = {
      q: [up, angle], e: [up, -angle], w: [right, -angle], s: [right, angle], a: [ahead, -angle], d: [ahead, angle],
    };
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.metaKey || event.altKey) {
      return false;
    }
    if (name in shifts) {
      this.held.shift(shifts[name][0].multiplyScalar(shifts[name][1]));
    } else if (name in turns) {
      this.held.turn(...turns[name]);
    } else if (name === 'r') {
      this.held.reset();
    } else {
      return false;
    }
    return true;
  }
}
