// What a moved body touches, and how near it is: found in a worker, by the module that the page carries, so that the page
// stays free. The first message brings the module and the models, each later one a question.
import { columnsOf } from '../../../../web/package/answers.js';
import { load, query, run } from '../../../../web/package/module.js';
import { bytesOf, unpackExact } from './exact.js';

const MOST_LINES = 20000; // of what crosses; counts are of all
const ALL = 0; // every pair of triangles
const NO_TIME_LIMIT = Infinity;

let models; // their blocks, until somebody needs them; then addresses of shapes
let ready; // when the module is loaded

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function shapeOf(k) {
  const model = models[k];
  if (model.shape === undefined) {
    const { vertices, triangles } = unpackExact(bytesOf(model.block), model.floats);
    const mesh = run('soms_mesh', vertices, vertices.length / 3, triangles, triangles.length / 3);
    model.shape = run('soms_shape', mesh, 0);
    model.block = '';
  }
  return model.shape;
}

// Lines of what pairs of triangles have in common: a point, a segment, or the outline of an area.
function linesOf(mover, other, pairs) {
  const count = pairs.length / 2;
  const [starts, points] = query('soms_crossings', mover.shape, mover.pose, other.shape, other.pose, pairs, count);
  const lines = [];
  const point = (n) => points.subarray(3 * n, 3 * n + 3);
  for (let k = 0; k < count; ++k) {
    const first = starts[k];
    const corners = starts[k + 1] - first;
    for (let n = 0; n < (corners === 2 ? 1 : corners); ++n) {
      lines.push(...point(first + n), ...point(first + (n + 1) % corners));
    }
  }
  return lines;
}

const everySo = (pairs, most) => {
  const pause = Math.ceil(pairs.length / 2 / most);
  return pause <= 1 ? pairs : pairs.filter((_, k) => Math.floor(k / 2) % pause === 0);
};

function touched(mover, others) {
  const found = [];
  for (const other of others) {
    const { pairs } = columnsOf('OverlapBatch', query('soms_overlap', mover.shape, mover.pose, 1, other.shape, other.pose,
      ALL, Infinity, NO_TIME_LIMIT));
    if (pairs.length > 0) {
      found.push({ other, pairs });
    }
  }
  return found;
}

// The least distance, of the first body that is so near; null where there is nothing.
function nearest(mover, others) {
  let best = null;
  for (const other of others) {
    const { lower, upper, farther, pointA, pointB } = columnsOf('Distance', query('soms_distance', mover.shape, mover.pose, 1,
      other.shape, other.pose, best?.upper ?? Infinity, NO_TIME_LIMIT));
    if (!farther[0] && upper[0] < (best?.upper ?? Infinity)) {
      best = { body: other.body, lower: lower[0], upper: upper[0], points: [[...pointA], [...pointB]] };
    }
  }
  return best;
}

function answer({ mover, others }) {
  const placed = ({ body, model, pose }) => ({ body, pose, shape: shapeOf(model) });
  const first = placed(mover);
  const rest = others.map(placed);
  const found = touched(first, rest);
  const lines = found.flatMap(({ other, pairs }) => linesOf(first, other, everySo(pairs, MOST_LINES / found.length)));
  return {
    touched: found.map(({ other, pairs }) => ({ body: other.body, pairs: pairs.length / 2 })),
    lines: Float64Array.from(lines),
    gap: found.length > 0 ? null : nearest(first, rest),
  };
}

self.onmessage = async ({ data }) => {
  try {
    if (data.module) {
      models = data.models;
      ready = inflated(bytesOf(data.module)).then((source) => load({ source }));
      await ready;
      return;
    }
    await ready;
    self.postMessage(answer(data));
  } catch (error) {
    self.postMessage({ trouble: error.message });
  }
};
