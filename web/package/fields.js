// Written by tools/fields.py from the lists of fields in C++.
/** Names of the codes that answers of batches hold. */
export const NAMES = Object.freeze({
  coverage: Object.freeze(['complete', 'first', 'cut']),
  relation: Object.freeze(['clear', 'touching', 'crossing', 'a_in_b', 'b_in_a', 'same', 'undecided']),
  why: Object.freeze(['none', 'deadline', 'open']),
  side: Object.freeze(['outside', 'inside', 'on', 'undecided']),
  feature: Object.freeze(['vertex', 'edge', 'face']),
  kind: Object.freeze(['enter', 'leave', 'graze']),
  verdict: Object.freeze(['free', 'contact', 'grazing', 'started']),
});

/** Columns of answers in order, each with what it is in a single answer; their cost is last. */
export const FIELDS = Object.freeze({
  Overlap: 'any:flag pairs coverage:name',
  OverlapBatch: 'any offsets pairs coverage',
  Distance: 'lower:number upper:number farther:flag triangles:pair pointA:point pointB:point coverage:name',
  Within: 'within:flag atLeast:number triangles:pair pointA:point pointB:point coverage:name',
  Solid: 'relation:name surfacesMeet:flag why:name coverage:name',
  Contains: 'side:name coverage:name',
  Closest: 'lower:number upper:number farther:flag triangle:triangle point:point feature:name coverage:name',
  NearTriangles: 'offsets triangle lower upper coverage',
  Winding: 'side:name lower:number upper:number coverage:name',
  ClosestHit: 'lower:number upper:number triangle:triangle point:point front:flag coverage:name',
  AnyHit: 'hit:flag coverage:name',
  AllHits: 'offsets lower upper kind triangleOffsets triangle coverage',
  FirstContact: 'verdict:name lower:number upper:number triangles:pair point:point normal:vector coverage:name',
});
