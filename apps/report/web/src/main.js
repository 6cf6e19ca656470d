// Brings the page to life: the view, the list of contacts, and time; or the list of a clash page, or motions.
import { isClashPage } from './clash_data.js';
import { startClashes } from './clash_main.js';
import { load } from './data.js';
import { List } from './list.js';
import { Live } from './live.js';
import { isMotionPage, startMotions } from './motion_main.js';
import { addPrinting, addSteps, byId, makeView, nameCells, said, svg, trouble } from './page.js';
import { printedRows } from './print.js';
import { addLinks, addPicking, loadRest, openPage, wayOf } from './scene_page.js';
import { SceneView } from './scene_view.js';
import { overSteps, Time } from './time.js';
import {
  bodyName, counted, gapWords, missing, moment, notDrawn, place, rowMost, rowPlace, rowTitle, rowWhen, title, triangles, whatIsDrawn, when,
} from './words.js';

const AROUND_WAY = 0.8; // of what is seen around a way, in its radii

function addTimeLine(all, choose) {
  for (const bar of document.querySelectorAll('#time-line [data-contact]')) {
    const k = Number(bar.dataset.contact);
    if (k < all.contacts.count) {
      svg('title', bar).textContent = `${title(all, k)}: ${when(all, k)}`;
      bar.style.cursor = 'pointer';
      bar.addEventListener('click', () => {
        byId('first').scrollIntoView();
        choose(all.contacts.row(k), k);
      });
    }
  }
}

// What is said of the row or contact that is chosen.
function wordsOf(all, r, k) {
  return (k >= 0 ? [title(all, k), when(all, k), triangles(all, k), place(all, k)]
    : [rowTitle(all, r), rowWhen(all, r), counted(all, all.rows.total(r)), rowMost(all, r), rowPlace(all, r), missing(all, r)])
    .filter(Boolean).join('; ');
}

// Shows what an address names: "#row=3", "#contact=12" or "#gap=4"; nothing if it names none.
function linked(all, choose, chooseGap) {
  const [, what, digits] = /^#(row|contact|gap)=(\d+)$/.exec(location.hash) ?? [];
  const named = Number(digits);
  if (what === 'gap' && named < all.gaps.count) {
    return () => chooseGap(named);
  }
  if (what === 'contact' && named < all.contacts.count) {
    return () => choose(all.contacts.row(named), named);
  }
  return what === 'row' && named < all.rows.count ? () => choose(named, -1) : null;
}

// The buttons that go through the contacts of the chosen row, and which of them is shown.
function showContacts({ rows }, r, k) {
  const contacts = r < 0 ? [] : [...rows.contacts(r)];
  byId('within').hidden = contacts.length < 2;
  const at = contacts.indexOf(k);
  byId('which').textContent = at < 0 ? `${contacts.length.toLocaleString('en')} contacts` : `${at + 1} of ${contacts.length.toLocaleString('en')}`;
}

// Of two bodies at one pose: which is which, and what the lines are.
function nameColors({ scene, contacts, gaps }) {
  byId('near').hidden = gaps.count === 0;
  byId('near-time').hidden = !scene.steps.smooth || scene.steps.count < 2;
  if (scene.steps.count < 2 && scene.bodies.names.length === 2) {
    byId('legend').replaceChildren(...[['moves', bodyName(scene, 0)], ['still', bodyName(scene, 1)],
      ...(contacts.count > 0 ? [['touch', 'where they cross']] : [])].flatMap(
      ([key, words]) => [said('span', '', `key ${key}`), words]), byId('near'));
  }
}

