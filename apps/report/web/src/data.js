// The blocks of data that the page carries, decoded.

import { bytesOf } from './exact.js';
import { Packed, unpackLines, unpackMesh, unpackPairs, unpackPoses } from './packed.js';

const NONE = 0xffffffff;

export function takeText(id) {
  const element = document.getElementById(`soms-${id}`);
  const text = element.textContent;
  element.remove(); // its memory is not needed twice
  return text;
}

const takeBytes = (id) => bytesOf(takeText(id));

const takeWords = (id) => takeBytes(id).buffer;

// Rows of so many words of four bytes each.
export class Table {
  constructor(id, width) {
    const buffer = takeWords(id);
    this.width = width;
    this.words = new Uint32Array(buffer);
    this.floats = new Float32Array(buffer);
    this.count = this.words.length / width;
  }

  word(k, column) { return this.words[k * this.width + column]; }

  float(k, column) { return this.floats[k * this.width + column]; }

  slice(k, column, count) {
    const at = k * this.width + column;
    return this.floats.subarray(at, at + count);
  }
}

// Contacts, or those of them that the page has room for; names are put together only where somebody looks.
class Contacts extends Table {
  constructor(scene) {
    super('contacts', 28);
    this.pairs = unpackPairs(takeBytes('pairs'), scene.contacts.pairs, scene.place_step);
  }

  a(k) { return this.word(k, 0); }

  b(k) { return this.word(k, 1); }

  part(k, side) { return this.word(k, 2 + side); }

  row(k) { return this.word(k, 27); }

  begin(k) { return this.word(k, 4); }

  end(k) { return this.word(k, 5); }

  pairsInAll(k) { return this.word(k, 6); }

  firstPair(k) { return this.word(k, 7); }

  pairCount(k) { return this.word(k, 8); }

  focus(k) { return this.slice(k, 9, 3); }

  reach(k) { return this.float(k, 12); }

  pose(k, side) { return this.slice(k, 13 + 7 * side, 7); }

  // Numbers of the triangles of one side, each once.
  triangles(k, side) {
    const found = new Set();
    for (let n = 0; n < this.pairCount(k); ++n) {
      found.add(this.triangleOf(this.firstPair(k) + n, side));
    }
    return [...found];
  }

  // Number of the triangle of pair n, counted over all contacts.
  triangleOf(n, side) { return this.pairs.numbers[2 * n + side]; }

  // The two ends of the line in which the triangles of pair n cross.
  crossing(n) {
    return this.pairs.points.subarray(24 * n, 24 * n + 6);
  }

  // The nine coordinates of a triangle of pair n, counted over all contacts.
  corners(n, side) {
    const at = 24 * n + 6 + 9 * side;
    return this.pairs.points.subarray(at, at + 9);
  }
}

// Two bodies, or parts of them, that touch; every such pair is here.
class Rows extends Table {
  constructor(scene, contacts) {
    super('rows', 19);
    this.passages = scene.passages ?? { row: this.count, after: [], proved: [] };
    // Contacts of each row: sorted by row, and where those of a row begin.
    this.starts = new Uint32Array(this.count + 1);
    for (let k = 0; k < contacts.count; ++k) {
      ++this.starts[contacts.row(k) + 1];
    }
    for (let r = 0; r < this.count; ++r) {
      this.starts[r + 1] += this.starts[r];
    }
    const next = this.starts.slice();
    this.members = new Uint32Array(contacts.count);
    for (let k = 0; k < contacts.count; ++k) {
      this.members[next[contacts.row(k)]++] = k;
    }
  }

  a(r) { return this.word(r, 0); }

  b(r) { return this.word(r, 1); }

  part(r, side) { return this.word(r, 2 + side); }

  total(r) { return this.word(r, 4) + 2 ** 32 * this.word(r, 5); }

  steps(r) { return this.word(r, 6); }

  begin(r) { return this.word(r, 7); }

  end(r) { return this.word(r, 8); }

