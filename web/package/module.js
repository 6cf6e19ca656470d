// The WebAssembly module: loaded once, called with numbers and typed arrays, answered in typed arrays.
import { SomsError } from './errors.js';
import { hostImports } from './host.js';

let exported = null;  // functions and memory of the module
let loading = null;
let scratch = { address: 0, bytes: 0 };

const COLUMN_TYPES = [Uint8Array, Uint32Array, Int32Array, Float64Array];

async function contentOf(url) {
  if (url.protocol === 'file:' && typeof process !== 'undefined' && process.versions?.node) {
    const files = 'node:fs/promises';  // a variable, so that bundlers for browsers leave it alone
    return (await import(/* webpackIgnore: true */ /* @vite-ignore */ files)).readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok) {
    throw new Error(`status ${response.status}`);
  }
  return response.arrayBuffer();
}

async function bytesOf(url) {
  try {
    return await contentOf(url);
  } catch (error) {
    throw new SomsError('cannot_open', `${url}: ${error.message}`,
                        'serve soms.wasm beside soms.js, or hand its URL or bytes to load()');
  }
}

async function compiledFrom(bytes) {
  try {
    return await WebAssembly.compile(bytes);
  } catch (error) {
    throw new SomsError('unsupported', `soms.wasm cannot be compiled: ${error.message}`,
                        'hand in the whole file; WebAssembly needs SIMD and exceptions, as browsers have since 2023');
  }
}

async function compiled(source) {
  if (source instanceof WebAssembly.Module) {
    return source;
  }
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) {
    return compiledFrom(source);
  }
  const beside = new URL('./soms.wasm', import.meta.url);
  return compiledFrom(await bytesOf(source === undefined ? beside : new URL(source, globalThis.location?.href ?? beside)));
}

async function start({ source } = {}) {
  const module = await compiled(source);
  const instance = await WebAssembly.instantiate(module, hostImports(() => exported.memory));
  exported = instance.exports;
  exported._initialize();
}

/**
 * Loads the module; further calls wait for the first one.
 * `source`: its URL, bytes or compiled module; without it, soms.wasm beside this file.
 */
export function load(options) {
  loading ??= start(options).catch((error) => {
    loading = null;
    exported = null;
    throw error;
  });
  return loading;
}

function loaded() {
  if (exported === null) {
    throw new SomsError('usage', 'soms is not loaded', 'await soms.load() first');
  }
  return exported;
}

/** Bytes of memory that the module holds. It grows and never shrinks: what is freed is used again. */
export function memorySize() {
  return loaded().memory.buffer.byteLength;
}

/** Bytes of it that are in use. */
export function memoryInUse() {
  return loaded().soms_memory_in_use() >>> 0;
}

function text(signed) {
  const address = signed >>> 0;
  const bytes = new Uint8Array(exported.memory.buffer);
  return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
}

function lastError() {
  return new SomsError(text(exported.soms_error_kind()), text(exported.soms_error_place()),
                       text(exported.soms_error_remedy()));
}

function makeRoom(bytes) {
  if (bytes <= scratch.bytes) {
    return;
  }
  exported.soms_release(scratch.address);
  const wanted = Math.max(bytes, 4096);
  scratch = { address: exported.soms_allocate(wanted) >>> 0, bytes: wanted };
  if (scratch.address === 0) {
    scratch.bytes = 0;
    throw new SomsError('out_of_memory', `no room for ${bytes} bytes of arguments`,
                        'hand in fewer at once');
  }
}

/** Large arguments are given back at once: their room would stay taken for good. */
function leaveRoom() {
  if (scratch.bytes > 1 << 20) {
    exported.soms_release(scratch.address);
    scratch = { address: 0, bytes: 0 };
  }
}

const padded = (bytes) => (bytes + 7) & ~7;

/** Calls a function: numbers as they are, typed arrays as the address of a copy. Throws where it returns null. */
export function run(name, ...values) {
  const functions = loaded();
  let bytes = 0;
  for (const value of values) {
    bytes += typeof value === 'number' ? 0 : padded(value.byteLength);
  }
  makeRoom(bytes);
  let at = scratch.address;
  const passed = values.map((value) => {
    if (typeof value === 'number') {
      return value;
    }
    const here = at;
    new Uint8Array(functions.memory.buffer, here, value.byteLength)
        .set(new Uint8Array(value.buffer, value.byteOffset, value.byteLength));
    at += padded(value.byteLength);
    return here;
  });
  const result = functions[name](...passed) >>> 0;  // WebAssembly's integers have a sign, addresses have none
  leaveRoom();
  if (result === 0) {
    throw lastError();
  }
  return result;
}

/** Calls a function that answers in columns; they are copied, and the answer is freed. */
export function query(name, ...values) {
  const answer = run(name, ...values);
  const columns = [];
  for (let k = 0; k < exported.soms_answer_columns(answer); ++k) {
    const [address, count, numbers] =
        new Uint32Array(exported.memory.buffer, exported.soms_answer_column(answer, k) >>> 0, 3);
    const Type = COLUMN_TYPES[numbers];
    columns.push(count === 0 ? new Type() : new Type(exported.memory.buffer, address, count).slice());
  }
  exported.soms_answer_free(answer);
  return columns;
}

/** The address of an object that the module made. Users have no way to make one: a number is no handle. */
export class Made {
  constructor(address) {
    this.address = address;
  }
}

export function made(address) {
  return new Made(address);
}

const forgotten = new FinalizationRegistry(({ address, release }) => exported[release](address));

/** What lives in the module until it is freed: by hand, by `using`, or after it became unreachable. */
export class Handle {
  #address;
  #release;
  #type;  // not the name of its class, which minifiers change

  constructor({ address }, release, type) {
    this.#address = address;
    this.#release = release;
    this.#type = type;
    forgotten.register(this, { address, release }, this);
  }

  /** Where it is in the module. Throws once it is freed. */
  get address() {
    if (this.#address === 0) {
      throw new SomsError('usage', `this ${this.#type} was freed`, 'keep it until its last use');
    }
    return this.#address;
  }

  /** Gives its memory back. Does nothing the second time. */
  free() {
    if (this.#address !== 0) {
      forgotten.unregister(this);
      exported[this.#release](this.#address);
      this.#address = 0;
    }
  }
}
if (Symbol.dispose) {
  Handle.prototype[Symbol.dispose] = Handle.prototype.free;
}
