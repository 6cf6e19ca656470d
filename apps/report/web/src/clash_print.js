// On paper: the list as it is searched and sorted, and pictures of the clash that is chosen and of the first ones.
import { countWords, rowSentence } from './clash_rows.js';
import { printedRow, said } from './page.js';
import { number } from './words.js';

const MOST_ROWS = 5000;
const MOST_PICTURES = 6;

// Parts of the width of a sheet, for what does not wrap; names share the rest.
const WIDTHS = { number: 5, class: 9, status: 8, group: 10, gap: 8, depth: 8, triangle_pairs: 7, place: 21 };

function printedTable(rows, order) {
  const table = document.createElement('table');
  table.id = 'printed';
  const head = table.createTHead().insertRow();
  for (const { key, title, isNumber } of rows.columns) {
    const cell = said('th', title, isNumber ? 'number' : '');
    cell.style.width = key in WIDTHS ? `${WIDTHS[key]}%` : '';
    head.append(cell);
  }
  const body = table.createTBody();
  for (const r of order) {
    body.insertRow().append(...rows.columns.map(
      ({ text, isNumber }) => said('td', text(rows.all.rows[r], r), isNumber ? 'number' : '')));
  }
  return table;
}

// Rows that are worth a picture each: the chosen one, then the first of which both parts were in none yet, then the
// first of the others.
export function picturedRows({ rows, sides }, order, chosen, most = MOST_PICTURES) {
  const pictured = chosen >= 0 ? [chosen] : [];
  const partsOf = (r) => [rows[r].a, rows[r].b].filter((side) => sides[side] !== undefined);
  const seen = new Set(pictured.flatMap(partsOf));
  for (const isNew of [(r) => partsOf(r).every((side) => !seen.has(side)), (r) => partsOf(r).some((side) => !seen.has(side)), () => true]) {
    for (let at = 0; at < order.length && pictured.length < most; ++at) {
      if (!pictured.includes(order[at]) && isNew(order[at])) {
        pictured.push(order[at]);
        partsOf(order[at]).forEach((side) => seen.add(side));
      }
    }
  }
  return pictured;
}

export function printedClashes(all, view, { rows, chosen }) {
  const order = rows.order.slice(0, MOST_ROWS);
  const pictured = picturedRows(all, order, chosen);
  const left = rows.order.length - order.length;
  return [said('h2', countWords(rows)), ...pictured.map((r) => printedRow(view, r, `${r + 1}. ${rowSentence(all, r)}`)),
    printedTable(rows, order), ...(left > 0 ? [said('p', `${number(left)} more rows are on the page and not on paper; a filter chooses which are printed.`)] : [])];
}
