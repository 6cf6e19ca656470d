// The table of a clash page.
import { countWords } from './clash_rows.js';
import { byId, said } from './page.js';
import { Scrolled } from './scrolled.js';
import { number } from './words.js';

// Classes of a cell; a narrow screen has no room for those of `wide`.
const kindOf = (isNumber, isWide) => [isNumber ? 'number' : '', isWide ? 'wide' : ''].filter(Boolean).join(' ');

export class ClashTable extends Scrolled {
  constructor(rows, onChoose) {
    super(byId('table'), byId('rows'), { height: 40, more: 8, head: byId('head') });
    this.rows = rows;
    this.onChoose = onChoose;
    this.chosen = -1;
    this.columns = rows.columns.filter(({ onPaper }) => !onPaper);
    this.box.style.setProperty('--wide', this.columns.map(({ width }) => width).join(' '));
    this.box.style.setProperty('--narrow', this.columns.filter(({ isWide }) => !isWide).map(({ narrow }) => narrow).join(' '));
    this.box.setAttribute('aria-colcount', this.columns.length);
    this.addHead();
    this.addFilters('class', byId('classes'));
    this.addFilters('status', byId('statuses'));
    byId('find').addEventListener('input', () => { rows.query = byId('find').value.trim(); this.sift(); });
    byId('clear').addEventListener('click', () => this.clear());
    this.lines.addEventListener('click', (event) => {
      const line = event.target.closest('[data-row]');
      if (line) {
        this.onChoose(Number(line.dataset.row));
      }
    });
    this.sift();
  }

  addHead() {
    this.head.replaceChildren(...this.columns.map(({ key, title, isNumber, isWide }) => {
      const cell = said('div', '', kindOf(isNumber, isWide));
      cell.setAttribute('role', 'columnheader');
      const button = said('button', title);
      button.type = 'button';
      button.dataset.sort = key;
      button.addEventListener('click', () => { this.rows.sortBy(key); this.markHead(); this.sift(); });
      cell.append(button);
      return cell;
    }));
    this.markHead();
  }

  markHead() {
    this.columns.forEach(({ key }, k) => this.head.children[k].setAttribute('aria-sort',
      key !== this.rows.sortedBy ? 'none' : this.rows.falling ? 'descending' : 'ascending'));
  }

  // A box to check for each value, with how many rows have it.
  addFilters(what, place) {
    const counts = this.rows.counts[what];
    place.hidden = counts.length === 0 || (counts.length === 1 && counts[0][0] === '');
    for (const [value, count] of counts) {
      const label = document.createElement('label');
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.checked = true;
      box.dataset[what] = value;
      box.addEventListener('change', () => {
        this.rows.hidden[what][box.checked ? 'delete' : 'add'](value);
        this.sift();
      });
      label.append(box, ` ${value || 'none'} ${number(count)}`);
      place.append(label);
    }
  }

  setPair(pair) {
    this.rows.pair = pair;
    const said = byId('pair-filter');
    said.hidden = pair === null;
    said.textContent = pair ? `Only clashes of ${pair.titles[0]} with ${pair.titles[1]}` : '';
    this.sift();
  }

  clear() {
    this.rows.query = byId('find').value = '';
    for (const box of document.querySelectorAll('#filters input[type=checkbox]')) {
      box.checked = true;
    }
    this.rows.hidden.class.clear();
    this.rows.hidden.status.clear();
    this.setPair(null);
  }

  sift() {
    this.rows.sift();
    byId('count').textContent = countWords(this.rows);
    this.box.setAttribute('aria-rowcount', this.size + 1);
    this.at = this.rows.order.indexOf(this.chosen);
    this.box.scrollTop = 0; // the first of what was found
    this.resize();
  }

  get size() { return this.rows.order.length; }

  chosenAt() { return this.at; }

  chooseAt(at) { this.onChoose(this.rows.order[at]); }

  line(at, top) {
    const r = this.rows.order[at];
    const row = this.rows.all.rows[r];
    const line = said('div', '', 'clash');
    line.id = `clash-${r}`;
    line.dataset.row = r;
    line.setAttribute('role', 'row');
    line.setAttribute('aria-rowindex', at + 2);
    line.setAttribute('aria-selected', r === this.chosen);
    line.style.top = `${top}px`;
    for (const { text, isNumber, isWide } of this.columns) {
      const cell = said('span', text(row, r), kindOf(isNumber, isWide));
      cell.setAttribute('role', 'gridcell');
      cell.title = cell.textContent;
      line.append(cell);
    }
    return line;
  }

  mark(r) {
    this.chosen = r;
    this.at = this.rows.order.indexOf(r);
    this.reveal();
  }
}
