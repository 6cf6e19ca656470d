// What the table of a clash page says of rows, and which rows it shows in which order.
import { holds, number } from './words.js';

const CLASSES = ['crossing', 'inside', 'same', 'touching', 'near', 'undecided'];

const textOf = (value) => (value === null || value === undefined ? '' : typeof value === 'object' ? JSON.stringify(value) : String(value));

// The file without its folder.
export const baseName = (file) => textOf(file).split('/').pop();

// What people call a side: the path of its names, its name, its number, its file.
export function sideName(side) {
  const path = Array.isArray(side.path) ? side.path.map(textOf).join('/') : '';
  if (textOf(side.part)) {
    return path || textOf(side.part);
  }
  if (side.index !== null && side.index !== undefined) {
    return path.replace(/\/$/, '') || `part ${side.index}`;
  }
  return baseName(side.file).replace(/\.[^.]*$/, '') || 'a part without a name';
}

const digits = (value) => (typeof value === 'number' ? String(Number(value.toPrecision(6))) : '');

// Digits that can be seen in a scene of this size.
export function pointText(place, size) {
  const after = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(size))));
  return Array.isArray(place) && place.length === 3 && place.every((value) => typeof value === 'number')
    ? `(${place.map((value) => Number(value.toFixed(after)) + 0).join(', ')})` : '';
}

function gapText({ gap }) {
  if (!Array.isArray(gap) || typeof gap[0] !== 'number') {
    return '';
  }
  return digits(gap[0]);
}

// A column: its heading, what a row shows there, what it is sorted by, and its width on the screen.
export function columnsOf(all) {
  const name = (which) => (row) => sideName(all.sides[row[which]]);
  const size = (all.scene?.size ?? 1) / (all.scene?.scale ?? 1);
  const some = (key) => all.rows.some((row) => row[key] !== undefined && row[key] !== null);
  const columns = [
    { key: 'number', title: '#', text: (row, r) => number(r + 1), by: (row, r) => r, width: '3.6rem', isNumber: true },
    { key: 'class', title: 'Class', text: (row) => textOf(row.class), by: (row) => CLASSES.indexOf(row.class), width: '6rem' },
  ];
  if (some('status')) {
    columns.push({ key: 'status', title: 'Status', text: (row) => textOf(row.status), by: (row) => textOf(row.status), width: '5.2rem' });
  }
  if (some('group')) {
    columns.push({ key: 'group', title: 'Group', text: (row) => textOf(row.group), by: (row) => textOf(row.group), width: '7rem' });
  }
  columns.push(
    { key: 'a', title: 'First part', text: name('a'), by: name('a'), width: 'minmax(10rem,1fr)' },
    { key: 'b', title: 'Second part', text: name('b'), by: name('b'), width: 'minmax(10rem,1fr)' },
    { key: 'gap', title: 'Gap', text: gapText, by: (row) => (Array.isArray(row.gap) ? row.gap[0] : Infinity), width: '5.5rem', isNumber: true });
  if (some('depth')) {
    const depth = ({ depth: value }) => (Array.isArray(value) ? value[0] : value);
    columns.push({ key: 'depth', title: 'Depth', text: (row) => digits(depth(row)) || textOf(row.depth), by: (row) => depth(row) ?? -Infinity, width: '5.5rem', isNumber: true });
  }
  columns.push(
    { key: 'triangle_pairs', title: 'Triangle pairs', text: (row) => (typeof row.triangle_pairs === 'number' ? number(row.triangle_pairs) : ''), by: (row) => row.triangle_pairs ?? -1, width: '8.4rem', isNumber: true },
    { key: 'place', title: 'Place', text: (row) => pointText(row.place, size), by: (row) => row.place ?? [], width: '13rem' });
  return columns;
}

function compared(x, y) {
  if (Array.isArray(x) && Array.isArray(y)) {
    for (let k = 0; k < Math.min(x.length, y.length); ++k) {
      if (x[k] !== y[k]) {
        return x[k] < y[k] ? -1 : 1;
      }
    }
    return x.length - y.length;
  }
  if (typeof x === 'string' && typeof y === 'string') {
    return x < y ? -1 : x > y ? 1 : 0; // not as languages sort: a hundred thousand names are many
  }
  return x < y ? -1 : x > y ? 1 : 0;
}

const NO_STATUS = '';

// Which rows are shown, and in which order.
export class ClashRows {
  constructor(all) {
    this.all = all;
    this.columns = columnsOf(all);
    this.hays = []; // made when somebody searches first
    this.hidden = { class: new Set(), status: new Set() };
    this.query = '';
    this.pair = null; // a filter by two values of sides: { key, a, b }
    this.sortedBy = 'number';
    this.falling = false;
    this.counts = {
      class: this.counted((row) => textOf(row.class), CLASSES), status: this.counted((row) => textOf(row.status) || NO_STATUS, []),
    };
    this.sort();
  }

