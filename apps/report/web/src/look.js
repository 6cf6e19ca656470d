// Colors and surfaces, by the reader's scheme. The page's style names colors; they come from apps/draw/look.h,
// as those of the window, pictures, maps and plots do.
import * as THREE from 'three';

const NAMES = { halo: 'paper', paper: 'sky-low', still: 'body-b', moves: 'body-a', touch: 'contact', was: 'contact-past', line: 'ink', frame: 'ink', rest: 'ground' };
const LIGHT = { sky: 2.1, sun: 1.9 };
const DARK = { sky: 1.6, sun: 1.5 };

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

// What bodies and parts are made of.
export const solid = (more) => new THREE.MeshLambertMaterial({ flatShading: true, side: THREE.DoubleSide, ...more });

export const calm = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
