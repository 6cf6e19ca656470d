// Meshes, shapes, and bodies: shapes at a place.
import { fileBytes, meshArrays, pose } from './arrays.js';
import { usage } from './errors.js';
import { Handle, made, Made, query, run } from './module.js';

const UP_AXES = ['unknown', 'x', 'y', 'z'];
const NO_PARENT = 0xffffffff;
const CHECKS = ['trusted', 'safe', 'sound', 'full'];

/** What a mesh holds, of its columns. */
function contentOf([vertices, triangles, rows, bytes, numbers, hash]) {
  const words = new TextDecoder().decode(bytes).split('\0').slice(0, -1);
  const count = rows.length / 3;
  const parts = words.slice(0, count).map((name, i) => {
    const [first, size, parent] = rows.subarray(3 * i);
    return { name, first, count: size, parent: parent === NO_PARENT ? -1 : parent };
  });
  const cornerHash = [...hash].map((half) => half.toString(16).padStart(8, '0')).join('');
  return { vertices, triangles, parts, notes: words.slice(count), unit: numbers[0], up: UP_AXES[numbers[1]], cornerHash };
}

/** Triangles as read, in double. */
export class Mesh extends Handle {
  /** Of {vertices, triangles} or a three.js BufferGeometry. */
  constructor(value) {
    super(value instanceof Made ? value : Mesh.#made(value), 'soms_mesh_free', 'Mesh');
  }

  static #made(value) {
    const { vertices, triangles } = meshArrays(value);
    return made(run('soms_mesh', vertices, vertices.length / 3, triangles, triangles.length / 3));
  }

  /** Copies: {vertices, triangles, parts, notes, unit, up, cornerHash}. */
  read() {
    return contentOf(query('soms_mesh_columns', this.address));
  }
}

/** The mesh in a file's bytes: PLY, STL, OBJ, GLB, OFF, 3DS. `format` is its extension, or its name. */
export function readMesh(bytes, format, { strict = false } = {}) {
  if (typeof format !== 'string') {
    throw usage(`format is ${String(format)}`, "give an extension, such as 'ply', or the file's name");
  }
  const content = fileBytes(bytes);
  const name = new TextEncoder().encode(`${format.includes('.') ? format : `model.${format}`}\0`);
  return new Mesh(made(run('soms_read_mesh', content, content.byteLength, name, strict ? 1 : 0)));
}

/** A mesh with its tree, ready for queries. */
export class Shape extends Handle {
  /** Of a Mesh, or of what makes one. `layout`: 'wide' for speed, 'compact' for memory. */
  constructor(value, { layout = 'wide' } = {}) {
    if (layout !== 'wide' && layout !== 'compact') {
      throw usage(`layout is '${layout}'`, "give 'wide' or 'compact'");
    }
    super(value instanceof Made ? value : Shape.#made(value, layout === 'compact' ? 1 : 0), 'soms_shape_free', 'Shape');
  }

  static #made(value, compact) {
    if (value instanceof Mesh) {
      return made(run('soms_shape', value.address, compact));
    }
    const mesh = new Mesh(value);
    try {
      return made(run('soms_shape', mesh.address, compact));
    } finally {
      mesh.free();
    }
  }

  /** {lower, upper}: the least box around it, not moved. */
  bounds() {
    const [corners] = query('soms_shape_columns', this.address);
    return { lower: corners.slice(0, 3), upper: corners.slice(3) };
  }

  /** Bytes that it holds. */
  memory() {
    return query('soms_shape_columns', this.address)[1][0];
  }

  /** Copies of what its mesh holds, as of Mesh. */
  read() {
    return contentOf(query('soms_shape_mesh_columns', this.address));
  }

  /** The bytes of its tree file. */
  save() {
    return query('soms_save_shape', this.address)[0];
  }
}

/** The shape in a tree file's bytes. `check` is one of CHECKS: each finds more faults than those before it. */
export function openShape(bytes, { check = 'sound' } = {}) {
  const number = CHECKS.indexOf(check);
  if (number < 0) {
    throw usage(`check is '${String(check)}'`, `give one of ${CHECKS.join(', ')}`);
  }
  const content = fileBytes(bytes);
  return new Shape(made(run('soms_open_shape', content, content.byteLength, number)));
}

/** A shape at a place. */
export class Body {
  constructor(shape, at) {
    this.shape = shape;
    this.pose = at;
  }
}

/** Address and pose of a Shape or a Body. */
export function placed(value, what) {
  const shape = value?.shape ?? value;
  if (!(shape instanceof Shape)) {
    throw usage(`${what} is no shape`, 'give a Shape, or a Body of one');
  }
  return [shape.address, pose(value.shape === undefined ? undefined : value.pose)];
}
