// The parts of a clash page: the two that are chosen in color, the others pale and cut away before the clash.
import * as THREE from 'three';
import { creased } from './creases.js';
import { trianglesOf } from './curves.js';
import { depthOnly, Glass, GLASS } from './glass.js';
import { solid } from './look.js';
import { Spots } from './spots.js';
import { View } from './view.js';

const DISTANCE = 2.62; // of the eye, in reaches: all within the reach is seen at 45 degrees
const CUT = 0.1; // reaches from the middle of the clash toward the eye
const GLASS_OF_ALL = 0.3; // of the set that one sees through where no row is chosen
const HIDDEN = 0.45; // of parts that others hide all the same
const NO_LINES = new Float32Array(0);

// Parts as one mesh, each at its place.
function joinedGeometry(parts) {
  const counts = parts.reduce(([vertices, corners], { mesh }) => [vertices + mesh.positions.length / 3, corners + mesh.indices.length], [0, 0]);
  const positions = new Float32Array(3 * counts[0]);
  const indices = new Uint32Array(counts[1]);
  let [vertex, corner] = [0, 0];
  for (const { mesh, place } of parts) {
    for (let k = 0; k < mesh.positions.length; ++k) {
      positions[3 * vertex + k] = mesh.positions[k] + place[k % 3];
    }
    for (let k = 0; k < mesh.indices.length; ++k) {
      indices[corner + k] = mesh.indices[k] + vertex;
    }
    vertex += mesh.positions.length / 3;
    corner += mesh.indices.length;
  }
  return creased({ positions, indices });
}

export class ClashView extends View {
  constructor(canvas, all) {
    super(canvas, all, [0.35, 0.75, 0.6], [-0.5, 0.45, 0.85]);
    this.row = -1;
    this.isCut = true;
    this.renderer.localClippingEnabled = true;
    this.addParts();
    this.addSpotsOfRows();
    this.spotCounts = new Spots(this, () => (this.row < 0 ? this.spotsAt : []), () => true);
    this.show(-1);
    this.begin();
  }

  // The parts of the first set, of the second, and those of no row.
  partsBySet() {
    const { parts, rows, scene } = this.all;
    const setOf = new Map();
    for (const side of ['b', 'a']) {
      rows.forEach((row) => setOf.set(scene.of_sides[row[side]], side === 'a' ? 0 : 1));
    }
    const sets = [[], [], []];
    parts.forEach((part, k) => sets[setOf.get(k) ?? 2].push(part));
    return sets;
  }

  addSpotsOfRows() {
    const { rows, sights } = this.all;
    this.spotsAt = rows.flatMap((_, row) => (sights.reach(row) > 0 ? [{ row, contact: -1, place: sights.place(row) }] : []));
    const places = trianglesOf(Float32Array.from(this.spotsAt.flatMap(({ place }) => [...place])));
    this.allSpots = ['halo', 'touch'].map((use, above) => ({ use, points: this.addSpots(this.world, places, 12 - 4 * above, 9 + above) }));
  }

  spotAt(x, y) { return this.row < 0 ? this.spotCounts.at(this.spotsAt, x, y) : undefined; }

  gapAt() { return -1; }

  addParts() {
    this.plane = new THREE.Plane();
    const sets = this.partsBySet();
    this.sets = sets.map((parts) => {
      const made = new THREE.Mesh(joinedGeometry(parts), solid());
      made.frustumCulled = false;
      made.castShadow = made.receiveShadow = true;
      this.world.add(made);
      return made;
    });
    // Of the set with the larger parts, only the nearest surface is drawn where one sees through it.
    const size = (parts) => parts.reduce((sum, { mesh }) => mesh.positions.reduce((most, at) => Math.max(most, at), 0) + sum, 0) / Math.max(1, parts.length);
    this.clear = this.sets[size(sets[0]) > size(sets[1]) ? 0 : 1];
    this.clearDepth = new THREE.Mesh(this.clear.geometry, depthOnly());
    this.clearDepth.frustumCulled = false;
    this.clearDepth.renderOrder = 3;
    this.clear.renderOrder = 4;
    this.world.add(this.clearDepth);
    const mesh = (material, order) => {
      const made = new THREE.Mesh(new THREE.BufferGeometry(), material);
      made.frustumCulled = false;
      made.visible = false;
      made.renderOrder = order;
      this.world.add(made);
      return made;
    };
    // In front of the pale part that they are themselves.
    const before = { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2 };
    this.small = mesh(solid({ transparent: true, ...before }), 2); // after what shines through, which it hides
    this.glass = new Glass(this.world, 3, before);
    // Where other parts are before the two, these shine through.
    const behind = { transparent: true, depthFunc: THREE.GreaterDepth, depthWrite: false };
    this.smallBehind = mesh(solid({ ...behind, opacity: HIDDEN }), 1);
    this.glassBehind = mesh(solid({ ...behind, opacity: HIDDEN * GLASS }), 1);
    this.curve = this.addCurve(this.world, 3.5, 6, true);
    this.mark = this.addSpots(this.world, new THREE.BufferGeometry(), 12, 9);
    this.mark.visible = false;
  }

