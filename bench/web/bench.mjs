// Does a car touch a city, at random places? soms in WebAssembly beside three-mesh-bvh, in one process, pose by pose.
//   node bench.mjs PACKAGE CITY.ply CAR.ply MODULES [POSES [ROUNDS]] > results.csv
// PACKAGE: what `make wasm` leaves. MODULES: a node_modules folder with three and three-mesh-bvh. The poses are written
// to poses.bin, for native.cpp. Times are processor time of the best of ROUNDS, in which all take turns.
import { readFile, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, cityFile, carFile, modules, posesText = '2000', roundsText = '3'] = process.argv.slice(2);
const load = (...path) => import(pathToFileURL(resolve(join(...path))));
const soms = await load(folder, 'soms.js');
const three = await load(modules, 'three/build/three.module.js');
const { CENTER, MeshBVH, SAH } = await load(modules, 'three-mesh-bvh/src/index.js');
const version = JSON.parse(await readFile(join(modules, 'three-mesh-bvh/package.json'))).version;
const [count, rounds] = [Number(posesText), Number(roundsText)];

/** Numbers from 0 to 1, the same in every run (a generator of Park and Miller). */
let state = 20261126;
function random() {
  state = state * 48271 % 2147483647;
  return state / 2147483647;
}

function seconds(work) {
  const before = process.cpuUsage();
  const answer = work();
  const { user, system } = process.cpuUsage(before);
  return [(user + system) / 1e6, answer];
}

/** The same, repeated until it can be measured: what is compiled while it runs takes a while to be at its best. */
function secondsOf(work) {
  const least = 0.3;
  let [all, answer] = seconds(work);
  let times = 1;
  for (; all < least; ++times) {
    all += seconds(work)[0];
  }
  return [all / times, answer];
}

/** Places over the whole city, up to a tenth of its height, turned about z. */
function randomPoses({ lower, upper }) {
  const all = new Float64Array(12 * count);
  for (let k = 0; k < count; ++k) {
    const angle = 2 * Math.PI * random();
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const at = lower.map((least, axis) => least + (upper[axis] - least) * random() * (axis === 2 ? 0.1 : 1));
    all.set([c, -s, 0, at[0], s, c, 0, at[1], 0, 0, 1, at[2]], 12 * k);
  }
  return all;
}

function matrices(poses) {
  return Array.from({ length: count }, (_, k) => {
    const p = poses.subarray(12 * k, 12 * k + 12);
    return new three.Matrix4().set(...p.subarray(0, 4), ...p.subarray(4, 8), ...p.subarray(8, 12), 0, 0, 0, 1);
  });
}

/** three.js keeps positions in float: both libraries get these. */
function geometryOf({ vertices, triangles }) {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(Float32Array.from(vertices), 3));
  geometry.setIndex(new three.BufferAttribute(triangles.slice(), 1));
  return geometry;
}

function contents(bytes) {
  const mesh = soms.readMesh(bytes, 'ply');
  const content = mesh.read();
  mesh.free();
  return content;
}

await soms.load();
const geometries = [contents(await readFile(cityFile)), contents(await readFile(carFile))].map(geometryOf);
const [buildTime, [city, car]] = seconds(() => geometries.map((geometry) => new soms.Shape(geometry)));
const poses = randomPoses(city.bounds());
const places = matrices(poses);
await writeFile('poses.bin', poses);

function countedPairs(tree, other) {
  return places.map((place) => {
    let pairs = 0;
    tree.bvhcast(other, place, {
      intersectsTriangles(a, b) {
        pairs += a.intersectsTriangle(b) ? 1 : 0;
        return false;
      },
    });
    return pairs;
  });
}

/** What takes part: its name, and its answers for all poses. */
const takers = [
  { name: 'soms', question: 'any', run: () => [...soms.overlapBatch(car, poses, city, { mode: 'any' }).any] },
  { name: 'soms, one call a pose', question: 'any', run: () => places.map(
      (pose) => Number(soms.overlap(new soms.Body(car, pose), city, { mode: 'any' }).any)) },
  { name: 'soms', question: 'all', run() {
    const { offsets } = soms.overlapBatch(car, poses, city);
    return places.map((_, k) => offsets[k + 1] - offsets[k]);
  } },
];
const builds = [['soms', buildTime]];
for (const [name, strategy] of [['center', CENTER], ['SAH', SAH]]) {
  const [time, trees] = seconds(() => geometries.map(
      (geometry) => new MeshBVH(geometry.clone(), { strategy })));
  trees[1].geometry.boundsTree = trees[1];  // which intersectsGeometry uses
  builds.push([`three-mesh-bvh ${version}, ${name}`, time]);
  takers.push(
      { name: `three-mesh-bvh ${version}, ${name}`, question: 'any',
        run: () => places.map((place) => Number(trees[0].intersectsGeometry(trees[1].geometry, place))) },
      { name: `three-mesh-bvh ${version}, ${name}`, question: 'all', run: () => countedPairs(...trees) });
}
for (const taker of takers) {
  taker.best = Infinity;
}
for (let round = 0; round < rounds; ++round) {
  for (const taker of takers) {
    const [time, answers] = secondsOf(taker.run);
    taker.best = Math.min(taker.best, time);
    taker.answers = answers;
  }
}
console.log('question,who,microseconds,ratio,differs');
for (const { name, question, best, answers } of takers) {
  const own = takers.find((taker) => taker.name === 'soms' && taker.question === question);
  const differs = answers.filter((answer, k) => answer !== own.answers[k]).length;
  console.log(`${question},"${name}",${(best * 1e6 / count).toFixed(3)},${(best / own.best).toFixed(1)},${differs}`);
}
for (const [name, time] of builds) {
  console.log(`build,"${name}",${(time * 1e6).toFixed(0)},${(time / buildTime).toFixed(1)},`);
}
