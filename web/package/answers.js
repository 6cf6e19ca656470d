// Answers as callers see them.
import { number } from './errors.js';

/** Names of the codes that answers of batches hold. */
export const NAMES = Object.freeze({
  coverage: Object.freeze(['complete', 'first', 'cut']),
  relation: Object.freeze(['clear', 'touching', 'crossing', 'a_in_b', 'b_in_a', 'same', 'undecided']),
  why: Object.freeze(['none', 'deadline', 'open']),
  side: Object.freeze(['outside', 'inside', 'on', 'undecided']),
  feature: Object.freeze(['vertex', 'edge', 'face']),
  kind: Object.freeze(['enter', 'leave', 'graze']),
});

export function costOf([nodeTests, triangleTests, exactTests]) {
  return { nodeTests, triangleTests, exactTests };
}

/** Number k of a column, by its name. */
export function nameOf(names, codes, k = 0) {
  return NAMES[names][codes[k]];
}

/** Three numbers of a column of points. */
export function pointOf(numbers, k = 0) {
  return numbers.slice(3 * k, 3 * k + 3);
}

export function triangleOf(numbers, k = 0) {
  return numbers[k] < 0 ? null : numbers[k];
}

export function pairOf(numbers, k = 0) {
  return numbers[2 * k] < 0 ? null : [numbers[2 * k], numbers[2 * k + 1]];
}

/** A limit of time in milliseconds; none by default. */
export function timeOf(options) {
  return number(options.timeLimit ?? Infinity, 'timeLimit');
}

/** What is farther does not count. */
export function atMostOf(options) {
  return number(options.atMost ?? Infinity, 'atMost');
}
