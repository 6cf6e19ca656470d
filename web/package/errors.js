/** Every error of soms: what kind, at what place, and what to do about it. */
export class SomsError extends Error {
  constructor(kind, place, remedy) {
    super(remedy === '' ? place : `${place}; ${remedy}`);
    this.name = 'SomsError';
    this.kind = kind;
    this.place = place;
    this.remedy = remedy;
  }
}

/** A number, also an infinite one, that is at least `least`. */
export function number(value, what, least = -Infinity) {
  if (typeof value !== 'number' || !(value >= least)) {
    throw usage(`${what} is ${String(value)}`, least === -Infinity ? 'give a number' : `give a number from ${least} on`);
  }
  return value;
}

export function usage(place, remedy) {
  return new SomsError('usage', place, remedy);
}