  // Values with how many rows have them; the known ones first.
  counted(of, known) {
    const counts = new Map();
    for (const row of this.all.rows) {
      counts.set(of(row), (counts.get(of(row)) ?? 0) + 1);
    }
    const place = (value) => (known.includes(value) ? known.indexOf(value) : known.length);
    return [...counts].sort(([x], [y]) => place(x) - place(y) || compared(x, y));
  }

  hay(r) {
    const { rows, sides } = this.all;
    this.hays[r] ??= [rows[r].key, rows[r].class, rows[r].status, rows[r].group, rows[r].relation,
      ...[rows[r].a, rows[r].b].flatMap((which) => {
        const side = sides[which];
        return [sideName(side), side.part, side.id, side.type, side.file, side.set, side.index];
      })].map(textOf).join(' ').toLowerCase();
    return this.hays[r];
  }

  isShown(r) {
    const row = this.all.rows[r];
    if (this.hidden.class.has(textOf(row.class)) || this.hidden.status.has(textOf(row.status))) {
      return false;
    }
    if (this.pair && !this.isOfPair(row)) {
      return false;
    }
    return this.query === '' || holds(this.hay(r), this.query);
  }

  isOfPair({ a, b }) {
    const { key, names } = this.pair;
    const values = [a, b].map((which) => textOf(this.all.sides[which][key]));
    return values[0] === names[0] && values[1] === names[1];
  }

  sift() {
    this.order = this.sorted.filter((r) => this.isShown(r));
  }

  sort() {
    const { by } = this.columns.find(({ key }) => key === this.sortedBy);
    const values = this.all.rows.map((row, r) => by(row, r));
    this.sorted = values.map((_, r) => r).sort((x, y) => (this.falling ? compared(values[y], values[x]) : compared(values[x], values[y])) || x - y);
    this.sift();
  }

  sortBy(key) {
    this.falling = this.sortedBy === key && !this.falling;
    this.sortedBy = key;
    this.sort();
  }
}

// "12 of 260 clashes", "All 260 clashes"
export function countWords(rows) {
  const all = rows.all.rows.length;
  const noun = all === 1 ? 'row' : 'rows';
  if (all === 0) {
    return rows.all.totals.complete ? 'No parts clash.' : 'No clash was found so far.';
  }
  return rows.order.length === all ? `All ${number(all)} ${noun}` : `${number(rows.order.length)} of ${number(all)} ${noun}`;
}

const HANDLED = new Set(['a', 'b', 'class', 'gap', 'place']);

// All that is known of a row, as names and values: nothing that JSON has is left out.
export function detailsOf(all, r) {
  const row = all.rows[r];
  const details = [['class', textOf(row.class)]];
  for (const [which, title] of [['a', 'first part'], ['b', 'second part']]) {
    const side = all.sides[row[which]];
    details.push([title, sideName(side)]);
    for (const [key, value] of Object.entries(side)) {
      if (value !== null && key !== 'part' && !(Array.isArray(value) && value.length === 0)) {
        details.push([key === 'path' || key === 'index' ? `its ${key}` : `its ${key.replaceAll('_', ' ')}`, Array.isArray(value) && key === 'path' ? value.map(textOf).join(' / ') : textOf(value)]);
      }
    }
  }
  if (row.gap !== undefined) {
    details.push(['gap', Array.isArray(row.gap) && row.gap[0] === row.gap[1] ? textOf(row.gap[0]) : textOf(row.gap)]);
  }
  if (row.place !== undefined) {
    details.push(['place', textOf(row.place)]);
  }
  for (const [key, value] of Object.entries(row)) {
    if (!HANDLED.has(key) && value !== null) {
      details.push([key.replaceAll('_', ' '), textOf(value)]);
    }
  }
  return details;
}

export const rowTitleOf = (all, r) => {
  const row = all.rows[r];
  return `${textOf(row.class)}: ${sideName(all.sides[row.a])} and ${sideName(all.sides[row.b])}`;
};

// How many rows each pair of values of sides has, the most first: [[a, b], count]. A value is that
// of `key`: "file" or "set".
export function pairCounts(all, key) {
  const counts = new Map();
  for (const { a, b } of all.rows) {
    const names = [a, b].map((which) => textOf(all.sides[which][key]));
    const mark = JSON.stringify(names);
    const found = counts.get(mark) ?? { names, count: 0 };
    ++found.count;
    counts.set(mark, found);
  }
  return [...counts.values()].sort((x, y) => y.count - x.count);
}

// What of the parts is drawn.
export function partsWords({ scene, sides }) {
  const words = [`Drawn: ${number(scene.parts)} of ${number(scene.all)} parts, ${number(scene.triangles)} of ${number(scene.triangles_in_all)} triangles; all parts of the list are among them`];
  if (scene.simplified > 0) {
    words.push(`${number(scene.simplified)} are simplified`);
  }
  const gone = scene.of_sides.filter((part) => part < 0).length;
  if (gone > 0) {
    words.push(`${number(gone)} of ${number(sides.length)} parts of the list are of the older list, and not in the models any more`);
  }
  return `${words.join('; ')}.`;
}
