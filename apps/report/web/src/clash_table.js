// The table of a clash page. Only rows that are seen are drawn, so that 100,000 are as quick as ten.
import { number } from './words.js';
import { countWords } from './clash_rows.js';

const HEIGHT = 40; // pixels of a row, as in the page's style
const TALLEST = 8e6; // pixels; browsers draw no element that is much taller
const MORE = 8; // rows beyond each end

const byId = (id) => document.getElementById(id);

export class ClashTable {
  constructor(rows, onChoose) {
    this.rows = rows;
    this.onChoose = onChoose;
    this.chosen = -1;
    this.box = byId('table');
    this.head = byId('head');
    this.body = byId('rows');
    this.widths = rows.columns.map(({ width }) => width).join(' ');
    this.box.setAttribute('aria-colcount', rows.columns.length);
    this.addHead();
    this.addFilters('class', byId('classes'));
    this.addFilters('status', byId('statuses'));
    byId('find').addEventListener('input', () => { rows.query = byId('find').value.trim(); this.sift(); });
    byId('clear').addEventListener('click', () => this.clear());
    this.box.addEventListener('scroll', () => this.draw());
    this.body.addEventListener('click', (event) => {
      const line = event.target.closest('[data-row]');
      if (line) {
        this.onChoose(Number(line.dataset.row));
      }
    });
    this.box.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.box);
    this.sift();
  }

  addHead() {
    this.head.style.gridTemplateColumns = this.widths;
    this.head.replaceChildren(...this.rows.columns.map(({ key, title, isNumber }) => {
      const cell = document.createElement('div');
      cell.setAttribute('role', 'columnheader');
      cell.className = isNumber ? 'number' : '';
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = title;
      button.dataset.sort = key;
      button.addEventListener('click', () => { this.rows.sortBy(key); this.markHead(); this.sift(); });
      cell.append(button);
      return cell;
    }));
    this.markHead();
  }

  markHead() {
    this.rows.columns.forEach(({ key }, k) => this.head.children[k].setAttribute('aria-sort',
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
    this.body.style.height = `${Math.min(TALLEST, HEIGHT * this.rows.order.length)}px`;
    this.box.setAttribute('aria-rowcount', this.rows.order.length + 1);
    this.at = this.rows.order.indexOf(this.chosen);
    this.draw();
  }

  room() { return Math.max(HEIGHT, this.box.clientHeight - this.head.offsetHeight); }

  // How many pixels of all rows lie above what is seen. Where they are taller than a browser can
  // scroll, a pixel of the scroll bar stands for several.
  above() {
    const all = HEIGHT * this.rows.order.length;
    return all <= TALLEST ? this.box.scrollTop : this.box.scrollTop / (TALLEST - this.room()) * (all - this.room());
  }

  scrollTo(above) {
    const all = HEIGHT * this.rows.order.length;
    this.box.scrollTop = all <= TALLEST ? above : above * (TALLEST - this.room()) / (all - this.room());
  }

  line(at, top) {
    const r = this.rows.order[at];
    const row = this.rows.all.rows[r];
    const line = document.createElement('div');
    line.id = `clash-${r}`;
    line.className = 'clash';
    line.dataset.row = r;
    line.setAttribute('role', 'row');
    line.setAttribute('aria-rowindex', at + 2);
    line.setAttribute('aria-selected', r === this.chosen);
    line.style.top = `${top}px`;
    line.style.gridTemplateColumns = this.widths;
    for (const { text, isNumber } of this.rows.columns) {
      const cell = document.createElement('span');
      cell.setAttribute('role', 'gridcell');
      cell.className = isNumber ? 'number' : '';
      cell.textContent = text(row, r);
      cell.title = cell.textContent;
      line.append(cell);
    }
    return line;
  }

  draw() {
    const above = this.above();
    const shift = this.box.scrollTop - above;
    const first = Math.max(0, Math.floor(above / HEIGHT) - MORE);
    const last = Math.min(this.rows.order.length, Math.ceil((above + this.box.clientHeight) / HEIGHT) + MORE);
    const lines = [];
    for (let at = first; at < last; ++at) {
      lines.push(this.line(at, HEIGHT * at + shift));
    }
    this.body.replaceChildren(...lines);
    const seen = this.body.querySelector('[aria-selected="true"]');
    if (seen) {
      this.box.setAttribute('aria-activedescendant', seen.id);
    } else {
      this.box.removeAttribute('aria-activedescendant');
    }
  }

  // Marks a row and brings it into sight; a filter may have left it out.
  mark(r) {
    this.chosen = r;
    this.at = this.rows.order.indexOf(r);
    if (this.at >= 0) {
      const top = HEIGHT * this.at;
      const above = this.above();
      if (top < above || top + HEIGHT > above + this.room()) {
        this.scrollTo(Math.max(0, top - this.room() / 3));
      }
    }
    this.draw();
  }

  neighbor(by) {
    const { order } = this.rows;
    if (order.length > 0) {
      const wanted = this.at < 0 ? (by > 0 ? 0 : order.length - 1) : this.at + by;
      this.onChoose(order[Math.min(order.length - 1, Math.max(0, wanted))]);
    }
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.room() / HEIGHT) - 1);
    const all = this.rows.order.length;
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -all, End: all };
    if (event.target === this.box && event.key in steps) {
      event.preventDefault();
      this.neighbor(steps[event.key]);
    }
  }
}
