// Tree files through the package, in node. WEB_PACKAGE and WEB_DATA as in truth.test.mjs; SOMS_NATIVE_COMMAND is the
// command of the host, where it is built.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

const { SOMS_NATIVE_COMMAND: command, WEB_DATA: data, WEB_PACKAGE: folder } = process.env;
const soms = await import(pathToFileURL(join(folder, 'soms.js')));
const { start } = await import(pathToFileURL(join(folder, 'worker.js')));

const CHECKS = ['trusted', 'safe', 'sound', 'full'];
const LAYOUTS = ['wide', 'compact'];
// Hashes of the sheet's files, as tests/store/tree_file_test.cpp has them for the host.
const GOLDEN = { wide: 0x86d2addf460a240cn, compact: 0x55a8ac8306870da4n };
const NAMES = ['head', 'vertices', 'triangles', 'faces', 'statements', 'nodes', 'blocks', 'least_ids'];

/** A sheet of 40 x 40 squares in steps, whose coordinates no arithmetic rounds. */
function steppedSheet() {
  const side = 40;
  const [vertices, triangles] = [[], []];
  for (let i = 0; i <= side; ++i) {
    for (let j = 0; j <= side; ++j) {
      vertices.push(i / 8, j / 8, ((7 * i * i + 13 * j * j + 5 * i * j) % 17) / 64);
      if (i < side && j < side) {
        const at = i * (side + 1) + j;
        triangles.push(at, at + 1, at + side + 1, at + 1, at + side + 2, at + side + 1);
      }
    }
  }
  return { vertices, triangles };
}

const shifted = (x, y, z) => Float64Array.of(1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z);
const viewOf = (bytes) => new DataView(bytes.buffer, bytes.byteOffset);
/** Where the records of a section begin; section -1 is the head. */
const offsetOf = (bytes, section) => (section < 0 ? 64 : Number(viewOf(bytes).getBigUint64(256 + 32 * section + 8, true)));

/** A copy with one bit of a byte changed. */
function damaged(bytes, at, bit = 0) {
  const copy = bytes.slice();
  copy[at] ^= 1 << bit;
  return copy;
}

function fails(kind, place, call) {
  assert.throws(call, (error) => {
    assert.ok(error instanceof soms.SomsError, String(error));
    assert.equal(error.kind, kind);
    assert.match(error.place, place);
    return true;
  });
}

async function shapeOf(name, options) {
  const mesh = soms.readMesh(await readFile(join(data, 'meshes', `${name}.ply`)), `${name}.ply`);
  const shape = new soms.Shape(mesh, options);
  mesh.free();
  return shape;
}

/** What is asked of a shape: every kind of query, with its costs. */
function answersOf(shape, other) {
  const { lower, upper } = shape.bounds();
  const middle = Array.from(lower, (x, k) => (x + upper[k]) / 2);
  const poses = [0, 0.5, 1, 3].map((part) => shifted(...lower.map((x, k) => part * (upper[k] - x))));
  const ray = { origin: [lower[0] - 1, middle[1], middle[2]], direction: [1, 0.01, 0.02] };
  const index = new soms.WindingIndex(shape);
  const answers = [
    soms.overlapBatch(other, poses, shape), soms.overlapBatch(shape, poses, other), soms.overlap(shape, shape),
    soms.distanceBatch(other, poses, shape), soms.withinBatch(other, poses, shape, 0.1),
    soms.closest(shape, middle), soms.nearestTriangles(shape, [middle], 5), soms.winding(index, middle),
    soms.closestHit(shape, ray), soms.anyHit(shape, ray), soms.allHits(shape, [ray]), shape.bounds(), shape.read(),
  ];
  index.free();
  return answers;
}

before(() => soms.load());

test('bytes are those that the host writes', () => {
  for (const layout of LAYOUTS) {
    const shape = new soms.Shape(steppedSheet(), { layout });
    assert.equal(viewOf(shape.save()).getBigUint64(24, true), GOLDEN[layout], layout);
    shape.free();
  }
});

