// The list of contacts: searched, ordered, and drawn only where it is seen.
import { haystack, holds, number, title, triangles, when } from './words.js';

const ROW = 56; // pixels, as in the page's style
const MORE = 6; // rows beyond each end

const ORDERS = {
  begin: (contacts) => (a, b) => contacts.begin(a) - contacts.begin(b) || a - b,
  length: (contacts) => (a, b) => (contacts.end(b) - contacts.begin(b)) - (contacts.end(a) - contacts.begin(a)) || a - b,
  mover: (contacts) => (a, b) => contacts.a(a) - contacts.a(b) || a - b,
  touched: (contacts) => (a, b) => contacts.b(a) - contacts.b(b) || contacts.word(a, 3) - contacts.word(b, 3) || a - b,
};

export class List {
  constructor(all, onChoose) {
    this.all = all;
    this.onChoose = onChoose;
    this.box = document.getElementById('list');
    this.rows = document.getElementById('rows');
    this.find = document.getElementById('find');
    this.order = document.getElementById('order');
    this.onlyNow = document.getElementById('now');
    this.count = document.getElementById('count');
    this.chosen = -1;
    this.step = 0;
    for (const [element, event] of [[this.find, 'input'], [this.order, 'change'], [this.onlyNow, 'change']]) {
      element.addEventListener(event, () => this.sift());
    }
    this.box.addEventListener('scroll', () => this.draw());
    this.box.addEventListener('click', (event) => {
      const row = event.target.closest('[data-contact]');
      if (row) {
        this.onChoose(Number(row.dataset.contact));
      }
    });
    this.box.addEventListener('keydown', (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.box);
    this.sift();
  }

  // Which contacts are listed, and in what order.
  sift() {
    const { contacts } = this.all;
    const query = this.find.value.trim();
    this.shown = [];
    for (let k = 0; k < contacts.count; ++k) {
      if (this.onlyNow.checked && !this.lasts(k)) {
        continue;
      }
      if (query !== '' && !holds(haystack(this.all, k), query)) {
        continue;
      }
      this.shown.push(k);
    }
    this.shown.sort(ORDERS[this.order.value](contacts));
    this.rows.style.height = `${ROW * this.shown.length}px`;
    this.count.textContent = contacts.count === 0 ? 'Nothing touches.'
      : `${number(this.shown.length)} of ${number(contacts.count)} contacts`;
    this.draw();
  }

  lasts(k) {
    const { contacts } = this.all;
    const now = Math.floor(this.step);
    return contacts.begin(k) <= now && now <= contacts.end(k);
  }

  setStep(step) {
    const before = Math.floor(this.step);
    this.step = step;
    if (Math.floor(step) !== before) {
      if (this.onlyNow.checked) {
        this.sift();
      } else {
        this.draw();
      }
    }
  }

  row(k, at) {
    const { scene, contacts } = this.all;
    const row = document.createElement('div');
    row.id = `contact-${k}`;
    row.dataset.contact = k;
    row.setAttribute('role', 'option');
    row.setAttribute('aria-selected', k === this.chosen);
    row.setAttribute('aria-posinset', at + 1);
    row.setAttribute('aria-setsize', this.shown.length);
    row.className = `contact${this.lasts(k) ? ' lasts' : ''}`;
    row.style.top = `${ROW * at}px`;
    const add = (tag, name, text) => {
      const element = document.createElement(tag);
      element.className = name;
      element.textContent = text;
      row.append(element);
      return element;
    };
    add('b', 'who', title(this.all, k)).title = title(this.all, k);
    add('span', 'what', [when(this.all, k), triangles(this.all, k)].filter(Boolean).join('; '));
    if (scene.steps.count > 1) {
      const bar = document.createElement('i');
      bar.style.left = `${100 * contacts.begin(k) / scene.steps.count}%`;
      bar.style.width = `${100 * (contacts.end(k) - contacts.begin(k) + 1) / scene.steps.count}%`;
      add('span', 'when', '').append(bar);
    }
    return row;
  }

  draw() {
    const first = Math.max(0, Math.floor(this.box.scrollTop / ROW) - MORE);
    const last = Math.min(this.shown.length, Math.ceil((this.box.scrollTop + this.box.clientHeight) / ROW) + MORE);
    const rows = [];
    for (let at = first; at < last; ++at) {
      rows.push(this.row(this.shown[at], at));
    }
    this.rows.replaceChildren(...rows);
    const seen = this.rows.querySelector('[aria-selected="true"]');
    if (seen) {
      this.box.setAttribute('aria-activedescendant', seen.id);
    } else {
      this.box.removeAttribute('aria-activedescendant');
    }
  }

  // Marks contact k and brings its row into sight; only a listed one has a row.
  mark(k) {
    this.chosen = k;
    const at = this.shown.indexOf(k);
    if (at >= 0) {
      const top = ROW * at;
      if (top < this.box.scrollTop || top + ROW > this.box.scrollTop + this.box.clientHeight) {
        this.box.scrollTop = Math.max(0, top - this.box.clientHeight / 3);
      }
    }
    this.draw();
  }

  // The contact `by` rows further on.
  neighbor(by) {
    if (this.shown.length === 0) {
      return;
    }
    const at = this.shown.indexOf(this.chosen);
    const next = at < 0 ? (by > 0 ? 0 : this.shown.length - 1) : at + by;
    this.onChoose(this.shown[Math.min(this.shown.length - 1, Math.max(0, next))]);
  }

  key(event) {
    const page = Math.max(1, Math.floor(this.box.clientHeight / ROW) - 1);
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -this.shown.length, End: this.shown.length };
    if (event.key in steps) {
      event.preventDefault();
      this.neighbor(steps[event.key]);
    } else if (event.key === 'Enter' && this.chosen >= 0) {
      this.onChoose(this.chosen);
    }
  }
}
