"""Which of a million points are inside a model?

    inside_or_not.py [POINTS]
"""
import sys

import numpy as np

import soms


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    statue = soms.ClosedBody(soms.Body(soms.generate("statue", 20_000)))
    lower, upper = statue.body.shape.mesh.bounds
    points = np.random.default_rng(1).uniform(lower, upper, (count, 3))
    side = soms.contains(statue, points, threads=0).side
    inside = np.count_nonzero(side == soms.Side.inside)
    print(f"{inside} of {count} points are inside, {np.count_nonzero(side == soms.Side.on)} on it")
    volume = np.prod(upper - lower) * inside / count
    print(f"so its volume is about {volume:.3f}")


if __name__ == "__main__":
    main()
