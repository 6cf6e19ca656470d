// Queries of rays and segments against one body: single, and in a batch.
import { costOf, nameOf, pointOf, timeOf, triangleOf } from './answers.js';
import { lines } from './arrays.js';
import { usage } from './errors.js';
import { placed } from './meshes.js';
import { query } from './module.js';

function columns(name, body, rays, options) {
  const { numbers, count, segments } = lines(rays);
  const skip = options.skip ?? -1;
  if (!Number.isInteger(skip) || skip < -1 || skip > 0x7fffffff) {
    throw usage(`skip is ${String(skip)}`, 'give the number of a triangle');
  }
  return query(name, ...placed(body, 'the body'), numbers, count, segments, skip, timeOf(options));
}

function closestHitColumns(body, rays, options) {
  const [lower, upper, triangle, point, front, coverage, cost] = columns('soms_closest_hit', body, rays, options);
  return { lower, upper, triangle, point, front, coverage, cost: costOf(cost) };
}

/** Where a ray, or a segment, first meets a surface. */
export function closestHit(body, ray, options = {}) {
  const found = closestHitColumns(body, [ray], options);
  return {
    lower: found.lower[0],
    upper: found.upper[0],
    triangle: triangleOf(found.triangle),
    point: pointOf(found.point),
    front: found.front[0] === 1,
    coverage: nameOf('coverage', found.coverage),
    cost: found.cost,
  };
}

export function closestHitBatch(body, rays, options = {}) {
  return closestHitColumns(body, rays, options);
}

/** Whether a ray, or a segment, meets a surface. */
export function anyHit(body, ray, options = {}) {
  const found = anyHitBatch(body, [ray], options);
  return { hit: found.hit[0] === 1, coverage: nameOf('coverage', found.coverage), cost: found.cost };
}

export function anyHitBatch(body, rays, options = {}) {
  const [hit, coverage, cost] = columns('soms_any_hit', body, rays, options);
  return { hit, coverage, cost: costOf(cost) };
}

/** Every place where each ray meets a surface: rows of crossings, and their triangles. */
export function allHits(body, rays, options = {}) {
  const [offsets, lower, upper, kind, triangleOffsets, triangle, coverage, cost] =
      columns('soms_all_hits', body, rays, options);
  return { offsets, lower, upper, kind, triangleOffsets, triangle, coverage, cost: costOf(cost) };
}