test('the command of the host writes the same file, and each opens that of the other',
     { skip: command === undefined && 'the command of the host is not built' }, async () => {
  const work = await mkdtemp(join(tmpdir(), 'soms-'));
  for (const name of ['ball', 'box2', 'degen', 'terrain', 'torus']) {
    const file = join(work, `${name}.somst`);
    execFileSync(command, ['build', `${name}.ply`, '-o', file], { cwd: join(data, 'meshes') });
    const native = await readFile(file);
    const shape = await shapeOf(name);
    assert.ok(native.equals(shape.save()), name);
    await writeFile(file, shape.save());
    execFileSync(command, ['info', '--verify', file]);
    soms.openShape(native, { check: 'full' }).free();
    shape.free();
  }
  await rm(work, { recursive: true });
});

test('a shape that was saved and opened answers the same, at the same cost', async () => {
  const other = await shapeOf('box2');
  for (const layout of LAYOUTS) {
    const shapes = [new soms.Shape(steppedSheet(), { layout }), await shapeOf('ball', { layout })];
    for (const shape of shapes) {
      const bytes = shape.save();
      const expected = answersOf(shape, other);
      for (const check of CHECKS) {
        const opened = soms.openShape(bytes, { check });
        assert.deepEqual(answersOf(opened, other), expected, check);
        assert.deepEqual(opened.save(), bytes);
        assert.ok(opened.memory() > 0 && opened.memory() <= shape.memory());
        opened.free();
      }
    }
    const [built, opened] = [shapes[1], soms.openShape(shapes[1].save())];
    const { lower, upper } = built.bounds();
    const middle = Array.from(lower, (x, k) => (x + upper[k]) / 2);
    assert.deepEqual(soms.contains(opened, middle), soms.contains(built, middle));
    assert.deepEqual(soms.signedClosest(opened, middle), soms.signedClosest(built, middle));
    assert.deepEqual(soms.solid(opened, other), soms.solid(built, other));
    [...shapes, opened].forEach((shape) => shape.free());
  }
  other.free();
});

test('a shape reads out the mesh that it was built of', async () => {
  for (const name of ['ascii.ply', 'polygons.obj', 'interleaved.glb']) {
    const mesh = soms.readMesh(await readFile(join(data, 'formats', name)), name);
    const built = new soms.Shape(mesh);
    const opened = soms.openShape(built.save());
    assert.deepEqual(built.read(), mesh.read());
    assert.deepEqual(opened.read(), mesh.read());
    [mesh, built, opened].forEach((handle) => handle.free());
  }
});

test('an empty shape has a tree file, too', () => {
  const empty = new soms.Shape({ vertices: [], triangles: [] });
  const opened = soms.openShape(empty.save(), { check: 'full' });
  assert.equal(opened.read().triangles.length, 0);
  assert.equal(soms.overlap(opened, opened).any, false);
  empty.free();
  opened.free();
});

test('bytes come in any buffer', () => {
  const shape = new soms.Shape(steppedSheet());
  const bytes = shape.save();
  const shared = new Uint8Array(new SharedArrayBuffer(bytes.length));
  shared.set(bytes);
  const within = new Uint8Array(bytes.length + 3);
  within.set(bytes, 3);
  for (const given of [bytes, bytes.buffer, Buffer.from(bytes), shared, shared.buffer, within.subarray(3), viewOf(bytes)]) {
    const opened = soms.openShape(given);
    assert.deepEqual(opened.bounds(), shape.bounds());
    opened.free();
  }
  shape.free();
});

test('damage is found by the check that is for it', () => {
  const shape = new soms.Shape(steppedSheet());
  const bytes = shape.save();
  shape.free();
  const [vertices, triangles] = [offsetOf(bytes, 0), offsetOf(bytes, 1)];
  const cases = [
    ['trusted', /head/, damaged(bytes, 64)],
    ['safe', /triangle/, damaged(bytes, triangles + 3, 7)],  // a vertex far beyond the last one
    ['sound', /section vertices/, damaged(bytes, vertices + 24)],  // the least bit of a coordinate
  ];
  for (const [finder, place, given] of cases) {
    for (const [k, check] of CHECKS.entries()) {
      if (k < CHECKS.indexOf(finder)) {
        soms.openShape(given, { check }).free();
      } else {
        fails('bad_file', place, () => soms.openShape(given, { check }));
      }
    }
  }
});

