// Brings a page about a list of parts to life: table, filters, details and view.
import { loadClashes } from './clash_data.js';
import { addMatrices } from './clash_matrix.js';
import { printedClashes } from './clash_print.js';
import { ClashRows, detailsOf, partsWords, rowTitleOf } from './clash_rows.js';
import { ClashTable } from './clash_table.js';
import { ClashView } from './clash_view.js';
import { addPrinting, addSteps, byId, makeView, said } from './page.js';

function showDetails(all, r) {
  byId('picked').textContent = `${r + 1}. ${rowTitleOf(all, r)}`;
  byId('details').replaceChildren(...detailsOf(all, r).flatMap(([name, value]) => [said('dt', name), said('dd', value)]));
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
  const view = makeView(ClashView, all, 'stage');
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
  addSteps(view, table);
  if (view) {
    byId('again').addEventListener('click', () => (table.chosen >= 0 ? view.choose(table.chosen) : table.neighbor(1)));
    byId('cut').addEventListener('change', () => view.setCut(byId('cut').checked));
  }
  addPrinting(() => printedClashes(all, view, table));
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
