// Which lines the list has: rows that pass the search, and below an open row its contacts and what is
// left out of them. A line is three numbers: what it is, its row, and its contact.
import { haystack, holds, rowHaystack } from './words.js';

export const ROW = 0;
export const CONTACT = 1;
export const MISSING = 2;

export const NO = 0;
export const PERHAPS = 1;
export const YES = 2;

const ORDERS = {
  most: (rows) => (a, b) => rows.mostPairs(b) - rows.mostPairs(a) || rows.total(b) - rows.total(a) || a - b,
  count: (rows) => (a, b) => rows.total(b) - rows.total(a) || a - b,
  begin: (rows) => (a, b) => rows.begin(a) + rows.after(a) - rows.begin(b) - rows.after(b) || a - b,
  length: (rows) => (a, b) => rows.steps(b) - rows.steps(a) || a - b,
  mover: (rows) => (a, b) => rows.a(a) - rows.a(b) || rows.part(a, 0) - rows.part(b, 0) || a - b,
  touched: (rows) => (a, b) => rows.b(a) - rows.b(b) || rows.part(a, 1) - rows.part(b, 1) || a - b,
};

export class Entries {
  constructor(all) {
    this.all = all;
    this.opened = new Set();
    this.hays = []; // of rows, made when somebody searches first
    this.kinds = [];
    this.rowOf = [];
    this.contactOf = [];
  }

  get size() { return this.kinds.length; }

  isOpen(r) { return this.opened.has(r) || this.found?.has(r); }

  toggle(r) {
    if (this.isOpen(r)) {
      this.opened.delete(r);
      this.found?.delete(r);
    } else {
      this.opened.add(r);
    }
  }

  hay(r) {
    this.hays[r] ??= rowHaystack(this.all, r);
    return this.hays[r];
  }

  lastsContact(k, step) {
    const { contacts } = this.all;
    return contacts.begin(k) <= step && step <= contacts.end(k);
  }

  // Whether the two of a row touch at a step. Where contacts of it are missing, nobody knows, unless
  // it touches at every step from its first to its last.
  lasts(r, step) {
    const { rows } = this.all;
    if (step < rows.begin(r) || step > rows.end(r)) {
      return NO;
    }
    const members = rows.contacts(r);
    if (step === rows.begin(r) || step === rows.end(r) || rows.steps(r) === rows.end(r) - rows.begin(r) + 1
      || members.some((k) => this.lastsContact(k, step))) {
      return YES;
    }
    return members.length < rows.total(r) ? PERHAPS : NO;
  }

  // Contacts of a row that a search finds, where the row itself is not found.
  matches(r, query) {
    return [...this.all.rows.contacts(r)].filter((k) => holds(`${this.hay(r)} ${haystack(this.all, k)}`, query));
  }

  // Chooses rows and their order; a row that is found by its contacts is opened. `step`: only what
  // lasts then, if it is given.
  sift(query, order, step) {
    const { rows } = this.all;
    this.step = step;
    this.found = new Map();
    this.order = [];
    for (let r = 0; r < rows.count; ++r) {
      if (step !== undefined && this.lasts(r, step) === NO) {
        continue;
      }
      if (query !== '' && !holds(this.hay(r), query)) {
        const members = this.matches(r, query);
        if (members.length === 0) {
          continue;
        }
        this.found.set(r, members);
      }
      this.order.push(r);
    }
    this.order.sort(ORDERS[order](rows));
    this.lay();
  }

  lay() {
    this.kinds = [];
    this.rowOf = [];
    this.contactOf = [];
    for (const r of this.order) {
      this.add(ROW, r, -1);
      if (this.isOpen(r)) {
        for (const k of this.found.get(r) ?? this.all.rows.contacts(r)) {
          if (this.step === undefined || this.lastsContact(k, this.step)) {
            this.add(CONTACT, r, k);
          }
        }
        if (this.all.rows.contacts(r).length < this.all.rows.total(r)) {
          this.add(MISSING, r, -1);
        }
      }
    }
  }

  add(kind, r, k) {
    this.kinds.push(kind);
    this.rowOf.push(r);
    this.contactOf.push(k);
  }

  // The line of a row, or of a contact of it; -1 if there is none.
  find(r, k) {
    for (let at = this.rowOf.indexOf(r); at >= 0 && at < this.size && this.rowOf[at] === r; ++at) {
      if (this.kinds[at] !== MISSING && this.contactOf[at] === k) {
        return at;
      }
    }
    return -1;
  }
}
