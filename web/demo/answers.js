// Answers for where the body is now: one question at a time, and always the latest one.
const MOST_DRAWN = 20000;  // pairs whose common points are looked up

/** Segments of what pairs of triangles have in common: points, segments, and outlines of areas. */
function segmentsOf({ offsets, points }) {
  const ends = [];
  for (let k = 0; k + 1 < offsets.length; ++k) {
    const [first, end] = [offsets[k], offsets[k + 1]];
    for (let n = first; n < end && (n === first || n + 1 < end || end - first > 2); ++n) {
      const next = n + 1 < end ? n + 1 : first;
      ends.push(...points.subarray(3 * n, 3 * n + 3), ...points.subarray(3 * next, 3 * next + 3));
    }
  }
  return Float32Array.from(ends);
}

export class Answers {
  #remote;
  #busy = false;
  #wanted = null;

  /** `onAnswer` gets {pose, pairs, count, gap, segments, line, milliseconds}; `onError` an error. */
  constructor(remote, onAnswer, onError) {
    this.#remote = remote;
    this.onAnswer = onAnswer;
    this.onError = onError;
  }

  /** What touches at this pose? A question that waits gives way. */
  want(fixed, moved, pose) {
    this.#wanted = { fixed, moved, pose };
    if (!this.#busy) {
      this.#run();
    }
  }

  async #run() {
    this.#busy = true;
    while (this.#wanted !== null) {
      const { fixed, moved, pose } = this.#wanted;
      this.#wanted = null;
      try {
        this.onAnswer(await this.#answer(fixed, { shape: moved, pose }, pose));
      } catch (error) {
        this.onError(error);
      }
    }
    this.#busy = false;
  }

  async #answer(fixed, body, pose) {
    const began = performance.now();
    const { pairs, any } = await this.#remote.overlap(body, fixed);
    const answer = { pose, count: pairs.length / 2, gap: 0, line: null, segments: new Float32Array() };
    if (any) {
      answer.segments = segmentsOf(await this.#remote.crossings(body, fixed, pairs.subarray(0, 2 * MOST_DRAWN)));
    } else {
      const { lower, pointA, pointB } = await this.#remote.distance(body, fixed);
      answer.gap = lower;
      answer.line = Float32Array.of(...pointA, ...pointB);
    }
    answer.milliseconds = performance.now() - began;
    return answer;
  }
}
