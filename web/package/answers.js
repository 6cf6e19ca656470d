// Answers as callers see them.
import { number } from './errors.js';
import { FIELDS, NAMES } from './fields.js';

function costOf([nodeTests, triangleTests, exactTests]) {
  return { nodeTests, triangleTests, exactTests };
}

const SINGLE = {
  flag: ([code]) => code === 1,
  number: ([value]) => value,
  name: ([code], field) => NAMES[field][code],
  point: (numbers) => numbers.slice(0, 3),
  vector: (numbers) => (Number.isNaN(numbers[0]) ? null : numbers.slice(0, 3)),
  triangle: ([triangle]) => (triangle < 0 ? null : triangle),
  pair: ([a, b]) => (a < 0 ? null : [a, b]),
};

/** Number k of a column, by its name. */
export function nameOf(field, codes, k = 0) {
  return NAMES[field][codes[k]];
}

/** What a query's columns are called: those of answers `type`, and their cost. */
export function columnsOf(type, columns) {
  const names = FIELDS[type].split(' ');
  const found = Object.fromEntries(names.map((field, k) => [field.split(':')[0], columns[k]]));
  return { ...found, cost: costOf(columns[names.length]) };
}

/** The only answer in columns; lists stay. */
export function firstOf(type, columns) {
  const found = { ...columns };
  for (const field of FIELDS[type].split(' ')) {
    const [name, kind] = field.split(':');
    if (kind) {
      found[name] = SINGLE[kind](columns[name], name);
    }
  }
  return found;
}

/** A limit of time in milliseconds; none by default. `timeLimit` is its old name. */
export function timeOf(options) {
  return number(options.timeout ?? options.timeLimit ?? Infinity, 'timeout');
}

/** What is farther does not count. */
export function atMostOf(options) {
  return number(options.atMost ?? Infinity, 'atMost');
}
