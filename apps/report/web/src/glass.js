// What one sees through: of a body or part only the nearest surface is drawn, its depth first, then its color.
import * as THREE from 'three';
import { solid } from './look.js';

export const GLASS = 0.28; // opacity

export const depthOnly = (more) => new THREE.MeshBasicMaterial({ colorWrite: false, side: THREE.DoubleSide, transparent: true, ...more });

export class Glass {
  // `order` is that of the depth; the color follows. Both materials have `more`.
  constructor(parent, order, more = {}, geometry = new THREE.BufferGeometry()) {
    this.ink = solid({ transparent: true, opacity: GLASS, ...more });
    this.meshes = [depthOnly(more), this.ink].map((material, above) => {
      const mesh = new THREE.Mesh(geometry, material);
      mesh.renderOrder = order + above;
      mesh.visible = mesh.frustumCulled = false;
      parent.add(mesh);
      return mesh;
    });
  }

  set geometry(geometry) { this.meshes.forEach((mesh) => { mesh.geometry = geometry; }); }

  show(visible) { this.meshes.forEach((mesh) => { mesh.visible = visible; }); }

  place(matrix) {
    for (const mesh of this.meshes) {
      mesh.matrixAutoUpdate = false;
      mesh.matrix.copy(matrix);
      mesh.matrixWorldNeedsUpdate = true;
    }
  }
}
