#!/usr/bin/env python3
"""Writes kisses.csv: first contacts of turning triangles at times that are known, proved by fractions.

usage: kisses.py > kisses.csv

Poses are turns of the cube, so quaternions are halves and ones. For a rational time t0 the rotation is rational, and
corners are chosen such that the place of the contact is whole. The body's velocity there, also rational, decides how the
resting triangle has to lie to be touched and left again (a kiss), crossed, or missed by a hair.

Proof of a row: on stretches of the way a direction parts the triangles, as all differences of corners along it are
polynomials above 0 there (coefficients in Bernstein's form). Next to t0 the direction is that of the contact, and the
polynomials that vanish at t0 are divided by powers of t0 - t first.
"""
import itertools
import math
import random
import sys
from fractions import Fraction as F

NEAR = F(1, 64)
DEPTH = 34


def add(p, q):
    n = max(len(p), len(q))
    return [(p[k] if k < len(p) else 0) + (q[k] if k < len(q) else 0) for k in range(n)]


def mul(p, q):
    r = [F(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            r[i + j] += a * b
    return r


def scaled(p, s):
    return [a * s for a in p]


def at(p, t):
    return sum(a * t**k for k, a in enumerate(p))


def positive(p, a, b):
    """Surely above 0 on [a, b]."""
    n, h = len(p) - 1, b - a
    moved = [sum(p[k] * math.comb(k, j) * a ** (k - j) for k in range(j, n + 1)) * h**j for j in range(n + 1)]
    return all(sum(F(math.comb(i, j), math.comb(n, j)) * moved[j] for j in range(i + 1)) > 0 for i in range(n + 1))


def divided(p, t0):
    """p / (t0 - t), p(t0) = 0."""
    q, carry = [F(0)] * (len(p) - 1), F(0)
    for k in range(len(p) - 1, 0, -1):
        carry = p[k] + t0 * carry
        q[k - 1] = -carry
    return q


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(a, b, s=1):
    return [x + s * y for x, y in zip(a, b)]


def whole(v):
    """The shortest whole vector along v."""
    den = math.lcm(*(F(x).denominator for x in v))
    ints = [int(x * den) for x in v]
    return [x // math.gcd(*ints) for x in ints] if any(ints) else ints


def matrix(w, x, y, z, mul2, add2, neg2):
    """|q|^2 times the rotation, for numbers or polynomials."""
    sq = lambda a: mul2(a, a)
    two = lambda a: add2(a, a)
    sub = lambda a, b: add2(a, neg2(b))
    return [[sub(add2(sq(w), sq(x)), add2(sq(y), sq(z))), two(sub(mul2(x, y), mul2(w, z))), two(add2(mul2(x, z), mul2(w, y)))],
            [two(add2(mul2(x, y), mul2(w, z))), sub(add2(sq(w), sq(y)), add2(sq(x), sq(z))), two(sub(mul2(y, z), mul2(w, x)))],
            [two(sub(mul2(x, z), mul2(w, y))), two(add2(mul2(y, z), mul2(w, x))), sub(add2(sq(w), sq(z)), add2(sq(x), sq(y)))]]


def quaternion_of(m):
    """As the library finds it."""
    xx, yy, zz = m[0][0], m[1][1], m[2][2]
    if xx + yy + zz > 0:
        q = [1 + xx + yy + zz, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    elif xx >= yy and xx >= zz:
        q = [m[2][1] - m[1][2], 1 + xx - yy - zz, m[0][1] + m[1][0], m[0][2] + m[2][0]]
    elif yy >= zz:
        q = [m[0][2] - m[2][0], m[0][1] + m[1][0], 1 + yy - xx - zz, m[1][2] + m[2][1]]
    else:
        q = [m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1 + zz - xx - yy]
    length = math.isqrt(int(dot(q, q)))
    assert length * length == dot(q, q)
    return [F(x, length) for x in q]


def rotation(q):
    n = dot(q, q)
    return [[a / n for a in row] for row in matrix(*q, lambda a, b: a * b, lambda a, b: a + b, lambda a: -a)]


class Law:
    def __init__(self, q0, q1, w0, w1, c):
        self.start, self.end = rotation(q0), rotation(q1)
        self.q0, self.q1 = quaternion_of(self.start), quaternion_of(self.end)
        if dot(self.q0, self.q1) < 0:
            self.q1 = [-x for x in self.q1]
        self.w0, self.w1, self.c = w0, w1, c
        q = [[a, b - a] for a, b in zip(self.q0, self.q1)]
        self.m = matrix(*q, mul, add, lambda p: scaled(p, -1))
        self.n = [F(0)]
        for p in q:
            self.n = add(self.n, mul(p, p))

    def turned(self, v):
        return [add(add(scaled(r[0], v[0]), scaled(r[1], v[1])), scaled(r[2], v[2])) for r in self.m]

    def corner(self, a):
        arm = self.turned(plus(a, self.c, -1))
        return [add(mul(self.n, [F(w0), F(w1 - w0)]), p) for w0, w1, p in zip(self.w0, self.w1, arm)]

    def place(self, a, t):
        return [at(p, t) / at(self.n, t) for p in self.corner(a)]

    def velocity(self, a, t):
        n, slope = at(self.n, t), at([k * x for k, x in enumerate(self.n)][1:], t)
        return [(at([k * x for k, x in enumerate(p)][1:], t) * n - at(p, t) * slope) / n**2 for p in self.corner(a)]


class Pair:
    def __init__(self, law, moving, resting):
        self.law, self.moving, self.resting = law, moving, resting
        self.x = [law.corner(a) for a in moving]

    def gaps(self, n):
        """Differences of corners along a direction of polynomials."""
        for x in self.x:
            for y in self.resting:
                gap = [F(0)]
                for k in range(3):
                    gap = add(gap, mul(n[k], add(x[k], scaled(self.law.n, -F(y[k])))))
                yield gap

    def parted(self, n, a, b):
        return all(positive(g, a, b) for g in self.gaps(n))

    def parted_next_to(self, n, a, b, t0):
        """Up to t0, or on both sides of it, but for t0 itself."""
        for gap in self.gaps(n):
            powers = 0
            if not any(gap):
                return False
            while at(gap, t0) == 0:
                gap, powers = divided(gap, t0), powers + 1
            if not positive(gap, a, b) or (b > t0 and powers % 2):
                return False
        return True

    def directions(self, t):
        x = [[float(v) for v in self.law.place(a, t)] for a in self.moving]
        y = [[float(v) for v in b] for b in self.resting]
        e, f = ([plus(c[(k + 1) % 3], c[k], -1) for k in range(3)] for c in (x, y))
        found = [cross(e[0], e[1]), cross(f[0], f[1])] + [cross(a, b) for a in e for b in f]
        apart = [plus(a, b, -1) for a in x for b in y]
        found += apart + [cross(a, cross(d, a)) for a in e + f for d in apart[:3]]
        best = []
        for n in found:
            size = math.sqrt(dot(n, n))
            if size > 1e-9:
                for s in (1 / size, -1 / size):
                    unit = [s * v for v in n]
                    best.append((min(dot(unit, a) for a in x) - max(dot(unit, b) for b in y), unit))
        return max(best)

    def free(self, a, b, depth=0):
        gap, n = self.directions((a + b) / 2)
        if gap > 0 and self.parted([[F(v).limit_denominator(2**50)] for v in n], a, b):
            return True
        middle = (a + b) / 2
        return depth < DEPTH and gap > -1e-6 and self.free(a, middle, depth + 1) and self.free(middle, b, depth + 1)


CUBE = [q for q in itertools.product((-1, 0, 1), repeat=4) if sum(map(abs, q)) == 1] + \
       [tuple(F(s, 2) for s in q) for q in itertools.product((-1, 1), repeat=4)]
TIMES = [F(1, 2), F(1, 2), F(1, 4), F(1, 3), F(3, 4), F(2, 3), F(1, 5), F(3, 8)]


def any_vector(rng, most):
    return [rng.randint(-most, most) for _ in range(3)]


def any_law(rng, t0):
    for _ in range(100):
        q0, q1 = rng.choice(CUBE), rng.choice(CUBE)
        law = Law([F(x) for x in q0], [F(x) for x in q1], [0] * 3, [0] * 3, any_vector(rng, 3))
        if law.q0 != law.q1:
            law.w0 = any_vector(rng, 3)
            law.w1 = plus(law.w0, any_vector(rng, 1) if rng.random() < 0.6 else [0] * 3, t0.denominator)
            return law


def attempt(rng, kind):
    """(law, moving, resting, t0, direction at the contact) or nothing."""
    t0 = rng.choice(TIMES)
    law = any_law(rng, t0)
    turn = rotation([a + t0 * (b - a) for a, b in zip(law.q0, law.q1)])
    den = math.lcm(*(x.denominator for row in turn for x in row))
    arm = lambda most: [den * v for v in any_vector(rng, most)]
    a = plus(law.c, arm(3))
    x0 = law.place(a, t0)
    v = whole(law.velocity(a, t0))
    d = any_vector(rng, 3)
    if not any(cross(v, d)):
        return None
    side = lambda i, j: plus(plus(x0, v, i), d, j)
    const = lambda n: [[F(k)] for k in n]
    moving = [a, plus(a, arm(2)), plus(a, arm(2))]
    n = const(cross(v, d))
    if kind in ("face", "miss"):
        resting = [side(-2, -1), side(2, -1), side(0, 2)]
        if kind == "miss":
            hair = F(1, 2 ** rng.choice([20, 30, 40]))
            resting = [plus(y, [-at(k, 0) for k in n], hair) for y in resting]
    elif kind == "border":
        resting = [side(-1, 0), side(1, 0), side(0, 1)] if rng.random() < 0.5 else [side(-1, -1), side(1, 1), side(-2, 1)]
    elif kind == "corner":
        resting = [x0, side(1, 2), side(-2, 1)]
    elif kind in ("edges", "wires"):
        e = arm(2)
        f = side(rng.choice([-1, 1]), 0)
        f = plus(plus(f, x0, -1), [dot(r, e) for r in turn], rng.choice([-1, 0, 1])) if kind == "edges" else d
        if not any(cross([dot(r, e) for r in turn], f)):
            return None
        moving = [plus(a, e), plus(a, e, -1), plus(a, arm(2))]
        resting = [plus(x0, f), plus(x0, f, -2), plus(x0, any_vector(rng, 3))]
        u = law.turned(e)
        n = [add(scaled(u[1], f[2]), scaled(u[2], -f[1])), add(scaled(u[2], f[0]), scaled(u[0], -f[2])),
             add(scaled(u[0], f[1]), scaled(u[1], -f[0]))]
        if kind == "wires":
            moving[2], resting[2] = moving[1], resting[0]
    elif kind == "plane":
        axis = [k for k in range(3) if law.q0[k + 1] == law.q1[k + 1] == 0]
        if len(axis) < 2 or law.start[3 - sum(axis)][3 - sum(axis)] != 1:
            return None
        up = 3 - sum(axis)
        law.c[up] = law.w0[up] = law.w1[up] = 0
        flat = lambda p: [0 if k == up else p[k] for k in range(3)]
        moving = [flat(p) for p in moving]
        x0 = law.place(moving[0], t0)
        d = flat(d)
        resting = [plus(x0, d), plus(x0, d, -2), flat(plus(x0, any_vector(rng, 3)))]
        n = const(cross(d, [int(k == up) for k in range(3)]))
    elif kind == "point":
        moving = [a] * 3
        resting = [plus(x0, d), plus(x0, any_vector(rng, 3)), None]
        resting[2] = [3 * x - p - q for x, p, q in zip(x0, *resting[:2])]
        n = const(cross(plus(resting[1], x0, -1), d))
    elif kind == "point and wire":
        moving = [a] * 3
        resting = [plus(x0, d), plus(x0, d, -1), plus(x0, d)]
        n = const(cross(d, cross(v, d)))
    else:  # two points
        moving, resting = [a] * 3, [x0] * 3
        n = const(v)
    return law, moving, resting, t0, n


def proved(kind, pair, t0, n):
    if kind == "miss":
        near, far = max(F(0), t0 - NEAR), min(F(1), t0 + NEAR)
        return pair.parted(n, near, far) and pair.free(F(0), near) and pair.free(far, F(1))
    kiss = kind in ("face", "border", "corner", "edges")
    until = t0 + NEAR if kiss else t0
    return pair.parted_next_to(n, t0 - NEAR, until, t0) and pair.free(F(0), t0 - NEAR)


KINDS = [("face", 24), ("border", 16), ("corner", 12), ("edges", 24), ("miss", 20), ("plane", 24), ("wires", 24),
         ("point", 20), ("point and wire", 12), ("points", 8)]


def number(x):
    x = F(x)
    assert x == F(float(x))
    return repr(float(x)).removesuffix(".0")


def row(kind, law, moving, resting, t0, scale):
    fields = [kind]
    shifts = [plus(w, [dot(r, law.c) for r in turn], -1) for w, turn in ((law.w0, law.start), (law.w1, law.end))]
    for q, shift in zip((law.q0, law.q1), shifts):
        fields += [number(x) for x in q] + [number(x * scale) for x in shift]
    for p in [law.c] + moving + resting:
        fields += [number(F(x) * scale) for x in p]
    return fields + (["free", "", ""] if kind == "miss" else ["contact", str(t0.numerator), str(t0.denominator)])


def main():
    rng = random.Random(20)
    names = ["kind"] + [f"{e}{c}" for e in ("s", "e") for c in ("qw", "qx", "qy", "qz", "x", "y", "z")]
    names += [f"{p}{c}" for p in ("c", "a0", "a1", "a2", "b0", "b1", "b2") for c in "xyz"]
    print(",".join(names + ["answer", "above", "below"]))
    for kind, count in KINDS:
        for _ in range(count):
            while True:
                found = attempt(rng, kind)
                if not found:
                    continue
                law, moving, resting, t0, n = found
                if any(F(x) != F(float(x)) for y in resting for x in y):
                    continue
                pair = Pair(law, moving, resting)
                if any(proved(kind, pair, t0, [scaled(k, s) for k in n]) for s in (1, -1)):
                    break
            print(",".join(row(kind, law, moving, resting, t0, F(2) ** rng.choice([0, 0, 0, -40, -200, 30]))))


if __name__ == "__main__":
    sys.exit(main())
