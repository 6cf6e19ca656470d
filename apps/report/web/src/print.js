// On paper: a picture of each of the first rows of the list, taken when the page is about to be printed.
import { counted, rowMost, rowPlace, rowTitle, rowWhen } from './words.js';

const MOST = 20;
const SIZE = [840, 560]; // pixels of a picture: two side by side on A4 at 250 dots an inch

const byId = (id) => document.getElementById(id);

function figureOf(all, view, r, number) {
  const figure = document.createElement('figure');
  if (view) {
    figure.append(view.pictureOf(r, ...SIZE));
  }
  const words = document.createElement('figcaption');
  const name = document.createElement('b');
  name.textContent = `${number}. ${rowTitle(all, r)}`;
  const what = [rowWhen(all, r), counted(all, all.rows.total(r)), rowMost(all, r), rowPlace(all, r)].filter(Boolean).join('; ');
  words.append(name, document.createElement('br'), what);
  figure.append(words);
  return figure;
}

export function addPrinting(all, view, list) {
  const place = byId('prints');
  addEventListener('beforeprint', () => {
    const rows = list.entries.order.slice(0, MOST);
    const title = document.createElement('h2');
    const left = list.entries.order.length - rows.length;
    title.textContent = left > 0 ? `The first ${rows.length} of ${list.entries.order.length.toLocaleString('en')}` : 'Who touches whom';
    place.replaceChildren(...(rows.length > 0 ? [title] : []), ...rows.map((r, k) => figureOf(all, view, r, k + 1)));
  });
  addEventListener('afterprint', () => place.replaceChildren());
}
