// soms: exact, fast answers to which triangles touch.
import { query } from './module.js';

export { NAMES } from './fields.js';
export { SomsError } from './errors.js';
export { Body, Mesh, Shape, openShape, readMesh } from './meshes.js';
export { load, memoryInUse, memorySize } from './module.js';
export { firstContact, firstContactBatch, poseAt } from './motions.js';
export { crossings, distance, distanceBatch, overlap, overlapBatch, solid, solidBatch, within, withinBatch } from './pairs.js';
export {
  WindingIndex, closest, closestBatch, contains, containsBatch, nearTriangles, nearestTriangles, signedClosest,
  signedClosestBatch, winding, windingBatch,
} from './points.js';
export { allHits, anyHit, anyHitBatch, closestHit, closestHitBatch } from './rays.js';

/** What queries run on: 'simd128'. */
export function instructionSet() {
  return new TextDecoder().decode(query('soms_instruction_set')[0]);
}
