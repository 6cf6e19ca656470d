// Where the picture is seen from: a point that is looked at, two angles and a distance.
const FIELD = Math.tan(Math.PI / 8);  // half the height of the picture at distance 1

export class Camera {
  target = [0, 0, 0];
  distance = 10;
  yaw = 0.6;
  pitch = 0.45;

  /** Looks at all of a box, with room for the panels above and below. */
  fit(lower, upper, aspect) {
    this.target = lower.map((x, k) => (x + upper[k]) / 2);
    this.size = Math.hypot(...lower.map((x, k) => upper[k] - x)) || 1;
    const [right, up, back] = this.axes();
    this.distance = 0.1 * this.size;
    for (let corner = 0; corner < 8; ++corner) {
      const at = this.target.map((x, k) => (corner >> k & 1 ? upper[k] : lower[k]) - x);
      const along = (axis) => axis.reduce((sum, a, k) => sum + a * at[k], 0);
      const across = Math.max(Math.abs(along(right)) / (0.98 * aspect), Math.abs(along(up)) / 0.78);
      this.distance = Math.max(this.distance, along(back) + across / FIELD);
    }
  }

  orbit(dx, dy) {
    this.yaw -= 0.008 * dx;
    this.pitch = Math.min(1.55, Math.max(-1.55, this.pitch + 0.008 * dy));
  }

  zoom(steps) {
    this.distance = Math.min(20 * this.size, Math.max(0.02 * this.size, this.distance * 1.0015 ** steps));
  }

  /** Unit vectors to the right, up and toward the eye; z is up. */
  axes() {
    const [cy, sy, cp, sp] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    return [[cy, sy, 0], [-sy * sp, cy * sp, cp], [sy * cp, -cy * cp, sp]];
  }

  eye() {
    const back = this.axes()[2];
    return this.target.map((x, k) => x + this.distance * back[k]);
  }

  /** The ray through a place of the picture, each coordinate from -1 to 1. */
  ray(x, y, aspect) {
    const [right, up, back] = this.axes();
    return { origin: this.eye(),
             direction: right.map((r, k) => FIELD * (aspect * x * r + y * up[k]) - back[k]) };
  }

  /** Length at a point of what is one pixel long in a picture so many pixels high. */
  pixel(point, height) {
    const [eye, back] = [this.eye(), this.axes()[2]];
    const depth = eye.reduce((sum, x, k) => sum + (x - point[k]) * back[k], 0);
    return 2 * FIELD * depth / height;
  }

  /** The matrix for WebGL, by columns, of points moved by a pose: 12 numbers by rows. */
  matrix(pose, center, aspect) {
    const axes = this.axes();
    const eye = this.eye();
    const near = this.distance * 0.01;
    const far = this.distance + 3 * this.size;
    const rows = axes.map((axis) => [0, 1, 2, 3].map((j) => axis.reduce((sum, a, k) => {
      const moved = j < 3 ? pose[4 * k + j]
                          : pose[4 * k + 3] + pose[4 * k] * center[0] + pose[4 * k + 1] * center[1] + pose[4 * k + 2] * center[2] - eye[k];
      return sum + a * moved;
    }, 0)));
    const columns = new Float32Array(16);
    for (let j = 0; j < 4; ++j) {
      const depth = rows[2][j];
      columns.set([rows[0][j] / (FIELD * aspect), rows[1][j] / FIELD,
                   (depth * (far + near) + (j === 3 ? 2 * far * near : 0)) / (near - far), -depth], 4 * j);
    }
    return columns;
  }
}
