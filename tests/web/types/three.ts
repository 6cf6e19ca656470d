// What a page hands over from three.js, by its real types; types_test.py checks it.
import * as soms from 'soms';
import { start } from 'soms/worker';
import {
  BoxGeometry, BufferAttribute, BufferGeometry, Float16BufferAttribute, InstancedMesh, InterleavedBuffer, InterleavedBufferAttribute,
  Matrix4, Mesh, MeshBasicMaterial, Ray, SkinnedMesh, SphereGeometry, Vector3,
} from 'three';

const carMesh = new Mesh(new BoxGeometry(1, 1, 1));
const cityMesh: Mesh<BufferGeometry, MeshBasicMaterial> = new Mesh(new BufferGeometry(), new MeshBasicMaterial());
const buffer = new InterleavedBuffer(new Float32Array(12), 4);
const interleaved = new BufferGeometry().setAttribute('position', new InterleavedBufferAttribute(buffer, 3, 0));
const halves = new BufferGeometry().setAttribute('position', new Float16BufferAttribute(new Uint16Array(9), 3));
const named: BufferGeometry<{ position: BufferAttribute }> = new BufferGeometry<{ position: BufferAttribute }>();
const instances = new InstancedMesh(carMesh.geometry, new MeshBasicMaterial(), 4);
const place = new Matrix4();
instances.getMatrixAt(2, place);

await soms.load();
const car = new soms.Shape(carMesh.geometry);
const shapes: soms.Shape[] = [interleaved, halves, named, carMesh, cityMesh, instances, new SkinnedMesh()].map((one) => new soms.Shape(one));
const like: soms.GeometryLike = new SphereGeometry(1);
const mesh = new soms.Mesh(like);
const [city = car] = shapes;
const hits: soms.Overlap = soms.overlap(new soms.Body(car, carMesh.matrixWorld), city);
const many: soms.OverlapBatch = soms.overlapBatch(car, [carMesh.matrixWorld, place], { shape: city, pose: cityMesh.matrixWorld });
const near: soms.Closest = soms.closest(car, new Vector3(1, 2, 3));
const sides: Uint8Array = soms.containsBatch(car, [new Vector3(), carMesh.position]).side;
const hit: soms.ClosestHit = soms.closestHit(car, new Ray());
const all: soms.AllHits = soms.allHits(car, [new Ray()]);

const remote = await start();
const far = await remote.shape(carMesh.geometry);
const fixed = await remote.shape(cityMesh);
const there: soms.Overlap = await remote.overlap({ shape: far, pose: carMesh.matrixWorld }, fixed);
const rays: soms.AllHits = await remote.allHits(far, [new Ray(new Vector3(), new Vector3(0, 0, 1))]);

// @ts-expect-error: a matrix is no mesh
new soms.Shape(place);
// @ts-expect-error: a geometry is no pose
new soms.Body(car, carMesh.geometry);
console.log(mesh, hits, many, near, sides, hit, all, there, rays);
