// The blocks of data of a page about a list of parts, decoded.
import { Table, takeText } from './data.js';
import { bytesOf } from './exact.js';
import { Packed, unpackLines, unpackNextMesh } from './packed.js';

// A float of four bytes among numbers of any length.
function nextFloat(packed) {
  const view = new DataView(packed.bytes.buffer, packed.bytes.byteOffset + packed.at, 4);
  packed.at += 4;
  return view.getFloat32(0, true);
}

// Parts as they are drawn: triangles around the place of their middle.
function takeParts(count) {
  const packed = new Packed(bytesOf(takeText('parts')));
  return Array.from({ length: count }, () => {
    const [drawn, all] = [packed.next(), packed.next()];
    const step = nextFloat(packed);
    const place = [nextFloat(packed), nextFloat(packed), nextFloat(packed)];
    return { all, place, mesh: unpackNextMesh(packed, drawn, step) };
  });
}

class Sights extends Table {
  constructor() { super('sights', 11); }

  place(r) { return this.slice(r, 0, 3); }

  focus(r) { return this.slice(r, 3, 3); }

  // 0 of a row that has no place.
  reach(r) { return this.float(r, 6); }

  toward(r) { return this.slice(r, 7, 3); }

  aIsLarger(r) { return this.float(r, 10) > 0; }
}

// Lines along which the two of a row cross, by row.
function takeCurves(sights) {
  const table = new Table('curves', 3);
  const packed = new Packed(bytesOf(takeText('lines')));
  const curves = new Map();
  for (let c = 0; c < table.count; ++c) {
    const row = table.word(c, 0);
    curves.set(row, unpackLines(packed, table.word(c, 1), sights.focus(row), table.float(c, 2)));
  }
  return curves;
}

export function isClashPage() {
  return document.getElementById('soms-clashes') !== null;
}

export function loadClashes() {
  const list = JSON.parse(takeText('clashes'));
  const scene = JSON.parse(takeText('parts-scene'));
  scene.size = 2 * Math.hypot(...scene.half) || 1;
  const sights = new Sights();
  return {
    ...list, scene, sights, curves: takeCurves(sights), parts: takeParts(scene.parts),
  };
}
