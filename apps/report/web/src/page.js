// What every page has around its view: elements, what is said of trouble, and pictures for paper.
const SIZE = [840, 560]; // pixels of a picture: two side by side on A4 at 250 dots an inch

export const byId = (id) => document.getElementById(id);

export function said(tag, text, kind = '') {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = kind;
  return element;
}

export function svg(name, parent, kind = '') {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  element.setAttribute('class', kind);
  parent.append(element);
  return element;
}

// Says what is wrong; the element `needless` is of no use without a picture.
export function trouble(words, needless) {
  byId('trouble').textContent = words;
  byId('trouble').hidden = false;
  byId('look').hidden = false;
  byId(needless).hidden = true;
}

// The page's view; null where the browser draws none.
export function makeView(Kind, all, needless) {
  // Requested of a canvas that is thrown away: one that failed once gives no other context.
  if (!document.createElement('canvas').getContext('webgl2')) {
    trouble('This browser does not support WebGL, so nothing is drawn in three dimensions. The list and all figures are still on this page.', needless);
    return null;
  }
  byId('canvas').addEventListener('webglcontextlost', () => trouble('The browser lost the graphics card. Reload the page to draw the picture again.', needless));
  const view = new Kind(byId('canvas'), all);
  byId('whole').addEventListener('click', () => view.whole());
  return view;
}

// Buttons and keys that go through the list of a page; `keys` are more of them.
export function addSteps(view, list, keys) {
  byId('next').addEventListener('click', () => list.neighbor(1));
  byId('previous').addEventListener('click', () => list.neighbor(-1));
  view?.addKeys({ n: () => list.neighbor(1), p: () => list.neighbor(-1), ...keys });
}

// Cells of tables get the names of their columns, which a narrow screen shows before each.
export function nameCells() {
  for (const table of document.querySelectorAll('.fold table')) {
    const names = [...table.tHead.rows[0].cells].map(({ textContent }) => textContent);
    table.classList.add('stacked');
    for (const { cells } of table.tBodies[0].rows) {
      [...cells].forEach((cell, k) => { cell.dataset.name = names[k]; });
    }
  }
}

// For paper: a picture of a row, and words below it.
export function printedRow(view, r, ...words) {
  const figure = document.createElement('figure');
  const caption = document.createElement('figcaption');
  caption.append(...words);
  figure.append(...(view ? [view.pictureOf(r, ...SIZE)] : []), caption);
  return figure;
}

// `make` gives the elements that are on paper alone. Nothing can be unfolded there.
export function addPrinting(make) {
  let folded = [];
  addEventListener('beforeprint', () => {
    byId('prints').replaceChildren(...make());
    folded = [...document.querySelectorAll('details.fold:not([open])')];
    folded.forEach((part) => { part.open = true; });
  });
  addEventListener('afterprint', () => {
    byId('prints').replaceChildren();
    folded.forEach((part) => { part.open = false; });
  });
}
