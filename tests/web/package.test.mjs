// The package as its users call it, in node. WEB_PACKAGE and WEB_DATA as in truth.test.mjs.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

const { WEB_DATA: data, WEB_PACKAGE: folder } = process.env;
const soms = await import(pathToFileURL(join(folder, 'soms.js')));
const { start } = await import(pathToFileURL(join(folder, 'worker.js')));

/** A box from -h to h, closed, facing outward. */
function box(h) {
  const vertices = Float64Array.from({ length: 24 }, (_, k) => ((k / 3 >> k % 3 & 1) === 1 ? h : -h));
  const triangles = Uint32Array.of(0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2,
                                   4, 6, 1, 3, 5, 3, 7, 5);
  return { vertices, triangles };
}

const shifted = (x) => Float64Array.of(1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0);
/** A Matrix4 as three.js has it: by columns. */
const matrix = (x) => ({ elements: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1] });

function fails(kind, call) {
  assert.throws(call, (error) => {
    assert.ok(error instanceof soms.SomsError, String(error));
    assert.equal(error.kind, kind);
    assert.ok(error.place.length > 0 && error.message.startsWith(error.place));
    return true;
  });
}

before(async () => {
  await assert.rejects(async () => new soms.Shape(box(1)), { kind: 'usage', place: 'soms is not loaded' });
  await soms.load({ source: await readFile(join(folder, 'soms.wasm')) });
});

test('single answers', () => {
  const [a, b] = [new soms.Shape(box(1)), new soms.Shape(box(1))];
  assert.equal(soms.overlap(a, new soms.Body(b, shifted(1))).any, true);
  assert.equal(soms.overlap(a, { shape: b, pose: matrix(2.5) }).any, false);
  const gap = soms.distance(new soms.Body(a, matrix(3)), b);
  assert.deepEqual([gap.lower, gap.upper, gap.farther, gap.coverage], [1, 1, false, 'complete']);
  assert.equal(soms.distance(new soms.Body(a, matrix(3)), b, { atMost: 0.5 }).farther, true);
  assert.equal(soms.within(new soms.Body(a, matrix(3)), b, 1).within, true);
  assert.equal(soms.solid(a, b).relation, 'same');
  assert.equal(soms.solid(a, new soms.Body(b, shifted(2))).relation, 'touching');
  assert.equal(soms.solid(a, new soms.Body(b, shifted(2.5))).relation, 'clear');
  assert.equal(soms.contains(a, [0, 0, 0]).side, 'inside');
  assert.equal(soms.contains(a, { x: 1, y: 0, z: 0 }).side, 'on');
  assert.deepEqual([...soms.closest(a, [3, 0, 0]).point], [1, 0, 0]);
  assert.equal(soms.signedClosest(a, [0, 0, 0.5]).side, 'inside');
  assert.equal(soms.closestHit(a, { origin: [-5, 0.25, 0], direction: [1, 0, 0] }).lower, 4);
  assert.equal(soms.anyHit(a, { from: [-5, 0, 0], to: [-2, 0, 0] }).hit, false);
  assert.deepEqual([...soms.allHits(a, [{ origin: [-5, 0.25, 0.5], direction: [1, 0, 0] }]).kind].map(
      (code) => soms.NAMES.kind[code]), ['enter', 'leave']);
  const index = new soms.WindingIndex(a);
  const number = soms.winding(index, [0, 0, 0]);
  assert.deepEqual([number.side, number.lower, number.upper], ['inside', 1, 1]);
  assert.deepEqual([...a.bounds().upper], [1, 1, 1]);
  assert.ok(a.memory() > 0);
  for (const handle of [a, b, index]) {
    handle.free();
  }
});

