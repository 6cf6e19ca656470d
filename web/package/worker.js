// soms in a worker: the same queries, each answered by a promise, while the page stays free.
import { isGeometry, meshArrays } from './arrays.js';
import { SomsError } from './errors.js';
import { MAKERS, METHODS, QUERIES } from './worker_names.js';

async function newThread(onReply, onFailure) {
  if (typeof Worker === 'undefined') {
    const file = './node_thread.js';
    return (await import(/* webpackIgnore: true */ /* @vite-ignore */ file)).newNodeThread(onReply, onFailure);
  }
  // Bundlers know this expression as it stands, once.
  const worker = new Worker(new URL('./worker_thread.js', import.meta.url), { type: 'module' });
  worker.onmessage = ({ data }) => onReply(data);
  worker.onerror = (event) => onFailure(event.message ?? 'its script cannot be loaded');
  return worker;
}

/** Options of load() as a message carries them: no URL can be sent, and a relative one is meant from the page. */
function sent(options) {
  const { source } = options;
  const address = typeof source === 'string' || source instanceof URL;
  return address ? { ...options, source: String(globalThis.location ? new URL(source, location.href) : source) } : options;
}

/** What lives in the worker until it is freed, or became unreachable here. */
class RemoteHandle {
  #post;

  constructor(held, type, post) {
    this.held = held;  // what a message carries
    this.#post = post;
    for (const method of METHODS[type]) {
      Object.defineProperty(this, method, { value: () => post(method, [], held) });
    }
  }

  /** Gives its memory back. */
  free() {
    return this.#post('free', [], this.held);
  }
}
if (Symbol.asyncDispose) {
  RemoteHandle.prototype[Symbol.asyncDispose] = RemoteHandle.prototype.free;
}

class RemoteSoms {
  #thread;
  #pending = new Map();
  #lastId = 0;
  #forgotten = new FinalizationRegistry((held) => {
    if (this.#thread) {
      this.#post('free', [], held).catch(() => {});  // closed meanwhile: all is freed
    }
  });

  async start(options) {
    this.#thread = await newThread((reply) => this.#settle(reply), (what) => this.#fail(what));
    try {
      await this.#post('load', options === undefined ? [] : [sent(options)]);
    } catch (error) {
      await this.close();
      throw error;
    }
    return this;
  }

  #settle({ id, value, error }) {
    const { resolve, reject } = this.#pending.get(id);
    this.#pending.delete(id);
    if (error) {
      reject(new SomsError(error.kind, error.place, error.remedy));
    } else {
      resolve(value);
    }
  }

  #fail(what) {
    for (const { reject } of this.#pending.values()) {
      reject(new SomsError('unsupported', `the worker ended: ${what}`, 'start another'));
    }
    this.#pending.clear();
  }

  #post(name, values, on) {
    if (!this.#thread) {
      return Promise.reject(new SomsError('usage', 'the worker was closed', 'start another'));
    }
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject });
      this.#thread.postMessage({ id, name, values, on });
    });
  }

  /** Answers of a query, or a handle. */
  async call(name, values) {
    const value = await this.#post(name, values);
    if (!(name in MAKERS)) {
      return value;
    }
    const handle = new RemoteHandle(value, MAKERS[name], (...parts) => this.#post(...parts));
    this.#forgotten.register(handle, value);
    return handle;
  }

  /** Ends the worker and all that lives in it. */
  async close() {
    const thread = this.#thread;
    this.#thread = null;
    this.#fail('it was closed');
    await thread?.terminate();
  }
}
for (const name of [...QUERIES, ...Object.keys(MAKERS)]) {
  RemoteSoms.prototype[name] = function (...values) {
    return this.call(name, values.map((value) => (isGeometry(value) ? meshArrays(value) : value)));
  };
}

/** Starts a worker and loads soms in it; `options` as of load(). */
export function start(options) {
  return new RemoteSoms().start(options);
}
