// Lines of six floats in the order of the curves that they make.

// Ends that have the same place, to within `least`.
function keyOf(lines, at, least) {
  return `${Math.round(lines[at] / least)},${Math.round(lines[at + 1] / least)},${Math.round(lines[at + 2] / least)}`;
}

// The same lines, each followed by one that goes on where it ends: dashes that are counted along them do not begin
// again with each line.
export function chained(lines, least) {
  const count = lines.length / 6;
  const keys = Array.from({ length: 2 * count }, (_, end) => keyOf(lines, 3 * end, least));
  const endsAt = new Map();
  keys.forEach((key, end) => (endsAt.get(key) ?? endsAt.set(key, []).get(key)).push(end));
  const used = new Uint8Array(count);
  const freeAt = (key) => {
    const ends = endsAt.get(key);
    while (ends.length > 0 && used[ends.at(-1) >> 1]) {
      ends.pop();
    }
    return ends.pop();
  };
  const sorted = new Float32Array(lines.length);
  let at = 0;
  const follow = (first) => {
    for (let end = first; end !== undefined; end = freeAt(keys[end ^ 1])) {
      used[end >> 1] = 1;
      sorted.set(lines.subarray(3 * end, 3 * end + 3), at);
      sorted.set(lines.subarray(3 * (end ^ 1), 3 * (end ^ 1) + 3), at + 3);
      at += 6;
    }
  };
  // Open curves from their ends, then those that close.
  keys.forEach((key, end) => { if (!used[end >> 1] && endsAt.get(key).length === 1) { follow(end); } });
  used.forEach((_, line) => { if (!used[line]) { follow(2 * line); } });
  return sorted;
}
