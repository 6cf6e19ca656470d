/** soms: exact, fast answers to which triangles touch. docs/web.md of its repository has a page about it. */

/// <reference lib="esnext.disposable" />

type Numbers = ArrayLike<number>;
/** Where the program knows no browser, these are nothing. */
type Url = typeof globalThis extends { URL: { prototype: infer Type } } ? Type : never;
type Module = typeof globalThis extends { WebAssembly: { Module: { prototype: infer Type } } } ? Type : never;

/** Thrown by every function. */
export class SomsError extends Error {
  /** Stable, to branch on. */
  readonly kind: 'usage' | 'cannot_open' | 'bad_file' | 'empty_mesh' | 'not_finite' | 'out_of_range' | 'not_rigid'
      | 'not_closed' | 'unsupported' | 'out_of_memory' | 'timed_out' | 'cannot_write' | 'cancelled';
  /** What is wrong, and where. */
  readonly place: string;
  /** What to do about it; may be empty. */
  readonly remedy: string;
  constructor(kind: string, place: string, remedy: string);
}

export interface LoadOptions {
  /** URL, bytes or compiled module; by default soms.wasm beside the script. */
  source?: string | Url | ArrayBuffer | ArrayBufferView | Module;
}

/** Loads the module. Await it before anything else; later calls wait for the first. */
export function load(options?: LoadOptions): Promise<void>;
/** What queries run on: 'simd128'. */
export function instructionSet(): string;
/** Bytes that the module's memory takes. What is freed is used again, and not given back. */
export function memorySize(): number;
/** Bytes of it that are in use. */
export function memoryInUse(): number;

/** A three.js BufferAttribute or InterleavedBufferAttribute, or what looks like one. */
export interface AttributeLike {
  array: Numbers;
  count: number;
  itemSize: number;
}
/** A three.js BufferGeometry, or what looks like one. */
export interface GeometryLike {
  attributes: { position: AttributeLike } | { [name: string]: AttributeLike };
  index: { array: Numbers; count: number } | null;
}
/** Vertices: n x 3. Triangles: m x 3 indices; without them three vertices each make a triangle. */
export interface MeshArrays {
  vertices: Numbers;
  triangles?: Numbers | null;
}
/** What a mesh is made of; of a three.js Mesh the geometry alone: its matrixWorld is a pose. */
export type MeshLike = MeshArrays | GeometryLike | { geometry: GeometryLike };
/** A three.js Matrix4, or 12 numbers: the rows of [R | t]. R must be a rotation, to 1e-6. */
export type PoseLike = { elements: Numbers } | Numbers;
/** n x 12 numbers, or an array of poses. */
export type PosesLike = Float64Array | readonly PoseLike[];
/** A three.js Vector3, or 3 numbers. */
export type PointLike = { x: number; y: number; z: number } | Numbers;
/** n x 3 numbers, or an array of points. */
export type PointsLike = Float64Array | Float32Array | readonly PointLike[];
/** origin + t direction, 0 <= t <= length; without `length` endless. A three.js Ray is one. */
export interface RayLike {
  origin: PointLike;
  direction: PointLike;
  length?: number;
}
export interface SegmentLike {
  from: PointLike;
  to: PointLike;
}
/** Arrays of one kind; n x 7 numbers of rays; or n x 6 numbers of segments. */
export type LinesLike = readonly RayLike[] | readonly SegmentLike[] | Float64Array | { segments: Numbers };

/** Lives in the module until `free`, the end of a `using` block, or some time after it is unreachable. */
declare class Handle {
  free(): void;
  [Symbol.dispose](): void;
}

export interface MeshPart {
  name: string;
  first: number;
  count: number;
  /** Index of the part around it; -1 for none. */
  parent: number;
}
export interface MeshContent {
  vertices: Float64Array;
  triangles: Uint32Array;
  parts: MeshPart[];
  /** What the file holds that was not read. */
  notes: string[];
  /** Meters a unit; 0 where the file does not say. */
  unit: number;
  up: 'unknown' | 'x' | 'y' | 'z';
  /** FNV-1a 64 over all corners, 16 hexadecimal digits: the `corner_hash` of C++. */
  cornerHash: string;
}

