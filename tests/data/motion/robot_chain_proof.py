"""The first contact of a chain, proved by intervals.

Intervals are whole multiples of 2^-160. Jets of them in time are a value, a rate, and a bound of the second rate over a
stretch. A direction parts two bodies on a stretch if all differences of corners along it are above 0 there. Stretches
are halved from the left. A contact is an edge that surely goes through a triangle at one time.
"""
import math
from fractions import Fraction as F

import numpy as np

from robot_chain import EDGES, FACES, best_axis, cross, dot, minus

P = 160
ONE = 1 << P
NARROW = F(1, 1 << 58)


class Interval:
    """Of real numbers, by whole multiples of 2^-P."""
    __slots__ = ("lo", "hi")

    def __init__(self, lo, hi=None):
        self.lo, self.hi = lo, lo if hi is None else hi

    def __add__(self, o):
        return Interval(self.lo + o.lo, self.hi + o.hi)

    def __sub__(self, o):
        return Interval(self.lo - o.hi, self.hi - o.lo)

    def __neg__(self):
        return Interval(-self.hi, -self.lo)

    def __mul__(self, o):
        a, b, c, d = self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi
        return Interval(min(a, b, c, d) >> P, -(-max(a, b, c, d) >> P))

    def most(self):
        return max(abs(self.lo), abs(self.hi))


def interval(x):
    n = F(x) * ONE
    return Interval(math.floor(n), math.ceil(n))


ZERO = Interval(0)
UNIT = Interval(ONE)


def around(radius):
    return Interval(-radius, radius)


def root(x):
    return Interval(math.isqrt(x.lo << P), math.isqrt(x.hi << P) + 1)


