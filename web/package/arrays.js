// Arguments of any shape that callers have, as flat typed arrays.
import { SomsError, number, usage } from './errors.js';

const SharedBuffer = globalThis.SharedArrayBuffer ?? ArrayBuffer;  // pages without isolation have none
const MOST_BYTES = 2 ** 31 - 8;  // of a file: its copy and what is made of it share 4 GB
const IDENTITY = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);

function isTyped(value) {
  return ArrayBuffer.isView(value) && !(value instanceof DataView) && typeof value[0] !== 'bigint';
}

/** Throws for a buffer that was handed to a worker: it looks empty, which would be a surprise. */
function demandPresent(buffer) {
  try {
    new Uint8Array(buffer);
  } catch {
    throw usage('this array was handed to a worker, and is empty now', 'hand over a copy of it');
  }
}

/** The bytes of a file: an ArrayBuffer, or a view of one, such as a Buffer of node. */
export function fileBytes(value) {
  if (!(ArrayBuffer.isView(value) || value instanceof ArrayBuffer || value instanceof SharedBuffer)) {
    throw usage('these are no bytes of a file', 'give an ArrayBuffer or a Uint8Array');
  }
  demandPresent(value.buffer ?? value);
  if (value.byteLength > MOST_BYTES) {
    throw new SomsError('out_of_memory', `the file has ${value.byteLength} bytes, more than ${MOST_BYTES}`,
                        'it does not fit into the module, which copies it: divide the model');
  }
  return ArrayBuffer.isView(value) ? value : new Uint8Array(value);
}

function isNumbers(value) {
  if (value?.length === 0 && isTyped(value)) {
    demandPresent(value.buffer);
  }
  return isTyped(value) || (Array.isArray(value) && value.every((x) => typeof x === 'number'));
}

/** Flat numbers, `width` to a row. */
function flat(value, width, what) {
  if (!isNumbers(value)) {
    throw usage(`${what}: no flat numbers`, 'give a typed array, or an array of numbers');
  }
  if (value.length % width !== 0) {
    throw usage(`${what}: ${value.length} numbers, which is not a multiple of ${width}`,
                `give ${width} numbers for each`);
  }
  return value instanceof Float64Array ? value : Float64Array.from(value);
}

function ofVector(value, what) {
  if (isNumbers(value) && value.length === 3) {
    return value;
  }
  if (typeof value?.x === 'number' && typeof value.y === 'number' && typeof value.z === 'number') {
    return [value.x, value.y, value.z];
  }
  throw usage(`${what} is no point`, 'give [x, y, z], a typed array of 3, or a Vector3');
}

/** One point: [x, y, z], a typed array, or a Vector3. */
export function point(value, what = 'the point') {
  return Float64Array.from(ofVector(value, what));
}

/** Points: n x 3 numbers, or an array of points. */
export function points(value) {
  if (isNumbers(value)) {
    return flat(value, 3, 'points');
  }
  if (!Array.isArray(value)) {
    throw usage('points are missing', 'give a Float64Array of n x 3 numbers, or an array of points');
  }
  return Float64Array.from(value.flatMap((each, i) => [...ofVector(each, `point ${i}`)]));
}

/** The 12 numbers of a pose: a Matrix4 (by columns, in double), or 12 numbers by rows of [R | t]. */
export function pose(value) {
  if (value === undefined || value === null) {
    return IDENTITY;
  }
  const e = value.elements;
  if (e?.length === 16) {
    if (e[3] !== 0 || e[7] !== 0 || e[11] !== 0 || e[15] !== 1) {
      throw usage('the last row of a Matrix4 is not 0, 0, 0, 1', 'give a matrix that turns and shifts');
    }
    return Float64Array.of(e[0], e[4], e[8], e[12], e[1], e[5], e[9], e[13], e[2], e[6], e[10], e[14]);
  }
  if (isNumbers(value) && value.length === 12) {
    return flat(value, 12, 'pose');
  }
  throw usage('this is no pose', 'give a Matrix4, or 12 numbers: the rows of [R | t]');
}

/** Poses: n x 12 numbers, or an array of poses. */
export function poses(value) {
  if (isNumbers(value)) {
    return flat(value, 12, 'poses');
  }
  if (!Array.isArray(value)) {
    throw usage('poses are missing', 'give a Float64Array of n x 12 numbers, or an array of Matrix4');
  }
  const all = new Float64Array(12 * value.length);
  value.forEach((each, i) => all.set(pose(each), 12 * i));
  return all;
}

/** 28 numbers of a motion: along, between, turn; its start; what is left. */
function motion(value, what) {
  const start = pose(value?.start);
  if (value?.by !== undefined) {
    return [0, ...start, ...ofVector(value.by, `${what}: by`)];
  }
  if (value?.axis !== undefined) {
    return [2, ...start, ...ofVector(value.center ?? [0, 0, 0], `${what}: its center`),
            ...ofVector(value.axis, `${what}: its axis`), number(value.angle, `${what}: its angle`)];
  }
  if (value?.end === undefined) {
    throw usage(`${what} has no end`, 'give {start, end}, {start, by}, or {start, center, axis, angle}');
  }
  return [1, ...start, ...pose(value.end), ...ofVector(value.pivot ?? [0, 0, 0], `${what}: its pivot`)];
}

