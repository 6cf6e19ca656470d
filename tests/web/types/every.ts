// Every function of the package, called as its users do; types_test.py checks the types, and that none is left out.
import * as soms from 'soms';
import { start } from 'soms/worker';

/** Fields of three.js that the package knows. */
class Vector3 {
  constructor(public x: number, public y: number, public z: number) {}
}
class Matrix4 {
  elements = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}
const position = { array: new Float32Array(9), count: 3, itemSize: 3, normalized: false };
const geometry = { attributes: { position }, index: null };

await soms.load();
await soms.load({ source: new URL('soms.wasm', 'https://example.org/') });
const size: number = soms.memorySize() + soms.memoryInUse();
const set: string = soms.instructionSet();

const read: soms.Mesh = soms.readMesh(new Uint8Array(8), 'ply', { strict: true });
const content: soms.MeshContent = read.read();
const part: string | undefined = content.parts[0]?.name;
const car = new soms.Shape(geometry);
const city = new soms.Shape(new soms.Mesh({ vertices: content.vertices, triangles: content.triangles }), { layout: 'compact' });
const lists = new soms.Shape({ vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0], triangles: [0, 1, 2] });
const { lower, upper }: { lower: Float64Array; upper: Float64Array } = lists.bounds();
const bytes: number = lists.memory();
const check: soms.TreeCheck = 'safe';
const saved: Uint8Array = lists.save();
const opened: soms.Shape = soms.openShape(saved, { check });
const reopened = soms.openShape(new ArrayBuffer(8));
const drawn: soms.MeshContent = opened.read();

const body = new soms.Body(car, new Matrix4());
const poses = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);
const hits: soms.Overlap = soms.overlap(body, city, { mode: 'first', limit: 10, timeout: 5 });
const common: soms.Crossings = soms.crossings(body, city, hits.pairs);
const many: soms.OverlapBatch = soms.overlapBatch(car, [new Matrix4(), poses], city);
const row: Uint32Array = many.pairs.subarray(2 * (many.offsets[0] ?? 0), 2 * (many.offsets[1] ?? 0));
const gap: soms.Distance = soms.distance(body, { shape: city }, { atMost: 1 });
const triangles: [number, number] | null = gap.triangles;
const gaps: soms.DistanceBatch = soms.distanceBatch(car, poses, city);
const near: soms.Within = soms.within(body, city, 0.1);
const nears: soms.WithinBatch = soms.withinBatch(car, poses, city, 0.1, { timeout: 1 });
const way: soms.MotionLike = { start: new Matrix4(), end: poses, pivot: new Vector3(0, 0, 1) };
const touch: soms.FirstContact = soms.firstContact(car, way, city, { within: 0.1, timeout: 5 });
const normal: Float64Array | null = touch.normal;
const touches: soms.FirstContactBatch = soms.firstContactBatch(car, [way, { by: [1, 0, 0] }, { axis: [0, 0, 1], angle: 1 }], city);
const stops: soms.ContactVerdict | undefined = soms.NAMES.verdict[touches.verdict[0] ?? 0];
const halfway: Float64Array = soms.poseAt(way, 0.5);
const relation: soms.Relation = soms.solid(body, city).relation;
const relations: soms.SolidBatch = soms.solidBatch(car, poses, city);
const named: soms.Relation | undefined = soms.NAMES.relation[relations.relation[0] ?? 0];

const points = [new Vector3(0, 0, 0), [1, 2, 3], Float64Array.of(1, 2, 3)];
const nearest: soms.Closest = soms.closest(city, points[0] ?? [0, 0, 0]);
const nearests: soms.ClosestBatch = soms.closestBatch(city, points, { atMost: 2 });
const side: soms.Side = soms.signedClosest(city, [0, 0, 0]).side;
const sides: Uint8Array = soms.signedClosestBatch(city, points).side;
const rows: soms.TriangleRows = soms.nearestTriangles(city, points, 4);
const within: soms.TriangleRows = soms.nearTriangles(city, Float64Array.of(0, 0, 0), 0.5);
const inside: soms.Side = soms.contains(city, [0, 0, 0]).side;
const insides: Uint8Array = soms.containsBatch(city, points).side;
const index = new soms.WindingIndex(city);
const turns: number = soms.winding(index, [0, 0, 0], { width: 1e-6 }).lower;
const turnings: Float64Array = soms.windingBatch(index, points).upper;

const ray = { origin: new Vector3(0, 0, 0), direction: [0, 0, 1], length: 5 };
const hit: soms.ClosestHit = soms.closestHit(city, ray, { skip: 3 });
const first: soms.ClosestHitBatch = soms.closestHitBatch(city, [ray]);
const seen: boolean = soms.anyHit(city, { from: [0, 0, 0], to: [0, 0, 1] }).hit;
const sights: Uint8Array = soms.anyHitBatch(city, { segments: [0, 0, 0, 0, 0, 1] }).hit;
const crossed: soms.AllHits = soms.allHits(city, Float64Array.of(0, 0, 0, 0, 0, 1, Infinity));

try {
  soms.overlap(body, car);
} catch (error) {
  if (error instanceof soms.SomsError) {
    const words: string = `${error.kind}: ${error.place}; ${error.remedy}`;
    console.log(words);
  }
}
for (const handle of [read, car, city, lists, opened, reopened, index]) {
  handle.free();
}
{
  using short = new soms.Shape(geometry);
  console.log(short.memory());
}

const remote = await start();
const far = await remote.shape(geometry, { layout: 'wide' });
const file = await remote.readMesh(new ArrayBuffer(8), 'model.stl');
const other = await remote.shape(file);
const answer: soms.Overlap = await remote.overlap({ shape: far, pose: new Matrix4() }, other, { mode: 'any' });
const remoteIndex = await remote.windingIndex(far);
const remoteSide: soms.Side = (await remote.winding(remoteIndex, [0, 0, 0])).side;
const box: Float64Array = (await far.bounds()).lower;
const remoteOpened = await remote.openShape(await far.save(), { check: 'full' });
const remoteDrawn: Uint32Array = (await remoteOpened.read()).triangles;
const remoteCommon: soms.Crossings = await remote.crossings(far, other, answer.pairs);
await (await remote.mesh(geometry)).free();
await remote.close();

// What is no argument is no program.
// @ts-expect-error: a mode that is none
soms.overlap(car, city, { mode: 'some' });
// @ts-expect-error: a check that is none
soms.openShape(saved, { check: 'some' });
// @ts-expect-error: a mesh is no shape
soms.overlap(read, city);
// @ts-expect-error: a shape of the page is none of the worker
await remote.overlap(car, far);
// @ts-expect-error: an answer's side is no number
const wrong: number = soms.contains(city, [0, 0, 0]).side;

console.log(size, set, part, lower, upper, bytes, common, row, triangles, gaps, near, nears, normal, stops, halfway, relation, named, nearest, nearests, side,
            sides, drawn, remoteDrawn, rows, within, inside, insides, turns, turnings, hit, first, seen, sights, crossed, remoteSide,
            box, remoteCommon, wrong);
