// Round marks of rows that are always as large on the screen: which one the pointer means, and how many lie on each other.
import { SpotCounts } from './counts.js';

const NEAR_POINTER = 14; // pixels

// `seen()` gives the spots of a picture, each with its place and its row, and `isNow(spot)` says whether it touches now.
export class Spots {
  constructor(view, seen, isNow) {
    Object.assign(this, { view, seen, isNow });
    this.counts = new SpotCounts();
    view.layers.push(this);
  }

  get heaps() { return this.counts.heaps; }

  // The spot nearest to a place on the canvas; undefined if none is near.
  at(spots, x, y) {
    const near = spots.map((spot) => {
      const [u, v, depth] = this.view.onCanvas(spot.place);
      return { spot, away: Math.abs(depth) <= 1 ? Math.hypot(u - x, v - y) : Infinity };
    });
    return near.reduce((best, one) => (one.away < best.away ? one : best), { away: NEAR_POINTER }).spot;
  }

  // Numbers where spots lie on each other.
  draw() {
    const { clientWidth: width, clientHeight: height } = this.view.canvas;
    this.counts.draw(this.seen().map((spot) => [...this.view.onCanvas(spot.place), this.isNow(spot)])
      .filter(([x, y, depth]) => Math.abs(depth) <= 1 && x >= 0 && y >= 0 && x <= width && y <= height)
      .map(([x, y, , now]) => ({ x, y, now })));
  }
}