export class Mesh extends Handle {
  constructor(value: MeshLike);
  /** Copies of what it holds. */
  read(): MeshContent;
}
/** `format`: 'ply', 'stl', 'obj', 'glb', 'off', '3ds', or the file's name. `strict`: notes are errors. */
export function readMesh(bytes: ArrayBuffer | ArrayBufferView, format: string, options?: { strict?: boolean }): Mesh;

/** A mesh with its tree. Costs a few seconds for a million triangles. */
export class Shape extends Handle {
  constructor(value: Mesh | MeshLike, options?: { layout?: 'wide' | 'compact' });
  bounds(): { lower: Float64Array; upper: Float64Array };
  memory(): number;
  /** Copies of what its mesh holds. */
  read(): MeshContent;
  /** The bytes of its tree file (.somst): about 110 for each triangle, 41 with layout 'compact'. `openShape` opens them. */
  save(): Uint8Array;
}
/**
 * How closely a tree file is looked at before it is used; each also finds what those before it find.
 * trusted: the head alone; for files of your own making, as a damaged one may end in a WebAssembly.RuntimeError.
 * safe: indices and numbers with which a query would not end, or touch other memory.
 * sound: all damage. full: boxes too small, which one who means harm could write.
 */
export type TreeCheck = 'trusted' | 'safe' | 'sound' | 'full';
/**
 * The shape in the bytes of a tree file, which are copied; `check` is 'sound' by default. Answers are those of the shape
 * that was saved. Throws kind 'bad_file', which names the section; 'unsupported' for another version of the format.
 */
export function openShape(bytes: ArrayBuffer | ArrayBufferView, options?: { check?: TreeCheck }): Shape;
/** A shape at a place. */
export class Body {
  constructor(shape: Shape, pose?: PoseLike);
  shape: Shape;
  pose?: PoseLike;
}
export type Placed = Shape | Body | { shape: Shape; pose?: PoseLike };

