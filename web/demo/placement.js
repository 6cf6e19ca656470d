// Where the moved body is: a unit quaternion about its center, and where that center is.

export class Placement {
  constructor(center, at) {
    this.center = center;  // of the body, not moved
    this.home = at;
    this.reset();
  }

  reset() {
    this.at = [...this.home];
    this.turned = [1, 0, 0, 0];
  }

  move(by) {
    this.at = this.at.map((x, k) => x + by[k]);
  }

  /** Turns it about an axis through its center. */
  turn(axis, angle) {
    const [s, c] = [Math.sin(angle / 2), Math.cos(angle / 2)];
    const [a, [b0, b1, b2, b3]] = [[c, ...axis.map((x) => s * x)], this.turned];
    const product = [
      a[0] * b0 - a[1] * b1 - a[2] * b2 - a[3] * b3, a[0] * b1 + a[1] * b0 + a[2] * b3 - a[3] * b2,
      a[0] * b2 - a[1] * b3 + a[2] * b0 + a[3] * b1, a[0] * b3 + a[1] * b2 - a[2] * b1 + a[3] * b0,
    ];
    const length = Math.hypot(...product);
    this.turned = product.map((x) => x / length);
  }

  /** The rows of [R | t]. By the formula of soms, so that the command answers for the same numbers. */
  pose() {
    const [w, x, y, z] = this.turned;
    const s = 2 / (((w * w + x * x) + y * y) + z * z);
    const rotation = [
      [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
      [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
      [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)],
    ];
    return Float64Array.from(rotation.flatMap((row, k) => [
      ...row, this.at[k] - row.reduce((sum, r, j) => sum + r * this.center[j], 0)]));
  }

  #numbers() {
    const pose = this.pose();
    return [pose[3], pose[7], pose[11], ...this.turned];
  }

  /** The same as the command takes it: x y z qw qx qy qz. */
  text() {
    return this.#numbers().join(' ');
  }

  /** Five digits of each, without the rotation where there is none. */
  shortText() {
    const numbers = this.turned[0] === 1 ? this.#numbers().slice(0, 3) : this.#numbers();
    return numbers.map((x) => Number(x.toPrecision(5))).join(' ');
  }
}
