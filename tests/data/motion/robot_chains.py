#!/usr/bin/env python3
"""Writes robot_chains.csv: chains of joints between two states, whose first contact is found twice.

usage: robot_chains.py > robot_chains.csv

Chains are drawn by chance. The way of each is decided by intervals (robot_chain_proof.py) and again by samples with 60
digits (robot_chain_check.py). A row stays if both are sure; if they disagree, this ends with an error. Near misses and
grazes are ways whose least gap is moved to a millionth to either side. Needs numpy and mpmath.
"""
import random
import sys
from fractions import Fraction as F

import numpy as np

from robot_chain import Chain, Joint
from robot_chain_check import Check
from robot_chain_proof import Proof

QUOTA = {"contact": 60, "self": 30, "free": 50, "miss": 25, "graze": 25, "started": 10}
NEAR = 1e-6


def sixtyfourths(rng, most):
    return rng.randint(-int(64 * most), int(64 * most)) / 64


def tetrahedron(rng, middle, size):
    while True:
        v = [[c + sixtyfourths(rng, size) for c in middle] for _ in range(4)]
        volume = np.linalg.det(np.array(v[1:]) - v[0])
        if abs(volume) > 0.05 * size**3:
            return v if volume > 0 else [v[0], v[2], v[1], v[3]]


def random_joint(rng, k, before):
    kind = rng.choice(["revolute", "continuous", "revolute", "continuous", "prismatic", "fixed" if k else "revolute"])
    q = [rng.randint(-3, 3) for _ in range(4)]
    axis = [rng.randint(-3, 3) for _ in range(3)]
    q, axis = (q if any(q) else [1, 0, 0, 0]), (axis if any(axis) else [0, 0, 1])
    shift = [sixtyfourths(rng, 0.6) for _ in range(3)]
    joint = Joint(kind, q, shift, axis)
    leaders = [i for i, j in enumerate(before) if j.kind != "fixed" and j.mimic < 0]
    if kind != "fixed" and leaders and rng.random() < 0.2:
        joint.mimic, joint.factor, joint.offset = rng.choice(leaders), rng.choice([-1.0, 0.5, -0.75, 1.25]), sixtyfourths(rng, 0.5)
    return joint


def random_chain(rng, kind):
    joints = []
    for k in range(rng.randint(2, 7)):
        joints.append(random_joint(rng, k, joints))
    bodies = [(k, tetrahedron(rng, [sixtyfourths(rng, 0.2) for _ in range(3)], rng.choice([0.25, 0.4])))
              for k in range(len(joints) + 1) for _ in range(2 if rng.random() < 0.15 else 1)]
    cell = rng.randint(0, 1) if kind == "self" else rng.randint(1, 3)
    bodies += [(-1, tetrahedron(rng, [sixtyfourths(rng, 1.5) for _ in range(3)], 0.5)) for _ in range(cell)]
    start = [sixtyfourths(rng, 2.5) for j in joints if j.kind != "fixed" and j.mimic < 0]
    step = rng.choice([0.25, 1, 2])
    return Chain(joints, bodies, start, [x + sixtyfourths(rng, step) for x in start])


def start_gap(check):
    return min((check.gaps(p, [0.0])[0][0] for p in check.chain.pairs()), default=1)


def moved_to(chain, gap):
    """The chain with its least gap at an inner time moved to `gap`, or None."""
    for _ in range(4):
        check, best = Check(chain), None
        times = np.linspace(0, 1, 1025)
        frames = check.frames(times)
        for pair in chain.pairs():
            gaps = check.gaps(pair, times, frames)[0]
            if gaps.min() <= -1e-3:
                return None
            k = int(gaps.argmin())
            if 50 < k < 975 and (best is None or gaps[k] < best[1]):
                t, g = times[k], gaps[k]
                for found in check.least(pair, gaps):
                    t, g = min((t, g), found, key=lambda p: p[1])
                best = (pair, g, t)
        if best is None or best[1] > 0.3:
            return None
        pair, g, t = best
        axis = check.gaps(pair, [t])[1][0]  # from the second body to the first
        link = chain.bodies[pair[1]][0]
        if link >= 0:
            axis = check.frames([t])[link][0][0].T @ axis
        bodies = list(chain.bodies)
        bodies[pair[1]] = (link, [[float(x + (g - gap) * n) for x, n in zip(v, axis)] for v in bodies[pair[1]][1]])
        chain = Chain(chain.joints, bodies, chain.start, chain.end)
    return chain