test('first contacts', () => {
  const [a, b] = [new soms.Shape(box(1)), new soms.Shape(box(1))];
  const away = new soms.Body(b, shifted(5));
  const shift = { by: [6, 0, 0] };
  const found = soms.firstContact(a, shift, away);
  assert.deepEqual([found.verdict, found.lower, found.upper, found.coverage], ['contact', 0.5, 0.5, 'complete']);
  assert.equal(found.point[0], 4);
  assert.equal(found.normal, null);  // faces on faces
  assert.deepEqual([...soms.poseAt(shift, 0.25)], [...shifted(1.5)]);
  const motions = [
    shift, { by: { x: 0, y: 6, z: 0 } }, { start: matrix(3.5) , by: [0, 0, 1] }, { start: shifted(1), end: matrix(7) },
    { end: shifted(2), pivot: [1, 0, 0] }, { axis: [0, 0, 1], angle: 3 }, { start: shifted(-9), center: [0, 0, 0],
      axis: [0, 0, 1], angle: 3.1 }, { start: shifted(-9), center: [-2.1, 0, 0], axis: [0, 1, 0], angle: -3.1 },
  ];
  const batch = soms.firstContactBatch(a, motions, away, { within: 0.25 });
  const expected = ['contact', 'free', 'started', 'contact', 'free', 'free', 'free', 'contact'];
  assert.deepEqual([...batch.verdict].map((code) => soms.NAMES.verdict[code]), expected);
  motions.forEach((motion, k) => {
    const single = soms.firstContact(a, motion, away, { within: 0.25 });
    assert.deepEqual([single.verdict, single.lower, single.upper], [expected[k], batch.lower[k], batch.upper[k]]);
  });
  const corner = new soms.Shape({ vertices: [0, 0, 0, 1, 0.125, 2, -1, 0.25, 2] });
  const floor = new soms.Shape({ vertices: [-9, -9, -1, 9, -9, -1, 0, 9, -1] });
  assert.ok(Math.abs(soms.firstContact(corner, { by: [0.25, 0.125, -2] }, floor).normal[2] - 1) < 1e-12);
  const slide = soms.firstContact(a, { start: shifted(2), by: [-9, 0, 0] }, b, { parting: true });
  assert.deepEqual([slide.verdict, slide.upper <= 1], ['started', true]);
  fails('usage', () => soms.firstContact(a, shift, b, { within: 1, parting: true }));
  fails('usage', () => soms.firstContact(a, {}, b));
  fails('usage', () => soms.firstContact(a, shift, b, { within: -1 }));
  fails('usage', () => soms.firstContact(a, { axis: [0, 0, 1], angle: 4 }, b));
  fails('usage', () => soms.firstContactBatch(a, shift, b));
  fails('usage', () => soms.poseAt(shift, 1.5));
  fails('not_rigid', () => soms.firstContact(a, { end: new Float64Array(12) }, b));
  for (const handle of [a, b, corner, floor]) {
    handle.free();
  }
});

test('batches are the single answers', () => {
  const [a, b] = [new soms.Shape(box(1)), new soms.Shape(box(2), { layout: 'compact' })];
  const places = [0, 0.5, 1, 1.5, 2.9, 3, 3.1, 7];
  const poses = Float64Array.from(places.flatMap((x) => [...shifted(x)]));
  const found = soms.overlapBatch(a, poses, b);
  assert.deepEqual(found, soms.overlapBatch(a, places.map(matrix), b));
  const gaps = soms.distanceBatch(a, poses, b);
  const near = soms.withinBatch(a, poses, b, 0.5);
  const relations = soms.solidBatch(a, poses, b);
  for (const [k, x] of places.entries()) {
    const body = new soms.Body(a, shifted(x));
    const single = soms.overlap(body, b);
    assert.equal(found.any[k] === 1, single.any);
    assert.deepEqual(found.pairs.slice(2 * found.offsets[k], 2 * found.offsets[k + 1]), single.pairs);
    assert.equal(gaps.lower[k], soms.distance(body, b).lower);
    assert.equal(near.within[k] === 1, soms.within(body, b, 0.5).within);
    assert.equal(soms.NAMES.relation[relations.relation[k]], soms.solid(body, b).relation);
  }
  assert.deepEqual(soms.overlapBatch(a, [], b).any, new Uint8Array());
  a.free();
  b.free();
});

