// What is drawn of a moved body's answer: the curve where it crosses others, or the shortest segment to the nearest.
import { GapLines } from './gaps.js';
import { inDigits } from './words.js';

const ALWAYS_SEEN = 15; // drawing order: above the contacts of the report

// One gap, in the form of those of the report.
class LiveGap {
  constructor() {
    this.count = 1;
    this.lengths = [''];
    this.points = null;
  }

  begin() { return -Infinity; }

  end() { return Infinity; }

  nearest() { return 0; }

  point(_, side) { return this.points[side]; }
}

export class LiveView {
  constructor(view) {
    this.view = view;
    this.curve = view.addCurve(view.world, 4, ALWAYS_SEEN, true);
    this.gap = new LiveGap();
    this.gapLines = new GapLines({ gaps: this.gap, scene: view.all.scene }, 'live-gap');
    view.layers.push(this);
  }

  // `lines` six floats each; `gap` two points and their distance, or nothing.
  show(lines, gap) {
    this.curve.show(lines, this.view.all.scene.size);
    this.gap.points = gap && gap.points;
    this.gapLines.setLength(0, gap ? inDigits(gap.length) : '');
    this.view.draw();
  }

  draw(camera, width, height) {
    this.gapLines.layer.style.display = this.gap.points ? '' : 'none';
    if (this.gap.points) {
      this.gapLines.draw(camera, width, height);
    }
  }
}
