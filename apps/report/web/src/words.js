// What the page says about rows, contacts and steps.

export const number = (value) => value.toLocaleString('en');

export const NO_PART = 0xffffffff;

const some = (values, most) => values.slice(0, most).map(number).join(', ')
  + (values.length > most ? ', ...' : '');

// "1 contact", "12,345 contacts"
export function counted({ scene }, count) {
  return `${number(count)} ${count === 1 ? scene.contacts.one : scene.contacts.many}`;
}

export function bodyName(scene, body) {
  return scene.bodies.names[body];
}

const nameOf = (scene, part) => (part === NO_PART ? '' : scene.parts[part]);

const pathOf = (scene, part) => (part === NO_PART ? '' : scene.paths[part]);

// Where only two bodies are, or a body is the only one that stands still, its parts need no other
// name beside theirs.
function side(scene, body, part) {
  const name = bodyName(scene, body);
  const partName = nameOf(scene, part);
  if (!partName || partName === name) {
    return name;
  }
  const alone = scene.bodies.moves.length === 2
    || (!scene.bodies.moves[body] && scene.bodies.moves.length - scene.moving === 1);
  return alone ? partName : `${name} (${partName})`;
}

// What a row or a contact says of its two: of rows by how they meet.
const MEETS = ['touches', 'passed through', 'may have passed through'];

const meets = (rows, r) => MEETS[rows.meeting(r)];

// "car 12 (hull) touches house_31"
export function title({ scene, contacts, rows }, k) {
  return `${side(scene, contacts.a(k), contacts.part(k, 0))} ${meets(rows, contacts.row(k))} ${side(scene, contacts.b(k), contacts.part(k, 1))}`;
}

// The same of a row.
export function rowTitle({ scene, rows }, r) {
  return `${side(scene, rows.a(r), rows.part(r, 0))} ${meets(rows, r)} ${side(scene, rows.b(r), rows.part(r, 1))}`;
}

// A name with its middle left out where it is long: names of parts often differ in their last words.
export function shortName(name, most = 44) {
  const letters = [...name];
  if (letters.length <= most) {
    return name;
  }
  const begin = Math.floor((most - 3) / 3);
  return `${letters.slice(0, begin).join('')}...${letters.slice(letters.length - (most - 3 - begin)).join('')}`;
}

// The title of a row as the list has room for it.
export function shortRowTitle({ scene, rows }, r) {
  return [0, 1].map((which) => shortName(side(scene, which === 0 ? rows.a(r) : rows.b(r), rows.part(r, which))))
    .join(` ${meets(rows, r)} `);
}

// Where parts lie in the hierarchy of their files; empty where that says no more than their names.
export function rowPaths({ scene, rows }, r) {
  return [0, 1].map((which) => pathOf(scene, rows.part(r, which))).filter(Boolean).join(` ${meets(rows, r)} `);
}

function span(scene, begin, end, after = 0) {
  const { noun, count } = scene.steps;
  if (count < 2) {
    return '';
  }
  if (after > 0) {
    return `${noun} ${number(begin)} + ${after.toFixed(2)}`;
  }
  return begin === end ? `${noun} ${number(begin)}` : `${noun}s ${number(begin)} to ${number(end)}`;
}

export function when({ scene, contacts, rows }, k) {
  return span(scene, contacts.begin(k), contacts.end(k), rows.after(contacts.row(k)));
}

// "poses 3 to 9, 5 of them"
export function rowWhen({ scene, rows }, r) {
  const text = span(scene, rows.begin(r), rows.end(r), rows.after(r));
  const all = rows.end(r) - rows.begin(r) + 1;
  return text && rows.steps(r) < all ? `${text}, ${number(rows.steps(r))} of them` : text;
}

// "(12.3, 4.56, 0.125)", a point of the scene in the coordinates of the files: digits that can be seen.
function point(scene, at) {
  const size = scene.size / scene.scale;
  const digits = Math.min(12, Math.max(0, 4 - Math.floor(Math.log10(size))));
  const values = [...at].map((value, axis) => scene.origin[axis] + value / scene.scale);
  return `(${values.map((value) => (size < 1e-6 || size > 1e9 ? value.toPrecision(6)
    : String(Number(value.toFixed(digits))))).join(', ')})`;
}

export const place = ({ scene, contacts }, k) => `at ${point(scene, contacts.focus(k))}`;

// "at (1, 2, 3)", where the two share a point; else around where they touch.
export function rowPlace({ scene, rows, curves }, r) {
  const curve = curves.ofRow.get(r);
  return curve === undefined ? `around ${point(scene, rows.center(r))}` : `at ${point(scene, curves.place(curve))}`;
}

// "at most 18 pairs of triangles, at frame 7"; empty where nobody counted.
export function rowMost({ scene, rows }, r) {
  const most = rows.mostPairs(r);
  return most === 0 ? '' : `at most ${number(most)} pair${most === 1 ? '' : 's'} of triangles, at ${scene.steps.noun} ${number(rows.mostStep(r))}`;
}

