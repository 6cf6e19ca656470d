// What pages with a scene share, whatever they list.
import * as THREE from 'three';
import { loadModel } from './data.js';
import { byId } from './page.js';

// A press that does not turn the view chooses the contact or the gap below it.
export function addPicking(view, choose, chooseGap) {
  const canvas = byId('canvas');
  let down = null;
  canvas.addEventListener('pointerdown', (event) => { down = event; });
  canvas.addEventListener('pointerup', (event) => {
    if (down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < 5) {
      const frame = canvas.getBoundingClientRect();
      const [x, y] = [event.clientX - frame.left, event.clientY - frame.top];
      const spot = view.spotAt(x, y);
      const gap = spot ? -1 : view.gapAt(x, y);
      if (spot) {
        choose(spot.row, spot.contact);
      } else if (gap >= 0) {
        chooseGap(gap);
      }
    }
    down = null;
  });
}

// Shows what a page opens on: what its address names (`linked`), else the worst row of its list; where nothing
// touches, the way if there is one, or the nearest gap.
export function openPage({ scene, rows, gaps }, list, linked, showRow, showGap) {
  if (linked) {
    linked();
  } else if (list.entries.order.length > 0) {
    showRow(list.entries.order[0]);
  } else if (rows.count === 0 && gaps.count > 0) {
    showGap(scene.steps.noun === 'station');
  }
}

// The sphere around a mover at all steps that the page holds: where its way is seen from.
export function wayOf({ scene, gaps }, { poses }) {
  const [place, turn, mover] = [new THREE.Vector3(), new THREE.Quaternion(), gaps.a(0)];
  const places = scene.steps.kept.map((step) => {
    poses.at(mover, step, place, turn);
    return place.clone();
  });
  return new THREE.Box3().setFromPoints(places).getBoundingSphere(new THREE.Sphere());
}

// Links of a table lead to its gaps or motions, however often they are followed.
export function addLinks(what, choose) {
  for (const link of document.querySelectorAll(`a[href^="#${what}="]`)) {
    link.addEventListener('click', (event) => {
      event.preventDefault();
      byId('first').scrollIntoView();
      choose(Number(link.hash.slice(what.length + 2)));
    });
  }
}

// Whole models take the place of coarse ones, one after the other, when nothing else is to be done.
export function loadRest(all, view) {
  const idle = (act) => (window.requestIdleCallback ?? setTimeout)(act, { timeout: 1000 });
  const waiting = [...all.scene.models.keys()].filter((k) => all.scene.models[k].coarse > 0);
  const next = () => {
    if (waiting.length > 0 && view) {
      const k = waiting.shift();
      view.setModel(k, loadModel(all, k));
      idle(next);
    } else {
      window.soms.isWhole = true;
    }
  };
  const begin = () => idle(next);
  const parsed = () => (document.readyState === 'loading' ? document.addEventListener('DOMContentLoaded', begin) : begin());
  if (view) {
    view.onFirst = parsed;
  } else {
    setTimeout(parsed);
  }
}
