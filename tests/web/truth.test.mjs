// The truth sets in node. WEB_PACKAGE: folder of the package; WEB_DATA: what prepare.py made.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { checkTruth, hashOf } from './truth.mjs';

const soms = await import(pathToFileURL(join(process.env.WEB_PACKAGE, 'soms.js')));
const CASES = 500;

test('the hash is that of the sets', () => {
  assert.equal(hashOf([]), 'cbf29ce484222325');
});

test('answers are those of the truth sets', async () => {
  await soms.load();
  assert.equal(soms.instructionSet(), 'simd128');
  const { checks, sets, faults } = await checkTruth(soms, (path) => readFile(join(process.env.WEB_DATA, path)), CASES);
  assert.deepEqual(faults, []);
  assert.ok(sets.overlaps >= 4 * CASES, `only ${sets.overlaps} checks of overlaps`);
  assert.ok(sets.shifts >= 2 * CASES && sets.paths > 200, `only ${sets.shifts} checks of shifts, ${sets.paths} of paths`);
  console.log(`${checks} checks: ${JSON.stringify(sets)}`);
});