// "car 3 and house_1: 0.0123 m at frame 35; near in frames 20 to 41; from (1, 2, 3) to (1, 2, 3.0123)"
export function gapWords({ scene, gaps }, g) {
  const one = scene.steps.count < 2;
  const at = one ? '' : ` at ${scene.steps.noun} ${number(gaps.nearest(g))}`;
  const lasting = gaps.begin(g) < gaps.end(g) ? [`near in ${span(scene, gaps.begin(g), gaps.end(g))}`] : [];
  return [`${bodyName(scene, gaps.a(g))} and ${bodyName(scene, gaps.b(g))}: ${gaps.lengths[g]}${at}`, ...lasting,
    `from ${point(scene, gaps.point(g, 0))} to ${point(scene, gaps.point(g, 1))}`].join('; ');
}

// "triangles 3, 5 and 4,711"
export function triangles({ contacts }, k) {
  const a = contacts.triangles(k, 0);
  const b = contacts.triangles(k, 1);
  if (a.length + b.length === 0) {
    return '';
  }
  const left = contacts.pairsInAll(k) - contacts.pairCount(k);
  return `triangles ${some(a, 3)} and ${some(b, 3)}`
    + (left > 0 ? `; ${number(left)} more pairs of triangles are not on this page` : '');
}

// What of a row is not in the page, and so not in the picture; empty where nothing is missing.
export function missing(all, r) {
  const left = all.rows.total(r) - all.rows.contacts(r).length;
  if (left === 0) {
    return '';
  }
  const numbers = [0, 1].map((which) => all.rows.triangle(r, which)).filter((t) => t !== undefined);
  const first = all.rows.contacts(r).length > 0 || numbers.length === 0 ? ''
    : `; the first: triangle${numbers.length > 1 ? 's' : ''} ${numbers.map(number).join(' and ')}`;
  return `${counted(all, left)} not on this page, so not drawn${first}`;
}

// 12,345 as 12345, wherever it stands.
const ungrouped = (text) => text.replace(/(\d),(?=\d{3})/g, '$1');

const searchable = (text) => {
  const small = text.toLowerCase();
  return `${small} ${ungrouped(small)}`;
};

// Everything that can be searched for in a contact, in small letters; numbers with commas and without.
export function haystack(all, k) {
  const plain = [...all.contacts.triangles(k, 0), ...all.contacts.triangles(k, 1)].join(' ');
  return searchable(`#${k} ${title(all, k)} ${plain} ${when(all, k)}`);
}

// The same of a row.
export function rowHaystack(all, r) {
  const numbers = [0, 1].map((which) => all.rows.triangle(r, which) ?? '').join(' ');
  return searchable(`${rowTitle(all, r)} ${rowPaths(all, r)} ${numbers} ${rowWhen(all, r)}`);
}

// Whether a text holds every word of a query. Commas may be those of a name, of a number or of a list.
export function holds(hay, query) {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  return words.every((word) => hay.includes(word) || hay.includes(ungrouped(word).replace(/,+$/, '')));
}

export function moment({ scene }, step) {
  const { count, noun, second } = scene.steps;
  const time = second > 0 ? `, ${(step / second).toFixed(2)} s` : '';
  return `${noun} ${number(Math.floor(step))} of ${number(count)}${time}`;
}

const rowsWhere = (rows, accept) => {
  let found = 0;
  for (let r = 0; r < rows.count; ++r) {
    found += accept(r) ? 1 : 0;
  }
  return found;
};

const nouns = new WeakMap();

// What rows are: "pairs of parts" or "pairs of bodies"; where movers touch parts and each other, both.
export function rowNoun({ rows, scene }, count) {
  if (scene.row.one) {
    return `${number(count)} ${count === 1 ? scene.row.one : scene.row.many}`;
  }
  if (!nouns.has(rows)) {
    const ofParts = rowsWhere(rows, (r) => rows.part(r, 0) !== NO_PART || rows.part(r, 1) !== NO_PART);
    nouns.set(rows, ofParts === 0 ? 'bodies' : ofParts === rows.count ? 'parts' : 'parts or bodies');
  }
  return `${number(count)} pair${count === 1 ? '' : 's'} of ${nouns.get(rows)}`;
}

// "All 260 pairs of parts that touch; 13,252 pairs of triangles in all", or what is known of them.
export function counts(all, shown) {
  const { rows, scene } = all;
  if (rows.count === 0) {
    return scene.complete ? 'Nothing touches.' : 'Nothing found so far.';
  }
  const which = shown < rows.count ? `${number(shown)} of ` : '';
  const inAll = counted(all, scene.contacts.all);
  const one = rows.count === 1;
  return scene.complete ? `${which || (one ? '' : 'All ')}${rowNoun(all, rows.count)}${scene.row.one ? '' : one ? ' that touches' : ' that touch'}; ${inAll} in all`
    : `${which}${rowNoun(all, rows.count)} and ${inAll} found so far; there may be more`;
}

