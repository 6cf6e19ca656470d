// Colors and surfaces, by the reader's scheme. The page's style names colors; they come from apps/draw/look.h,
// as those of the window, pictures, maps and plots do.
import * as THREE from 'three';

const NAMES = {
  halo: 'paper', paper: 'sky-low', still: 'body-b', moves: 'body-a', touch: 'contact', was: 'contact-past', line: 'ink', frame: 'ink', rest: 'rest', ground: 'ground',
};
const LIGHT = { sky: 2.0, sun: 1.7 };
const DARK = { sky: 1.7, sun: 1.7 };
const CREASE = 1.1; // pixels of a sharp edge, on either side
const DARKER = 0.42; // on it

const scheme = matchMedia('(prefers-color-scheme: dark)');

// The first rule of the page's style has the colors of paper, the next ones of dark screens.
const onPaper = () => document.styleSheets[0].cssRules[0].style;

export function colors(paper = false) {
  const style = paper ? onPaper() : getComputedStyle(document.documentElement);
  const named = Object.entries(NAMES).map(
    ([use, name]) => [use, new THREE.Color(style.getPropertyValue(`--${name}`).trim())]);
  return { ...Object.fromEntries(named), ...(scheme.matches && !paper ? DARK : LIGHT) };
}

export function whenSchemeChanges(act) {
  scheme.addEventListener('change', act);
}

// Sharp edges are drawn with the surface; triangles of few pixels have none, so that what is far stays calm.
function drawCreases(shader) {
  shader.vertexShader = shader.vertexShader.replace('void main() {', 'attribute vec3 away;\nvarying vec3 vAway;\nvoid main() {\nvAway = away;');
  shader.fragmentShader = shader.fragmentShader.replace('void main() {', 'varying vec3 vAway;\nvoid main() {')
    .replace('#include <color_fragment>', `#include <color_fragment>
      vec3 slope = fwidth(vAway) + 1e-9;
      vec3 lines = (1.0 - smoothstep(0.3 * slope, ${CREASE.toFixed(2)} * slope, vAway)) * (1.0 - smoothstep(0.06, 0.25, slope));
      diffuseColor.rgb *= 1.0 - ${DARKER.toFixed(2)} * max(lines.x, max(lines.y, lines.z));`);
}

// What bodies and parts are made of; with creases, of geometry that has them (creases.js).
export function solid(more, creases = true) {
  const material = new THREE.MeshLambertMaterial({ flatShading: true, side: THREE.DoubleSide, ...more });
  if (creases) {
    material.onBeforeCompile = drawCreases;
  }
  return material;
}

export const calm = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
