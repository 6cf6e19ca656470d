// Numbers on spots that lie on each other: how many rows of the list are there.
import { byId, svg } from './page.js';

const APART = 20; // pixels: spots nearer than this are one
const MOST = 400; // numbers in a picture

// Places that are nearer to each other than `apart` as one, each with how many there are that are
// now, and in all. A place joins the first one that is near, so that each counts once.
export function gathered(places, apart = APART) {
  const cells = new Map();
  const heaps = [];
  for (const { x, y, now } of places) {
    const [column, row] = [Math.floor(x / apart), Math.floor(y / apart)];
    let heap;
    for (let n = 0; n < 9 && !heap; ++n) {
      heap = cells.get(`${column + (n % 3) - 1} ${row + Math.floor(n / 3) - 1}`)
        ?.find((other) => Math.hypot(other.x - x, other.y - y) < apart);
    }
    if (!heap) {
      heap = { x, y, now: 0, all: 0 };
      heaps.push(heap);
      const key = `${column} ${row}`;
      cells.set(key, [...(cells.get(key) ?? []), heap]);
    }
    heap.now += now ? 1 : 0;
    heap.all += 1;
  }
  return heaps;
}

export class SpotCounts {
  constructor() {
    this.layer = byId('spots');
    this.marks = [];
    this.heaps = [];
  }

  // `places` are those of spots that are seen, in pixels; `now` says which touch at the step that is shown.
  draw(places) {
    this.heaps = gathered(places);
    const many = this.heaps.filter(({ now, all }) => (now || all) > 1).slice(0, MOST);
    while (this.marks.length < many.length) {
      const group = svg('g', this.layer);
      this.marks.push({ group, disc: svg('circle', group), text: svg('text', group) });
    }
    this.marks.forEach(({ group, disc, text }, k) => {
      group.style.display = k < many.length ? '' : 'none';
      if (k < many.length) {
        const { x, y, now, all } = many[k];
        text.textContent = (now || all).toLocaleString('en');
        group.setAttribute('class', now ? '' : 'was');
        group.setAttribute('transform', `translate(${x.toFixed(1)} ${y.toFixed(1)})`);
        disc.setAttribute('r', 6 + 3 * text.textContent.length);
      }
    });
  }
}