/** Motions, 28 numbers each. */
export function motions(value) {
  if (!Array.isArray(value)) {
    throw usage('motions are missing', 'give an array of motions');
  }
  const all = new Float64Array(28 * value.length);
  value.forEach((each, i) => all.set(motion(each, `motion ${i}`), 28 * i));
  return all;
}

function line(value, what) {
  if (value?.origin !== undefined && value.direction !== undefined) {
    return [...ofVector(value.origin, `${what}: its origin`), ...ofVector(value.direction, `${what}: its direction`),
            value.length ?? Infinity];
  }
  if (value?.from !== undefined && value.to !== undefined) {
    return [...ofVector(value.from, `${what}: from`), ...ofVector(value.to, `${what}: to`)];
  }
  throw usage(`${what} is no ray`, 'give {origin, direction, length}, or {from, to} for a segment');
}

/** Lines: an array of rays or of segments, n x 7 numbers of rays, or {segments: n x 6 numbers}. */
export function lines(value) {
  if (isNumbers(value) && value.length > 0) {
    return { numbers: flat(value, 7, 'rays'), count: value.length / 7, segments: 0 };
  }
  if (value?.segments !== undefined) {
    const numbers = flat(value.segments, 6, 'segments');
    return { numbers, count: numbers.length / 6, segments: 1 };
  }
  if (value?.length === undefined || typeof value === 'string') {
    throw usage('rays are missing', 'give an array of rays, or a Float64Array of n x 7 numbers');
  }
  const all = value.map((each, i) => line(each, `ray ${i}`));
  const width = all.length === 0 ? 7 : all[0].length;
  if (all.some((each) => each.length !== width)) {
    throw usage('rays and segments are mixed', 'give them in two calls');
  }
  return { numbers: Float64Array.from(all.flat()), count: all.length, segments: width === 6 ? 1 : 0 };
}

function indices(value) {
  if (!isNumbers(value)) {
    throw usage('triangles: no flat numbers', 'give a typed array, or an array of numbers: three for each');
  }
  if (value instanceof Uint32Array) {
    return value;
  }
  for (const [k, index] of value.entries()) {
    if (!Number.isInteger(index) || index < 0 || index > 0xffffffff) {
      throw usage(`number ${k} of triangles is ${index}`, 'give whole numbers from 0 on');
    }
  }
  return Uint32Array.from(value);
}

/** Whether the array's numbers are coordinates: three.js scales integers, and keeps halves of floats as integers. */
function isPlain({ array, isInterleavedBufferAttribute, itemSize, normalized, getX }) {
  const isFloat = array instanceof Float32Array || array instanceof Float64Array;
  return isNumbers(array) && !isInterleavedBufferAttribute && itemSize === 3 && (isFloat || !(normalized || getX));
}

function taken(array, count) {
  if (!isNumbers(array)) {
    throw usage('a geometry has no numbers in an array', 'give a BufferGeometry, or {vertices, triangles}');
  }
  return array.length === count ? array : array.slice(0, count);
}

function positions(attribute) {
  if (isPlain(attribute)) {
    return taken(attribute.array, 3 * attribute.count);
  }
  if (typeof attribute.getX !== 'function') {
    throw usage('the positions of this geometry cannot be read', 'give a BufferAttribute, or an array of 3 numbers for each vertex');
  }
  const all = new Float64Array(3 * attribute.count);
  for (let i = 0; i < attribute.count; ++i) {
    all.set([attribute.getX(i), attribute.getY(i), attribute.getZ(i)], 3 * i);
  }
  return all;
}

function arraysOf(value) {
  const geometry = value?.geometry ?? value;
  if (geometry?.attributes?.position !== undefined) {
    const index = geometry.index;
    return [positions(geometry.attributes.position), index ? taken(index.array, index.count) : undefined];
  }
  if (value?.vertices !== undefined) {
    return [value.vertices, value.triangles];
  }
  throw usage('this is no mesh', 'give {vertices, triangles}, or a BufferGeometry');
}

/** Arrays of a mesh: {vertices: n x 3, triangles: m x 3} or a BufferGeometry; without indices, three vertices each. */
export function meshArrays(value) {
  const [given, faces] = arraysOf(value);
  const vertices = flat(given, 3, 'vertices');
  const triangles = faces === undefined || faces === null
      ? Uint32Array.from({ length: vertices.length / 3 }, (_, i) => i) : indices(faces);
  if (triangles.length % 3 !== 0) {
    throw usage(`triangles: ${triangles.length} indices, which is not a multiple of 3`, 'give three for each');
  }
  return { vertices, triangles };
}

/** Pairs of triangles: n x 2 numbers. */
export function pairs(value) {
  const all = indices(value);
  if (all.length % 2 !== 0) {
    throw usage(`pairs: ${all.length} numbers, which is not a multiple of 2`, 'give two for each');
  }
  return all;
}

/** Whether `meshArrays` takes it for a BufferGeometry, or a mesh of one. */
export function isGeometry(value) {
  return (value?.geometry ?? value)?.attributes?.position !== undefined;
}
