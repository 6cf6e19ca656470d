// The bodies of the scene. Large models have a coarse stand-in, for the first picture and for motion
// where drawing is slow; movers that are small on the screen are drawn as their boxes.
import * as THREE from 'three';
import { creased } from './creases.js';
import { Glass } from './glass.js';
import { solid } from './look.js';
import { MotionPoses } from './motions.js';
import { Poses } from './poses.js';

const SMALL = 14; // pixels: what is smaller is drawn as a box
const CLEAR = -4; // drawing order: before all marks

function boxOf(geometry) {
  const size = geometry.boundingBox.getSize(new THREE.Vector3());
  const middle = geometry.boundingBox.getCenter(new THREE.Vector3());
  const box = new THREE.BoxGeometry(size.x, size.y, size.z).translate(middle.x, middle.y, middle.z);
  return creased({ positions: box.getAttribute('position').array, indices: box.index.array });
}

// A mesh but for some of its triangles.
function without({ positions, indices }, gone) {
  const keyAt = (corners, at) => corners.subarray(at, at + 3).join();
  const keys = new Set(Array.from({ length: gone.length / 3 }, (_, n) => keyAt(gone, 3 * n)));
  const firsts = new Set(gone.filter((_, corner) => corner % 3 === 0));
  return { positions, indices: indices.filter((_, corner) => {
    const at = corner - corner % 3;
    return !firsts.has(indices[at]) || !keys.has(keyAt(indices, at));
  }) };
}

export class Bodies {
  constructor(world, scene) {
    this.scene = scene;
    this.world = world;
    this.geometries = scene.models.map((model) => creased(model.mesh));
    this.whole = new Map(); // of models that have a stand-in, once they are there
    this.movingMaterial = solid();
    this.stillMeshes = [];
    const poses = new Poses(scene);
    this.partColor = new THREE.Color();
    this.poses = scene.motions ? new MotionPoses(poses, scene.motions) : poses;
    this.clear = -1; // the body that one sees through,
    this.clearsPart = false; // or through the part of it that is shown
    this.glass = new Glass(world, CLEAR);
    this.moving = []; // bodies that move, with where they are
    this.moved = null; // the one that the reader moves: its number, place and turning
    const counts = scene.models.map(() => 0);
    scene.bodies.model.forEach((model, body) => {
      if (scene.bodies.moves[body]) {
        ++counts[model];
        this.moving.push({
          body, model, matrix: new THREE.Matrix4(), place: new THREE.Vector3(), color: new THREE.Color(),
        });
      } else {
        const mesh = new THREE.Mesh(this.geometries[model], solid());
        this.poses.still(body, mesh.position, mesh.quaternion);
        mesh.userData = { model, body };
        mesh.castShadow = mesh.receiveShadow = true;
        this.stillMeshes.push(mesh);
        world.add(mesh);
      }
    });
    const instances = (geometry, count) => {
      const mesh = new THREE.InstancedMesh(geometry, this.movingMaterial, count);
      mesh.frustumCulled = false;
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.userData.bodies = [];
      mesh.setColorAt(0, new THREE.Color());
      world.add(mesh);
      return mesh;
    };
    this.near = counts.map((count, model) => (count > 0 ? instances(this.geometries[model], count) : null));
    this.far = counts.map((count, model) => (count > 0 ? instances(boxOf(this.geometries[model]), count) : null));
  }

  // The whole of a model that was coarse so far.
  setModel(k, mesh) {
    this.whole.set(k, creased(mesh));
    this.scene.models[k].mesh = mesh;
    if (this.part) {
      this.showSome(...this.part.shown); // by finer triangles
    }
    if (this.near[k]) {
      this.near[k].geometry = this.whole.get(k);
    }
    this.setClear(this.clear, this.clearsPart);
  }

  // A part of a body that stands still, upon the body; or none.
  showPart(body, part) {
    this.showSome(body, part === undefined ? undefined : ({ indices, parts }) => (
      parts ? indices.filter((_, corner) => parts[(corner - corner % 3) / 3] === part + 1) : []));
  }

  // Triangles of a body that stands still: `some(mesh)` has their corners.
  showSome(body, some) {
    this.part ??= this.addPart();
    this.part.mesh.visible = this.part.isThere = false;
    this.part.shown = [body, some];
    if (some === undefined || this.scene.bodies.moves[body]) {
      return;
    }
    const { mesh } = this.scene.models[this.scene.bodies.model[body]];
    const { positions } = mesh;
    const own = some(mesh);
    this.part.indices = own;
    if (own.length > 0) {
      this.part.mesh.geometry.dispose();
      this.part.mesh.geometry = creased({ positions, indices: own });
      this.poses.still(body, this.part.mesh.position, this.part.mesh.quaternion);
      this.part.mesh.visible = this.part.isThere = true;
    }
  }

  addPart() {
    const mesh = new THREE.Mesh(new THREE.BufferGeometry(), solid({ polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2 }));
    mesh.receiveShadow = true; // the body casts it
    this.world.add(mesh);
    return { mesh };
  }

  // Models with a stand-in are drawn by it, or whole. True if that changes the picture.
  setCoarse(coarse) {
    let changed = false;
    for (const mesh of this.stillMeshes) {
      const { model } = mesh.userData;
      const wanted = mesh.userData.cut ?? (coarse ? undefined : this.whole.get(model)) ?? this.geometries[model];
      changed ||= mesh.geometry !== wanted;
      mesh.geometry = wanted;
    }
    return changed;
  }

