// Brings a page about a list of parts to life: table, filters, details and view.
import { loadClashes } from './clash_data.js';
import { addMatrices } from './clash_matrix.js';
import { printedClashes } from './clash_print.js';
import { ClashRows, detailsOf, partsWords, rowSentence } from './clash_rows.js';
import { ClashTable } from './clash_table.js';
import { ClashView } from './clash_view.js';
import { addPrinting, addSteps, byId, makeView, said } from './page.js';
import { addPicking } from './scene_page.js';

function showDetails(all, r) {
  byId('picked').textContent = `${r + 1}. ${rowSentence(all, r)}`;
  byId('details').replaceChildren(...detailsOf(all, r).map(([name, value]) => {
    const pair = said('div', '');
    pair.append(said('dt', name), said('dd', value));
    return pair;
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
  const view = makeView(ClashView, all, 'stage');
  const rows = new ClashRows(all);
  // A page that opens flies nowhere, and its address stays.
  const choose = (r, opens = false) => {
    table.mark(r);
    view?.choose(r, !opens);
    showDetails(all, r);
    if (!opens) {
      history.replaceState(null, '', `#clash=${all.rows[r].key}`);
    }
  };
  const table = new ClashTable(rows, (r) => choose(r));
  addMatrices(all, (pair) => {
    table.setPair(pair);
    byId('first').scrollIntoView();
  });
  addSteps(view, table);
  if (view) {
    byId('again').addEventListener('click', () => (table.chosen >= 0 ? view.choose(table.chosen) : table.neighbor(1)));
    addPicking(view, (r) => choose(r), () => {});
    byId('cut').addEventListener('change', () => view.setCut(byId('cut').checked));
  }
  addPrinting(() => printedClashes(all, view, table));
  const named = linkedRow(all);
  if (named >= 0) {
    choose(named);
  } else if (rows.order.length > 0) {
    choose(rows.order[0], true);
  }
  // For scripts that look at the page, our tests among them.
  window.soms = {
    view,
    rows: all.rows.length,
    row: (r) => ({ ...all.rows[r], a: all.sides[all.rows[r].a], b: all.sides[all.rows[r].b] }),
    shown: () => [...rows.order],
    chosenRow: () => table.chosen,
    spots: () => view?.spotCounts.heaps ?? [],
    flying: () => Boolean(view?.flight),
    target: () => view?.controls.target.toArray(),
    focus: (r) => [...all.sights.focus(r)],
    reach: (r) => all.sights.reach(r),
    lines: (r) => (all.curves.get(r)?.length ?? 0) / 6,
    parts: all.parts.length,
    isWhole: true,
  };
}
