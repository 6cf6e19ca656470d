// Queries of two surfaces: single, and for a batch of poses of the first.
import { atMostOf, columnsOf, firstOf, timeOf } from './answers.js';
import { pairs as pairsOf, poses as posesOf } from './arrays.js';
import { number, usage } from './errors.js';
import { placed } from './meshes.js';
import { query } from './module.js';

const MODES = ['all', 'any', 'first'];

/** Address of the mover, its poses and how many, address and pose of the fixed body. */
function batch(mover, poses, fixed) {
  const moved = posesOf(poses);
  return [placed(mover, 'the mover')[0], moved, moved.length / 12, ...placed(fixed, 'the fixed body')];
}

function single(a, b) {
  const [address, pose] = placed(a, 'the first body');
  return [address, pose, 1, ...placed(b, 'the second body')];
}

function overlapColumns(bodies, options) {
  const mode = MODES.indexOf(options.mode ?? 'all');
  if (mode < 0) {
    throw usage(`mode is '${options.mode}'`, `give one of ${MODES.join(', ')}`);
  }
  return query('soms_overlap', ...bodies, mode, number(options.limit ?? Infinity, 'limit', 0), timeOf(options));
}

/** Which triangles of two surfaces share a point. */
export function overlap(a, b, options = {}) {
  const { any, coverage, pairs, cost } = columnsOf('OverlapBatch', overlapColumns(single(a, b), options));
  return firstOf('Overlap', { any, pairs, coverage, cost });
}

export function overlapBatch(mover, poses, fixed, options = {}) {
  return columnsOf('OverlapBatch', overlapColumns(batch(mover, poses, fixed), options));
}

/** What pairs of triangles have in common, for drawing: nothing, a point, a segment's ends, or an outline. */
export function crossings(a, b, pairs) {
  const [first, second] = [placed(a, 'the first body'), placed(b, 'the second body')];
  const numbers = pairsOf(pairs);
  const [offsets, points] = query('soms_crossings', ...first, ...second, numbers, numbers.length / 2);
  return { offsets, points };
}

function distances(bodies, options) {
  return columnsOf('Distance', query('soms_distance', ...bodies, atMostOf(options), timeOf(options)));
}

/** The least distance of two surfaces, as a bracket that holds it. */
export function distance(a, b, options = {}) {
  return firstOf('Distance', distances(single(a, b), options));
}

export function distanceBatch(mover, poses, fixed, options = {}) {
  return distances(batch(mover, poses, fixed), options);
}

function withins(bodies, clearance, options) {
  return columnsOf('Within', query('soms_within', ...bodies, number(clearance, 'clearance'), timeOf(options)));
}

/** Whether two surfaces are within a clearance of each other. */
export function within(a, b, clearance, options = {}) {
  return firstOf('Within', withins(single(a, b), clearance, options));
}

export function withinBatch(mover, poses, fixed, clearance, options = {}) {
  return withins(batch(mover, poses, fixed), clearance, options);
}

function relations(bodies, options) {
  return columnsOf('Solid', query('soms_solid', ...bodies, timeOf(options)));
}

/** The relation of two closed bodies. */
export function solid(a, b, options = {}) {
  return firstOf('Solid', relations(single(a, b), options));
}

export function solidBatch(mover, poses, fixed, options = {}) {
  return relations(batch(mover, poses, fixed), options);
}
