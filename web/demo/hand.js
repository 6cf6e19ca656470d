// Mouse, fingers and keys: they move the body or the camera.

/** Where an event is in the picture, each coordinate from -1 to 1. */
function placeOf(event, canvas) {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return [2 * (event.clientX - left) / width - 1, 1 - 2 * (event.clientY - top) / height];
}

const ARROWS = {
  ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageUp: [2, -1], PageDown: [2, 1],
};

export class Hand {
  #drag = null;

  /**
   * `world`: {camera, picture, placement()}. `pick(ray)` promises the point of the moved body that is seen there, or null.
   * `changed(moved)` is called after each change; `moved`: of the body.
   */
  constructor(canvas, world, pick, changed) {
    Object.assign(this, { canvas, world, pick, changed });
    canvas.addEventListener('pointerdown', (event) => this.#down(event));
    canvas.addEventListener('pointermove', (event) => this.#move(event));
    for (const end of ['pointerup', 'pointercancel']) {
      canvas.addEventListener(end, () => { this.#drag = null; });
    }
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      world.camera.zoom(event.deltaY);
      changed(false);
    }, { passive: false });
    canvas.addEventListener('keydown', (event) => this.#key(event));
  }

  /** What the drag that goes on does: 'move', 'turn' or 'orbit'; null where none does yet. */
  holds() {
    return this.#drag?.does ?? null;
  }

  async #down(event) {
    const { camera, picture } = this.world;
    this.canvas.focus();
    this.canvas.setPointerCapture(event.pointerId);
    const drag = { at: [event.clientX, event.clientY], turns: event.shiftKey || event.button === 2, does: null };
    this.#drag = drag;
    const seen = await this.pick(camera.ray(...placeOf(event, this.canvas), picture.aspect()));
    drag.point = seen;
    drag.does = seen === null ? 'orbit' : drag.turns ? 'turn' : 'move';
  }

  #move(event) {
    const drag = this.#drag;
    if (drag === null || drag.does === null) {
      return;  // what lies under the pointer is not known yet: the next event has the whole way
    }
    const [dx, dy] = [event.clientX - drag.at[0], event.clientY - drag.at[1]];
    drag.at = [event.clientX, event.clientY];
    const { camera } = this.world;
    if (drag.does === 'orbit') {
      camera.orbit(dx, dy);
      this.changed(false);
    } else if (drag.does === 'turn') {
      this.#turn(0.008 * dx, 0.008 * dy);
    } else {
      const pixel = camera.pixel(drag.point, this.canvas.clientHeight);
      this.#shift([dx * pixel, -dy * pixel, 0]);
    }
  }

  /** By lengths to the right, up and toward the eye. */
  #shift(lengths) {
    const axes = this.world.camera.axes();
    this.world.placement().move([0, 1, 2].map((k) => axes.reduce((sum, axis, i) => sum + lengths[i] * axis[k], 0)));
    this.changed(true);
  }

  #turn(aboutUp, aboutRight) {
    const [right, up] = this.world.camera.axes();
    this.world.placement().turn(up, aboutUp);
    this.world.placement().turn(right, aboutRight);
    this.changed(true);
  }

  #key(event) {
    if (event.key === 'Home') {
      this.world.placement().reset();
      this.changed(true);
    } else if (event.key in ARROWS) {
      const [axis, sign] = ARROWS[event.key];
      if (event.shiftKey) {
        this.#turn(axis === 0 ? 0.03 * sign : 0, axis === 0 ? 0 : -0.03 * sign);
      } else {
        const step = sign * 0.005 * this.world.camera.size;
        this.#shift([0, 1, 2].map((k) => (k === axis ? step : 0)));
      }
    } else {
      return;
    }
    event.preventDefault();
  }
}
