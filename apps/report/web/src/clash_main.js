// Brings a page about a list of parts to life: table, filters, details and view.
import { loadClashes } from './clash_data.js';
import { addMatrices } from './clash_matrix.js';
import { addClashPrinting } from './clash_print.js';
import { ClashRows, detailsOf, partsWords, rowTitleOf } from './clash_rows.js';
import { ClashTable } from './clash_table.js';
import { ClashView } from './clash_view.js';

const byId = (id) => document.getElementById(id);

export function clashTrouble(words) {
  const place = byId('trouble');
  place.textContent = words;
  place.hidden = false;
}

function makeView(all) {
  // Asked of a canvas that is thrown away: one that failed once gives no other context.
  if (!document.createElement('canvas').getContext('webgl2')) {
    byId('stage').hidden = true;
    clashTrouble('This browser does not support WebGL, so the parts cannot be drawn. The list is whole all the same.');
    return null;
  }
  const canvas = byId('canvas');
  canvas.addEventListener('webglcontextlost', () => clashTrouble('The browser lost the graphics card. Reload the page to draw the parts again.'));
  return new ClashView(canvas, all);
}

function addKeys(view, table) {
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
    n: () => table.neighbor(1),
    p: () => table.neighbor(-1),
  };
  byId('canvas').addEventListener('keydown', (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key; // N is n with Caps Lock
    if (key in keys && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      keys[key](event.shiftKey);
    }
  });
}

function showDetails(all, r) {
  byId('picked').textContent = `${r + 1}. ${rowTitleOf(all, r)}`;
  byId('details').replaceChildren(...detailsOf(all, r).flatMap(([name, value]) => {
    const [title, text] = [document.createElement('dt'), document.createElement('dd')];
    title.textContent = name;
    text.textContent = value;
    return [title, text];
  }));
}

// The row that an address names: "#clash=KEY", which later lists have, too.
function linkedRow(all) {
  const [, key] = /^#clash=([0-9a-f]+)$/.exec(location.hash) ?? [];
  return key === undefined ? -1 : all.rows.findIndex((row) => row.key === key);
}

export function startClashes() {
  const all = loadClashes();
  byId('look').hidden = false;
  byId('drawn').textContent = partsWords(all);
  const view = makeView(all);
  const rows = new ClashRows(all);
  const choose = (r) => {
    table.mark(r);
    view?.choose(r);
    showDetails(all, r);
    history.replaceState(null, '', `#clash=${all.rows[r].key}`);
  };
  const table = new ClashTable(rows, choose);
  addMatrices(all, (pair) => {
    table.setPair(pair);
    byId('list-view').scrollIntoView();
  });
  byId('next').addEventListener('click', () => table.neighbor(1));
  byId('previous').addEventListener('click', () => table.neighbor(-1));
  if (view) {
    byId('whole').addEventListener('click', () => view.whole());
    byId('again').addEventListener('click', () => (table.chosen >= 0 ? view.choose(table.chosen) : table.neighbor(1)));
    byId('cut').addEventListener('change', () => view.setCut(byId('cut').checked));
    addKeys(view, table);
  }
  addClashPrinting(all, view, table);
  const first = linkedRow(all);
  if (first >= 0) {
    choose(first);
  }
  // For scripts that look at the page, our tests among them.
  window.soms = {
    rows: all.rows.length,
    row: (r) => ({ ...all.rows[r], a: all.sides[all.rows[r].a], b: all.sides[all.rows[r].b] }),
    shown: () => [...rows.order],
    chosenRow: () => table.chosen,
    flying: () => Boolean(view?.flight),
    target: () => view?.controls.target.toArray(),
    focus: (r) => [...all.sights.focus(r)],
    reach: (r) => all.sights.reach(r),
    lines: (r) => (all.curves.get(r)?.length ?? 0) / 6,
    parts: all.parts.length,
    isWhole: true,
  };
}
