// Queries of points against one body: single, and in a batch.
import { atMostOf, costOf, nameOf, pointOf, timeOf, triangleOf } from './answers.js';
import { point as pointArray, points as pointArrays } from './arrays.js';
import { number, usage } from './errors.js';
import { placed } from './meshes.js';
import { Handle, made, query, run } from './module.js';

function against(body, numbers) {
  return [...placed(body, 'the body'), numbers, numbers.length / 3];
}

function closestColumns(name, body, numbers, options) {
  const [lower, upper, triangle, point, feature, farther, coverage, cost, side] =
      query(name, ...against(body, numbers), atMostOf(options), timeOf(options));
  const found = { lower, upper, triangle, point, feature, farther, coverage, cost: costOf(cost) };
  return side === undefined ? found : { ...found, side };
}

function firstClosest(found) {
  return {
    lower: found.lower[0],
    upper: found.upper[0],
    triangle: triangleOf(found.triangle),
    point: pointOf(found.point),
    feature: nameOf('feature', found.feature),
    farther: found.farther[0] === 1,
    coverage: nameOf('coverage', found.coverage),
    cost: found.cost,
  };
}

/** The nearest point of a surface to a point. */
export function closest(body, point, options = {}) {
  return firstClosest(closestColumns('soms_closest', body, pointArray(point), options));
}

export function closestBatch(body, points, options = {}) {
  return closestColumns('soms_closest', body, pointArrays(points), options);
}

/** The same of a closed body, with the side of the point. */
export function signedClosest(body, point, options = {}) {
  const found = closestColumns('soms_signed_closest', body, pointArray(point), options);
  return { ...firstClosest(found), side: nameOf('side', found.side) };
}

export function signedClosestBatch(body, points, options = {}) {
  return closestColumns('soms_signed_closest', body, pointArrays(points), options);
}

function rows([offsets, triangle, lower, upper, coverage, cost]) {
  return { offsets, triangle, lower, upper, coverage, cost: costOf(cost) };
}

/** The `count` triangles nearest to each point, nearest first. */
export function nearestTriangles(body, points, count, options = {}) {
  if (!Number.isInteger(count) || count < 0 || count > 0x7fffffff) {
    throw usage(`count is ${count}`, 'give a whole number from 0 on');
  }
  return rows(query('soms_nearest_triangles', ...against(body, pointArrays(points)), count,
                    atMostOf(options), timeOf(options)));
}

/** The triangles within a radius of each point, nearest first. */
export function nearTriangles(body, points, radius, options = {}) {
  return rows(query('soms_near_triangles', ...against(body, pointArrays(points)), number(radius, 'radius'),
                    timeOf(options)));
}

function containsColumns(body, numbers, options) {
  const [side, coverage, cost] = query('soms_contains', ...against(body, numbers), timeOf(options));
  return { side, coverage: nameOf('coverage', coverage), cost: costOf(cost) };
}

/** On which side of a closed body a point is. */
export function contains(body, point, options = {}) {
  const found = containsColumns(body, pointArray(point), options);
  return { ...found, side: nameOf('side', found.side) };
}

export function containsBatch(body, points, options = {}) {
  return containsColumns(body, pointArrays(points), options);
}

/** What `winding` knows of a body. Made once, queried often. */
export class WindingIndex extends Handle {
  constructor(body) {
    super(made(run('soms_winding_index', ...placed(body, 'the body'))), 'soms_winding_index_free', 'WindingIndex');
  }
}

function windingColumns(index, numbers, options) {
  if (!(index instanceof WindingIndex)) {
    throw usage('this is no index of winding numbers', 'give a WindingIndex of the body');
  }
  const [side, lower, upper, coverage, cost] =
      query('soms_winding', index.address, numbers, numbers.length / 3, number(options.width ?? 1e-9, 'width'),
            timeOf(options));
  return { side, lower, upper, coverage, cost: costOf(cost) };
}

/** The winding number of a point, as a bracket that holds it. */
export function winding(index, point, options = {}) {
  const found = windingColumns(index, pointArray(point), options);
  return {
    side: nameOf('side', found.side),
    lower: found.lower[0],
    upper: found.upper[0],
    coverage: nameOf('coverage', found.coverage),
    cost: found.cost,
  };
}

export function windingBatch(index, points, options = {}) {
  return windingColumns(index, pointArrays(points), options);
}
