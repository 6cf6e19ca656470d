// The blocks of data that the page carries, decoded.

const NONE = 0xffffffff;
const WORDS_OF_CONTACT = 28;
const WORDS_OF_ROW = 17;
const WORDS_OF_PAIR = 26;
const WORDS_OF_GAP = 26;

function takeText(id) {
  const element = document.getElementById(`soms-${id}`);
  const text = element.textContent;
  element.remove(); // its memory is not needed twice
  return text;
}

function takeBytes(id) {
  const raw = atob(takeText(id));
  const bytes = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; ++k) {
    bytes[k] = raw.charCodeAt(k);
  }
  return bytes.buffer;
}

// Contacts, or those of them that the page has room for; names are put together only where somebody looks.
class Contacts {
  constructor(scene) {
    this.scene = scene;
    const buffer = takeBytes('contacts');
    this.words = new Uint32Array(buffer);
    this.floats = new Float32Array(buffer);
    const pairs = takeBytes('pairs');
    this.pairWords = new Uint32Array(pairs);
    this.pairFloats = new Float32Array(pairs);
    this.count = scene.contacts.listed;
  }

  word(k, column) {
    return this.words[k * WORDS_OF_CONTACT + column];
  }

  slice(k, column, count) {
    const at = k * WORDS_OF_CONTACT + column;
    return this.floats.subarray(at, at + count);
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

  reach(k) { return this.slice(k, 12, 1)[0]; }

  pose(k, side) { return this.slice(k, 13 + 7 * side, 7); }

  // Numbers of the triangles of one side, each once.
  triangles(k, side) {
    const found = new Set();
    for (let n = 0; n < this.pairCount(k); ++n) {
      found.add(this.pairWords[(this.firstPair(k) + n) * WORDS_OF_PAIR + side]);
    }
    return [...found];
  }

  // Number of the triangle of pair n, counted over all contacts.
  triangleOf(n, side) { return this.pairWords[n * WORDS_OF_PAIR + side]; }

  // The two ends of the line in which the triangles of pair n cross.
  crossing(n) {
    const at = n * WORDS_OF_PAIR + 20;
    return this.pairFloats.subarray(at, at + 6);
  }

  // The nine coordinates of a triangle of pair n, counted over all contacts.
  corners(n, side) {
    const at = n * WORDS_OF_PAIR + 2 + 9 * side;
    return this.pairFloats.subarray(at, at + 9);
  }
}

// Two bodies, or parts of them, that touch; every such pair is here.
class Rows {
  constructor(scene, contacts) {
    this.scene = scene;
    const buffer = takeBytes('rows');
    this.words = new Uint32Array(buffer);
    this.floats = new Float32Array(buffer);
    this.count = scene.rows;
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

  word(r, column) {
    return this.words[r * WORDS_OF_ROW + column];
  }

  slice(r, column, count) {
    const at = r * WORDS_OF_ROW + column;
    return this.floats.subarray(at, at + count);
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

  center(r) { return this.slice(r, 11, 3); }

  half(r) { return this.slice(r, 14, 3); }

  // Numbers of the contacts that the page holds, in order of time.
  contacts(r) { return this.members.subarray(this.starts[r], this.starts[r + 1]); }
}

// Shortest segments between two bodies that are near each other, each at the step where it is least.
class Gaps {
  constructor(scene) {
    const buffer = takeBytes('gaps');
    this.words = new Uint32Array(buffer);
    this.floats = new Float32Array(buffer);
    this.lengths = scene.gaps.lengths;
    this.count = scene.gaps.listed;
  }

  word(g, column) { return this.words[g * WORDS_OF_GAP + column]; }

  slice(g, column, count) {
    const at = g * WORDS_OF_GAP + column;
    return this.floats.subarray(at, at + count);
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

  reach(g) { return this.slice(g, 11, 1)[0]; }

  pose(g, side) { return this.slice(g, 12 + 7 * side, 7); }
}

export function load() {
  const scene = JSON.parse(takeText('scene'));
  scene.size = 2 * Math.hypot(...scene.half) || 1;
  scene.models.forEach((model, k) => {
    const buffer = takeBytes(`model-${k}`);
    model.positions = new Float32Array(buffer, 0, 3 * model.vertices);
    model.indices = new Uint32Array(buffer, 12 * model.vertices);
  });
  scene.still = new Float32Array(takeBytes('still'));
  scene.poses = new Float32Array(takeBytes('poses'));
  scene.moving = scene.bodies.moves.reduce((sum, moves) => sum + moves, 0);
  const contacts = new Contacts(scene);
  return { scene, contacts, rows: new Rows(scene, contacts), gaps: new Gaps(scene) };
}
