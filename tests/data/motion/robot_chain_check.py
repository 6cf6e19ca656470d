"""The first contact of a chain by samples, which know nothing of the proof.

The gap of two tetrahedra is the greatest along 44 axes. It is sampled at 1,025 times, followed to its least values, and
halved by mpmath, with 60 digits, where its sign changes.
"""
import math
from fractions import Fraction as F

import mpmath
import numpy as np

from robot_chain import EDGES, FACES, best_axis, cross, dot, minus

TIMES = 1024
mpmath.mp.dps = 60


class Check:
    """Samples: of many times by numpy, of one by mpmath."""

    def __init__(self, chain):
        self.chain = chain
        self.ends = chain.ends()

    def frames(self, times):
        t = np.asarray(times, float)
        turn, place = np.broadcast_to(np.eye(3), (len(t), 3, 3)), np.zeros((len(t), 3))
        out = [(turn, place)]
        for (first, last), j in zip(self.ends, self.chain.joints):
            place, turn = place + turn @ np.array(j.shift, float), turn @ np.array(j.turn)
            value = float(first) + t * float(last - first)
            u = np.array(j.axis, float) / np.linalg.norm(j.axis)
            if j.kind == "prismatic":
                place = place + value[:, None] * (turn @ u)
            elif j.kind != "fixed":
                k = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
                turn = turn @ (np.eye(3) + np.sin(value)[:, None, None] * k + (1 - np.cos(value))[:, None, None] * (k @ k))
            out.append((turn, place))
        return out

    def gaps(self, pair, times, frames=None):
        frames = frames or self.frames(times)
        body = []
        for b in pair:
            link, corners = self.chain.bodies[b]
            v = np.array(corners, float)
            turn, place = frames[max(link, 0)]
            body.append(np.broadcast_to(v, (len(times), 4, 3)) if link < 0 else
                        np.einsum("nij,vj->nvi", turn, v) + place[:, None])
        return best_axis(*body)

    def exact_gap(self, pair, t):
        """With 60 digits."""
        m = mpmath.mpf
        body, t = [], m(t.numerator) / t.denominator
        number = lambda x: m(F(x).numerator) / F(x).denominator
        for b in pair:
            link, corners = self.chain.bodies[b]
            moved = [[number(x) for x in v] for v in corners]
            for k in range(link - 1, -1, -1):  # from the hand to the base, point by point
                j, (first, last) = self.chain.joints[k], self.ends[k]
                value = number(first) + t * number(last - first)
                u = [m(x) for x in j.axis]
                length = mpmath.sqrt(dot(u, u))
                u = [x / length for x in u]
                if j.kind == "prismatic":
                    moved = [[x + value * y for x, y in zip(v, u)] for v in moved]
                elif j.kind != "fixed":
                    c, s = mpmath.cos(value), mpmath.sin(value)
                    moved = [[c * x + s * y + (1 - c) * dot(u, v) * z for x, y, z in zip(v, cross(u, v), u)] for v in moved]
                moved = [[dot([number(x) for x in row], v) + number(p) for row, p in zip(j.turn, j.shift)] for v in moved]
            body.append(moved)
        x, y = body
        axes = [cross(minus(v[b], v[a]), minus(v[c], v[a])) for v in body for a, b, c in FACES]
        axes += [cross(minus(x[j], x[i]), minus(y[q], y[p])) for i, j in EDGES for p, q in EDGES]
        best = None
        for n in axes:
            length = mpmath.sqrt(dot(n, n))
            if length > m(10) ** -20:
                px, py = [dot(n, v) for v in x], [dot(n, v) for v in y]
                gap = max(min(px) - max(py), min(py) - max(px)) / length
                best = gap if best is None else max(best, gap)
        return best

    def least(self, pair, gaps):
        """Where a sampled gap is least: the time and the gap, followed by ever finer samples."""
        out = []
        for k in range(1, TIMES):
            if gaps[k] <= gaps[k - 1] and gaps[k] <= gaps[k + 1] and 0 < gaps[k] < 0.02:
                a, b = (k - 1) / TIMES, (k + 1) / TIMES
                for _ in range(12):
                    t = np.linspace(a, b, 17)
                    g = self.gaps(pair, t)[0]
                    i = int(np.clip(g.argmin(), 1, 15))
                    a, b = t[i - 1], t[i + 1]
                out.append((t[i], g[i]))
        return out

    def first(self):
        """(time before, time in contact or None, pair, least gap of all)."""
        times = np.linspace(0, 1, TIMES + 1)
        frames, found, least = self.frames(times), None, math.inf
        for pair in self.chain.pairs():
            gaps = self.gaps(pair, times, frames)[0]
            points = sorted([*zip(times, gaps), *self.least(pair, gaps)])
            least = min(least, min(g for _, g in points))
            hit = next((k for k, p in enumerate(points) if p[1] <= 0), None)
            if hit is not None:
                before = F(points[hit - 1][0]) if hit else F(0)
                if found is None or before <= found[1]:
                    now = self.halved(pair, before, F(points[hit][0]))
                    found = now if found is None or now[1] < found[1] else found
        return (F(1), None, None, least) if found is None else (*found, least)

    def halved(self, pair, a, b):
        while b - a > F(1, 1 << 62):
            middle = (a + b) / 2
            a, b = (a, middle) if self.exact_gap(pair, middle) <= 0 else (middle, b)
        return a, b, pair
