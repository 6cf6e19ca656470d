// How many clashes each pair of models, or of sets, has: a table whose numbers filter the list.
import { baseName, pairCounts } from './clash_rows.js';
import { byId, said } from './page.js';
import { number } from './words.js';

const MOST = 24; // rows and columns; pairs of others are counted beside the table

function tableOf(all, key, title, onPair) {
  const counts = pairCounts(all, key);
  const titleOf = (name) => (key === 'file' ? baseName(name) : name) || 'none';
  const axis = (side) => [...new Set(counts.map(({ names }) => names[side]))].slice(0, MOST);
  const [down, across] = [axis(0), axis(1)];
  const table = document.createElement('table');
  const head = table.createTHead().insertRow();
  head.append(said('th', ''), ...across.map((name) => {
    const cell = said('th', titleOf(name), 'number');
    cell.title = name;
    cell.scope = 'col';
    return cell;
  }));
  const body = table.createTBody();
  let shown = 0;
  for (const a of down) {
    const row = body.insertRow();
    const name = said('th', titleOf(a));
    name.title = a;
    name.scope = 'row';
    row.append(name);
    for (const b of across) {
      const found = counts.find(({ names }) => names[0] === a && names[1] === b);
      const cell = said('td', '', 'number');
      if (found) {
        const button = said('button', number(found.count));
        button.type = 'button';
        button.setAttribute('aria-label', `${number(found.count)} clashes of ${titleOf(a)} with ${titleOf(b)}: show them alone`);
        button.addEventListener('click', () => onPair({ key, names: [a, b], titles: [titleOf(a), titleOf(b)] }));
        cell.append(button);
        shown += found.count;
      }
      row.append(cell);
    }
  }
  const frame = said('div', '', 'picture');
  frame.tabIndex = 0;
  frame.append(table);
  const left = all.rows.length - shown;
  const lead = said('p', `${title}: clashes of what is named at the left with what is named above. A number shows them alone.`);
  return left > 0 ? [lead, frame, said('p', `${number(left)} clashes are of other pairs; the list has them.`, 'note')] : [lead, frame];
}

export function addMatrices(all, onPair) {
  if (all.rows.length === 0) {
    return;
  }
  byId('matrix-view').hidden = false;
  const tables = tableOf(all, 'file', 'By model', onPair);
  if (all.sides.some(({ set }) => set !== undefined && set !== null)) {
    tables.push(...tableOf(all, 'set', 'By set', onPair));
  }
  byId('matrices').replaceChildren(...tables);
}
