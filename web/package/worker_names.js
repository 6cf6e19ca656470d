// What a worker offers by the same names as soms.js. QUERIES is written by tools/fields.py of the functions in soms.d.ts.
export const QUERIES = Object.freeze([
  'allHits', 'anyHit', 'anyHitBatch', 'closest', 'closestBatch', 'closestHit', 'closestHitBatch', 'contains',
  'containsBatch', 'crossings', 'distance', 'distanceBatch', 'firstContact', 'firstContactBatch', 'instructionSet',
  'memoryInUse', 'memorySize', 'nearTriangles', 'nearestTriangles', 'overlap', 'overlapBatch', 'poseAt',
  'signedClosest', 'signedClosestBatch', 'solid', 'solidBatch', 'winding', 'windingBatch', 'within', 'withinBatch',
]);

/** What makes a handle: the method of the worker, and what it returns. */
export const MAKERS = Object.freeze({
  mesh: 'Mesh', shape: 'Shape', windingIndex: 'WindingIndex', openShape: 'Shape', readMesh: 'Mesh',
});

/** Methods of handles. */
export const METHODS = Object.freeze({ Mesh: ['read'], Shape: ['bounds', 'memory', 'read', 'save'], WindingIndex: [] });
