// The list: a row for each two that touch, their contacts below it where it is open.
import { CONTACT, Entries, MISSING, NO, PERHAPS, ROW, YES } from './entries.js';
import { byId, said } from './page.js';
import { Scrolled } from './scrolled.js';
import {
  counted, counts, missing, number, place, rowMost, rowPaths, rowPlace, rowTitle, rowWhen, shortRowTitle, title, triangles, when,
} from './words.js';

export class List extends Scrolled {
  constructor(all, onChoose) {
    super(byId('list'), byId('rows'), { height: 92, more: 6 });
    this.all = all;
    this.onChoose = onChoose; // of a row, and a contact of it or -1
    this.entries = new Entries(all);
    this.find = byId('find');
    this.order = byId('order');
    this.onlyNow = byId('now');
    this.chosen = { row: -1, contact: -1 };
    this.step = 0;
    if (all.scene.steps.count < 2) {
      this.onlyNow.parentElement.hidden = true;
    }
    if (all.rows.count === 1) {
      this.entries.toggle(0);
    }
    for (const [element, event] of [[this.find, 'input'], [this.order, 'change'], [this.onlyNow, 'change']]) {
      element.addEventListener(event, () => {
        this.box.scrollTop = 0; // the first of what was found
        this.sift();
      });
    }
    this.box.addEventListener('click', (event) => this.click(event));
    this.sift();
  }

  sift() {
    this.entries.sift(this.find.value.trim(), this.order.value,
      this.onlyNow.checked ? Math.floor(this.step) : undefined);
    byId('count').textContent = counts(this.all, this.entries.order.length);
    this.resize();
  }

  get size() { return this.entries.size; }

  chosenAt() { return this.entries.find(this.chosen.row, this.chosen.contact); }

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

  toggle(r) {
    this.entries.toggle(r);
    this.entries.lay();
    this.resize();
  }

  click(event) {
    const line = event.target.closest('[data-at]');
    if (!line) {
      return;
    }
    const at = Number(line.dataset.at);
    const r = this.entries.rowOf[at];
    if (this.entries.kinds[at] === ROW) {
      const chosen = this.chosen.row === r && this.chosen.contact < 0;
      if (event.target.closest('.fold') || chosen || !this.entries.isOpen(r)) {
        this.toggle(r);
      }
      if (event.target.closest('.fold')) {
        return;
      }
    }
    if (this.entries.kinds[at] !== MISSING) {
      this.onChoose(r, this.entries.contactOf[at]);
    }
  }

  isChosen(at) {
    return this.entries.kinds[at] !== MISSING && this.entries.rowOf[at] === this.chosen.row
      && this.entries.contactOf[at] === this.chosen.contact;
  }

  line(at, top) {
    const kind = this.entries.kinds[at];
    const r = this.entries.rowOf[at];
    const k = this.entries.contactOf[at];
    const line = document.createElement('div');
    line.id = `line-${at}`;
    line.dataset.at = at;
    line.setAttribute('role', 'treeitem');
    line.setAttribute('aria-level', kind === ROW ? 1 : 2);
    line.setAttribute('aria-selected', this.isChosen(at));
    line.setAttribute('aria-posinset', at + 1);
    line.setAttribute('aria-setsize', this.entries.size);
    line.style.top = `${top}px`;
    const add = (tag, name, text) => line.appendChild(said(tag, text, name));
    if (kind === ROW) {
      this.fillRow(line, r, add);
    } else if (kind === CONTACT) {
      line.dataset.contact = k;
      line.className = `line contact${this.entries.lastsContact(k, Math.floor(this.step)) ? ' lasts' : ''}`;
      const text = title(this.all, k);
      add('b', 'who', triangles(this.all, k) || text).title = text;
      const other = text === rowTitle(this.all, r) ? '' : text; // a part of a mover is a contact's own
      add('span', 'what', [when(this.all, k), other, place(this.all, k)].filter(Boolean).join('; '));
    } else {
      line.className = 'line left';
      const text = missing(this.all, r);
      add('span', 'what', text).title = text;
    }
    return line;
  }

