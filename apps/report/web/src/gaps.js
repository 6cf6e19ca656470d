// Gaps: shortest segments between bodies, drawn over the picture with their lengths. Lines and words
// of the page stay sharp, are as thick as they are to be, and no wall hides them.
import * as THREE from 'three';
import { byId, svg } from './page.js';

const MOST_LENGTHS = 24; // written at a time; more would hide each other
const NEAR_POINTER = 10; // pixels

export class GapLines {
  constructor(all, layer = 'gaps') {
    this.gaps = all.gaps;
    this.faint = all.scene.steps.smooth; // those of other poses would say nothing of this one
    this.step = 0;
    this.chosen = -1;
    this.layer = byId(layer);
    this.layer.classList.toggle('many', this.gaps.count > MOST_LENGTHS); // those of other steps are thin lines
    this.marks = Array.from({ length: this.gaps.count }, (_, g) => {
      const group = svg('g', this.layer);
      const mark = {
        group, halo: svg('line', group, 'halo'), line: svg('line', group, 'ink'), ends: [svg('circle', group, 'end'), svg('circle', group, 'end')], text: svg('text', group),
      };
      mark.ends.forEach((end) => end.setAttribute('r', 4));
      mark.text.textContent = this.gaps.lengths[g];
      return mark;
    });
  }

  setLength(g, text) {
    this.marks[g].text.textContent = text;
  }

  lasts(g) {
    return this.gaps.begin(g) <= this.step && this.step <= this.gaps.end(g);
  }

  // Where a gap ends on the canvas, of the part in front of the eye; nothing if all is behind it.
  segment(g, camera, width, height) {
    const ends = [0, 1].map((side) => new THREE.Vector3().fromArray(this.gaps.point(g, side))
      .applyMatrix4(camera.matrixWorldInverse));
    const depth = (end) => -end.z - camera.near;
    if (depth(ends[0]) <= 0 && depth(ends[1]) <= 0) {
      return null;
    }
    const [a, b] = ends.map(depth);
    if (a * b < 0) {
      const cut = ends[0].clone().lerp(ends[1], a / (a - b));
      ends[a < 0 ? 0 : 1].copy(cut);
    }
    return ends.map((end) => end.applyMatrix4(camera.projectionMatrix))
      .map(({ x, y }) => [(x + 1) * width / 2, (1 - y) * height / 2]);
  }

  isSeen(g) {
    return g === this.chosen || this.faint || this.lasts(g);
  }

  draw(camera, width, height) {
    const written = []; // places of lengths
    camera.updateMatrixWorld();
    this.marks.forEach((mark, g) => {
      const ends = this.isSeen(g) ? this.segment(g, camera, width, height) : null;
      mark.group.style.display = ends ? '' : 'none';
      if (!ends) {
        return;
      }
      const now = this.lasts(g);
      const exact = Math.floor(this.step) === this.gaps.nearest(g);
      mark.group.setAttribute('class', `${exact ? 'is' : 'was'}${now || g === this.chosen ? '' : ' far'}${g === this.chosen ? ' chosen' : ''}`);
      for (const line of [mark.halo, mark.line]) {
        ['x1', 'y1', 'x2', 'y2'].forEach((name, k) => line.setAttribute(name, ends[k >> 1][k & 1].toFixed(1)));
      }
      mark.ends.forEach((end, side) => {
        end.setAttribute('cx', ends[side][0].toFixed(1));
        end.setAttribute('cy', ends[side][1].toFixed(1));
      });
      this.write(mark, g, ends, now, written);
    });
  }

  // The length beside the middle of the segment, unless another one is there: the nearest come first.
  write(mark, g, ends, now, written) {
    const x = (ends[0][0] + ends[1][0]) / 2;
    const steep = Math.abs(ends[0][1] - ends[1][1]) > Math.abs(ends[0][0] - ends[1][0]);
    const y = (ends[0][1] + ends[1][1]) / 2;
    const at = steep ? [x + 12, y + 5] : [x, y - 10];
    const free = written.length < MOST_LENGTHS
      && written.every((other) => Math.abs(other[0] - at[0]) > 80 || Math.abs(other[1] - at[1]) > 16);
    const shown = g === this.chosen || (now && free);
    mark.text.style.display = shown ? '' : 'none';
    if (shown) {
      written.push(at);
      mark.text.style.textAnchor = steep ? 'start' : 'middle';
      mark.text.setAttribute('x', at[0].toFixed(1));
      mark.text.setAttribute('y', at[1].toFixed(1));
    }
  }

  // The gap whose segment is nearest to a place on the canvas; -1 if none is near.
  at(x, y, camera, width, height) {
    const place = new THREE.Vector3(x, y, 0);
    const nearest = new THREE.Vector3();
    let best = -1;
    let least = NEAR_POINTER;
    this.marks.forEach((_, g) => {
      const ends = this.isSeen(g) ? this.segment(g, camera, width, height) : null;
      if (ends) {
        const [a, b] = ends.map(([u, v]) => new THREE.Vector3(u, v, 0));
        const distance = new THREE.Line3(a, b).closestPointToPoint(place, true, nearest).distanceTo(place);
        if (distance < least) {
          least = distance;
          best = g;
        }
      }
    });
    return best;
  }
}