test('geometries of three.js', () => {
  const { vertices, triangles } = box(1);
  const attribute = { array: Float32Array.from(vertices), count: 8, itemSize: 3 };
  const indexed = new soms.Mesh({ attributes: { position: attribute },
                                  index: { array: Uint16Array.from(triangles), count: 36 } });
  const plain = new soms.Mesh({ vertices, triangles });
  assert.deepEqual(indexed.read(), plain.read());
  const corners = Float32Array.from([...triangles].flatMap((i) => [...vertices.subarray(3 * i, 3 * i + 3)]));
  const loose = new soms.Mesh({ geometry: { attributes: { position: { array: corners, count: 36, itemSize: 3 } }, index: null } });
  assert.equal(loose.read().cornerHash, plain.read().cornerHash);
  const interleaved = { isInterleavedBufferAttribute: true, count: 3, itemSize: 3, array: new Float32Array(18),
                        getX: (i) => i, getY: () => 0.5, getZ: (i) => i * i };
  assert.deepEqual([...new soms.Mesh({ attributes: { position: interleaved }, index: null }).read().vertices],
                   [0, 0.5, 0, 1, 0.5, 1, 2, 0.5, 4]);
  // As Float16BufferAttribute has it: 0x3c00 is 1.
  const halves = { array: Uint16Array.of(0, 0, 0, 0x3c00, 0, 0, 0, 0x3c00, 0), count: 3, itemSize: 3, getX: (i) => Number(i === 1),
                   getY: (i) => Number(i === 2), getZ: () => 0 };
  assert.deepEqual([...new soms.Mesh({ attributes: { position: halves }, index: null }).read().vertices], [0, 0, 0, 1, 0, 0, 0, 1, 0]);
});

test('positions that cannot be read are errors', () => {
  const array = new Int16Array(9);
  for (const position of [{ count: 3, itemSize: 3 }, { array, count: 3, itemSize: 3, normalized: true }, { array, count: 3, itemSize: 2 }]) {
    fails('usage', () => new soms.Mesh({ attributes: { position }, index: null }));
  }
  const position = { array: [0, 0, 0, 1, 0, 0, 0, 1, 0], count: 3, itemSize: 3 };
  fails('usage', () => new soms.Mesh({ attributes: { position }, index: { count: 3 } }));
  const listed = new soms.Mesh({ attributes: { position }, index: { array: [0, 1, 2, 2], count: 3 } });
  assert.deepEqual([...listed.read().triangles], [0, 1, 2]);
});

test('errors have kind, place and remedy', () => {
  const a = new soms.Shape(box(1));
  fails('usage', () => new soms.Shape({}));
  fails('usage', () => new soms.Mesh({ vertices: [0, 0], triangles: [] }));
  fails('usage', () => new soms.Mesh({ vertices: [0, 0, 0], triangles: [0, 0, -1] }));
  fails('usage', () => soms.overlap(a, {}));
  fails('usage', () => soms.overlap(a, a, { mode: 'some' }));
  fails('usage', () => soms.overlap(a, new soms.Body(a, [1, 2, 3])));
  fails('usage', () => soms.overlap(a, new soms.Body(a, { elements: [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] })));
  fails('usage', () => soms.within(a, a, -1));
  fails('usage', () => soms.closest(a, 'nowhere'));
  fails('usage', () => soms.winding(a, [0, 0, 0]));
  fails('usage', () => soms.anyHit(a, { origin: [0, 0, 0] }));
  fails('usage', () => soms.closestHit(a, { origin: [0, 0, 0], direction: [0, 0, 0] }));
  fails('not_rigid', () => soms.overlap(a, new soms.Body(a, Float64Array.of(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0))));
  fails('not_finite', () => new soms.Mesh({ vertices: [0, 0, NaN, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] }));
  fails('out_of_range', () => new soms.Mesh({ vertices: [0, 0, 2 ** 301, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] }));
  const open = new soms.Shape({ vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0] });
  fails('not_closed', () => soms.contains(open, [0, 0, 0]));
  fails('bad_file', () => soms.readMesh(new TextEncoder().encode('ply\nformat ascii 2.0\n'), 'ply'));
  fails('unsupported', () => soms.readMesh(new TextEncoder().encode('PK\x03\x04'), 'zip'));
  fails('unsupported', () => soms.readMesh(new TextEncoder().encode('Kaydara FBX Binary'), 'model.fbx'));
  const scaled = Float64Array.of(...shifted(0), 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0);
  assert.throws(() => soms.overlapBatch(a, scaled, a), { kind: 'not_rigid', place: /pose 1/ });
  open.free();
  a.free();
  a.free();
  fails('usage', () => soms.overlap(a, a));
});

