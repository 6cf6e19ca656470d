// Two bodies to begin with, so that there is something to move before a file is dropped.

/** A closed tube around a closed curve: `around` x `along` x 2 triangles. */
function tube(curve, radius, along, around) {
  const vertices = new Float64Array(3 * along * around);
  const triangles = new Uint32Array(6 * along * around);
  for (let i = 0; i < along; ++i) {
    const t = 2 * Math.PI * i / along;
    const [here, next] = [curve(t), curve(t + 1e-4)];
    const forward = unit(next.map((x, k) => x - here[k]));
    const side = unit(cross(forward, unit(here.map((x, k) => x + [0, 0, 3][k]))));
    const up = cross(side, forward);
    for (let j = 0; j < around; ++j) {
      const angle = 2 * Math.PI * j / around;
      const thick = radius * (1 + 0.08 * Math.sin(9 * t) * Math.cos(5 * angle));
      const [c, s] = [thick * Math.cos(angle), thick * Math.sin(angle)];
      vertices.set(here.map((x, k) => x + c * side[k] + s * up[k]), 3 * (i * around + j));
      const [a, b] = [i * around, (i + 1) % along * around];
      const k = (j + 1) % around;
      triangles.set([a + j, b + j, a + k, b + j, b + k, a + k], 6 * (i * around + j));
    }
  }
  return { vertices, triangles };
}

function unit(v) {
  const length = Math.hypot(...v);
  return v.map((x) => x / length);
}

function cross([a, b, c], [x, y, z]) {
  return [b * z - c * y, c * x - a * z, a * y - b * x];
}

const knot = (t) => [(2 + Math.cos(3 * t)) * Math.cos(2 * t), (2 + Math.cos(3 * t)) * Math.sin(2 * t), Math.sin(3 * t)];
const ring = (t) => [1.4 * Math.cos(t), 1.4 * Math.sin(t), 0.2 * Math.sin(2 * t)];

/** Bodies of 50,000 triangles each. */
export const SAMPLES = {
  fixed: { name: 'a knot', mesh: () => tube(knot, 0.45, 500, 50) },
  moved: { name: 'a ring', mesh: () => tube(ring, 0.35, 500, 50) },
};