  fillRow(line, r, add) {
    const { rows, scene } = this.all;
    const open = Boolean(this.entries.isOpen(r));
    line.dataset.row = r;
    const touching = scene.steps.count > 1 ? this.entries.lasts(r, Math.floor(this.step)) : NO;
    line.className = `line pair${touching === YES ? ' lasts' : touching === PERHAPS ? ' perhaps' : ''}`;
    line.setAttribute('aria-expanded', open);
    const fold = add('span', 'fold', open ? '\u25be' : '\u25b8');
    fold.setAttribute('aria-hidden', true);
    const text = rowTitle(this.all, r);
    add('b', 'who', shortRowTitle(this.all, r)).title = rowPaths(this.all, r) || text;
    const left = rows.total(r) - rows.contacts(r).length;
    const parts = [counted(this.all, rows.total(r))];
    if (left > 0) {
      parts[0] += ` (${number(left)} not drawn)`;
    }
    const now = touching === PERHAPS ? 'perhaps now' : ''; // of the contacts that are not on the page
    add('span', 'what', [rowWhen(this.all, r), ...parts, now, rowMost(this.all, r), rowPlace(this.all, r)].filter(Boolean).join('; '));
    if (scene.steps.count > 1) {
      const bar = document.createElement('i');
      bar.style.left = `${100 * rows.begin(r) / scene.steps.count}%`;
      bar.style.width = `${100 * (rows.end(r) - rows.begin(r) + 1) / scene.steps.count}%`;
      add('span', 'when', '').append(bar);
    }
  }

  // Marks row r, or contact k of it, and brings its line into sight; a search may have left it out.
  mark(r, k) {
    this.chosen = { row: r, contact: k };
    if (k >= 0 && !this.entries.isOpen(r)) {
      this.toggle(r);
    }
    this.reveal();
  }

  // The next row in the order of the list, whatever is folded out.
  nextRow(by) {
    const { order } = this.entries;
    const at = order.indexOf(this.chosen.row);
    const next = at < 0 ? (by > 0 ? 0 : order.length - 1) : Math.min(order.length - 1, Math.max(0, at + by));
    if (order.length > 0) {
      this.onChoose(order[next], -1);
    }
  }

  // The next of the contacts that the page holds of the chosen row.
  nextContact(by) {
    const contacts = this.chosen.row < 0 ? [] : [...this.all.rows.contacts(this.chosen.row)];
    if (contacts.length > 0) {
      const at = contacts.indexOf(this.chosen.contact);
      const next = at < 0 ? (by > 0 ? 0 : contacts.length - 1) : Math.min(contacts.length - 1, Math.max(0, at + by));
      this.onChoose(this.chosen.row, contacts[next]);
    }
  }

  // What is left out is passed over.
  chooseAt(at, by) {
    const { entries } = this;
    let next = at;
    while (entries.kinds[next] === MISSING) {
      next += by > 0 && next + 1 < entries.size ? 1 : -1;
    }
    this.onChoose(entries.rowOf[next], entries.contactOf[next]);
  }

  // Opens and closes rows, besides what all lists do.
  key(event) {
    super.key(event);
    const { row, contact } = this.chosen;
    if (row >= 0 && (event.key === 'Enter' || event.key === 'ArrowRight' || event.key === 'ArrowLeft')) {
      event.preventDefault();
      const open = Boolean(this.entries.isOpen(row));
      const wanted = event.key === 'Enter' ? !open : event.key === 'ArrowRight';
      if (contact >= 0 && event.key === 'ArrowLeft') {
        this.onChoose(row, -1);
      } else if (contact < 0 && open !== wanted) {
        this.toggle(row);
      }
    }
  }
}