test('what is no argument is refused, whatever it is', () => {
  const a = new soms.Shape(box(1));
  const handedOver = Float64Array.from(box(1).vertices);
  structuredClone(handedOver, { transfer: [handedOver.buffer] });
  const triangle = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  const calls = {
    'an address for a mesh': () => new soms.Mesh(5),
    'an object like a handle': () => new soms.Mesh({ address: 5 }),
    'no mesh': () => new soms.Mesh(null),
    'text for vertices': () => new soms.Mesh({ vertices: 'abc', triangles: [] }),
    'nested vertices': () => new soms.Mesh({ vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]] }),
    'big integers': () => new soms.Mesh({ vertices: BigInt64Array.of(0n, 0n, 0n) }),
    'a view of data': () => new soms.Mesh({ vertices: new DataView(new ArrayBuffer(72)) }),
    'one index': () => new soms.Mesh({ vertices: triangle, triangles: 5 }),
    'an index that is no whole number': () => new soms.Mesh({ vertices: triangle, triangles: [0, 1, 1.5] }),
    'an index that is no vertex': () => new soms.Shape({ vertices: triangle, triangles: [0, 1, 3] }),
    'vertices that were handed over': () => new soms.Shape({ vertices: handedOver, triangles: box(1).triangles }),
    'no shape': () => new soms.Shape(undefined),
    'text for a file': () => soms.readMesh('ply', 'ply'),
    'a number for a file': () => soms.readMesh(64, 'ply'),
    'a file without a format': () => soms.readMesh(new Uint8Array(8)),
    'bytes that were handed over': () => soms.readMesh(handedOver.buffer, 'ply'),
    'no limit': () => soms.overlap(a, a, { limit: NaN }),
    'a limit below 0': () => soms.overlap(a, a, { limit: -1 }),
    'no time': () => soms.overlap(a, a, { timeout: 'soon' }),
    'no distance': () => soms.distance(a, a, { atMost: NaN }),
    'a distance below 0': () => soms.closest(a, [0, 0, 0], { atMost: -1 }),
    'no clearance': () => soms.within(a, a),
    'a clearance that is text': () => soms.within(a, a, '1'),
    'no radius': () => soms.nearTriangles(a, [0, 0, 0]),
    'no count': () => soms.nearestTriangles(a, [0, 0, 0], 0.5),
    'no triangle to skip': () => soms.anyHit(a, { from: [0, 0, 0], to: [1, 0, 0] }, { skip: 1.5 }),
    'no points': () => soms.closestBatch(a, undefined),
    'points by twos': () => soms.closestBatch(a, [0, 1]),
    'no rays': () => soms.allHits(a, 7),
    'no poses': () => soms.overlapBatch(a, 7, a),
    'a body without a shape': () => soms.overlap(a, new soms.Body(undefined, shifted(0))),
    'no pairs': () => soms.crossings(a, a, undefined),
    'half a pair': () => soms.crossings(a, a, [0]),
    'a pair of other bodies': () => soms.crossings(a, a, [0, 12]),
  };
  for (const [what, call] of Object.entries(calls)) {
    assert.throws(call, (error) => error instanceof soms.SomsError || assert.fail(`${what}: ${error}`), what);
  }
  fails('not_finite', () => soms.overlap(a, new soms.Body(a, shifted(NaN))));
  fails('not_finite', () => soms.closest(a, [0, Infinity, 0]));
  assert.equal(soms.overlap(a, a).pairs.length / 2 > 12, true);  // nothing of it did harm
  a.free();
});

test('shared memory is read as any other', () => {
  const { vertices, triangles } = box(1);
  const shared = new Float64Array(new SharedArrayBuffer(8 * vertices.length));
  shared.set(vertices);
  const [a, b] = [new soms.Shape({ vertices: shared, triangles }), new soms.Shape(box(1))];
  assert.deepEqual(soms.overlap(a, b), soms.overlap(b, b));
  a.free();
  b.free();
});

