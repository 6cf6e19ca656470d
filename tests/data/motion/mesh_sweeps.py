"""Makes mesh_sweeps.csv: when a shifted mesh first touches another, decided twice in whole numbers.

    python3 tests/data/motion/mesh_sweeps.py ROWS > mesh_sweeps.csv

Vertices are those of both bodies as their poses move them, rounded; A's go straight from there in real numbers. Way one
looks at pairs of features: a corner and a face, two edges. Way two is a linear program of each pair of triangles, which
share a point at t where convex combinations of corners meet, solved by the simplex method. Rows on which they differ
would end the program.
"""
import csv
import itertools
import math
import pathlib
import random
import struct
import sys
from fractions import Fraction

DATA = pathlib.Path(__file__).resolve().parents[1]
SEED = 20261201
WORDS = "box2 box357 boxp octa1 octa4 tetra latsoup degen needles points segs slivers small2 plane boxgrid ball soup".split()
LATTICE = "box2 box357 octa1 octa4 tetra latsoup boxgrid".split()


def read_mesh(name):
    data = (DATA / "truth" / "meshes" / f"{name}.ply").read_bytes()
    head, rest = data.split(b"end_header\n", 1)
    counts = {line.split()[1]: int(line.split()[2]) for line in head.splitlines() if line.startswith(b"element")}
    vertices = [struct.unpack_from("<3d", rest, 24 * k) for k in range(counts[b"vertex"])]
    at = 24 * len(vertices)
    triangles = []
    for _ in range(counts[b"face"]):
        triangles.append(struct.unpack_from("<3i", rest, at + 1))
        at += 13
    return vertices, triangles


def moved(pose, v):
    """As a pose moves a vertex: each operation rounded once."""
    return tuple(((pose[4 * r] * v[0] + pose[4 * r + 1] * v[1]) + pose[4 * r + 2] * v[2]) + pose[4 * r + 3] for r in range(3))


def rotation(rng):
    q = [rng.gauss(0, 1) for _ in range(4)]
    length = math.sqrt(sum(x * x for x in q))
    w, x, y, z = (x / length for x in q)
    s = 2 / (((w * w + x * x) + y * y) + z * z)
    return [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y), s * (x * y + w * z), 1 - s * (x * x + z * z),
            s * (y * z - w * x), s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)]


def pose_of(r, t):
    return [*r[0:3], t[0], *r[3:6], t[1], *r[6:9], t[2]]


IDENTITY = [1.0, 0, 0, 0, 1.0, 0, 0, 0, 1.0]


def question(rng, kind):
    """Meshes, poses and the shift of A."""
    whole = kind in ("lattice", "step", "touching")
    names = LATTICE if whole else WORDS
    a, b = rng.choice(names), rng.choice(names)
    if whole:
        place = [float(rng.randint(-6, 6)) for _ in range(3)]
        by = [float(rng.randint(-12, 12)) for _ in range(3)]
        if kind == "step":
            place = [x + rng.randint(-2, 2) * 2.0 ** -50 for x in place]
            by = [x + rng.randint(-2, 2) * 2.0 ** -49 for x in by]
        if kind == "touching":
            by = [x * 0.5 for x in by]
        return a, b, pose_of(IDENTITY, place), pose_of(IDENTITY, [0.0, 0, 0]), by
    far = 4096.0 if kind == "far" else 0.0
    center = [far, -far, far / 2]
    reach = 2.0 ** -20 if kind == "short" else 1.0
    place = [c + rng.uniform(-5, 5) for c in center]
    toward = [(c - p) * rng.uniform(0.6, 2) + rng.uniform(-1, 1) for c, p in zip(center, place)]
    by = [x * reach for x in toward]
    return a, b, pose_of(rotation(rng), place), pose_of(rotation(rng), center), by


def on_grid(points):
    """Whole numbers: all coordinates times one power of two."""
    exact = [[Fraction(x) for x in p] for p in points]
    unit = max(x.denominator for p in exact for x in p)
    return [tuple(int(x * unit) for x in p) for p in exact]


