// Poses as soms has them: 12 doubles, the rows of [R | t].

const DIGITS = 9; // of a turning that a hand made, and of places in units of what the scene shows

// The same doubles as Pose::from_quaternion, operation by operation. `turn` is x, y, z, w.
export function poseOf([x, y, z, w], t) {
  const norm = ((w * w + x * x) + y * y) + z * z;
  const s = 2 / norm;
  return [
    1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), t[0],
    s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x), t[1],
    s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y), t[2],
  ];
}

// The rotation of a pose as a quaternion x, y, z, w of length 1, with w >= 0.
export function turnOf(m) {
  const squares = [
    1 + m[0] - m[5] - m[10], 1 - m[0] + m[5] - m[10], 1 - m[0] - m[5] + m[10], 1 + m[0] + m[5] + m[10],
  ];
  const most = squares.indexOf(Math.max(...squares));
  const turn = [
    [squares[0], m[1] + m[4], m[2] + m[8], m[9] - m[6]],
    [m[1] + m[4], squares[1], m[6] + m[9], m[2] - m[8]],
    [m[2] + m[8], m[6] + m[9], squares[2], m[4] - m[1]],
    [m[9] - m[6], m[2] - m[8], m[4] - m[1], squares[3]],
  ][most];
  const length = Math.hypot(...turn) * (turn[3] < 0 ? -1 : 1);
  return turn.map((part) => part / length);
}

// A turning in few digits, so that a reader can copy it; poseOf makes a rotation of it to the last bits.
export const roundedTurn = (turn) => turn.map((part) => Number(part.toFixed(DIGITS)) + 0);

// A coordinate in as few digits as show a millionth of `size`.
export function roundedPlace(value, size) {
  const digits = 6 - Math.floor(Math.log10(size));
  return digits >= 0 && digits <= 100 ? Number(value.toFixed(digits)) + 0 : value;
}

export const shiftOf = (m) => [m[3], m[7], m[11]];

export const moved = (m, [x, y, z]) => [0, 4, 8].map((at) => ((m[at] * x + m[at + 1] * y) + m[at + 2] * z) + m[at + 3]);

// What --pose of soms takes: "x y z" or "x y z qw qx qy qz".
export const argumentFrom = (t, [x, y, z, w]) => [...t, ...(w === 1 ? [] : [w, x, y, z])].join(' ');

// The same for exactly this pose; null where no such numbers are found.
export function argumentOf(m) {
  const turn = [turnOf(m), roundedTurn(turnOf(m))].find((some) => poseOf(some, shiftOf(m)).every((value, k) => value === m[k]));
  return turn ? argumentFrom(shiftOf(m), turn) : null;
}