test('pairs that cross have points in common', () => {
  const [a, b] = [new soms.Shape(box(1)), new soms.Shape(box(1))];
  const moved = new soms.Body(a, Float64Array.of(1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1));  // corner into corner
  const { pairs } = soms.overlap(moved, b);
  const { offsets, points } = soms.crossings(moved, b, pairs);
  assert.equal(offsets.length, pairs.length / 2 + 1);
  assert.equal(points.length, 3 * offsets.at(-1));
  for (let k = 0; k < pairs.length / 2; ++k) {
    assert.ok(offsets[k + 1] > offsets[k]);
  }
  assert.ok(points.every((x) => x >= 0 && x <= 1));
  a.free();
  b.free();
});

test('broken files are errors, and the module goes on', async () => {
  const { readdir } = await import('node:fs/promises');
  const kinds = new Map();
  for (const { name } of (await readdir(join(data, 'bad'), { withFileTypes: true })).filter((entry) => entry.isFile())) {
    const bytes = await readFile(join(data, 'bad', name));
    try {
      soms.readMesh(bytes, name).free();
      kinds.set('read', (kinds.get('read') ?? 0) + 1);
    } catch (error) {
      assert.ok(error instanceof soms.SomsError, `${name}: ${error}`);
      kinds.set(error.kind, (kinds.get(error.kind) ?? 0) + 1);
    }
  }
  assert.ok(kinds.get('bad_file') > 50, JSON.stringify([...kinds]));
  const a = new soms.Shape(box(1));
  assert.equal(soms.overlap(a, a).any, true);
  a.free();
});

test('addresses beyond 2 GB, and no memory beyond 4 GB', async () => {
  // A module of its own: what it took stays taken. Pages that nobody writes to cost nothing.
  const own = await import(`${pathToFileURL(join(folder, 'module.js'))}?large`);
  await own.load({ source: await readFile(join(folder, 'soms.wasm')) });
  own.run('soms_allocate', 0x7e000000);
  own.run('soms_allocate', 0x10000000);
  assert.ok(own.run('soms_allocate', 0x100000) > 2 ** 31);
  const { vertices, triangles } = box(1);
  const home = shifted(0);
  const mesh = own.run('soms_mesh', vertices, 8, triangles, 12);
  const shape = own.run('soms_shape', mesh, 0);
  const [any, , pairs] = own.query('soms_overlap', shape, home, 1, shape, home, 0, Infinity, Infinity);
  assert.equal(any[0], 1);
  assert.ok(pairs.length > 24);
  assert.throws(() => own.run('soms_mesh', vertices, 2 ** 31 / 6 | 0, triangles, 12), { name: 'SomsError', kind: 'out_of_memory' });
  assert.equal(own.query('soms_overlap', shape, home, 1, shape, home, 0, Infinity, Infinity)[0][0], 1);
});

test('a module that is missing or broken is an error, after which the right one loads', async () => {
  const own = await import(`${pathToFileURL(join(folder, 'module.js'))}?broken`);
  const whole = await readFile(join(folder, 'soms.wasm'));
  await assert.rejects(own.load({ source: new URL('nothing.wasm', pathToFileURL(folder)) }), { name: 'SomsError', kind: 'cannot_open' });
  await assert.rejects(own.load({ source: whole.subarray(0, 1000) }), { name: 'SomsError', kind: 'unsupported' });
  await own.load({ source: whole });
  await assert.rejects(start({ source: whole.subarray(0, 1000) }), { name: 'SomsError', kind: 'unsupported' });
});

test('two workers are two modules', async () => {
  const source = await readFile(join(folder, 'soms.wasm'));
  const [one, other] = await Promise.all([start({ source }), start({ source })]);
  const [a, b] = await Promise.all([one.shape(box(1)), other.shape(box(2))]);
  assert.deepEqual([...(await a.bounds()).upper, ...(await b.bounds()).upper], [1, 1, 1, 2, 2, 2]);
  await one.close();
  assert.equal((await other.overlap(b, b)).any, true);
  await assert.rejects(one.overlap(a, a), { kind: 'usage' });
  await other.close();
});

