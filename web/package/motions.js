// First contacts on the way from one pose to another.
import { columnsOf, firstOf, timeOf } from './answers.js';
import { motions as motionsOf } from './arrays.js';
import { number, usage } from './errors.js';
import { placed } from './meshes.js';
import { query } from './module.js';

function contacts(mover, motions, fixed, options) {
  const numbers = motionsOf(motions);
  return columnsOf('FirstContact', query('soms_first_contact', placed(mover, 'the mover')[0], numbers,
                                         numbers.length / 28, ...placed(fixed, 'the fixed body'),
                                         number(options.within ?? 0, 'within', 0), options.parting ? 1 : 0, timeOf(options)));
}

/** When a moving body first touches another, proved for all times of the way. */
export function firstContact(mover, motion, fixed, options = {}) {
  return firstOf('FirstContact', contacts(mover, [motion], fixed, options));
}

export function firstContactBatch(mover, motions, fixed, options = {}) {
  return contacts(mover, motions, fixed, options);
}

/** Where a motion is at a part t of the way: 12 numbers, the rows of [R | t]. */
export function poseAt(motion, t) {
  if (!(number(t, 't', 0) <= 1)) {
    throw usage(`t is ${t}`, 'give a part of the way, from 0 to 1');
  }
  return query('soms_pose_at', motionsOf([motion]), t)[0];
}
