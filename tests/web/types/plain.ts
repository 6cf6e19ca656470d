// A program for node that has none of a browser's declarations: lib is ES2022 alone.
import { load, overlap, Shape, type Overlap } from 'soms';
import { start } from 'soms/worker';

await load({ source: new Uint8Array(8) });
const shape = new Shape({ vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0] });
const hits: Overlap = overlap(shape, shape);
shape.free();
const remote = await start({ source: 'soms.wasm' });
await remote.close();
export const { any } = hits;
