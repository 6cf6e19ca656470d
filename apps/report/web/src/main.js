// Brings the page to life: the view, the list of contacts, and time.
import { load } from './data.js';
import { List } from './list.js';
import { Time } from './time.js';
import { View } from './view.js';
import { moment, title, triangles, whatIsDrawn, when } from './words.js';

const byId = (id) => document.getElementById(id);

function trouble(words) {
  const place = byId('trouble');
  place.textContent = words;
  place.hidden = false;
  byId('tools').hidden = true;
}

function makeView(all) {
  // Asked of a canvas that is thrown away: one that failed once gives no other context.
  if (!document.createElement('canvas').getContext('webgl2')) {
    trouble('This browser shows no WebGL, so the scene cannot be drawn here. Contacts, figures and pictures are all on the page.');
    return null;
  }
  const canvas = byId('canvas');
  canvas.addEventListener('webglcontextlost', () => trouble('The graphics card was lost; reload the page to draw the scene again.'));
  return new View(canvas, all);
}

function addKeys(view, time, list) {
  const turn = 0.12;
  const keys = {
    ArrowLeft: (shift) => (shift ? view.shift(-0.1, 0) : view.turn(-turn, 0)),
    ArrowRight: (shift) => (shift ? view.shift(0.1, 0) : view.turn(turn, 0)),
    ArrowUp: (shift) => (shift ? view.shift(0, 0.1) : view.turn(0, -turn)),
    ArrowDown: (shift) => (shift ? view.shift(0, -0.1) : view.turn(0, turn)),
    '+': () => view.closer(0.85),
    '=': () => view.closer(0.85),
    '-': () => view.closer(1 / 0.85),
    Home: () => view.whole(),
    ' ': () => time.toggle(),
    n: () => list.neighbor(1),
    p: () => list.neighbor(-1),
  };
  byId('canvas').addEventListener('keydown', (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key; // N is n with Caps Lock
    if (key in keys && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      keys[key](event.shiftKey);
    }
  });
}

// A press that does not turn the view chooses the contact below it.
function addPicking(view, choose) {
  const canvas = byId('canvas');
  let down = null;
  canvas.addEventListener('pointerdown', (event) => { down = event; });
  canvas.addEventListener('pointerup', (event) => {
    if (down && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < 5) {
      const frame = canvas.getBoundingClientRect();
      const k = view.contactAt(event.clientX - frame.left, event.clientY - frame.top);
      if (k >= 0) {
        choose(k);
      }
    }
    down = null;
  });
}

function addTimeLine(all, choose) {
  for (const bar of document.querySelectorAll('#time-line [data-contact]')) {
    const k = Number(bar.dataset.contact);
    if (k < all.contacts.count) {
      const words = document.createElementNS('http://www.w3.org/2000/svg', 'title');
      words.textContent = `${title(all, k)}: ${when(all, k)}`;
      bar.append(words);
      bar.style.cursor = 'pointer';
      bar.addEventListener('click', () => {
        byId('view').scrollIntoView();
        choose(k);
      });
    }
  }
}

function start() {
  const all = load();
  byId('look').hidden = false;
  byId('drawn').textContent = whatIsDrawn(all);
  const view = makeView(all);
  const time = new Time(all, (step) => {
    view?.setStep(step);
    list.setStep(step);
    byId('moment').textContent = moment(all, step);
  });
  const choose = (k) => {
    time.stop();
    time.show(all.contacts.begin(k));
    list.setStep(all.contacts.begin(k));
    list.mark(k);
    view?.choose(k);
    byId('moment').textContent = moment(all, all.contacts.begin(k));
    byId('picked').textContent = [title(all, k), when(all, k), triangles(all, k)].filter(Boolean).join('; ');
    history.replaceState(null, '', `#contact=${k}`);
  };
  const list = new List(all, choose);
  byId('next').addEventListener('click', () => list.neighbor(1));
  byId('previous').addEventListener('click', () => list.neighbor(-1));
  addTimeLine(all, choose);
  if (view) {
    byId('whole').addEventListener('click', () => view.whole());
    byId('above').addEventListener('click', () => view.above());
    addKeys(view, time, list);
    addPicking(view, choose);
  }
  time.go(0);
  const linked = /^#contact=(\d+)$/.exec(location.hash);
  if (linked && Number(linked[1]) < all.contacts.count) {
    choose(Number(linked[1]));
  }
  // For scripts that look at the page, our tests among them.
  window.soms = {
    contacts: all.contacts.count,
    camera: () => view?.camera.position.toArray(),
    target: () => view?.controls.target.toArray(),
    chosen: () => list.chosen,
    step: () => time.step,
    flying: () => Boolean(view?.flight),
    focus: (k) => [...all.contacts.focus(k)],
    calls: () => view?.renderer.info.render.calls,
  };
}

try {
  start();
} catch (error) {
  byId('look').hidden = false;
  trouble(`The scene cannot be shown: ${error.message}`);
  console.error(error);
}
