// What bodies stand in: a ground, the light, their shadows, and air that takes what is far.
import * as THREE from 'three';
import { solid } from './look.js';

const WIDTH = 3; // of the ground's radius, in sizes of the scene
const SOLID = 0.3; // share of it that does not fade
const BELOW = 2e-4; // sizes of the scene: the ground covers no street
const MAP = 2048; // texels of the shadows' side
const AROUND = 1.7; // distances of the eye around what it looks at have shadows
const STALE = 0.3; // of that, or as much larger or smaller: they are drawn anew
const OFF = 2.5; // texels that a surface is held off its own shadow
const CLEAR = 1.6; // distances of the eye up to which the air is clear
const THICK = 16; // and where it hides all

// One look into the map, which gives a soft edge already: software is slow at more.
THREE.ShaderChunk.shadowmap_pars_fragment = THREE.ShaderChunk.shadowmap_pars_fragment.replace(
  /float phi = interleavedGradientNoise[^]*?\) \* 0\.2;/, 'shadow = texture( shadowMap, shadowCoord.xyz );');

// A disc that fades out.
function groundOf(radius) {
  const rings = [0, SOLID, 0.5, 0.75, 1];
  const sides = 64;
  const [places, inks, indices] = [[], [], []];
  rings.forEach((ring, r) => {
    for (let k = 0; k < sides; ++k) {
      const angle = 2 * Math.PI * k / sides;
      places.push(radius * ring * Math.cos(angle), radius * ring * Math.sin(angle), 0);
      inks.push(1, 1, 1, [1, 1, 0.55, 0.15, 0][r]);
      const [a, b] = [r * sides + k, r * sides + (k + 1) % sides];
      if (r + 1 < rings.length) {
        indices.push(a, a + sides, b + sides, a, b + sides, b);
      }
    }
  });
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(inks, 4));
  geometry.setIndex(indices);
  return geometry;
}

export class Stage {
  // `sun` is a direction toward it.
  constructor(world, renderer, { half, size }, up, sun) {
    this.renderer = renderer;
    this.size = size;
    this.toSun = sun.clone().normalize();
    this.sky = new THREE.HemisphereLight(0xffffff, 0xe2ded6, 1);
    this.sky.position.copy(up);
    this.sun = new THREE.DirectionalLight(0xfffaf0, 1);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(MAP, MAP);
    this.air = new THREE.Fog(0xffffff, 1, 2);
    world.fog = this.air;
    this.ground = new THREE.Mesh(groundOf(WIDTH * size), solid({
      side: THREE.FrontSide, flatShading: false, transparent: true, vertexColors: true, depthWrite: false,
    }, false));
    this.ground.geometry.setAttribute('normal', new THREE.BufferAttribute(
      new Float32Array(this.ground.geometry.getAttribute('position').count * 3).map((_, k) => (k % 3 === 2 ? 1 : 0)), 3));
    this.ground.quaternion.setFromUnitVectors(new THREE.Vector3(0, 0, 1), up);
    const rise = Math.abs(up.dot(new THREE.Vector3().fromArray(half)));
    this.ground.position.copy(up).multiplyScalar(-rise - BELOW * size);
    this.ground.receiveShadow = true;
    this.ground.renderOrder = -10; // below all that one sees through
    world.add(this.sky, this.sun, this.sun.target, this.ground);
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.autoUpdate = false;
    this.middle = new THREE.Vector3();
    this.reach = 0;
    this.hasShadows = false; // the first picture is quicker without
  }

  paint({ paper, ground, sky, sun }) {
    this.air.color.copy(paper);
    this.ground.material.color.copy(ground);
    this.sky.intensity = sky;
    this.sun.intensity = sun;
  }

  addShadows() {
    this.hasShadows = this.isStale = true;
  }

  // 0 where shadows would say nothing, as inside of what is cut open.
  set shade(share) { this.sun.shadow.intensity = share; }

  // Bodies have moved, or look otherwise.
  changed() { this.isStale = true; }

  // Before each picture: air and shadows are those of what the eye looks at.
  aim(target, distance) {
    this.air.near = CLEAR * distance;
    this.air.far = THICK * distance;
    const reach = Math.min(AROUND * distance, 0.8 * this.size);
    const middle = target.clone().clampLength(0, 0.5 * this.size);
    const isNear = middle.distanceTo(this.middle) < STALE * reach && Math.abs(Math.log(reach / this.reach)) < 2 * STALE;
    if (!isNear) {
      this.middle.copy(middle);
      this.reach = reach;
      this.turnSun();
    }
    if (this.hasShadows && (!isNear || this.isStale)) {
      this.renderer.shadowMap.needsUpdate = true;
      this.isStale = false;
    }
  }

  turnSun() {
    const { shadow, target, position } = this.sun;
    const away = this.size;
    target.position.copy(this.middle);
    position.copy(this.middle).addScaledVector(this.toSun, away);
    target.updateMatrixWorld();
    const { reach } = this;
    Object.assign(shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.01 * away, far: 2 * away });
    shadow.camera.updateProjectionMatrix();
    shadow.bias = -OFF * (2 * reach / MAP) / (1.99 * away);
  }
}
