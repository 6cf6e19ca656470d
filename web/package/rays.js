// Queries of rays and segments against one body: single, and in a batch.
import { columnsOf, firstOf, timeOf } from './answers.js';
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

/** Where a ray, or a segment, first meets a surface. */
export function closestHit(body, ray, options = {}) {
  return firstOf('ClosestHit', closestHitBatch(body, [ray], options));
}

export function closestHitBatch(body, rays, options = {}) {
  return columnsOf('ClosestHit', columns('soms_closest_hit', body, rays, options));
}

/** Whether a ray, or a segment, meets a surface. */
export function anyHit(body, ray, options = {}) {
  return firstOf('AnyHit', anyHitBatch(body, [ray], options));
}

export function anyHitBatch(body, rays, options = {}) {
  return columnsOf('AnyHit', columns('soms_any_hit', body, rays, options));
}

/** Every place where each ray meets a surface: rows of crossings, and their triangles. */
export function allHits(body, rays, options = {}) {
  return columnsOf('AllHits', columns('soms_all_hits', body, rays, options));
}