test('damaged bytes are errors that say where', () => {
  const shape = new soms.Shape(steppedSheet());
  const bytes = shape.save();
  for (const [k, name] of NAMES.entries()) {
    if (name !== 'faces') {  // a mesh of arrays has none
      fails('bad_file', new RegExp(name), () => soms.openShape(damaged(bytes, offsetOf(bytes, k - 1))));
    }
  }
  for (const length of [0, 7, 8, 100, 4095, 4096, bytes.length - 1]) {
    fails('bad_file', /model\.somst/, () => soms.openShape(bytes.subarray(0, length)));
  }
  fails('bad_file', /not a tree file/, () => soms.openShape(new TextEncoder().encode('ply\nformat ascii 1.0\n')));
  fails('unsupported', /version 3/, () => soms.openShape(damaged(bytes, 8, 1)));
  fails('unsupported', /a tree file, not a model/, () => soms.readMesh(bytes, 'model.ply'));
  const opened = soms.openShape(bytes);  // nothing of it did harm
  assert.deepEqual(soms.overlap(opened, opened), soms.overlap(shape, shape));
  shape.free();
  opened.free();
});

test('whatever a file holds, queries of a safe one end', () => {
  const shape = new soms.Shape(steppedSheet());
  const bytes = shape.save();
  let state = 1;
  const random = (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor(state / 2 ** 32 * below);
  };
  let opened = 0;
  for (let k = 0; k < 300; ++k) {
    const given = damaged(bytes, 4096 + random(bytes.length - 4096), random(8));
    try {
      const found = soms.openShape(given, { check: 'safe' });
      soms.overlap(found, shape);
      soms.distance(found, new soms.Body(shape, shifted(0, 0, 9)));
      soms.closestHit(found, { origin: [2, 2, 9], direction: [0, 0, -1] });
      found.free();
      ++opened;
    } catch (error) {
      assert.equal(error.kind, 'bad_file', String(error));
    }
  }
  assert.ok(opened > 100 && opened < 300, `${opened} of 300 opened`);
  shape.free();
});

test('what is no argument is refused', () => {
  const shape = new soms.Shape(steppedSheet());
  const bytes = shape.save();
  const handedOver = bytes.slice();
  structuredClone(handedOver, { transfer: [handedOver.buffer] });
  for (const check of ['some', '', 'Sound', null, 2, 'sound\0', Symbol('sound')]) {
    fails('usage', /^check is/, () => soms.openShape(bytes, { check }));
  }
  for (const given of [undefined, null, 'city.somst', 7, [...bytes.subarray(0, 8)], shape]) {
    fails('usage', /no bytes/, () => soms.openShape(given));
  }
  fails('usage', /handed to a worker/, () => soms.openShape(handedOver));
  fails('out_of_memory', /2147483648 bytes/, () => soms.openShape(new ArrayBuffer(2 ** 31)));
  shape.free();
  fails('usage', /was freed/, () => shape.save());
  fails('usage', /was freed/, () => shape.read());
});

test('memory is given back', () => {
  const shape = new soms.Shape(steppedSheet());
  const bytes = shape.save();
  const once = () => {
    soms.openShape(shape.save(), { check: 'full' }).free();
    fails('bad_file', /section vertices/, () => soms.openShape(damaged(bytes, offsetOf(bytes, 0))));
  };
  once();
  const [size, used] = [soms.memorySize(), soms.memoryInUse()];
  for (let k = 0; k < 50; ++k) {
    once();
  }
  assert.equal(soms.memorySize(), size);
  assert.ok(Math.abs(soms.memoryInUse() - used) < 1000, `${soms.memoryInUse()} bytes in use, before ${used}`);
  shape.free();
});

test('a worker saves and opens', async () => {
  const remote = await start();
  const local = new soms.Shape(steppedSheet());
  const built = await remote.shape(steppedSheet());
  const bytes = await built.save();
  assert.deepEqual(bytes, local.save());
  const opened = await remote.openShape(bytes, { check: 'safe' });
  assert.deepEqual(await opened.read(), local.read());
  assert.deepEqual(await remote.overlap(opened, built), soms.overlap(local, local));
  await assert.rejects(remote.openShape(damaged(bytes, 64)), { name: 'SomsError', kind: 'bad_file' });
  await assert.rejects(remote.openShape(bytes, { check: 'some' }), { name: 'SomsError', kind: 'usage' });
  await remote.close();
  local.free();
});
