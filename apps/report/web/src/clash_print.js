// On paper: the list as it is searched and sorted, and pictures of the clash that is chosen and of the first ones.
import { countWords, rowTitleOf } from './clash_rows.js';
import { printedRow, said } from './page.js';
import { number } from './words.js';

const MOST_ROWS = 5000;
const MOST_PICTURES = 6;

function printedTable(rows, order) {
  const table = document.createElement('table');
  table.id = 'printed';
  table.createTHead().insertRow().append(...rows.columns.map(({ title }) => said('th', title)));
  const body = table.createTBody();
  for (const r of order) {
    body.insertRow().append(...rows.columns.map(
      ({ text, isNumber }) => said('td', text(rows.all.rows[r], r), isNumber ? 'number' : '')));
  }
  return table;
}

export function printedClashes(all, view, { rows, chosen }) {
  const order = rows.order.slice(0, MOST_ROWS);
  const pictured = [...new Set([...(chosen >= 0 ? [chosen] : []), ...order])].slice(0, MOST_PICTURES);
  const left = rows.order.length - order.length;
  return [said('h2', countWords(rows)), ...pictured.map((r) => printedRow(view, r, `${r + 1}. ${rowTitleOf(all, r)}`)),
    printedTable(rows, order), ...(left > 0 ? [said('p', `${number(left)} more rows are on the page and not on paper; a filter chooses which are printed.`)] : [])];
}
