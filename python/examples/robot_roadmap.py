"""Edges of a roadmap of a robot of six links in a cell: proved one by one, beside samples of them.

    robot_roadmap.py [EDGES [TRIANGLES [STEP]]]

An edge goes from a free state by STEP radians or less of each joint. Samples are taken ever closer until they find every
edge that is proved to be blocked; the time of the closest ones is given. Thirty million samples at most are tried.
"""
import sys
import time

import numpy as np

import soms
from robot_path import knots, six_links

MOST = 30_000_000


def free_states(model, count, rng):
    found = []
    while sum(map(len, found)) < count:
        states = rng.uniform(-2.4, 2.4, (1000, 6))
        found.append(states[soms.robot_contacts(model, states, first_contact=True).free])
    return np.concatenate(found)[:count]


def proved(model, starts, ends):
    """Which edges are free: each is a path of two states."""
    return np.array([soms.robot_path(model, np.stack(edge)).free[0] for edge in zip(starts, ends)])


def sampled(model, starts, ends, samples):
    """Which edges have no sample in contact, both ends among them."""
    parts = np.linspace(0, 1, samples)[:, None]
    return np.array([soms.robot_contacts(model, a + parts * (b - a), first_contact=True).free.all()
                     for a, b in zip(starts, ends)])


def timed(function, *given):
    begin = time.process_time()
    found = function(*given)
    return found, time.process_time() - begin


def main():
    given = sys.argv[1:] + [None] * 3
    count, triangles, step = int(given[0] or 100_000), int(given[1] or 300_000), float(given[2] or 0.2)
    rng = np.random.default_rng(2)
    model = soms.RobotModel(six_links(), knots(triangles, rng))
    starts = free_states(model, count, rng)
    ends = starts + rng.uniform(-step, step, starts.shape)
    free, seconds = timed(proved, model, starts, ends)
    print(f"{count:,} edges: {np.count_nonzero(free):,} free, {count / seconds:,.0f} edges a second")
    samples = 2
    while samples * count <= MOST:
        found, took = timed(sampled, model, starts, ends, samples)
        assert not np.any(free & ~found), "an edge that is proved free has a sample in contact"
        missed = np.count_nonzero(found & ~free)
        print(f"{samples} samples an edge: {missed:,} blocked edges missed, {took / seconds:.1f} times as long")
        if missed == 0:
            break
        samples = 2 * samples - 1


if __name__ == "__main__":
    main()
