// The slider over steps, or over a way, and playing.
import { byId } from './page.js';

const SLOW = 4; // steps a second where steps are no time

// How the slider goes over the steps of a scene.
export const overSteps = ({ count, second }) => ({
  slider: byId('step'), end: Math.max(0, count - 1), speed: second || SLOW, mark: Math.floor,
});

export class Time {
  // From 0 to `end`, at `speed` a second; the slider stands at `mark` of where it is.
  constructor({ slider, end, speed, mark }, onStep) {
    Object.assign(this, { slider, end, speed, mark, onStep });
    this.step = 0;
    this.button = byId('play');
    this.slider.max = end;
    byId('time').hidden = end === 0;
    this.slider.addEventListener('input', () => {
      this.stop();
      this.go(Number(this.slider.value));
    });
    this.button.addEventListener('click', () => this.toggle());
  }

  // Sets the slider without telling anybody.
  show(step) {
    this.step = step;
    this.slider.value = this.mark(step);
  }

  go(step) {
    this.show(step);
    this.onStep(step);
  }

  toggle() {
    if (this.playing) {
      this.stop();
    } else if (this.end > 0) {
      this.playing = true;
      this.button.textContent = 'Pause';
      if (this.step >= this.end) {
        this.go(0);
      }
      this.last = performance.now();
      requestAnimationFrame((now) => this.next(now));
    }
  }

  stop() {
    this.playing = false;
    this.button.textContent = 'Play';
  }

  next(now) {
    if (!this.playing) {
      return;
    }
    const passed = Math.max(0, now - this.last) / 1000;
    this.last = now;
    this.go(Math.min(this.end, this.step + passed * this.speed));
    if (this.step >= this.end) {
      this.stop();
    }
    requestAnimationFrame((later) => this.next(later));
  }
}
