// Runs inside the worker: does what messages say, and answers each.
import * as soms from './soms.js';
import { MAKERS, METHODS, QUERIES } from './worker_names.js';

const held = new Map();  // by number
let lastNumber = 0;

function revived(value) {
  if (value?.held !== undefined) {
    return held.get(value.held);
  }
  return value?.shape?.held === undefined ? value : new soms.Body(held.get(value.shape.held), value.pose);
}

function hold(handle) {
  held.set(++lastNumber, handle);
  return lastNumber;
}

function free(number) {
  held.get(number)?.free();
  held.delete(number);
}

function made(name, values) {
  return hold(name === 'readMesh' ? soms.readMesh(...values) : new soms[MAKERS[name]](...values));
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
    const handle = held.get(on);
    return METHODS[handle.constructor.name].includes(name) ? handle[name]() : undefined;
  }
  return name in MAKERS ? made(name, known) : QUERIES.includes(name) ? soms[name](...known) : undefined;
}

function buffersOf(value) {
  return Object.values(value ?? {}).filter(ArrayBuffer.isView).map((view) => view.buffer);
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
  const { parentPort } = await import(/* webpackIgnore: true */ /* @vite-ignore */ threads);
  parentPort.on('message', (message) => answer(message, (data, list) => parentPort.postMessage(data, list)));
} else {
  self.onmessage = ({ data }) => answer(data, (reply, list) => self.postMessage(reply, list));
}
