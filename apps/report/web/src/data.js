// The blocks of data that the page carries, decoded.

const NONE = 0xffffffff;
const WORDS_OF_CONTACT = 27;
const WORDS_OF_PAIR = 20;

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

// Contact k as an object; names are put together only where somebody looks.
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

  part(k, side) {
    const number = this.word(k, 2 + side);
    return number === NONE ? '' : this.scene.parts[number];
  }

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

  // The nine coordinates of a triangle of pair n, counted over all contacts.
  corners(n, side) {
    const at = n * WORDS_OF_PAIR + 2 + 9 * side;
    return this.pairFloats.subarray(at, at + 9);
  }
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
  return { scene, contacts: new Contacts(scene) };
}
