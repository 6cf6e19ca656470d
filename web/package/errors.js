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

export function usage(place, remedy) {
  return new SomsError('usage', place, remedy);
}
