// A page as users write it: bodies of three.js, questions here and in a worker. bundlers_test.py bundles and opens it.
import * as soms from 'soms';
import { start } from 'soms/worker';
import { BoxGeometry, BufferGeometry, Float16BufferAttribute, InterleavedBuffer, InterleavedBufferAttribute, Mesh } from 'three';

function interleaved() {
  const buffer = new InterleavedBuffer(new Float32Array([0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9]), 4);
  return new BufferGeometry().setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0));
}

function halves() {
  const position = new Float16BufferAttribute(new Uint16Array(9), 3);
  position.setXYZ(1, 1, 0, 0).setXYZ(2, 0, 1, 0);
  return new BufferGeometry().setAttribute('position', position);
}

function errorOf(call) {
  try {
    return call();
  } catch (error) {
    return `${error.name} ${error.kind}: ${error.place}`;
  }
}

async function answers() {
  await soms.load();
  const mesh = new Mesh(new BoxGeometry(2, 2, 2));
  mesh.position.set(1.5, 0, 0);
  mesh.updateMatrixWorld();
  const box = new soms.Shape(mesh.geometry);
  const here = soms.overlap(new soms.Body(box, mesh.matrixWorld), box);

  const remote = await start();
  const far = await remote.shape(mesh.geometry);
  const there = await remote.overlap({ shape: far, pose: mesh.matrixWorld }, far);
  const turns = await remote.winding(await remote.windingIndex(far), [0, 0, 0]);
  const copy = await (await remote.mesh(mesh)).read();
  const { upper } = await far.bounds();
  const refused = await remote.within(far, far, -1).catch((error) => `${error.name} ${error.kind}`);
  const kept = await far.memory();
  await remote.close();

  const bytes = box.memory();
  box.free();
  return {
    here: [...here.pairs], there: [...there.pairs], turns: turns.lower, triangles: copy.triangles.length / 3,
    upper: [...upper], refused, memory: kept === bytes, freed: errorOf(() => box.bounds()),
    parts: [interleaved(), halves()].map((geometry) => [...new soms.Mesh(geometry).read().vertices]),
  };
}

window.outcome = answers();
