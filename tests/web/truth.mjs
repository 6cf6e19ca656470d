// The truth sets of tests/data, queried through the package: in node and in a browser. Answers of the sets were decided
// by independent exact methods; see their README.md.

/** Rows of a CSV file as objects, and where they are in it. */
function rowsOf(bytes) {
  const [header, ...lines] = new TextDecoder().decode(bytes).trimEnd().split(/\r?\n/);
  const names = header.split(',');
  return lines.map((line, number) => {
    const fields = line.split(',');
    return { number, ...Object.fromEntries(names.map((name, i) => [name, fields[i]])) };
  });
}

const real = (text) => (text === 'inf' ? Infinity : Number(text));
const numbers = (row, names) => names.map((name) => real(row[name]));
const poseOf = (row, letter) => Float64Array.from({ length: 12 }, (_, i) => real(row[`${letter}${i}`]));

/** So many rows, taken evenly. */
function spread(rows, most) {
  const stride = Math.max(1, Math.floor(rows.length / most));
  return rows.filter((_, i) => i % stride === 0).slice(0, most);
}

/** FNV-1a 64 over numbers as little-endian u32, in halves of 32 bits. */
export function hashOf(words) {
  let high = 0xcbf29ce4;
  let low = 0x84222325;
  for (const word of words) {
    for (let shift = 0; shift < 32; shift += 8) {
      low = (low ^ (word >>> shift & 255)) >>> 0;
      // times 2^40 + 0x1b3
      const product = (low & 0xffff) * 0x1b3;
      const upper = (low >>> 16) * 0x1b3 + (product >>> 16);
      high = (Math.imul(high, 0x1b3) + (low << 8) + (upper >>> 16)) >>> 0;
      low = (upper << 16 | product & 0xffff) >>> 0;
    }
  }
  return high.toString(16).padStart(8, '0') + low.toString(16).padStart(8, '0');
}

class Truth {
  constructor(soms, read, most) {
    this.soms = soms;
    this.read = read;
    this.most = most;
    this.shapes = new Map();
    this.checks = 0;
    this.faults = [];
  }

  expect(found, expected, what) {
    ++this.checks;
    const [left, right] = [found, expected].map((value) => JSON.stringify(value, (_, x) => (
      typeof x === 'number' && !Number.isFinite(x) ? String(x) : ArrayBuffer.isView(x) ? [...x] : x)));
    if (left !== right) {
      this.faults.push(`${what}: ${left} in place of ${right}`);
    }
  }

  /** Shapes stay until all sets are done. */
  async shape(name) {
    if (!this.shapes.has(name)) {
      const mesh = this.soms.readMesh(await this.read(`meshes/${name}.ply`), 'ply');
      this.shapes.set(name, new this.soms.Shape(mesh));
      mesh.free();
    }
    return this.shapes.get(name);
  }

  async rows(file, ofMesh = (row) => [row.mesh]) {
    const known = new Set(rowsOf(await this.read('meshes.csv')).map((row) => row.mesh));
    return spread(rowsOf(await this.read(file)).filter((row) => ofMesh(row).every((name) => known.has(name))),
                  this.most);
  }

  async pairRows(file) {
    return this.rows(file, (row) => [row.meshA, row.meshB]);
  }

  async bodies(row) {
    const { Body } = this.soms;
    return [new Body(await this.shape(row.meshA), poseOf(row, 'a')), new Body(await this.shape(row.meshB), poseOf(row, 'b'))];
  }

  async overlaps() {
    const { overlap, overlapBatch } = this.soms;
    for (const row of await this.pairRows('truth/cases.csv')) {
      const [a, b] = await this.bodies(row);
      const what = `case ${row.case}`;
      const all = overlap(a, b);
      this.expect([all.any, all.pairs.length / 2, all.coverage, hashOf(all.pairs)],
                  [row.overlap === '1', Number(row.count), 'complete', row.hash], what);
      const any = overlap(a, b, { mode: 'any' });
      this.expect([any.any, any.pairs.length], [all.any, all.any ? 2 : 0], `${what}, any`);
      const first = overlap(a, b, { mode: 'first' });
      this.expect(first.pairs, all.pairs.slice(0, 2), `${what}, first`);
      const batch = overlapBatch(a.shape, [a.pose, a.pose], b);
      this.expect([hashOf(batch.pairs.slice(0, 2 * batch.offsets[1])), batch.offsets[2]],
                  [row.hash, 2 * Number(row.count)], `${what}, batch`);
    }
  }

