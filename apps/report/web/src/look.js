// Colors, by the reader's scheme. Those that carry meaning are told apart by the color-blind
// (Okabe and Ito 2008, Color Universal Design).
import * as THREE from 'three';

const LIGHT = { paper: '#eef1f4', still: '#c3beb2', moves: '#0072b2', touch: '#d55e00', was: '#e6a36f', chosen: '#d9dee3', line: '#000000', frame: '#000000', sky: 2.1, sun: 1.9 };
const DARK = { paper: '#101316', still: '#7b8087', moves: '#56b4e9', touch: '#ff7a1a', was: '#a8683a', chosen: '#b9bfc6', line: '#000000', frame: '#ffffff', sky: 1.6, sun: 1.5 };

const scheme = matchMedia('(prefers-color-scheme: dark)');

export function colors() {
  const chosen = scheme.matches ? DARK : LIGHT;
  return Object.fromEntries(Object.entries(chosen).map(
    ([name, value]) => [name, typeof value === 'string' ? new THREE.Color(value) : value]));
}

export function whenSchemeChanges(act) {
  scheme.addEventListener('change', act);
}

export const calm = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
