// Queries of two surfaces: single, and for a batch of poses of the first.
import { atMostOf, costOf, nameOf, pairOf, pointOf, timeOf } from './answers.js';
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
  const [any, coverage, offsets, pairs, cost] =
      query('soms_overlap', ...bodies, mode, number(options.limit ?? Infinity, 'limit', 0), timeOf(options));
  return { any, coverage, offsets, pairs, cost: costOf(cost) };
}

/** Which triangles of two surfaces share a point. */
export function overlap(a, b, options = {}) {
  const { any, coverage, pairs, cost } = overlapColumns(single(a, b), options);
  return { any: any[0] === 1, pairs, coverage: nameOf('coverage', coverage), cost };
}

export function overlapBatch(mover, poses, fixed, options = {}) {
  return overlapColumns(batch(mover, poses, fixed), options);
}

/** What pairs of triangles have in common, for drawing: nothing, a point, a segment's ends, or an outline. */
export function crossings(a, b, pairs) {
  const [first, second] = [placed(a, 'the first body'), placed(b, 'the second body')];
  const numbers = pairsOf(pairs);
  const [offsets, points] = query('soms_crossings', ...first, ...second, numbers, numbers.length / 2);
  return { offsets, points };
}

function distanceColumns(bodies, options) {
  const [lower, upper, triangles, pointA, pointB, farther, coverage, cost] =
      query('soms_distance', ...bodies, atMostOf(options), timeOf(options));
  return { lower, upper, triangles, pointA, pointB, farther, coverage, cost: costOf(cost) };
}

/** The least distance of two surfaces, as a bracket that holds it. */
export function distance(a, b, options = {}) {
  const found = distanceColumns(single(a, b), options);
  return {
    lower: found.lower[0],
    upper: found.upper[0],
    triangles: pairOf(found.triangles),
    pointA: pointOf(found.pointA),
    pointB: pointOf(found.pointB),
    farther: found.farther[0] === 1,
    coverage: nameOf('coverage', found.coverage),
    cost: found.cost,
  };
}

export function distanceBatch(mover, poses, fixed, options = {}) {
  return distanceColumns(batch(mover, poses, fixed), options);
}

function withinColumns(bodies, clearance, options) {
  const [within, triangles, pointA, pointB, atLeast, coverage, cost] =
      query('soms_within', ...bodies, number(clearance, 'clearance'), timeOf(options));
  return { within, triangles, pointA, pointB, atLeast, coverage, cost: costOf(cost) };
}

/** Whether two surfaces are within a clearance of each other. */
export function within(a, b, clearance, options = {}) {
  const found = withinColumns(single(a, b), clearance, options);
  return {
    within: found.within[0] === 1,
    triangles: pairOf(found.triangles),
    pointA: pointOf(found.pointA),
    pointB: pointOf(found.pointB),
    atLeast: found.atLeast[0],
    coverage: nameOf('coverage', found.coverage),
    cost: found.cost,
  };
}

export function withinBatch(mover, poses, fixed, clearance, options = {}) {
  return withinColumns(batch(mover, poses, fixed), clearance, options);
}

function solidColumns(bodies, options) {
  const [relation, surfacesMeet, why, coverage, cost] = query('soms_solid', ...bodies, timeOf(options));
  return { relation, surfacesMeet, why, coverage, cost: costOf(cost) };
}

/** The relation of two closed bodies. */
export function solid(a, b, options = {}) {
  const found = solidColumns(single(a, b), options);
  return {
    relation: nameOf('relation', found.relation),
    surfacesMeet: found.surfacesMeet[0] === 1,
    why: nameOf('why', found.why),
    coverage: nameOf('coverage', found.coverage),
    cost: found.cost,
  };
}

export function solidBatch(mover, poses, fixed, options = {}) {
  return solidColumns(batch(mover, poses, fixed), options);
}
