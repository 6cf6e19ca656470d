"""Chains of joints with a tetrahedron or two on each link, as robot_chains.csv has them, and what both ways share."""
from fractions import Fraction as F

import numpy as np

FACES = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))
EDGES = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def turn_of(q):
    """The matrix of a quaternion of whole numbers: each entry is a double."""
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    rows = [[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w + y * y - x * x - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w + z * z - x * x - y * y]]
    return [[a / n for a in row] for row in rows]


class Joint:
    def __init__(self, kind, q, shift, axis, mimic=-1, factor=0.0, offset=0.0):
        self.kind, self.q, self.shift, self.axis = kind, q, shift, axis
        self.mimic, self.factor, self.offset = mimic, factor, offset
        self.turn = turn_of(q)

    def text(self):
        numbers = [*self.q, *self.shift, *self.axis, self.mimic, self.factor, self.offset]
        return self.kind + " " + " ".join(f"{x:.17g}" for x in numbers)


class Chain:
    """Link k + 1 hangs from link k by joint k. Bodies are (link, corners); those of the cell have link -1."""

    def __init__(self, joints, bodies, start, end):
        self.joints, self.bodies, self.start, self.end = joints, bodies, start, end

    def ends(self):
        """Values of all joints in both states, as fractions; the doubles are those of the library."""
        both = []
        for state in (self.start, self.end):
            values, free = [], iter(state)
            for j in self.joints:
                if j.kind == "fixed":
                    values.append(F(0))
                elif j.mimic >= 0:
                    values.append(F(j.factor) * values[j.mimic] + F(j.offset))
                else:
                    values.append(F(next(free)))
            assert all(F(float(v)) == v for v in values)
            both.append(values)
        return list(zip(*both))

    def pairs(self):
        """Of bodies that are compared: not of one link, nor of neighbors, nor both of the cell."""
        n, link = len(self.bodies), [b[0] for b in self.bodies]
        return [(i, j) for i in range(n) for j in range(i + 1, n)
                if link[i] >= 0 and (link[j] < 0 or abs(link[i] - link[j]) > 1)]


def best_axis(x, y):
    """The greatest gap along an axis of length 1 that points from y to x, and the axis, for n pairs of tetrahedra."""
    edges = lambda v: np.stack([v[:, j] - v[:, i] for i, j in EDGES], 1)
    normals = lambda v: np.stack([np.cross(v[:, b] - v[:, a], v[:, c] - v[:, a]) for a, b, c in FACES], 1)
    ex, ey = edges(x), edges(y)
    n = np.concatenate([normals(x), normals(y), np.cross(ex[:, :, None], ey[:, None]).reshape(len(x), 36, 3)], 1)
    length = np.linalg.norm(n, axis=2, keepdims=True)
    n = np.where(length > 1e-9, n / np.maximum(length, 1e-300), 0)
    px, py = np.einsum("nak,nvk->nav", n, x), np.einsum("nak,nvk->nav", n, y)
    up, down = px.min(2) - py.max(2), py.min(2) - px.max(2)
    gap = np.where(length[:, :, 0] > 1e-9, np.maximum(up, down), -np.inf)
    k = gap.argmax(1)
    rows = np.arange(len(x))
    return gap[rows, k], n[rows, k] * np.where(up[rows, k] >= down[rows, k], 1, -1)[:, None]
