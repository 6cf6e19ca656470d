// Brings a page about motions to life: the view, the slider over the way, and the list of motions.
import { load } from './data.js';
import { MotionList } from './motion_list.js';
import { MotionView } from './motion_view.js';
import { addPrinting, addSteps, byId, makeView, printedRow, said } from './page.js';
import { addLinks, addPicking, loadRest } from './scene_page.js';
import { Time } from './time.js';
import { trianglesDrawn } from './words.js';

const SPEED = 0.2; // of a way, a second
const SNAP = 6e-4; // of a way: the slider stops at a contact that is nearer
const MOST_PRINTED = 20;

export const isMotionPage = () => byId('way') !== null;

// What holds of a motion at a part of its way.
export function stateAt({ blocked, lower, upper }, part) {
  if (!blocked || part < lower) {
    return 'no contact';
  }
  if (part === upper) {
    return 'the first contact';
  }
  return upper !== null && part > upper ? 'after the first contact' : 'not known';
}

const partWords = (motion, part) => `t = ${Number(part.toPrecision(6))}: ${stateAt(motion, part)}`;

// The line below the slider: what is free, what is not known, and what comes after the contact.
function drawTrack({ blocked, lower, upper, moment }) {
  const [free, known] = blocked ? [lower, upper ?? 1] : [1, 1];
  [['before', free], ['open', known - free], ['after', 1 - known]].forEach(([id, share]) => {
    byId(id).style.width = `${100 * share}%`;
  });
  byId('meets').hidden = !blocked;
  byId('meets').style.left = `${100 * moment}%`;
}

function printedMotions({ scene }, view, order) {
  return order.slice(0, MOST_PRINTED).map((k) => {
    const { number, verdict, words } = scene.motions[k];
    return printedRow(view, k, said('b', `Motion ${number}: ${verdict}`), document.createElement('br'), words);
  });
}

// The motion that an address names, "#motion=3"; else the first of the list.
function linkedMotion(motions) {
  const [, digits] = /^#motion=(\d+)$/.exec(location.hash) ?? [];
  return Math.max(0, motions.findIndex(({ number }) => number === Number(digits)));
}

export function startMotions() {
  const all = load();
  const { motions } = all.scene;
  byId('look').hidden = false;
  byId('drawn').textContent = `${trianglesDrawn(all.scene)}.`;
  byId('missing').hidden = true;
  const view = makeView(MotionView, all, 'tools');
  let chosen = 0;
  const time = new Time({ slider: byId('part'), end: 1, speed: SPEED, mark: (part) => part }, (part) => {
    const motion = motions[chosen];
    const near = !time.playing && Math.abs(part - motion.moment) < SNAP ? motion.moment : part;
    view?.setPart(near);
    say(near);
  });
  const say = (part) => {
    time.step = part;
    byId('moment').textContent = partWords(motions[chosen], part);
    byId('part').setAttribute('aria-valuetext', byId('moment').textContent);
  };
  const choose = (k, fly = true) => {
    chosen = k;
    const motion = motions[k];
    time.stop();
    list.mark(k);
    drawTrack(motion);
    byId('contact').hidden = motion.row < 0;
    document.querySelector('.blocking').hidden = !motion.blocked;
    byId('picked').textContent = `${motions.length > 1 ? `Motion ${motion.number}: ` : ''}${motion.words}`;
    if (fly) {
      view?.choose(k);
    } else {
      view?.showAtOnce(k);
    }
    time.show(motion.moment);
    say(motion.moment);
    if (motions.length > 1 && fly) {
      history.replaceState(null, '', `#motion=${motion.number}`);
    }
  };
  const list = new MotionList(all, (k) => choose(k));
  const toContact = () => {
    if (motions[chosen].row >= 0) {
      time.stop();
      time.show(motions[chosen].moment);
      say(motions[chosen].moment);
      view?.seeContact();
    }
  };
  byId('contact').addEventListener('click', toContact);
  addSteps(view, list, { ' ': () => time.toggle(), c: toContact });
  addLinks('motion', (named) => choose(motions.findIndex(({ number }) => number === named)));
  if (view?.named.size > 0) {
    byId('legend').append(' ', said('span', '', 'key rest'), 'B, away from the contact.');
  }
  if (view) {
    byId('above').addEventListener('click', () => view.above());
    addPicking(view, (row) => choose(motions.findIndex((motion) => motion.row === row)), () => {});
  }
  addPrinting(() => printedMotions(all, view, list.order));
  choose(linkedMotion(motions), false);
  loadRest(all, view);
  // For scripts that look at the page, our tests among them.
  window.soms = {
    view,
    motions: motions.length,
    motion: (k) => motions[k],
    shown: () => list.order.length,
    chosen: () => chosen,
    part: () => time.step,
    place: () => view?.bodies.placeOf(0).toArray(), // of the middle of A, in the page's lengths
    partDrawn: () => view?.partDrawn(),
    camera: () => view?.camera.position.toArray(),
    target: () => view?.controls.target.toArray(),
    flying: () => Boolean(view?.flight),
    onCanvas: (k) => view?.onCanvas(motions[k].place).slice(0, 2), // a contact, in pixels from the upper left corner
    firstPicture: () => view?.firstPicture,
    isWhole: false,
  };
}