test('a worker loads from a URL, too', async () => {
  const url = pathToFileURL(join(folder, 'soms.wasm'));
  for (const source of [url, url.href, undefined]) {
    const remote = await start({ source });
    assert.equal(await remote.instructionSet(), 'simd128');
    await remote.close();
  }
  await assert.rejects(start({ source: new URL('nothing.wasm', url) }), { name: 'SomsError', kind: 'cannot_open' });
});

test('a limit of time cuts, and says so', () => {
  const a = new soms.Shape(box(1));
  assert.equal(soms.overlap(a, new soms.Body(a, shifted(1)), { timeout: -1 }).coverage, 'cut');
  assert.equal(soms.overlap(a, new soms.Body(a, shifted(1)), { limit: 3 }).coverage, 'cut');
  a.free();
});

test('files of each format', async () => {
  const hashes = new Map();
  for (const name of ['ascii.ply', 'be_double.ply', 'ascii_exponents.ply', 'polygons.obj', 'polygons.off', 'ascii.stl',
                      'binary.stl', 'full.3ds', 'interleaved.glb', 'strips.glb']) {
    const mesh = soms.readMesh(await readFile(join(data, 'formats', name)), name.split('.')[1]);
    const content = mesh.read();
    assert.ok(content.triangles.length > 0 && content.vertices.length > 0, name);
    hashes.set(name, content.cornerHash);
    mesh.free();
  }
  assert.equal(hashes.get('polygons.obj'), hashes.get('polygons.off'));
});

test('memory stays flat over 100,000 calls', () => {
  const [a, b] = [new soms.Shape(box(1)), new soms.Shape(box(1))];
  const once = (k) => {
    const body = new soms.Body(a, shifted(k % 4));
    soms.overlap(body, b);
    soms.distance(body, b);
    soms.contains(b, [k % 4, 0, 0]);
    soms.closestHit(b, { origin: [-5, 0, 0], direction: [1, 0, 0] });
    new soms.Mesh(box(1)).free();
    new soms.Shape(box(1)).free();
    new soms.WindingIndex(body).free();
    try {
      soms.within(body, b, -1);
    } catch (error) {
      assert.equal(error.kind, 'usage');
    }
  };
  for (let k = 0; k < 1000; ++k) {
    once(k);
  }
  const [bytes, blocks] = [soms.memorySize(), soms.memoryInUse()];
  for (let k = 0; k < 12500; ++k) {
    once(k);
  }
  assert.equal(soms.memorySize(), bytes);
  // A block may be some bytes longer than what was asked for, as the allocator leaves no rest that is too small.
  assert.ok(Math.abs(soms.memoryInUse() - blocks) < 1000, `${soms.memoryInUse()} bytes in use, before ${blocks}`);
  a.free();
  b.free();
});

test('the worker answers as the page does', async () => {
  const remote = await start({ source: await readFile(join(folder, 'soms.wasm')) });
  const shape = await remote.shape(box(1));
  const local = new soms.Shape(box(1));
  const bodies = (one) => [{ shape: one, pose: matrix(1) }, one];
  assert.deepEqual(await remote.overlap(...bodies(shape)), soms.overlap(...bodies(local)));
  assert.deepEqual(await remote.closestBatch(shape, [[3, 0, 0]]), soms.closestBatch(local, [[3, 0, 0]]));
  const index = await remote.windingIndex(shape);
  assert.equal((await remote.winding(index, [0, 0, 0])).side, 'inside');
  const mesh = await remote.readMesh(await readFile(join(data, 'formats', 'ascii.ply')), 'ply');
  assert.ok((await mesh.read()).triangles.length > 0);
  assert.deepEqual(await shape.bounds(), local.bounds());
  await assert.rejects(remote.within(shape, shape, -1), { name: 'SomsError', kind: 'usage' });
  await shape.free();
  await assert.rejects(remote.contains(shape, [0, 0, 0]), { kind: 'usage' });
  await assert.rejects(shape.bounds(), { name: 'SomsError', kind: 'usage', place: 'this handle was freed' });
  assert.throws(() => (local.free(), local.bounds()), { name: 'SomsError', kind: 'usage', place: 'this Shape was freed' });
  await remote.close();
  await assert.rejects(remote.memorySize(), { kind: 'usage' });
  local.free();
});