  async solids() {
    for (const row of await this.pairRows('questions/solid.csv')) {
      const [a, b] = await this.bodies(row);
      const found = this.soms.solid(a, b);
      this.expect([found.relation, found.surfacesMeet, found.why], [row.answer.replace('_touching', ''), Number(row.count) > 0, 'none'],
                  `solid ${row.case}`);
    }
  }

  async distances() {
    const { distance, distanceBatch, within } = this.soms;
    for (const row of await this.pairRows('distance/cases.csv')) {
      const [a, b] = await this.bodies(row);
      const [lower, upper] = numbers(row, ['lo', 'hi']);
      const what = `distance ${row.case}`;
      const found = distance(a, b);
      this.expect([found.lower, found.upper, found.triangles, found.farther],
                  [lower, upper, numbers(row, ['i', 'j']), false], what);
      this.expect(distanceBatch(a.shape, a.pose, b).lower, [lower], `${what}, batch`);
      this.expect([within(a, b, lower).within, within(a, b, upper).within],
                  [row.within_lo === '1', row.within_hi === '1'], `${what}, within`);
    }
  }

  async nearestPoints() {
    const { closest, closestBatch, nearTriangles, nearestTriangles } = this.soms;
    for (const row of await this.rows('distance/closest.csv')) {
      const body = await this.shape(row.mesh);
      const point = numbers(row, ['px', 'py', 'pz']);
      const [lower, upper, triangle, ties] = numbers(row, ['lo', 'hi', 'triangle', 'ties']);
      const what = `closest ${row.number}`;
      const found = closest(body, point);
      this.expect([found.lower, found.upper, found.triangle, found.feature, found.point],
                  [lower, upper, triangle, row.feature, numbers(row, ['qx', 'qy', 'qz'])], what);
      this.expect(closestBatch(body, [point, point]).triangle, [triangle, triangle], `${what}, batch`);
      const nearest = nearestTriangles(body, [point], ties);
      this.expect([nearest.offsets, nearest.triangle[0], nearest.upper.at(-1)], [[0, ties], triangle, upper],
                  `${what}, nearest`);
      this.expect(nearTriangles(body, [point], upper).triangle.slice(0, ties), nearest.triangle, `${what}, near`);
    }
  }

  async sides() {
    const { WindingIndex, contains, containsBatch, signedClosest, winding } = this.soms;
    for (const row of await this.rows('questions/inside.csv')) {
      const body = await this.shape(row.mesh);
      const point = numbers(row, ['px', 'py', 'pz']);
      const what = `inside ${row.number}, ${row.mesh}`;
      this.expect(contains(body, point).side, row.answer, what);
      this.expect(containsBatch(body, Float64Array.from([...point, ...point])).side[1],
                  this.soms.NAMES.side.indexOf(row.answer), `${what}, batch`);
      const signed = signedClosest(body, point);
      this.expect([signed.side, signed.upper === 0], [row.answer, row.answer === 'on'], `${what}, signed`);
      const index = new WindingIndex(body);
      this.expect(winding(index, point).side === 'on', row.answer === 'on', `${what}, winding`);
      index.free();
    }
  }

