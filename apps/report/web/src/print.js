// On paper: a picture of each of the first rows of the list, taken when the page is about to be printed.
import { printedRow, said } from './page.js';
import { counted, rowMost, rowPlace, rowTitle, rowWhen } from './words.js';

const MOST = 20;

export function printedRows(all, view, order) {
  const rows = order.slice(0, MOST);
  const title = rows.length < order.length ? `The first ${rows.length} of ${order.length.toLocaleString('en')}` : 'Who touches whom';
  return [...(rows.length > 0 ? [said('h2', title)] : []), ...rows.map((r, k) => printedRow(
    view, r, said('b', `${k + 1}. ${rowTitle(all, r)}`), document.createElement('br'),
    [rowWhen(all, r), counted(all, all.rows.total(r)), rowMost(all, r), rowPlace(all, r)].filter(Boolean).join('; ')))];
}
