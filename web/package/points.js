// Queries of points against one body: single, and in a batch.
import { atMostOf, columnsOf, firstOf, nameOf, timeOf } from './answers.js';
import { point as pointArray, points as pointArrays } from './arrays.js';
import { number, usage } from './errors.js';
import { placed } from './meshes.js';
import { Handle, made, query, run } from './module.js';

function against(body, numbers) {
  return [...placed(body, 'the body'), numbers, numbers.length / 3];
}

function nearest(body, numbers, options) {
  return columnsOf('Closest', query('soms_closest', ...against(body, numbers), atMostOf(options), timeOf(options)));
}

/** The nearest point of a surface to a point. */
export function closest(body, point, options = {}) {
  return firstOf('Closest', nearest(body, pointArray(point), options));
}

export function closestBatch(body, points, options = {}) {
  return nearest(body, pointArrays(points), options);
}

function signed(body, numbers, options) {
  const columns = query('soms_signed_closest', ...against(body, numbers), atMostOf(options), timeOf(options));
  return { ...columnsOf('Closest', columns), side: columns[columns.length - 1] };
}

/** The same of a closed body, with the side of the point. */
export function signedClosest(body, point, options = {}) {
  const found = signed(body, pointArray(point), options);
  return { ...firstOf('Closest', found), side: nameOf('side', found.side) };
}

export function signedClosestBatch(body, points, options = {}) {
  return signed(body, pointArrays(points), options);
}

/** The `count` triangles nearest to each point, nearest first. */
export function nearestTriangles(body, points, count, options = {}) {
  if (!Number.isInteger(count) || count < 0 || count > 0x7fffffff) {
    throw usage(`count is ${count}`, 'give a whole number from 0 on');
  }
  return columnsOf('NearTriangles', query('soms_nearest_triangles', ...against(body, pointArrays(points)), count,
                    atMostOf(options), timeOf(options)));
}

/** The triangles within a radius of each point, nearest first. */
export function nearTriangles(body, points, radius, options = {}) {
  return columnsOf('NearTriangles', query('soms_near_triangles', ...against(body, pointArrays(points)), number(radius, 'radius'),
                    timeOf(options)));
}

function sides(body, numbers, options) {
  return columnsOf('Contains', query('soms_contains', ...against(body, numbers), timeOf(options)));
}

/** On which side of a closed body a point is. */
export function contains(body, point, options = {}) {
  return firstOf('Contains', sides(body, pointArray(point), options));
}

export function containsBatch(body, points, options = {}) {
  return sides(body, pointArrays(points), options);
}

/** What `winding` knows of a body. Made once, queried often. */
export class WindingIndex extends Handle {
  constructor(body) {
    super(made(run('soms_winding_index', ...placed(body, 'the body'))), 'soms_winding_index_free', 'WindingIndex');
  }
}

function numbersAt(index, numbers, options) {
  if (!(index instanceof WindingIndex)) {
    throw usage('this is no index of winding numbers', 'give a WindingIndex of the body');
  }
  return columnsOf('Winding', query('soms_winding', index.address, numbers, numbers.length / 3,
                                    number(options.width ?? 1e-9, 'width'), timeOf(options)));
}

/** The winding number of a point, as a bracket that holds it. */
export function winding(index, point, options = {}) {
  return firstOf('Winding', numbersAt(index, pointArray(point), options));
}

export function windingBatch(index, points, options = {}) {
  return numbersAt(index, pointArrays(points), options);
}
