// The slider over steps, and playing.
import { byId } from './page.js';

const SLOW = 4; // steps a second where steps are no time

export class Time {
  constructor(all, onStep) {
    this.steps = all.scene.steps;
    this.onStep = onStep;
    this.step = 0;
    this.slider = byId('step');
    this.button = byId('play');
    this.slider.max = Math.max(0, this.steps.count - 1);
    byId('time').hidden = this.steps.count < 2;
    this.slider.addEventListener('input', () => {
      this.stop();
      this.go(Number(this.slider.value));
    });
    this.button.addEventListener('click', () => this.toggle());
  }

  // Sets the slider without telling anybody.
  show(step) {
    this.step = step;
    this.slider.value = Math.floor(step);
  }

  go(step) {
    this.show(step);
    this.onStep(step);
  }

  toggle() {
    if (this.playing) {
      this.stop();
    } else if (this.steps.count > 1) {
      this.playing = true;
      this.button.textContent = 'Pause';
      if (this.step >= this.steps.count - 1) {
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
    const end = this.steps.count - 1;
    this.go(Math.min(end, this.step + passed * (this.steps.second || SLOW)));
    if (this.step >= end) {
      this.stop();
    }
    requestAnimationFrame((later) => this.next(later));
  }
}