  paint(paper = false) {
    super.paint(paper);
    this.allSpots.forEach(({ use, points }) => points.material.color.copy(this.colors[use]));
    this.mark.material.color.copy(this.colors.touch);
    this.paintParts();
  }

  paintParts() {
    const isWhole = this.row < 0;
    ['moves', 'still', 'rest'].forEach((use, set) => this.sets[set].material.color.copy(this.colors[isWhole ? use : 'rest']));
    Object.assign(this.clear.material, {
      transparent: isWhole, opacity: isWhole ? GLASS_OF_ALL : 1, depthFunc: isWhole ? THREE.LessEqualDepth : THREE.LessDepth, needsUpdate: true,
    });
    this.clearDepth.visible = isWhole;
    this.stage.shade = isWhole ? 1 : 0;
    this.allSpots.forEach(({ points }) => { points.visible = isWhole && this.spotsAt.length > 0; });
    const [a, b] = [this.colors.moves, this.colors.still];
    const aIsGlass = this.row >= 0 && this.all.sights.aIsLarger(this.row);
    [this.glass.ink, this.glassBehind.material].forEach(({ color }) => color.copy(aIsGlass ? a : b));
    [this.small, this.smallBehind].forEach(({ material }) => material.color.copy(aIsGlass ? b : a));
  }

  // Shows a row, or with -1 none.
  show(r) {
    this.row = r;
    const { rows, parts, scene, sights, curves } = this.all;
    const [a, b] = r < 0 ? [] : [rows[r].a, rows[r].b].map((side) => parts[scene.of_sides[side]]);
    const [large, little] = r >= 0 && sights.aIsLarger(r) ? [a, b] : [b, a];
    for (const [meshes, part] of [[[this.small, this.smallBehind], little], [[...this.glass.meshes, this.glassBehind], large]]) {
      meshes[0].geometry.dispose();
      const geometry = part === undefined ? new THREE.BufferGeometry() : joinedGeometry([part]);
      for (const mesh of meshes) {
        mesh.visible = part !== undefined;
        mesh.geometry = geometry;
      }
    }
    this.curve.show(r < 0 ? NO_LINES : curves.get(r) ?? NO_LINES, scene.size);
    this.mark.visible = r >= 0 && sights.reach(r) > 0;
    if (this.mark.visible) {
      this.mark.geometry.dispose();
      this.mark.geometry = trianglesOf(sights.place(r).slice());
    }
    if (this.colors) {
      this.paintParts();
    }
    this.stage.changed();
  }

  // All parts in the colors of their sets, and a mark for each row.
  whole(soft = true) {
    this.show(-1);
    super.whole(soft);
  }

  // Where the eye stands to see a row; null where it has no place.
  sightOf(r) {
    const { sights } = this.all;
    if (!(sights.reach(r) > 0)) {
      return null;
    }
    const focus = new THREE.Vector3().fromArray(sights.focus(r));
    const toward = new THREE.Vector3().fromArray(sights.toward(r));
    return { focus, eye: focus.clone().addScaledVector(toward, DISTANCE * this.narrow() * sights.reach(r)) };
  }

  choose(r, soft = true) {
    this.show(r);
    const sight = this.sightOf(r);
    if (sight) {
      this.fly(sight.focus, sight.eye, soft);
    } else {
      this.draw();
    }
  }

  setCut(cut) {
    this.isCut = cut;
    this.draw();
  }

  // What is nearer to the eye than the clash is cut away, from wherever it is looked at.
  prepare() {
    const cuts = this.isCut && this.row >= 0 && this.all.sights.reach(this.row) > 0;
    this.sets.forEach(({ material }) => { material.clippingPlanes = cuts ? [this.plane] : []; });
    if (cuts) {
      const { sights } = this.all;
      const away = this.camera.getWorldDirection(new THREE.Vector3());
      const at = new THREE.Vector3().fromArray(sights.focus(this.row)).addScaledVector(away, -CUT * sights.reach(this.row));
      this.plane.setFromNormalAndCoplanarPoint(away, at);
    }
  }

  showAtOnce(r) { this.choose(r, false); }

  kept() { return { ...super.kept(), row: this.row }; }

  restore(kept) {
    this.show(kept.row);
    super.restore(kept);
  }
}
