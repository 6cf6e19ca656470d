// On paper: the list as it is searched and sorted, and pictures of the clash that is chosen and of the first ones.
import { number } from './words.js';
import { countWords, rowTitleOf } from './clash_rows.js';

const MOST_ROWS = 5000;
const MOST_PICTURES = 6;
const SIZE = [840, 560]; // pixels of a picture: two side by side on A4 at 250 dots an inch

const byId = (id) => document.getElementById(id);

function said(tag, text) {
  const element = document.createElement(tag);
  element.textContent = text;
  return element;
}

function figureOf(all, view, r) {
  const figure = document.createElement('figure');
  if (view) {
    figure.append(view.pictureOf(r, ...SIZE));
  }
  figure.append(said('figcaption', `${r + 1}. ${rowTitleOf(all, r)}`));
  return figure;
}

function printedTable(rows, order) {
  const table = document.createElement('table');
  table.id = 'printed';
  const head = table.createTHead().insertRow();
  head.append(...rows.columns.map(({ title }) => said('th', title)));
  const body = table.createTBody();
  for (const r of order) {
    const line = body.insertRow();
    for (const { text, isNumber } of rows.columns) {
      const cell = said('td', text(rows.all.rows[r], r));
      cell.className = isNumber ? 'number' : '';
      line.append(cell);
    }
  }
  return table;
}

export function addClashPrinting(all, view, table) {
  const { rows } = table;
  addEventListener('beforeprint', () => {
    const order = rows.order.slice(0, MOST_ROWS);
    const pictured = [...new Set([...(table.chosen >= 0 ? [table.chosen] : []), ...order])].slice(0, MOST_PICTURES);
    const parts = [said('h2', countWords(rows)), ...pictured.map((r) => figureOf(all, view, r)), printedTable(rows, order)];
    if (order.length < rows.order.length) {
      parts.push(said('p', `${number(rows.order.length - order.length)} more rows are on the page and not on paper; a filter chooses which are printed.`));
    }
    byId('prints').replaceChildren(...parts);
  });
  addEventListener('afterprint', () => byId('prints').replaceChildren());
}