  // Number of the first triangle on one side; undefined for a body as a whole.
  triangle(r, side) {
    const number = this.word(r, 9 + side);
    return number === NONE ? undefined : number;
  }

  // The most pairs of triangles that touch at a step, and the first such step; 0 where nobody counted.
  mostPairs(r) { return this.word(r, 11); }

  mostStep(r) { return this.word(r, 12); }

  // The step at which a row is shown.
  moment(r) { return this.mostPairs(r) > 0 ? this.mostStep(r) : this.begin(r) + this.after(r); }

  // The part of the way to the next step, of a passage; else 0.
  after(r) { return this.passages.after[r - this.passages.row] ?? 0; }

  // 0: touches; 1: passes between two steps; 2: perhaps.
  meeting(r) {
    const proved = this.passages.proved[r - this.passages.row];
    return proved === undefined ? 0 : 2 - proved;
  }

  center(r) { return this.slice(r, 13, 3); }

  half(r) { return this.slice(r, 16, 3); }

  // Numbers of the contacts that the page holds, in order of time.
  contacts(r) { return this.members.subarray(this.starts[r], this.starts[r + 1]); }
}

// Where the two of a row cross at its step of most pairs: lines, and all that is to be known to draw
// them. Not every row has one.
class Curves extends Table {
  constructor() {
    super('curves', 21);
    this.ofRow = new Map();
    this.lines = [];
    const packed = new Packed(takeBytes('lines'));
    for (let c = 0; c < this.count; ++c) {
      this.ofRow.set(this.row(c), c);
      this.lines.push(unpackLines(packed, this.word(c, 1), this.place(c), this.float(c, 6)));
    }
  }

  row(c) { return this.word(c, 0); }

  place(c) { return this.slice(c, 2, 3); }

  reach(c) { return this.float(c, 5); }

  pose(c, side) { return this.slice(c, 7 + 7 * side, 7); }
}

// Shortest segments between two bodies that are near each other, each at the step where it is least.
class Gaps extends Table {
  constructor(scene) {
    super('gaps', 26);
    this.lengths = scene.gaps.lengths;
  }

  a(g) { return this.word(g, 0); }

  b(g) { return this.word(g, 1); }

  begin(g) { return this.word(g, 2); }

  end(g) { return this.word(g, 3); }

  nearest(g) { return this.word(g, 4); }

  point(g, side) { return this.slice(g, 5 + 3 * side, 3); }

  middle(g) {
    const [a, b] = [this.point(g, 0), this.point(g, 1)];
    return [0, 1, 2].map((axis) => (a[axis] + b[axis]) / 2);
  }

  reach(g) { return this.float(g, 11); }

  pose(g, side) { return this.slice(g, 12 + 7 * side, 7); }
}

const takeMesh = (id, triangles, step) => unpackMesh(takeBytes(id), triangles, step);

// The whole of a model that had a coarse stand-in. Its block is behind the script.
export function loadModel({ scene }, k) {
  const { drawn, step } = scene.models[k];
  return takeMesh(`model-${k}`, drawn, step);
}

// All that a first picture needs.
export function load() {
  const scene = JSON.parse(takeText('scene'));
  scene.size = 2 * Math.hypot(...scene.half) || 1;
  scene.models.forEach((model, k) => {
    const { coarse, drawn, step } = model;
    model.mesh = coarse > 0 ? takeMesh(`coarse-${k}`, coarse, step) : takeMesh(`model-${k}`, drawn, step);
  });
  scene.still = new Float32Array(takeWords('still'));
  scene.moving = scene.bodies.moves.reduce((sum, moves) => sum + moves, 0);
  scene.poses = unpackPoses(takeBytes('poses'), scene.moving, scene.steps.kept.length, scene.place_step, scene.turns);
  const contacts = new Contacts(scene);
  return {
    scene, contacts, rows: new Rows(scene, contacts), curves: new Curves(), gaps: new Gaps(scene),
  };
}