function start() {
  const all = load();
  byId('look').hidden = false;
  byId('drawn').textContent = whatIsDrawn(all);
  byId('missing').textContent = notDrawn(all);
  nameColors(all);
  byId('missing').hidden = notDrawn(all) === '';
  const view = makeView(SceneView, all, 'tools');
  document.querySelectorAll('.around').forEach((key) => { key.hidden = !view || view.named.size === 0; });
  const time = new Time(overSteps(all.scene.steps), (step) => {
    view?.setStep(step);
    list.setStep(step);
    live?.setStep();
    byId('moment').textContent = moment(all, step);
  });
  // A page that opens flies nowhere, and its address stays.
  const choose = (r, k, opens = false) => {
    const begin = k >= 0 ? all.contacts.begin(k) + all.rows.after(r) : all.rows.moment(r);
    time.stop();
    time.show(begin);
    list.setStep(begin);
    list.mark(r, k);
    if (opens) {
      view?.showAtOnce(r);
    } else {
      view?.choose(r, k);
      history.replaceState(null, '', k >= 0 ? `#contact=${k}` : `#row=${r}`);
    }
    live?.follow();
    byId('moment').textContent = moment(all, begin);
    byId('picked').textContent = wordsOf(all, r, k);
    showContacts(all, r, k);
  };
  const chooseGap = (g, opens = false, ofWay = false) => {
    const step = all.gaps.nearest(g);
    time.stop();
    time.show(step);
    list.setStep(step);
    list.mark(-1, -1);
    view?.chooseGap(g);
    if (view && ofWay) {
      const { center, radius } = wayOf(all, view.bodies);
      view.flyTo(center.toArray(), AROUND_WAY * radius, undefined, false);
    }
    live?.follow();
    byId('moment').textContent = moment(all, step);
    byId('picked').textContent = gapWords(all, g);
    showContacts(all, -1, -1);
    if (!opens) {
      history.replaceState(null, '', `#gap=${g}`);
    }
  };
  const list = new List(all, choose);
  const live = view && all.scene.live ? new Live(all, view) : null;
  addSteps(view, { neighbor: (by) => list.nextRow(by) }, {
    ' ': () => time.toggle(), '.': () => list.nextContact(1), ',': () => list.nextContact(-1),
  });
  byId('later').addEventListener('click', () => list.nextContact(1));
  byId('earlier').addEventListener('click', () => list.nextContact(-1));
  addTimeLine(all, choose);
  addLinks('gap', chooseGap);
  if (view) {
    byId('above').addEventListener('click', () => view.above());
    addPicking(view, choose, chooseGap);
  }
  addPrinting(() => printedRows(all, view, list.entries.order));
  time.go(0);
  openPage(all, list, linked(all, choose, chooseGap), (r) => choose(r, -1, true), (ofWay) => chooseGap(0, true, ofWay));
  loadRest(all, view);
  // For scripts that look at the page, our tests among them.
  window.soms = {
    view,
    rows: all.rows.count,
    contacts: all.contacts.count,
    total: (r) => all.rows.total(r),
    held: (r) => all.rows.contacts(r).length,
    title: (r) => rowTitle(all, r),
    bodies: (r) => [all.rows.a(r), all.rows.b(r)],
    shown: () => list.entries.order.length,
    camera: () => view?.camera.position.toArray(),
    target: () => view?.controls.target.toArray(),
    chosen: () => list.chosen.contact,
    chosenRow: () => list.chosen.row,
    gaps: all.gaps.count,
    chosenGap: () => view?.gapLines.chosen ?? -1,
    spots: () => view?.spotCounts.heaps ?? [],
    chosenTriangles: () => (view?.chosenParts[0].mesh.visible ? view.chosenParts[0].mesh.geometry.getAttribute('position').count : 0),
    step: () => time.step,
    flying: () => Boolean(view?.flight),
    focus: (k) => [...all.contacts.focus(k)],
    center: (r) => [...(view?.sightOf(r).place ?? all.rows.center(r))],
    most: (r) => all.rows.mostPairs(r),
    isWhole: false,
    firstPicture: () => view?.firstPicture, // triangles drawn, and milliseconds after the page was opened
    middle: (g) => all.gaps.middle(g),
    live: () => (live?.active ? { body: live.held, pose: live.pose, recorded: live.isRecorded(), answer: live.answer } : null),
    onCanvas: (body) => view?.onCanvas(view.bodies.placeOf(body)).slice(0, 2), // pixels from the upper left corner
    calls: () => view?.renderer.info.render.calls,
  };
}

const ofClashes = isClashPage();
try {
  nameCells();
  (ofClashes ? startClashes : isMotionPage() ? startMotions : start)();
} catch (error) {
  trouble(`The scene cannot be shown: ${error.message}`, ofClashes ? 'stage' : 'tools');
  console.error(error);
}
