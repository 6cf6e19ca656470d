// Runs inside the worker: does what messages say, and answers each.
import { usage } from './errors.js';
import * as soms from './soms.js';
import { MAKERS, METHODS, QUERIES } from './worker_names.js';

const held = new Map();  // {handle, type} by number
let lastNumber = 0;

function revived(value) {
  if (value?.held !== undefined) {
    return held.get(value.held)?.handle;
  }
  return value?.shape?.held === undefined ? value : new soms.Body(held.get(value.shape.held)?.handle, value.pose);
}

function free(number) {
  held.get(number)?.handle.free();
  held.delete(number);
}

function made(name, values) {
  const type = MAKERS[name];
  const handle = typeof soms[name] === 'function' ? soms[name](...values) : new soms[type](...values);
  held.set(++lastNumber, { handle, type });
  return lastNumber;
}

async function done({ name, values, on }) {
  const known = values.map(revived);
  if (name === 'load') {
    return soms.load(...known);
  }
  if (name === 'free') {
    return free(on);
  }
  if (on !== undefined) {
    const kept = held.get(on);
    if (kept === undefined) {
      throw usage('this handle was freed', 'keep it until its last use');
    }
    return METHODS[kept.type].includes(name) ? kept.handle[name]() : undefined;
  }
  return name in MAKERS ? made(name, known) : QUERIES.includes(name) ? soms[name](...known) : undefined;
}

/** What is handed over and not copied: the buffer of an array, or those of an answer's columns. */
function buffersOf(value) {
  return ArrayBuffer.isView(value) ? [value.buffer] : Object.values(value ?? {}).filter(ArrayBuffer.isView).map((view) => view.buffer);
}

async function answer(message, post) {
  try {
    const value = await done(message);
    post({ id: message.id, value }, typeof value === 'object' ? buffersOf(value) : []);
  } catch (error) {
    const { kind = 'unsupported', place = String(error), remedy = '' } = error ?? {};
    post({ id: message.id, error: { kind, place, remedy } }, []);
  }
}

if (typeof self === 'undefined') {
  const threads = 'node:worker_threads';
  import(/* webpackIgnore: true */ /* @vite-ignore */ threads).then(({ parentPort }) => {
    parentPort.on('message', (message) => answer(message, (data, list) => parentPort.postMessage(data, list)));
  });
} else {
  self.onmessage = ({ data }) => answer(data, (reply, list) => self.postMessage(reply, list));
}