// "spread over all 260 pairs of parts"; where there are more rows than contacts, "of 10,000 of 14,400 ...".
function spread(all) {
  const { rows } = all;
  const held = rowsWhere(rows, (r) => rows.contacts(r).length > 0);
  return held < rows.count ? `from ${number(held)} of ${rowNoun(all, rows.count)}`
    : `spread over all ${rowNoun(all, rows.count)}`;
}

// "Drawn: 7,462 of 13,252 pairs of triangles, ..."; empty where all are.
export function notDrawn(all) {
  const { listed, all: inAll, many } = all.scene.contacts;
  return listed < inAll ? `Drawn: ${number(listed)} of ${number(inAll)} ${many}, ${spread(all)}` : '';
}

export function trianglesDrawn({ models }) {
  const sum = (key) => models.reduce((total, model) => total + model[key], 0);
  return `Drawn: ${number(sum('drawn'))} of ${number(sum('triangles'))} triangles${sum('drawn') < sum('triangles')
    ? ' (simplified far from contacts; the answers are exact)' : ''}`;
}

export function whatIsDrawn(all) {
  const { scene } = all;
  const parts = [trianglesDrawn(scene)];
  const { listed, all: inAll, many } = scene.contacts;
  if (all.rows.count > 0) {
    parts.push(`listed: ${counts(all, all.rows.count).replace(/^All/, 'all')}`);
  }
  if (listed < inAll) {
    parts.push(`${number(listed)} of the ${number(inAll)} ${many} are on this page, ${spread(all)}`);
  }
  if (scene.bodies.names.length < scene.bodies.all) {
    parts.push(`bodies: ${number(scene.bodies.names.length)} of ${number(scene.bodies.all)}`);
  }
  if (scene.gaps.listed < scene.gaps.all) {
    parts.push(`gaps: the nearest ${number(scene.gaps.listed)} of ${number(scene.gaps.all)}`);
  }
  const { kept, count, noun, smooth } = scene.steps;
  if (kept.length < count) {
    parts.push(`poses: those of ${number(kept.length)} of ${number(count)} ${noun}s${smooth
      ? ', interpolated in between; where a contact begins they are exact' : ''}`);
  }
  return `${parts.join('; ')}.`;
}

const pairsOf = (count) => `${number(count)} pair${count === 1 ? '' : 's'} of triangles`;

const MOST_TOUCHED = 5; // bodies that are named

// A length in four digits.
export const inDigits = (length) => String(Number(length.toPrecision(4)));

// What a moved body touches, or how near it is: "car 3 touches house_1: 12 pairs of triangles". `left` bodies were left out.
export function liveAnswer({ scene }, body, { touched, gap }, { left, known = Infinity }) {
  const name = bodyName(scene, body);
  if (known <= 0) {
    return `${name} is where this page does not hold all exact triangles: what it touches is not known here`;
  }
  if (touched.length === 0 && !gap && known < Infinity) {
    return `${name} touches nothing${left > 0 ? ' that it is compared with' : ''}; the nearest is at least ${inDigits(0.999 * known)} away`;
  }
  if (touched.length === 0) {
    return `${name} touches nothing${left > 0 ? ' that it is compared with' : ''}${gap ? `: ${inDigits(gap.lower)} from ${bodyName(scene, gap.body)}` : ''}`;
  }
  if (touched.length === 1) {
    return `${name} touches ${bodyName(scene, touched[0].body)}: ${pairsOf(touched[0].pairs)}`;
  }
  const most = [...touched].sort((a, b) => b.pairs - a.pairs);
  const named = most.slice(0, MOST_TOUCHED).map((other) => `${bodyName(scene, other.body)} (${number(other.pairs)})`);
  const inAll = touched.reduce((sum, { pairs }) => sum + pairs, 0);
  return `${name} touches ${named.join(', ')}${most.length > named.length ? ` and ${number(most.length - named.length)} more` : ''}: ${pairsOf(inAll)}`;
}

// Where a moved body is; its pose follows. `unsaid` is another one, whose pose does not.
export function liveWhere({ scene }, body, isRecorded, isExact, unsaid) {
  const stays = unsaid < 0 ? '' : ` ${bodyName(scene, unsaid)} stays where the report has it, at a pose without a short form.`;
  return `${bodyName(scene, body)} is ${isRecorded ? 'where the report has it' : 'moved'}${isRecorded && !isExact ? ', rounded' : ''}.${stays}`;
}

// What a moved body is compared with, where that is not all that is seen.
export function liveOthers(all, others, left) {
  return left === 0 ? '' : `Compared with ${number(others)} ${others === 1 ? 'body' : 'bodies'}; the other movers (${number(left)}) are left out, as this page holds their poses rounded.`;
}
