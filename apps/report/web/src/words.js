// What the page says about contacts and steps.

export const number = (value) => value.toLocaleString('en');

const some = (values, most) => values.slice(0, most).map(number).join(', ')
  + (values.length > most ? ', ...' : '');

export function bodyName(scene, body) {
  return scene.bodies.names[body];
}

// The only thing that stands still needs no name beside those of its parts.
function side(scene, body, part) {
  const name = bodyName(scene, body);
  if (!part || part === name) {
    return name;
  }
  const alone = scene.bodies.moves.length - scene.moving === 1;
  return !scene.bodies.moves[body] && alone ? part : `${name} (${part})`;
}

// "car 12 (hull) touches house_31"
export function title({ scene, contacts }, k) {
  return `${side(scene, contacts.a(k), contacts.part(k, 0))} touches ${side(scene, contacts.b(k), contacts.part(k, 1))}`;
}

export function when({ scene, contacts }, k) {
  const { noun, count } = scene.steps;
  if (count < 2) {
    return '';
  }
  const begin = contacts.begin(k);
  const end = contacts.end(k);
  return begin === end ? `${noun} ${number(begin)}` : `${noun}s ${number(begin)} to ${number(end)}`;
}

// "triangles 3, 5 and 4,711"
export function triangles({ contacts }, k) {
  const a = contacts.triangles(k, 0);
  const b = contacts.triangles(k, 1);
  if (a.length + b.length === 0) {
    return '';
  }
  return `triangle${a.length > 1 ? 's' : ''} ${some(a, 3)} and ${some(b, 3)}`;
}

// 12,345 as 12345, wherever it stands.
const ungrouped = (text) => text.replace(/(\d),(?=\d{3})/g, '$1');

// Everything that can be searched for, in small letters; numbers with commas and without.
export function haystack(all, k) {
  const plain = [...all.contacts.triangles(k, 0), ...all.contacts.triangles(k, 1)].join(' ');
  const text = `#${k} ${title(all, k)} ${plain} ${when(all, k)}`.toLowerCase();
  return `${text} ${ungrouped(text)}`;
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

export function whatIsDrawn({ scene }) {
  const sum = (key) => scene.models.reduce((all, model) => all + model[key], 0);
  const parts = [`Drawn: ${number(sum('drawn'))} of ${number(sum('triangles'))} triangles`];
  if (sum('drawn') < sum('triangles')) {
    parts[0] += ' (simplified away from the contacts; the answers are not)';
  }
  const { listed, all } = scene.contacts;
  parts.push(listed < all
    ? `listed: ${number(listed)} of ${number(all)} contacts`
    : `listed: ${listed === 1 ? 'the one contact' : `all ${number(all)} contacts`}`);
  if (scene.bodies.names.length < scene.bodies.all) {
    parts.push(`bodies: ${number(scene.bodies.names.length)} of ${number(scene.bodies.all)}`);
  }
  const { kept, count, noun, smooth } = scene.steps;
  if (kept.length < count) {
    parts.push(`poses: of ${number(kept.length)} of ${number(count)} ${noun}s${smooth
      ? ', in between they are interpolated; where a contact begins they are exact' : ''}`);
  }
  return `${parts.join('; ')}.`;
}
