// The module of live reports in node: its answers are those of the package. WEB_PACKAGE: folder of the package; WEB_LIVE: the
// small module.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

const folder = process.env.WEB_PACKAGE;
const bytes = await readFile(process.env.WEB_LIVE);
// Two copies of the scripts, each with a module of its own.
const load = async (copy, source) => {
  const { load: start, query, run } = await import(`${pathToFileURL(join(folder, 'module.js'))}?${copy}`);
  await start({ source });
  return { query, run };
};
const live = await load('live', bytes);
const whole = await load('whole', await readFile(join(folder, 'soms.wasm')));

/** A wavy sheet of n x n squares; its numbers are no multiples of anything. */
function sheet(n, tilt) {
  const vertices = [];
  const triangles = [];
  for (let i = 0; i <= n; ++i) {
    for (let j = 0; j <= n; ++j) {
      const [x, y] = [i / n, j / n];
      vertices.push(x, y, tilt * (x - 0.5) + 0.1 * Math.sin(7 * x) * Math.cos(5 * y));
      if (i < n && j < n) {
        const at = i * (n + 1) + j;
        triangles.push(at, at + 1, at + n + 1, at + 1, at + n + 2, at + n + 1);
      }
    }
  }
  return { vertices: Float64Array.from(vertices), triangles: Uint32Array.from(triangles) };
}

function shapeIn(module, { vertices, triangles }) {
  const mesh = module.run('soms_mesh', vertices, vertices.length / 3, triangles, triangles.length / 3);
  return module.run('soms_shape', mesh, 0);
}

const lifted = (z) => Float64Array.of(1, 0, 0, 0.0625, 0, 0.96, -0.28, 0, 0, 0.28, 0.96, z);
const HOME = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);
const sheets = [sheet(24, 0.7), sheet(31, -0.4)];
const inLive = sheets.map((mesh) => shapeIn(live, mesh));
const inWhole = sheets.map((mesh) => shapeIn(whole, mesh));

test('overlap and distance are those of the package, touching and free', () => {
  const seen = new Set();
  for (const z of [-2, -0.5, -0.25, 0, 0.25, 0.5, 2]) {
    const answersOf = ({ query }, [a, b]) => ({
      overlap: query('soms_overlap', a, lifted(z), 1, b, HOME, 0, Infinity, Infinity),
      distance: query('soms_distance', a, lifted(z), 1, b, HOME, Infinity, Infinity),
    });
    const found = answersOf(live, inLive);
    assert.deepEqual(found, answersOf(whole, inWhole));
    seen.add(found.overlap[0][0]);
    assert.equal(found.overlap[0][0] === 1, found.distance[0][0] === 0);
  }
  assert.deepEqual([...seen].sort(), [0, 1]);
});

test('each pair that overlaps has something in common, where both triangles are', () => {
  const pose = lifted(0);
  const [, , pairs] = live.query('soms_overlap', inLive[0], pose, 1, inLive[1], HOME, 0, Infinity, Infinity);
  assert.ok(pairs.length > 20, `${pairs.length / 2} pairs`);
  const [offsets, corners] = live.query('soms_crossings', inLive[0], pose, inLive[1], HOME, pairs, pairs.length / 2);
  assert.equal(offsets.length, pairs.length / 2 + 1);
  assert.equal(3 * offsets.at(-1), corners.length);
  const { vertices, triangles } = sheets[1];
  for (let k = 0; k < pairs.length / 2; ++k) {
    assert.ok(offsets[k + 1] > offsets[k], `pair ${k} has nothing in common`);
    for (let n = offsets[k]; n < offsets[k + 1]; ++n) {
      for (const axis of [0, 1, 2]) {
        const along = [0, 1, 2].map((c) => vertices[3 * triangles[3 * pairs[2 * k + 1] + c] + axis]);
        const at = corners[3 * n + axis];
        assert.ok(at >= Math.min(...along) - 1e-9 && at <= Math.max(...along) + 1e-9, `pair ${k}: ${at} of ${along}`);
      }
    }
  }
});