def decided(chain):
    """(kind of answer, before, upper, pair, least gap), or None where a way is not sure."""
    check = Check(chain)
    by_samples = check.first()
    by_proof = Proof(chain).first()
    if by_proof is None or (by_proof[1] is None and by_proof[0] < 1):
        return None
    before, hit, pair = by_proof
    if hit is None:
        if by_samples[1] is not None:
            raise SystemExit("the ways disagree about a free one")
        return "free", before, None, None, by_samples[3]
    if by_samples[1] is None:
        return None  # shorter than the samples see
    if max(before, by_samples[0]) > min(hit, by_samples[1]) + F(1, 1 << 54):
        raise SystemExit(f"the ways disagree about a time: {float(before)} {float(by_samples[0])}")
    return "contact", before, hit, pair, by_samples[3]


def speed_before(chain, pair, t):
    d = F(1, 1 << 24)
    return float(Check(chain).exact_gap(pair, t - d) / d) if t > d else 0.0


def rounded(x, up):
    y = float(x)
    if up and F(y) < x:
        return float(np.nextafter(y, np.inf))
    return float(np.nextafter(y, -np.inf)) if not up and F(y) > x else y


def row_of(kind, chain, found):
    answer, before, hit, pair, gap = found
    number = lambda x: f"{x:.17g}"
    bodies = "|".join(" ".join([str(link), *(number(x) for v in corners for x in v)]) for link, corners in chain.bodies)
    fields = [kind, "|".join(j.text() for j in chain.joints), bodies, *(" ".join(map(number, s)) for s in (chain.start, chain.end)), answer]
    if hit is None:
        return ",".join([*fields, "1", "", "", "", "", number(gap)])
    a, b = (chain.bodies[k][0] for k in pair)
    number_in_cell = "" if b >= 0 else str(pair[1] - next(k for k, body in enumerate(chain.bodies) if body[0] < 0))
    speed = speed_before(chain, pair, before) if answer == "contact" else 0.0
    return ",".join([*fields, number(rounded(before, False)), number(rounded(hit, True)), str(a),
                     str(b) if b >= 0 else "cell " + number_in_cell, number(speed), ""])


def attempt(rng, kind):
    chain = random_chain(rng, kind)
    check = Check(chain)
    gap = start_gap(check)
    if kind == "started":
        pairs = [p for p in chain.pairs() if check.gaps(p, [0.0])[0][0] < 0]
        crossing = len(pairs) == 1 and -0.05 < check.gaps(pairs[0], [0.0])[0][0] < -0.01
        proof = Proof(chain)
        places = proof.places(F(0), F(0), sorted(pairs[0])) if crossing else {}
        met = crossing and proof.meets(*(places[k] for k in pairs[0]))
        return row_of(kind, chain, ("started", F(0), F(0), pairs[0], None)) if met else None
    if gap < 0.02:
        return None
    if kind in ("miss", "graze"):
        chain = moved_to(chain, NEAR if kind == "miss" else -NEAR)
        if chain is None or start_gap(Check(chain)) < 0.02:
            return None
    found = decided(chain)
    if found is None or found[0] != ("free" if kind in ("free", "miss") else "contact"):
        return None
    if kind == "free" and found[4] > 0.3 or kind == "miss" and not 0.3 * NEAR < found[4] < 3 * NEAR:
        return None
    if kind == "self" and chain.bodies[found[3][1]][0] < 0:
        return None
    row = row_of(kind, chain, found)
    return None if found[0] == "contact" and float(row.split(",")[-2]) <= 0 else row


def main():
    rng = random.Random(20261201)
    print("kind,joints,bodies,from,to,answer,lower,upper,link,other,speed,gap")
    for kind, count in QUOTA.items():
        while count:
            row = attempt(rng, kind)
            if row is not None:
                print(row, flush=True)
                count -= 1
        print(kind, file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
