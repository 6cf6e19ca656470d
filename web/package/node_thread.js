// A thread of node in the place of a worker. Loaded by name in node alone, so that no bundler for pages sees it.
import { Worker } from 'node:worker_threads';

export function newNodeThread(onReply, onFailure) {
  const worker = new Worker(new URL('./worker_thread.js', import.meta.url));
  worker.on('message', onReply);
  worker.on('error', (error) => onFailure(String(error)));
  return worker;
}