// Answers, written by tools/fields.py.
/** How much of the question an answer covers: everything, up to the first hit as requested, or what a limit or a deadline left. */
export type Coverage = 'complete' | 'first' | 'cut';
/** How two closed bodies stand to each other. */
export type Relation = 'clear' | 'touching' | 'crossing' | 'a_in_b' | 'b_in_a' | 'same' | 'undecided';
/** Where a point lies. */
export type Side = 'outside' | 'inside' | 'on' | 'undecided';
/** Where on a triangle a point lies. */
export type TriangleFeature = 'vertex' | 'edge' | 'face';
/** What is proved of a motion: no contact at all, a contact on the way, neither of the two, or a contact at the start. */
export type ContactVerdict = 'free' | 'contact' | 'grazing' | 'started';
/** Work done, the same on every machine. */
export interface Cost {
  /** Boxes, or pairs of boxes, tested. */
  nodeTests: number;
  /** Triangles, or pairs of them, tested. */
  triangleTests: number;
  /** Of these, those that needed exact arithmetic. */
  exactTests: number;
}
/** Answer of overlap. */
export interface Overlap {
  /** Some pair of triangles shares a point. */
  any: boolean;
  /** k x 2. Triangle of a, triangle of b; sorted. One pair in modes any, first. */
  pairs: Uint32Array;
  coverage: Coverage;
  cost: Cost;
}
/** Answers of overlap for n poses. */
export interface OverlapBatch {
  /** n. Some pair of triangles shares a point. */
  any: Uint8Array;
  /** n + 1. Pose i has the pairs offsets[i] to offsets[i + 1]. */
  offsets: Uint32Array;
  /** k x 2. The pairs of all poses. */
  pairs: Uint32Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of distance. */
export interface Distance {
  /** The distance is at least this. */
  lower: number;
  /** The distance is at most this. */
  upper: number;
  /** The distance exceeds atMost. */
  farther: boolean;
  /** The least pair at this distance. */
  triangles: [number, number] | null;
  /** The end of its shortest segment on a, in world. 0 without a triangle. */
  pointA: Float64Array;
  /** The other end, on b. 0 without a triangle. */
  pointB: Float64Array;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of Distance. */
export interface DistanceBatch {
  lower: Float64Array;
  upper: Float64Array;
  farther: Uint8Array;
  /** n x 2; -1 for none. */
  triangles: Int32Array;
  /** n x 3. */
  pointA: Float64Array;
  /** n x 3. */
  pointB: Float64Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of within. */
export interface Within {
  /** The distance is at most the clearance. */
  within: boolean;
  /** A lower bound of the distance. */
  atLeast: number;
  /** Some pair within the clearance. */
  triangles: [number, number] | null;
  /** The end of its shortest segment on a, in world. 0 without a triangle. */
  pointA: Float64Array;
  /** The other end, on b. 0 without a triangle. */
  pointB: Float64Array;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of Within. */
export interface WithinBatch {
  within: Uint8Array;
  atLeast: Float64Array;
  /** n x 2; -1 for none. */
  triangles: Int32Array;
  /** n x 3. */
  pointA: Float64Array;
  /** n x 3. */
  pointB: Float64Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of solid. */
export interface Solid {
  /** How the bodies stand to each other. */
  relation: Relation;
  /** Triangles of the two overlap. */
  surfacesMeet: boolean;
  /** Why the relation is undecided. */
  why: 'none' | 'deadline' | 'open';
  coverage: Coverage;
  cost: Cost;
}
/** Columns of Solid. */
export interface SolidBatch {
  relation: Uint8Array;
  surfacesMeet: Uint8Array;
  why: Uint8Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of contains for a point. */
export interface Contains {
  /** Where the point lies. */
  side: Side;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of Contains. */
export interface ContainsBatch {
  side: Uint8Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of closest for a point. */
export interface Closest {
  /** The distance is at least this. */
  lower: number;
  /** The distance is at most this. */
  upper: number;
  /** The distance exceeds atMost. */
  farther: boolean;
  /** The least triangle at this distance. */
  triangle: number | null;
  /** The nearest point, in world. 0 without a triangle. */
  point: Float64Array;
  /** Where on the triangle that lies. 0 without a triangle. */
  feature: TriangleFeature;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of Closest. */
export interface ClosestBatch {
  lower: Float64Array;
  upper: Float64Array;
  farther: Uint8Array;
  /** n; -1 for none. */
  triangle: Int32Array;
  /** n x 3. */
  point: Float64Array;
  feature: Uint8Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Triangles near each of n points. */
export interface NearTriangles {
  /** n + 1. Point i has the triangles offsets[i] to offsets[i + 1]. */
  offsets: Uint32Array;
  /** k. The triangles of all points. */
  triangle: Uint32Array;
  /** k. The distance is at least this. */
  lower: Float64Array;
  /** k. The distance is at most this. */
  upper: Float64Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of winding for a point. */
export interface Winding {
  /** Where the point lies, by the number. */
  side: Side;
  /** The winding number is at least this. */
  lower: number;
  /** The winding number is at most this. */
  upper: number;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of Winding. */
export interface WindingBatch {
  side: Uint8Array;
  lower: Float64Array;
  upper: Float64Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of closest_hit for a ray. */
export interface ClosestHit {
  /** The least t, infinity where nothing is hit, is at least this. */
  lower: number;
  /** The least t, infinity where nothing is hit, is at most this. */
  upper: number;
  /** The least triangle met at this t. */
  triangle: number | null;
  /** Where, in world. 0 without a triangle. */
  point: Float64Array;
  /** The ray meets the front of the triangle. 0 without a triangle. */
  front: boolean;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of ClosestHit. */
export interface ClosestHitBatch {
  lower: Float64Array;
  upper: Float64Array;
  /** n; -1 for none. */
  triangle: Int32Array;
  /** n x 3. */
  point: Float64Array;
  front: Uint8Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of any_hit for a ray. */
export interface AnyHit {
  /** The ray hits something. */
  hit: boolean;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of AnyHit. */
export interface AnyHitBatch {
  hit: Uint8Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** All places where n rays meet a surface. */
export interface AllHits {
  /** n + 1. Ray i has the crossings offsets[i] to offsets[i + 1]. */
  offsets: Uint32Array;
  /** m. The t of each crossing is at least this. */
  lower: Float64Array;
  /** m. The t of each crossing is at most this. */
  upper: Float64Array;
  /** m. How the ray passes there. */
  kind: Uint8Array;
  /** m + 1. Crossing j has the triangles triangleOffsets[j] to triangleOffsets[j + 1]. */
  triangleOffsets: Uint32Array;
  /** k. Triangles of all crossings. */
  triangle: Uint32Array;
  coverage: Uint8Array;
  cost: Cost;
}
/** Answer of first_contact. */
export interface FirstContact {
  /** What is proved. */
  verdict: ContactVerdict;
  /** The part of the way at the first contact is at least this. */
  lower: number;
  /** The part of the way at the first contact is at most this. */
  upper: number;
  /** A pair that is in contact then. */
  triangles: [number, number] | null;
  /** Where it is, in world. 0 without a triangle. */
  point: Float64Array;
  /** From the fixed body to the mover, of length 1. */
  normal: Float64Array | null;
  coverage: Coverage;
  cost: Cost;
}
/** Columns of FirstContact. */
export interface FirstContactBatch {
  verdict: Uint8Array;
  lower: Float64Array;
  upper: Float64Array;
  /** n x 2; -1 for none. */
  triangles: Int32Array;
  /** n x 3. */
  point: Float64Array;
  /** n x 3; NaN for none. */
  normal: Float64Array;
  coverage: Uint8Array;
  cost: Cost;
}
// End of answers.
/** @deprecated */
export type TriangleRows = NearTriangles;
/** @deprecated */
export type Feature = TriangleFeature;

/** Names of the codes in answers of batches: NAMES.side[codes[k]]. */
export const NAMES: {
  readonly coverage: readonly Coverage[];
  readonly relation: readonly Relation[];
  readonly why: readonly ('none' | 'deadline' | 'open')[];
  readonly side: readonly Side[];
  readonly feature: readonly TriangleFeature[];
  readonly verdict: readonly ContactVerdict[];
  readonly kind: readonly ('enter' | 'leave' | 'graze')[];
};

export interface TimeOptions {
  /** Milliseconds after which the answer is what was found so far, with coverage 'cut'. */
  timeout?: number;
  /** @deprecated The old name of `timeout`. */
  timeLimit?: number;
}

export interface OverlapOptions extends TimeOptions {
  /** 'all' pairs, sorted; 'any' pair; the 'first' by number. */
  mode?: 'all' | 'any' | 'first';
  /** Most pairs of a pose. */
  limit?: number;
}
/** Which triangles of two surfaces share a point, decided exactly. */
export function overlap(a: Placed, b: Placed, options?: OverlapOptions): Overlap;
export function overlapBatch(mover: Shape, poses: PosesLike, fixed: Placed, options?: OverlapOptions): OverlapBatch;

/** What pairs of triangles have in common: row k, of 0 to 6 points, is that of pair k. */
export interface Crossings {
  /** n + 1: the points of pair k are those from offsets[k] to offsets[k + 1]. */
  offsets: Uint32Array;
  /** x 3. One is a point, two are the ends of a segment, more an outline. */
  points: Float64Array;
}
/** Where pairs that `overlap` found cross, for drawing: within 1e-12 of the triangles' extent. */
export function crossings(a: Placed, b: Placed, pairs: Numbers): Crossings;

export interface DistanceOptions extends TimeOptions {
  /** Beyond this the answer is `farther`. */
  atMost?: number;
}
/** The least distance of two surfaces. */
export function distance(a: Placed, b: Placed, options?: DistanceOptions): Distance;
export function distanceBatch(mover: Shape, poses: PosesLike, fixed: Placed, options?: DistanceOptions): DistanceBatch;

/**
 * A way from one pose to another, at parts t from 0 to 1: a straight shift; to another pose, where the pivot, a point of
 * the body, goes straight while the body turns the shorter way; or a turn about an axis by less than a half turn.
 * Without `start` it begins at the identity.
 */
export type MotionLike =
    { start?: PoseLike; by: PointLike } | { start?: PoseLike; end: PoseLike; pivot?: PointLike }
    | { start?: PoseLike; center?: PointLike; axis: PointLike; angle: number };
export interface FirstContactOptions extends TimeOptions {
  /** Being this near is a contact; 0 for a common point. */
  within?: number;
  /** Pairs of triangles in contact at the start are left out; the verdict stays 'started', the time is of another pair. */
  parting?: boolean;
}
/** When a moving body first touches another that rests: proved for all times of the way, not for samples of it. */
export function firstContact(mover: Shape, motion: MotionLike, fixed: Placed, options?: FirstContactOptions): FirstContact;
export function firstContactBatch(mover: Shape, motions: readonly MotionLike[], fixed: Placed,
                                  options?: FirstContactOptions): FirstContactBatch;
/** The pose at a part t of the way: 12 numbers, the rows of [R | t]. */
export function poseAt(motion: MotionLike, t: number): Float64Array;

/** Whether the distance is at most `clearance`, decided exactly. */
export function within(a: Placed, b: Placed, clearance: number, options?: TimeOptions): Within;
export function withinBatch(mover: Shape, poses: PosesLike, fixed: Placed, clearance: number,
                            options?: TimeOptions): WithinBatch;

/** The relation of two closed bodies. Throws kind 'not_closed' for others. */
export function solid(a: Placed, b: Placed, options?: TimeOptions): Solid;
export function solidBatch(mover: Shape, poses: PosesLike, fixed: Placed, options?: TimeOptions): SolidBatch;

/** The point of a surface that is nearest to a point. */
export function closest(body: Placed, point: PointLike, options?: DistanceOptions): Closest;
export function closestBatch(body: Placed, points: PointsLike, options?: DistanceOptions): ClosestBatch;
/** The same, and on which side of a closed body the point is. */
export function signedClosest(body: Placed, point: PointLike, options?: DistanceOptions): Closest & { side: Side };
export function signedClosestBatch(body: Placed, points: PointsLike,
                                   options?: DistanceOptions): ClosestBatch & { side: Uint8Array };

export function nearestTriangles(body: Placed, points: PointsLike, count: number,
                                 options?: DistanceOptions): NearTriangles;
export function nearTriangles(body: Placed, points: PointsLike, radius: number, options?: TimeOptions): NearTriangles;

/** On which side of a closed body a point is, decided exactly. */
export function contains(body: Placed, point: PointLike,
                         options?: TimeOptions): Contains;
export function containsBatch(body: Placed, points: PointsLike,
                              options?: TimeOptions): ContainsBatch;

/** What `winding` knows of a body. */
export class WindingIndex extends Handle {
  constructor(body: Placed);
}
export interface WindingOptions extends TimeOptions {
  /** By how much far triangles may widen the bracket; 1e-9 by default. */
  width?: number;
}
/** The winding number of a point: also of surfaces that are not closed. */
export function winding(index: WindingIndex, point: PointLike, options?: WindingOptions):
    Winding;
export function windingBatch(index: WindingIndex, points: PointsLike, options?: WindingOptions):
    WindingBatch;

export interface RayOptions extends TimeOptions {
  /** A triangle that takes no part. */
  skip?: number;
}
/** Where a ray, or a segment, first meets a surface. */
export function closestHit(body: Placed, ray: RayLike | SegmentLike, options?: RayOptions): ClosestHit;
export function closestHitBatch(body: Placed, rays: LinesLike, options?: RayOptions): ClosestHitBatch;
export function anyHit(body: Placed, ray: RayLike | SegmentLike,
                       options?: RayOptions): AnyHit;
export function anyHitBatch(body: Placed, rays: LinesLike,
                            options?: RayOptions): AnyHitBatch;
export function allHits(body: Placed, rays: LinesLike, options?: RayOptions): AllHits;
