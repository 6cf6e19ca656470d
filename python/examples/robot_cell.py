"""A robot arm against its cell: which of many positions are free, and how near do they come?

    robot_cell.py [POSITIONS]

The arm has a shoulder, an elbow and two beams. Its links are placed for all positions at once, and
each is one call.
"""
import sys

import numpy as np

import soms

BEAM = np.array([[0, -0.1, -0.1], [1, -0.05, -0.05], [1, 0.05, -0.05], [1, 0, 0.05],
                 [0, 0.1, -0.1], [0, 0, 0.1]])
FACES = np.array([[0, 4, 5], [1, 3, 2], [0, 1, 2], [0, 2, 4], [4, 2, 3], [4, 3, 5], [5, 3, 1],
                  [5, 1, 0]])


def rotations(angles):
    """(n, 4, 4): about +z by angles in radians."""
    matrices = np.tile(np.eye(4), (len(angles), 1, 1))
    matrices[:, 0, 0] = matrices[:, 1, 1] = np.cos(angles)
    matrices[:, 1, 0] = np.sin(angles)
    matrices[:, 0, 1] = -matrices[:, 1, 0]
    return matrices


def cell():
    """A wall, and a ball on a stand."""
    wall = soms.Mesh([[1.8, -3, -3], [1.8, 3, -3], [1.8, 3, 3], [1.8, -3, 3]], [[0, 1, 2], [0, 2, 3]])
    ball = soms.generate("sphere", 800)
    return [soms.Body(wall, name="wall"), soms.Body(ball, [-1.5, 1.5, 0], name="ball")]


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    numbers = np.random.default_rng(1)
    shoulder = rotations(numbers.uniform(-np.pi, np.pi, count))
    forearm = shoulder @ rotations(numbers.uniform(-2.5, 2.5, count))
    forearm[:, :, 3] = shoulder[:, :, 0] + shoulder[:, :, 3]  # from the end of the upper arm

    beam = soms.Shape(soms.Mesh(BEAM, FACES))
    free = np.ones(count, dtype=bool)
    gap = np.full(count, np.inf)
    for body in cell():
        for link in (shoulder, forearm):
            free &= ~soms.overlap(beam, body, link, mode="any", threads=0).any
            gap = np.minimum(gap, soms.distance(beam, body, link, threads=0).lower)
    assert ((gap > 0) == free).all()
    print(f"{np.count_nonzero(free)} of {count} positions are free")
    print(f"{np.count_nonzero(gap > 0.1)} keep 0.1 m from everything")


if __name__ == "__main__":
    main()