def over(x, y):
    """x / y, y above 0."""
    ends = [(a << P, b) for a in (x.lo, x.hi) for b in (y.lo, y.hi)]
    return Interval(min(a // b for a, b in ends), max(-(-a // b) for a, b in ends))


def sine_cosine(x):
    """Taylor's sums at a fraction, with the rest."""
    x = interval(x)
    square, sums, term, k = x * x, [ZERO, ZERO], UNIT, 0
    while True:
        sign = -1 if k % 4 > 1 else 1
        sums[k % 2] = sums[k % 2] + (term if sign > 0 else -term)
        k += 1
        term = term * x
        term = Interval(term.lo // k, -(-term.hi // k))
        if k > 12 + 2 * (square.hi >> P) and term.most() < 4:
            break
    rest = around(2 * term.most() + 8)  # later terms are at most half of the one before
    return sums[1] + rest, sums[0] + rest


class Jet:
    """Value and rate at the middle of a stretch, and its second rate all over; h is half its length."""
    __slots__ = ("a", "b", "c", "h")

    def __init__(self, a, b, c, h):
        self.a, self.b, self.c, self.h = a, b, c, h

    def __add__(self, o):
        return Jet(self.a + o.a, self.b + o.b, self.c + o.c, self.h)

    def __sub__(self, o):
        return Jet(self.a - o.a, self.b - o.b, self.c - o.c, self.h)

    def times(self, k):
        return Jet(self.a * k, self.b * k, self.c * k, self.h)

    def rate(self):
        return self.b + self.c * around(self.h.hi)

    def value(self):
        return self.a + self.rate() * around(self.h.hi)

    def __mul__(self, o):
        two = Interval(2 * ONE)
        return Jet(self.a * o.a, self.a * o.b + self.b * o.a,
                   self.c * o.value() + two * self.rate() * o.rate() + self.value() * o.c, self.h)

    def least(self):
        """Below its values on the stretch; a whole number."""
        bend = max(0, -self.c.lo)
        return self.a.lo - (-(-self.b.most() * self.h.hi >> P)) - (bend * self.h.hi ** 2 >> 2 * P + 1) - 2


def constant(x, h):
    return Jet(x, ZERO, ZERO, h)


class Proof:
    """Stretches by intervals."""

    def __init__(self, chain):
        self.chain, self.ends = chain, chain.ends()
        self.axes = []
        for j in chain.joints:
            u = [interval(x) for x in j.axis]
            length = root(dot(u, u))
            self.axes.append([over(x, length) for x in u])
        self.turns = [[[interval(x) for x in row] for row in j.turn] for j in chain.joints]
        self.shifts = [[interval(x) for x in j.shift] for j in chain.joints]
        self.corners = [[[interval(x) for x in v] for v in body] for _, body in chain.bodies]

    def motion(self, k, t, h):
        """Turn columns (s, 1 - c) or a shift of joint k."""
        first, last = self.ends[k]
        value, rate = first + t * (last - first), interval(last - first)
        if self.chain.joints[k].kind == "prismatic":
            return Jet(interval(value), rate, ZERO, h)
        s, c = sine_cosine(value)
        near = Interval(-(rate.most() * h.hi >> P) - 1, (rate.most() * h.hi >> P) + 1)
        return (Jet(s, rate * c, -(rate * rate * (s + near)), h),
                Jet(UNIT - c, rate * s, rate * rate * (c + near), h))

    def frames(self, t, h, links):
        zero, one = constant(ZERO, h), constant(UNIT, h)
        turn = [[one if i == j else zero for j in range(3)] for i in range(3)]
        place = [zero, zero, zero]
        frames = [(turn, place)]
        for k in range(links):
            by, shift, u = self.turns[k], self.shifts[k], self.axes[k]
            place = [self.along(row, shift) + p for row, p in zip(turn, place)]
            turn = [[self.along(row, [by[i][j] for i in range(3)]) for j in range(3)] for row in turn]
            kind = self.chain.joints[k].kind
            if kind == "prismatic":
                value = self.motion(k, t, h)
                place = [p + self.along(row, u) * value for row, p in zip(turn, place)]
            elif kind != "fixed":
                s, d = self.motion(k, t, h)
                rows = []
                for row in turn:  # times 1 + s K + (1 - c) K^2; a row times K is its cross product with u
                    once = self.across(row, u)
                    twice = self.across(once, u)
                    rows.append([r + s * a + d * b for r, a, b in zip(row, once, twice)])
                turn = rows
            frames.append((turn, place))
        return frames

    @staticmethod
    def along(row, v):
        return row[0].times(v[0]) + row[1].times(v[1]) + row[2].times(v[2])

    @staticmethod
    def across(row, u):
        pick = lambda i, j: row[i].times(u[j]) - row[j].times(u[i])
        return [pick(1, 2), pick(2, 0), pick(0, 1)]

    def places(self, t, h, bodies):
        h = interval(h)
        frames = self.frames(t, h, max(self.chain.bodies[b][0] for b in bodies))
        found = {}
        for b in bodies:
            link = self.chain.bodies[b][0]
            if link < 0:
                found[b] = [[constant(x, h) for x in v] for v in self.corners[b]]
            else:
                turn, place = frames[link]
                found[b] = [[self.along(row, v) + p for row, p in zip(turn, place)] for v in self.corners[b]]
        return found

    @staticmethod
    def parted(a, b):
        """A direction is found by doubles, and proved."""
        x, y = ([[c.a.lo / ONE for c in v] for v in body] for body in (a, b))
        n = [F(c).limit_denominator(1 << 40) for c in best_axis(np.array(x)[None], np.array(y)[None])[1][0]]
        n = [interval(c) for c in n]
        return all(Proof.along([p - q for p, q in zip(v, w)], n).least() > 0 for v in a for w in b)

    @staticmethod
    def volume(a, b, c, d):
        return dot(cross(minus(b, a), minus(c, a)), minus(d, a))

    @staticmethod
    def sign(x):
        return 1 if x.lo > 0 else -1 if x.hi < 0 else 0

    def meets(self, a, b):
        """An edge goes surely through a triangle at the middle."""
        a, b = ([[c.a for c in v] for v in body] for body in (a, b))
        for x, y in ((a, b), (b, a)):
            for i, j in EDGES:
                for f in FACES:
                    u, v, w = (y[k] for k in f)
                    below, above = self.sign(self.volume(u, v, w, x[i])), self.sign(self.volume(u, v, w, x[j]))
                    if below * above >= 0:
                        continue
                    sides = {self.sign(self.volume(x[i], x[j], p, q)) for p, q in ((u, v), (v, w), (w, u))}
                    if sides in ({1}, {-1}):
                        return True
        return False

    def first(self):
        """(time without contact before, time in contact or None, pair): free where the first is 1."""
        pairs = self.chain.pairs()
        todo, hit, pair, count = [(F(0), F(1), pairs)], None, None, 0
        while todo:
            a, b, left = todo.pop()
            if hit is not None and a >= hit:
                continue
            count += 1
            if count > 6000:
                return None
            middle, half = (a + b) / 2, (b - a) / 2
            places = self.places(middle, half, sorted({k for p in left for k in p}))
            left = [(i, j) for i, j in left if not self.parted(places[i], places[j])]
            if not left:
                continue
            if hit is None or middle < hit:
                for i, j in left:
                    if self.meets(places[i], places[j]):
                        hit, pair = middle, (i, j)
            if b - a < NARROW:
                return a, hit, pair
            todo += [(middle, b, left), (a, middle, left)]
        return F(1), None, None
