"""The classes that `soms clash` gives to pairs of convex parts are those of separating axes, in whole numbers.

An independent method: two convex bodies share interior exactly if their shadows overlap in more than a point on every
normal of a face of either and on every cross product of an edge of the one with an edge of the other (Gottschalk, Lin
and Manocha 1996, section 4, for convex bodies in general). Coordinates are doubles, so they are whole numbers after a
shift, and nothing is rounded. The least overlap of two shadows, beside the length of its axis, is how deep they go.

usage: convex_clashes.py SOMS A B    (.obj or .gltf)
"""
import base64
import decimal
import fractions
import itertools
import json
import math
import struct
import subprocess
import sys

SHIFT = 1 << 90  # far below the last digit of every coordinate here


def whole(x):
    numerator, denominator = x.as_integer_ratio()
    assert SHIFT % denominator == 0
    return numerator * (SHIFT // denominator)


def subtract(p, q):
    return (p[0] - q[0], p[1] - q[1], p[2] - q[2])


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


class Convex:
    """A closed convex part: corners, outward planes, and directions of edges."""

    def __init__(self, triangles):
        self.corners = sorted({corner for triangle in triangles for corner in triangle})
        self.box = [(min(c), max(c)) for c in zip(*self.corners)]
        self.planes = {}
        edges = set()
        for a, b, c in triangles:
            normal = cross(subtract(b, a), subtract(c, a))
            if normal == (0, 0, 0):
                continue
            offset = dot(normal, a)
            if any(dot(normal, p) > offset for p in self.corners):
                normal, offset = tuple(-x for x in normal), -offset
            self.planes[direction(normal, signed=True)] = (normal, offset)
            edges.update(direction(subtract(q, p)) for p, q in ((a, b), (b, c), (c, a)))
        self.edges = sorted(edges)

    def shadow(self, axis):
        places = [dot(axis, p) for p in self.corners]
        return min(places), max(places)

    def holds(self, p):
        return all(dot(normal, p) <= offset for normal, offset in self.planes.values())


def direction(v, signed=False):
    """The same for parallel vectors; opposite ones too, unless `signed`."""
    divisor = math.gcd(*v) or 1
    v = tuple(x // divisor for x in v)
    return v if signed or v >= (0, 0, 0) else tuple(-x for x in v)


def axes(a, b):
    yield from ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    for body in (a, b):
        yield from (normal for normal, _ in body.planes.values())
    for p, q in itertools.product(a.edges, b.edges):
        axis = cross(p, q)
        if axis != (0, 0, 0):
            yield axis


def relation(a, b):
    if any(p[1] < q[0] or q[1] < p[0] for p, q in zip(a.box, b.box)):
        return "clear"
    touching = False
    for axis in axes(a, b):
        p, q = a.shadow(axis), b.shadow(axis)
        if p[1] < q[0] or q[1] < p[0]:
            return "clear"
        touching = touching or p[1] == q[0] or q[1] == p[0]
    if touching:
        return "touching"
    a_in_b = all(b.holds(p) for p in a.corners)
    b_in_a = all(a.holds(p) for p in b.corners)
    return {(True, True): "same", (True, False): "inside", (False, True): "inside"}.get((a_in_b, b_in_a), "crossing")


def least_translation(a, b):
    """Length of the shortest translation that separates two parts which share interior, to 50 digits."""
    least = None
    for axis in axes(a, b):
        p, q = a.shadow(axis), b.shadow(axis)
        square = fractions.Fraction(min(p[1] - q[0], q[1] - p[0]) ** 2, dot(axis, axis) * SHIFT ** 2)
        least = square if least is None or square < least else least
    return decimal_root(least)


def decimal_root(square):
    with decimal.localcontext() as context:
        context.prec = 50
        return (decimal.Decimal(square.numerator) / decimal.Decimal(square.denominator)).sqrt()


def wrong_depth(depth, a, b):
    """What is wrong with a depth, or None. It separates for certain, and exceeds the least by rounding and little."""
    least = least_translation(a, b)
    extent = max(high - low for low, high in a.box + b.box) / SHIFT
    if depth is None:
        return "no depth"
    if not 0 <= decimal.Decimal(depth) - least <= decimal.Decimal(4e-6 * extent):
        return f"{depth} deep, but separated by {least:.20}"
    return None


def read_obj(path):
    corners, parts = [], {}
    for line in open(path, encoding="utf-8"):
        words = line.split()
        if line.startswith("o "):
            part = parts.setdefault(line[2:].strip(), [])
        elif line.startswith("v "):
            corners.append(tuple(whole(float(x)) for x in words[1:4]))
        elif line.startswith("f "):
            part.append(tuple(corners[int(x.split("/")[0]) - 1] for x in words[1:4]))
    return parts


def read_gltf(path):
    """Parts of a file whose nodes have no transforms, turned from y up to z up."""
    file = json.load(open(path, encoding="utf-8"))
    buffers = [base64.b64decode(buffer["uri"].split(",", 1)[1]) for buffer in file["buffers"]]

    def values(number):
        accessor = file["accessors"][number]
        view = file["bufferViews"][accessor["bufferView"]]
        code = {5126: "f", 5125: "I", 5123: "H", 5121: "B"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
        begin = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        flat = struct.unpack_from(f"<{accessor['count'] * width}{code}", buffers[view["buffer"]], begin)
        return [flat[k:k + width] for k in range(0, len(flat), width)]

    parts = {}
    for node in file["nodes"]:
        if "mesh" not in node:
            continue
        assert not {"matrix", "translation", "rotation", "scale"} & set(node), "nodes are not moved here"
        for primitive in file["meshes"][node["mesh"]]["primitives"]:
            corners = [(whole(x), -whole(z), whole(y))
                       for x, y, z in values(primitive["attributes"]["POSITION"])]
            indices = [i for (i,) in values(primitive["indices"])]
            parts.setdefault(node["name"], []).extend(
                tuple(corners[i] for i in indices[k:k + 3]) for k in range(0, len(indices), 3))
    return parts


def read_parts(path):
    parts = read_gltf(path) if path.endswith(".gltf") else read_obj(path)
    return {name: Convex(triangles) for name, triangles in parts.items()}


def main(soms, file_a, file_b):
    command = [soms, "clash", file_a, "--against", file_b, "--json", "--quiet"]
    rows = [json.loads(line) for line in subprocess.run(command, check=True, capture_output=True, text=True)
            .stdout.splitlines()]
    found = {(row["a"]["part"], row["b"]["part"]): row["class"] for row in rows[:-1]}
    depth = {(row["a"]["part"], row["b"]["part"]): row.get("depth") for row in rows[:-1]}
    a, b = read_parts(file_a), read_parts(file_b)
    wrong, counts = 0, {}
    for (p, body_p), (q, body_q) in itertools.product(a.items(), b.items()):
        expected = relation(body_p, body_q)
        counts[expected] = counts.get(expected, 0) + 1
        if found.get((p, q), "clear") != expected:
            wrong += 1
            print(f"{p} and {q}: {expected} by separating axes, but soms says {found.get((p, q), 'clear')}")
        if expected in ("crossing", "inside", "same"):
            fault = wrong_depth(depth.get((p, q)), body_p, body_q)
            wrong += fault is not None
            if fault:
                print(f"{p} and {q}: {fault}")
    print(f"{len(a)} x {len(b)} parts:", ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items())),
          f"- {wrong} differ")
    return 1 if wrong or len(a) * len(b) != rows[-1]["pairs_of_parts"] else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
