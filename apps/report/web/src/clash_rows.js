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

const inMost = (value, most) => (typeof value === 'number' ? String(Number(value.toPrecision(most))) : '');

// As a table has room for; the details have more.
const digits = (value) => inMost(value, 4);

const isPoint = (value) => Array.isArray(value) && value.length === 3 && value.every((part) => typeof part === 'number');

// Digits that can be seen in a scene of this size.
export function pointText(place, size) {
  const after = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(size))));
  return isPoint(place) ? `(${place.map((value) => Number(value.toFixed(after)) + 0).join(', ')})` : '';
}

const sizeOf = ({ scene }) => (scene?.size ?? 1) / (scene?.scale ?? 1);

// The lower of the two ends that enclose a length, or the length itself.
const lower = (value) => (Array.isArray(value) ? value[0] : value) ?? undefined;

// What is worse comes first: by class, then the deeper, the nearer, and the one with more pairs of triangles. What
// is resolved comes last.
function worst({ class: kind, status, depth, gap, triangle_pairs: pairs }) {
  const known = CLASSES.indexOf(kind);
  return [status === 'resolved' ? 1 : 0, known < 0 ? CLASSES.length : known, -(lower(depth) ?? 0), lower(gap) ?? 0, -(pairs ?? 0)];
}

// A column: its heading, what a row shows there, what it is sorted by, its width on the screen and, if it is not `isWide`,
// on a narrow one. Those of `onPaper` are there alone, as the details have them on the screen.
export function columnsOf(all) {
  const name = (which) => (row) => sideName(all.sides[row[which]]);
  const size = sizeOf(all);
  const some = (key) => all.rows.some((row) => row[key] !== undefined && row[key] !== null);
  const columns = [
    { key: 'number', title: '#', text: (row, r) => number(r + 1), by: (row, r) => r, width: '3rem', isNumber: true, isWide: true },
    { key: 'class', title: 'Class', text: (row) => textOf(row.class), by: worst, width: '5.4rem', isWide: true },
  ];
  if (some('status')) {
    columns.push({ key: 'status', title: 'Status', text: (row) => textOf(row.status), by: (row) => textOf(row.status), width: '5rem', isWide: true });
  }
  if (some('group')) {
    columns.push({ key: 'group', title: 'Group', text: (row) => textOf(row.group), by: (row) => textOf(row.group), width: '6rem', isWide: true });
  }
  columns.push(
    { key: 'a', title: 'First part', text: name('a'), by: name('a'), width: 'minmax(5rem,1fr)', narrow: 'minmax(0,1fr)' },
    { key: 'b', title: 'Second part', text: name('b'), by: name('b'), width: 'minmax(5rem,1fr)', narrow: 'minmax(0,1fr)' });
  const length = (key, title, without, isWide = false) => columns.push({
    key, title, text: (row) => (lower(row[key]) > 0 ? digits(lower(row[key])) : ''), by: (row) => lower(row[key]) ?? without, width: '5rem', narrow: '5rem', isNumber: true, isWide,
  });
  if (all.rows.some(({ gap }) => lower(gap) > 0)) {
    length('gap', 'Gap', Infinity, some('depth'));
  }
  if (some('depth')) {
    length('depth', 'Depth', -Infinity);
  }
  columns.push(
    { key: 'triangle_pairs', title: 'Pairs', text: (row) => (typeof row.triangle_pairs === 'number' ? number(row.triangle_pairs) : ''), by: (row) => row.triangle_pairs ?? -1, width: '4.6rem', isNumber: true, isWide: true },
    { key: 'place', title: 'Place', text: (row) => pointText(row.place, size), by: (row) => row.place ?? [], onPaper: true });
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
    this.sortedBy = 'class'; // the worst first
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

// A value of JSON in words, with digits that can be seen in a scene of this size.
function inWords(value, size) {
  if (isPoint(value)) {
    return pointText(value, size);
  }
  if (Array.isArray(value)) {
    const parts = value.map((part) => inWords(part, size));
    const isRange = parts.length === 2 && value.every((part) => typeof part === 'number' || isPoint(part));
    return isRange ? [...new Set(parts)].join(' to ') : parts.join(value.some(Array.isArray) ? '; ' : ', ');
  }
  if (typeof value === 'boolean') {
    return value ? 'yes' : 'no';
  }
  if (value !== null && typeof value === 'object') {
    return Object.entries(value).filter(([, part]) => part !== null).map(([key, part]) => `${spaced(key)}: ${inWords(part, size)}`).join(', ');
  }
  return typeof value === 'number' && !Number.isInteger(value) ? inMost(value, 6) : textOf(value);
}

const spaced = (key) => key.replaceAll('_', ' ');

const isEmpty = (value) => value === null || value === undefined || value === '' || (Array.isArray(value) && value.length === 0);

// In this order; all others follow.
const FIRST = ['class', 'status', 'depth', 'gap', 'place', 'triangle_pairs'];

function sideDetails(side, title, size) {
  return [[title, sideName(side)], ...Object.entries(side).filter(([key, value]) => key !== 'part' && !isEmpty(value))
    .map(([key, value]) => [`its ${spaced(key)}`, key === 'path' && Array.isArray(value) ? value.map(textOf).join(' / ') : inWords(value, size)])];
}

// All that is known of a row, as names and values: nothing that JSON has is left out.
export function detailsOf(all, r) {
  const row = all.rows[r];
  const size = sizeOf(all);
  const of = (keys) => keys.filter((key) => !isEmpty(row[key])).map((key) => [spaced(key), inWords(row[key], size)]);
  return [...of(FIRST), ...sideDetails(all.sides[row.a], 'first part', size), ...sideDetails(all.sides[row.b], 'second part', size),
    ...of(Object.keys(row).filter((key) => key !== 'a' && key !== 'b' && !FIRST.includes(key)))];
}

// What a row comes to: "Beam and Duct: crossing, 0.3064 deep, at (1, 2, 3)".
export function rowSentence(all, r) {
  const { class: kind, depth, gap, place } = all.rows[r];
  const measure = lower(gap) > 0 ? `${digits(lower(gap))} apart` : lower(depth) > 0 ? `${digits(lower(depth))} deep` : '';
  return `${namesOf(all, r)}: ${[textOf(kind), measure, isPoint(place) ? `at ${pointText(place, sizeOf(all))}` : ''].filter(Boolean).join(', ')}`;
}

const namesOf = (all, r) => ['a', 'b'].map((which) => sideName(all.sides[all.rows[r][which]])).join(' and ');

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
