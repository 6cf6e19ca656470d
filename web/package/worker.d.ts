/** The queries of soms in a worker: each answers by a promise. */
import type * as soms from './soms.js';

/** What lives in the worker until `free`, or some time after it is unreachable. */
interface Remote<Type> {
  /** Tells handles of different kinds apart. */
  readonly remote: Type;
  free(): Promise<void>;
}
export interface RemoteMesh extends Remote<'Mesh'> {
  read(): Promise<soms.MeshContent>;
}
export interface RemoteShape extends Remote<'Shape'> {
  bounds(): Promise<{ lower: Float64Array; upper: Float64Array }>;
  memory(): Promise<number>;
  read(): Promise<soms.MeshContent>;
  save(): Promise<Uint8Array>;
}
export interface RemoteWindingIndex extends Remote<'WindingIndex'> {}

/** Handles of the worker in the place of those of the page. */
type Passed<Value> = Value extends soms.Shape ? RemoteShape
    : Value extends soms.Mesh ? RemoteMesh
    : Value extends soms.WindingIndex ? RemoteWindingIndex
    : Value extends soms.Body ? { shape: RemoteShape; pose?: soms.PoseLike }
    : Value extends { shape: soms.Shape } ? { shape: RemoteShape; pose?: soms.PoseLike }
    : Value;
type PassedAll<Values extends unknown[]> = { [K in keyof Values]: Passed<Values[K]> };
type Promised<Query> = Query extends (...values: infer Values) => infer Answer
    ? (...values: PassedAll<Values>) => Promise<Answer> : never;

// Written by tools/fields.py of the functions in soms.d.ts.
type QueryName =
    'allHits' | 'anyHit' | 'anyHitBatch' | 'closest' | 'closestBatch' | 'closestHit' | 'closestHitBatch'
    | 'contains' | 'containsBatch' | 'crossings' | 'distance' | 'distanceBatch' | 'firstContact' | 'firstContactBatch'
    | 'instructionSet' | 'memoryInUse' | 'memorySize' | 'nearTriangles' | 'nearestTriangles' | 'overlap'
    | 'overlapBatch' | 'poseAt' | 'signedClosest' | 'signedClosestBatch' | 'solid' | 'solidBatch' | 'winding'
    | 'windingBatch' | 'within' | 'withinBatch';

export type RemoteSoms = { [Name in QueryName]: Promised<(typeof soms)[Name]> } & {
  mesh(value: soms.MeshLike): Promise<RemoteMesh>;
  readMesh(bytes: ArrayBuffer | ArrayBufferView, format: string, options?: { strict?: boolean }): Promise<RemoteMesh>;
  openShape(bytes: ArrayBuffer | ArrayBufferView, options?: { check?: soms.TreeCheck }): Promise<RemoteShape>;
  shape(value: RemoteMesh | soms.MeshLike, options?: { layout?: 'wide' | 'compact' }): Promise<RemoteShape>;
  windingIndex(body: RemoteShape | { shape: RemoteShape; pose?: soms.PoseLike }): Promise<RemoteWindingIndex>;
  /** Ends the worker and all that lives in it. */
  close(): Promise<void>;
};

/** Starts a worker and loads soms in it. */
export function start(options?: soms.LoadOptions): Promise<RemoteSoms>;