def less(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# Way one: t d lies in a difference of features.

def solve(columns, right):
    """Solutions of three equations in as many unknowns as columns; nothing where they have no single one."""
    rows = [[Fraction(c[r]) for c in columns] + [Fraction(right[r])] for r in range(3)]
    at = 0
    for column in range(len(columns)):
        pivot = next((r for r in range(at, 3) if rows[r][column]), None)
        if pivot is None:
            return None
        rows[at], rows[pivot] = rows[pivot], rows[at]
        rows[at] = [x / rows[at][column] for x in rows[at]]
        for r in range(3):
            if r != at and rows[r][column]:
                rows[r] = [x - rows[r][column] * y for x, y in zip(rows[r], rows[at])]
        at += 1
    return [rows[k][-1] for k in range(at)] if all(row[-1] == 0 for row in rows[at:]) else None


def of_triangle(found):
    return min(found) >= 0 and sum(found) <= 1


def of_edges(found):
    return min(found) >= 0 and max(found) <= 1


def meet(x, y):
    """Whether triangles share a point: a corner in a face, two edges, an edge and a face."""
    for a, b in ((x, y), (y, x)):
        legs = [less(b[1], b[0]), less(b[2], b[0])]
        for k in range(3):
            found = solve(legs, less(a[k], b[0]))
            if found is not None and of_triangle(found):
                return True
            found = solve([*legs, less(a[k], a[(k + 1) % 3])], less(a[k], b[0]))
            if found is not None and of_triangle(found[:2]) and 0 <= found[2] <= 1:
                return True
    for i, j in itertools.product(range(3), range(3)):
        found = solve([less(x[(i + 1) % 3], x[i]), less(y[j], y[(j + 1) % 3])], less(y[j], x[i]))
        if found is not None and of_edges(found):
            return True
    return any(on_edge(p, e) for a, b in ((x, y), (y, x)) for p in a for e in zip(b, (b[1], b[2], b[0])))


def on_edge(p, edge):
    found = solve([less(edge[1], edge[0])], less(p, edge[0])) if edge[0] != edge[1] else None
    return p == edge[0] or (found is not None and of_edges(found))


def first_by_features(x, y, d):
    """The least t in [0, 1] at which triangle x + t d meets y; nothing if there is none. Corners, edges, faces."""
    if meet(x, y):
        return Fraction(0)
    best = None

    def take(base, legs, inside):
        nonlocal best
        found = solve([*legs, less((0, 0, 0), d)], less((0, 0, 0), base))
        if found is not None and 0 <= found[-1] <= 1 and inside(found[:-1]) and (best is None or found[-1] < best):
            best = found[-1]

    # base + legs of y - x = t d: corner of x against features of y, and the other way round, then edges against edges.
    for corner in x:
        take(less(y[0], corner), [less(y[1], y[0]), less(y[2], y[0])], of_triangle)
    for corner in y:
        take(less(corner, x[0]), [less(x[0], x[1]), less(x[0], x[2])], of_triangle)
    for i, j in itertools.product(range(3), range(3)):
        e, f = less(x[(i + 1) % 3], x[i]), less(y[(j + 1) % 3], y[j])
        take(less(y[j], x[i]), [less((0, 0, 0), e), f], of_edges)
        # What has no area: corners on edges, corners on corners.
        for end in (x[i], x[(i + 1) % 3]):
            take(less(y[j], end), [f], of_edges)
        for end in (y[j], y[(j + 1) % 3]):
            take(less(end, x[i]), [less((0, 0, 0), e)], of_edges)
        if solve_point(less(y[j], x[i]), d) is not None:
            t = solve_point(less(y[j], x[i]), d)
            best = t if best is None or t < best else best
    return best


def solve_point(way, d):
    """t in [0, 1] with t d = way."""
    found = solve([d], way) if any(d) else None
    return found[0] if found is not None and 0 <= found[0] <= 1 else None


# Way two: the least t of a linear program, by the simplex method with Bland's rule.

def enter(table, basis, leaving, entering):
    """Solves row `leaving` for the unknown `entering`, and takes that out of all others."""
    pivot = table[leaving][entering]
    table[leaving] = [x / pivot for x in table[leaving]]
    for i, row in enumerate(table):
        if i != leaving and row[entering]:
            table[i] = [x - row[entering] * y for x, y in zip(row, table[leaving])]
    basis[leaving] = entering


def simplex(table, basis, cost):
    """Minimizes cost over a table in canonical form of `basis`; changes both."""
    width = len(table[0]) - 1
    while True:
        prices = [cost[b] for b in basis]
        entering = next((j for j in range(width) if j not in basis
                         and cost[j] - sum(p * row[j] for p, row in zip(prices, table)) < 0), None)
        if entering is None:
            return sum(p * row[-1] for p, row in zip(prices, table))
        ratios = [(row[-1] / row[entering], basis[i], i) for i, row in enumerate(table) if row[entering] > 0]
        if not ratios:
            raise ArithmeticError("unbounded")
        enter(table, basis, min(ratios)[2], entering)


def first_by_program(x, y, d):
    """As first_by_features. Unknowns: weights of x, of y, t, and what t lacks of 1."""
    rows = []
    for axis in range(3):
        rows.append([*(p[axis] for p in x), *(-p[axis] for p in y), d[axis], 0, 0])
    rows += [[1, 1, 1, 0, 0, 0, 0, 0, 1], [0, 0, 0, 1, 1, 1, 0, 0, 1], [0, 0, 0, 0, 0, 0, 1, 1, 1]]
    count = len(rows)
    table = [[Fraction(v) for v in row[:-1]] + [Fraction(int(k == i)) for k in range(count)] + [Fraction(row[-1])]
             for i, row in enumerate(rows)]
    basis = list(range(8, 8 + count))
    if simplex(table, basis, [0] * 8 + [1] * count) != 0:
        return None
    for i, b in enumerate(basis):  # equations that say nothing more keep an unknown that stays 0
        if b >= 8:
            column = next((j for j in range(8) if table[i][j] != 0), None)
            if column is not None:
                enter(table, basis, i, column)
    kept = [i for i, b in enumerate(basis) if b < 8]
    table = [table[i][:8] + table[i][-1:] for i in kept]
    basis = [basis[i] for i in kept]
    return simplex(table, basis, [0] * 6 + [1, 0])


def windows(xs, ys, d):
    """Pairs whose boxes may meet, with a time before which they do not, by whole numbers."""
    boxes = [[(min(p[k] for p in t), max(p[k] for p in t)) for k in range(3)] for t in ys]
    for i, x in enumerate(xs):
        box = [(min(p[k] for p in x), max(p[k] for p in x)) for k in range(3)]
        for j, other in enumerate(boxes):
            lower, upper = Fraction(0), Fraction(1)
            for k in range(3):
                begin, end = other[k][0] - box[k][1], other[k][1] - box[k][0]
                if d[k] == 0:
                    if begin > 0 or end < 0:
                        break
                    continue
                if d[k] < 0:
                    begin, end = end, begin
                if Fraction(end, d[k]) < lower or Fraction(begin, d[k]) > upper:
                    break
                lower, upper = max(lower, Fraction(begin, d[k])), min(upper, Fraction(end, d[k]))
            else:
                if lower <= upper:
                    yield lower, i, j


def neighbors(t):
    """The doubles next to a fraction."""
    near = t.numerator / t.denominator
    if Fraction(near) == t:
        return near, near
    return (near, math.nextafter(near, 2)) if Fraction(near) < t else (math.nextafter(near, -1), near)


def decide(xs, ys, d):
    """The least t and the least pair that touches then; nothing if all is free."""
    best, pairs = None, []
    for lower, i, j in sorted(windows(xs, ys, d)):
        if best is not None and lower > best:
            break
        t = first_by_features(xs[i], ys[j], d)
        again = first_by_program(xs[i], ys[j], d)
        if t != again:
            sys.exit(f"two ways differ: {t}, {again}: {xs[i]} {ys[j]} {d}")
        if t is not None and (best is None or t <= best):
            pairs = [(i, j)] if best is None or t < best else [*pairs, (i, j)]
            best = t
    return best, min(pairs, default=None)


def main(count):
    rng = random.Random(SEED)
    meshes = {name: read_mesh(name) for name in WORDS}
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["meshA", "meshB", "kind", *(f"a{k}" for k in range(12)), *(f"b{k}" for k in range(12)), "dx", "dy", "dz",
                  "answer", "t_lo", "t_hi", "i", "j"])
    kinds = itertools.cycle(["lattice", "step", "touching", "random", "far", "short"])
    answers = {"contact": 0, "free": 0, "start": 0}
    while sum(answers.values()) < count:
        kind = next(kinds)
        a, b, pose_a, pose_b, by = question(rng, kind)
        points = [*(moved(pose_a, v) for v in meshes[a][0]), *(moved(pose_b, v) for v in meshes[b][0]), tuple(by)]
        grid = on_grid(points)
        first = len(meshes[a][0])
        xs = [tuple(grid[k] for k in t) for t in meshes[a][1]]
        ys = [tuple(grid[first + k] for k in t) for t in meshes[b][1]]
        t, pair = decide(xs, ys, grid[-1])
        answer = "free" if t is None else "start" if t == 0 else "contact"
        if answer != "contact" and 5 * answers[answer] >= count:
            continue
        answers[answer] += 1
        lower, upper = neighbors(t) if answer == "contact" else ("", "")
        out.writerow([a, b, kind, *map(repr, pose_a), *map(repr, pose_b), *map(repr, by), answer,
                      *(repr(x) if x != "" else "" for x in (lower, upper)), *(pair if answer == "contact" else ("", ""))])


if __name__ == "__main__":
    main(int(sys.argv[1]))