  async rays() {
    const { allHits, anyHit, closestHit, closestHitBatch } = this.soms;
    for (const row of await this.rows('questions/ray.csv')) {
      const body = await this.shape(row.mesh);
      const ray = { origin: numbers(row, ['ox', 'oy', 'oz']), direction: numbers(row, ['dx', 'dy', 'dz']),
                    length: real(row.length) };
      const [lower, upper] = row.t_lo === '' ? [Infinity, Infinity] : numbers(row, ['t_lo', 't_hi']);
      const triangle = row.triangle === '' ? null : Number(row.triangle);
      const what = `ray ${row.number}`;
      const found = closestHit(body, ray);
      this.expect([found.lower, found.upper, found.triangle], [lower, upper, triangle], what);
      this.expect(closestHitBatch(body, [ray]).triangle, [triangle ?? -1], `${what}, batch`);
      this.expect(anyHit(body, ray).hit, row.any === '1', `${what}, any`);
      const all = allHits(body, [ray]);
      this.expect(all.triangle.length, Number(row.hits), `${what}, all`);
    }
  }

  /** Triangles that shift, by exact times: brackets are neighboring doubles. */
  async shifts() {
    const { Body, Shape, firstContact, firstContactBatch } = this.soms;
    const corners = (row, name) => ({ vertices: Float64Array.from(numbers(row, [0, 1, 2].flatMap(
        (k) => ['x', 'y', 'z'].map((axis) => `${name}${k}${axis}`)))) });
    for (const row of spread(rowsOf(await this.read('motion/translation.csv')), this.most)) {
      const [moving, resting] = [new Shape(corners(row, 'b')), new Shape(corners(row, 'a'))];
      const motion = { by: numbers(row, ['dx', 'dy', 'dz']) };
      const found = firstContact(moving, motion, new Body(resting));
      const what = `shift ${row.number}`;
      const verdict = row.contact !== '1' ? 'free' : row.free_until === '' ? 'started' : 'contact';
      this.expect(found.verdict, verdict, what);
      if (verdict === 'contact') {
        const [after, by] = numbers(row, ['free_until', 'touching_by']);
        this.expect([found.lower <= by, found.upper >= after, found.upper - found.lower < 1e-15, found.triangles],
                    [true, true, true, [0, 0]], `${what}, time`);
      }
      const batch = firstContactBatch(moving, [motion, motion], resting);
      this.expect([batch.verdict[1], batch.lower[0], batch.upper[1]],
                  [this.soms.NAMES.verdict.indexOf(verdict), found.lower, found.upper], `${what}, batch`);
      moving.free();
      resting.free();
    }
  }

  /** Meshes that turn and shift. */
  async paths() {
    const { Body, firstContact, overlap, poseAt } = this.soms;
    const verdicts = { free: 'free', contact: 'contact', start: 'started' };
    for (const row of spread(rowsOf(await this.read('motion/motion_path.csv')), this.most)) {
      const shift = Float64Array.of(1, 0, 0, real(row.bx), 0, 1, 0, real(row.by), 0, 0, 1, real(row.bz));
      const [mover, fixed] = [await this.shape(row.meshA), new Body(await this.shape(row.meshB), shift)];
      const motion = { start: poseOf(row, 'a'), end: poseOf(row, 'e'), pivot: numbers(row, ['cx', 'cy', 'cz']) };
      const found = firstContact(mover, motion, fixed);
      const what = `path ${row.number}`;
      this.expect(found.verdict, verdicts[row.answer], what);
      if (found.verdict === 'contact') {
        const [after, by] = numbers(row, ['t_lo', 't_hi']);
        this.expect([found.lower <= by + 1e-6, found.upper >= after - 1e-6], [true, true], `${what}, time`);
        this.expect(overlap(new Body(mover, poseAt(motion, found.upper)), fixed).any, true, `${what}, then`);
      }
    }
  }
}

/** Checks up to `most` rows of each set; `read(path)` gives the bytes of a prepared file (prepare.py). */
export async function checkTruth(soms, read, most) {
  const truth = new Truth(soms, read, most);
  const sets = {};
  for (const set of ['overlaps', 'solids', 'distances', 'nearestPoints', 'sides', 'rays', 'shifts', 'paths']) {
    const before = truth.checks;
    await truth[set]();
    sets[set] = truth.checks - before;
  }
  for (const shape of truth.shapes.values()) {
    shape.free();
  }
  return { checks: truth.checks, sets, faults: truth.faults };
}