  // Bodies go to their places at a step; `exact` has poses of some of them. `colorOf` is of a body.
  place(step, exact, colorOf) {
    const turn = new THREE.Quaternion();
    const size = new THREE.Vector3(1, 1, 1);
    for (const mover of this.moving) {
      const side = exact ? exact.bodies.indexOf(mover.body) : -1;
      if (this.moved?.body === mover.body) {
        mover.place.fromArray(this.moved.place);
        turn.fromArray(this.moved.turn);
      } else if (side >= 0) {
        mover.place.fromArray(exact.poses[side], 0);
        turn.fromArray(exact.poses[side], 3);
      } else {
        this.poses.at(mover.body, step, mover.place, turn);
      }
      mover.matrix.compose(mover.place, turn, size);
      mover.color.copy(colorOf(mover.body));
    }
    this.stillMeshes.forEach(({ material, userData }) => material.color.copy(colorOf(userData.body)));
    this.part?.mesh.material.color.copy(this.partColor);
    if (this.clear >= 0) {
      this.glass.ink.color.copy(this.clearsPart ? this.partColor : colorOf(this.clear));
      this.placeClear();
    }
  }

  // One sees through a body, or the part of it that is shown; with -1 through none.
  setClear(body, ofPart = false) {
    this.clear = body;
    this.clearsPart = ofPart;
    for (const mesh of this.stillMeshes) {
      const isClear = mesh.userData.body === body;
      mesh.visible = !isClear || ofPart;
      mesh.userData.cut?.dispose();
      mesh.userData.cut = isClear && ofPart ? creased(without(this.scene.models[mesh.userData.model].mesh, this.part.indices)) : undefined;
    }
    this.glass.show(body >= 0);
    this.placeClear();
    if (this.part) {
      this.part.mesh.visible = this.part.isThere && !ofPart;
    }
  }

  placeClear() {
    const [found] = this.clear < 0 ? [] : this.shownOf([this.clear]);
    if (found) {
      this.glass.geometry = found.geometry;
      this.glass.place(found.matrix);
    }
  }

  // Bodies as `placed` has them, or the part that is shown of one.
  shownOf(bodies) {
    const placed = this.placed(bodies);
    const shown = bodies.flatMap((body) => placed.find((one) => one.body === body) ?? []);
    const isPart = ({ body }) => this.part?.isThere && this.part.shown[0] === body && (this.clear !== body || this.clearsPart);
    return shown.map((one) => (isPart(one) ? { ...one, geometry: this.part.mesh.geometry, isPart: true } : one));
  }

  // Chooses who is drawn whole, as the camera sees them: lengths at distance 1 are so many pixels high.
  sort(camera, pixels) {
    for (const list of [this.near, this.far]) {
      list.forEach((mesh) => { if (mesh) { mesh.count = 0; } });
    }
    for (const { body, model, place, matrix, color } of this.moving.filter((mover) => mover.body !== this.clear)) {
      const size = 2 * this.geometries[model].boundingSphere.radius;
      const large = size * pixels > SMALL * camera.position.distanceTo(place);
      const mesh = (large ? this.near : this.far)[model];
      mesh.userData.bodies[mesh.count] = body;
      mesh.setMatrixAt(mesh.count, matrix);
      mesh.setColorAt(mesh.count++, color);
    }
    for (const mesh of [...this.near, ...this.far]) {
      if (mesh) {
        mesh.visible = mesh.count > 0;
        mesh.instanceMatrix.needsUpdate = mesh.instanceColor.needsUpdate = true;
      }
    }
  }

  // Where the report has a body that moves, as the page draws it.
  recorded(body, step) {
    const [place, turn] = [new THREE.Vector3(), new THREE.Quaternion()];
    this.poses.at(body, step, place, turn);
    return { place: place.toArray(), turn: turn.toArray() };
  }

  // All that stands still, and some that move, each with its geometry and where it is.
  placed(bodies) {
    const movers = this.moving.filter(({ body }) => bodies.includes(body))
      .map(({ body, model, matrix }) => ({ body, geometry: this.whole.get(model) ?? this.geometries[model], matrix }));
    this.stillMeshes.forEach((mesh) => mesh.updateMatrix());
    return [...movers, ...this.stillMeshes.map(({ userData: { model, body }, matrix }) => ({ body, geometry: this.whole.get(model) ?? this.geometries[model], matrix }))];
  }

  // Where a body is drawn: the middle of its model.
  placeOf(body) {
    return (this.moving.find((mover) => mover.body === body)?.place
      ?? this.stillMeshes[this.poses.rank[body]].position).clone();
  }

  sizeOf(body) {
    return 2 * this.geometries[this.scene.bodies.model[body]].boundingSphere.radius;
  }

  // The body that moves and is seen first along a ray, and where it is met; null if none is, or another is before it.
  moverAt(raycaster) {
    const movers = [...this.near, ...this.far].filter((mesh) => mesh?.count > 0);
    movers.forEach((mesh) => { mesh.boundingSphere = null; }); // instances have moved since it was found
    const clear = this.scene.bodies.moves[this.clear] ? [this.glass.meshes[0]] : [];
    const [first] = raycaster.intersectObjects([...movers, ...clear, ...this.stillMeshes.filter(({ visible }) => visible)], false);
    if (first?.object === clear[0] && first) {
      return { body: this.clear, point: first.point };
    }
    return first?.instanceId === undefined ? null : { body: first.object.userData.bodies[first.instanceId], point: first.point };
  }
}
