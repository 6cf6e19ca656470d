#!/usr/bin/env python3
"""Draws the words of docs/meaning.md and docs/axes.md: docs/pictures/terms/*.svg.

usage: tools/draw_terms.py [FOLDER]

The triangles of a drawing are data (SCENES, NEAREST), so that a test asks soms whether they overlap, or
how far apart they are, as the drawing says. Only sums, products and square roots: every machine writes the same bytes.
"""
import pathlib
import sys

from draw_motion import motion
from drawing import WIDTH, arrow, box, dot, drawing, line, number, polygon, words

# --- Space, seen from the front, a little from the right and from above ---------------------------

RIGHT = (0.8, 0.6, 0.0)
UP = (-0.6 * 5 / 13, 0.8 * 5 / 13, 12 / 13)
TOWARD = (0.6 * 12 / 13, -0.8 * 12 / 13, 5 / 13)


def dot_product(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1], p[2] - q[2])


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


class View:
    """Puts points of space on the page, about a place and by a scale."""

    def __init__(self, x, y, scale, flat=False):
        self.x, self.y, self.scale, self.flat = x, y, scale, flat

    def __call__(self, p):
        if self.flat:
            return (self.x + self.scale * p[0], self.y - self.scale * p[1])
        return (self.x + self.scale * dot_product(p, RIGHT), self.y - self.scale * dot_product(p, UP))

    def path(self, corners):
        return [self(p) for p in corners]


def half(polygon_in, origin, normal, side):
    """The part of a convex polygon on one side of a plane."""
    kept = []
    for k, p in enumerate(polygon_in):
        q = polygon_in[(k + 1) % len(polygon_in)]
        d, e = (side * dot_product(minus(r, origin), normal) for r in (p, q))
        if d >= 0:
            kept.append(p)
        if d * e < 0:
            t = d / (d - e)
            kept.append(tuple(p[i] + t * (q[i] - p[i]) for i in range(3)))
    return kept


def two_triangles(view, a, b):
    """b behind the plane of a, then a, then b before it."""
    normal = cross(minus(a[1], a[0]), minus(a[2], a[0]))
    if dot_product(normal, TOWARD) < 0:
        normal = minus((0, 0, 0), normal)
    made = []
    for side in (-1, 1):
        part = half(b, a[0], normal, side)
        if len(part) > 2:
            made.append(polygon(view.path(part), "b solid b-line"))
        if side < 0:
            made.append(polygon(view.path(a), "a solid a-line"))
    return made


def faces(lower, upper):
    """The six sides of a box as quadrilaterals, those seen from behind first."""
    (x, y, z), (u, v, w) = lower, upper
    behind = [[(x, v, z), (u, v, z), (u, v, w), (x, v, w)], [(x, y, z), (x, v, z), (x, v, w), (x, y, w)],
              [(x, y, z), (u, y, z), (u, v, z), (x, v, z)]]
    before = [[(u, y, z), (u, v, z), (u, v, w), (u, y, w)], [(x, y, z), (u, y, z), (u, y, w), (x, y, w)],
              [(x, y, w), (u, y, w), (u, v, w), (x, v, w)]]
    return behind, before


def triangles_of(quadrilaterals):
    return [t for p, q, r, s in quadrilaterals for t in ((p, q, r), (p, r, s))]


# --- What is drawn: (words, triangles of A, triangles of B, whether they overlap) -----------------

FLOOR = ((0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (1.0, 2.5, 0.0))
LEAST = 1e-300


def tip(height):
    return ((1.25, 0.75, height), (0.6, 0.9, 1.7), (2.0, 1.1, 1.7))


HALL, CAR, OUT = ((0, 0, 0), (4, 3, 2)), ((1.2, 1, 0.4), (2.6, 1.8, 1)), ((3.2, 1, 0.4), (4.6, 1.8, 1))
# Of tests/data/frames: a slab and a wall, z up; a duct as its file has it, y up, and turned to z up.
SLAB, WALL = ((0, 0, 0), (6, 4, 0.25)), ((3, 0, 0.25), (3.25, 4, 3))
DUCT, TURNED = ((1, 2, -2), (5, 2.5, -1.5)), ((1, 1.5, 2), (5, 2, 2.5))


def building(duct):
    return ([t for body in (SLAB, WALL) for t in triangles_of(sum(faces(*body), []))],
            triangles_of(sum(faces(*duct), [])))


SCENES = {
    "axes": [("numbers as stored", *building(DUCT), False),
             ("B turned by --up-b y", *building(TURNED), True)],
    "touching": [
        ("corner on corner", [FLOOR], [((3.0, 0.0, 0.0), (2.6, 0.6, 1.7), (3.6, 0.9, 1.5))], True),
        ("corner on face", [FLOOR], [tip(0.0)], True),
        ("edge on edge", [FLOOR], [((1.0, 0.0, 0.0), (3.6, 0.0, 0.0), (2.4, 0.5, 1.7))], True)],
    "crossing": [
        ("they share a segment", [FLOOR], [((0.4, 0.5, -0.9), (2.4, 0.9, -0.5), (1.5, 1.1, 1.7))], True)],
    "coplanar": [
        ("a common area", [((0, 0, 0), (4, 0, 0), (1, 3, 0))], [((1.5, 0.8, 0), (4.6, 1.6, 0), (2, 3.2, 0))],
         True),
        ("a common edge", [((0, 0, 0), (4, 0, 0), (1, 3, 0))], [((4, 0, 0), (4.6, 2.8, 0), (1, 3, 0))], True),
        ("nothing in common", [((0, 0, 0), (3, 0, 0), (0.6, 2.4, 0))], [((4, 1, 0), (4.4, 3, 0), (1.6, 3, 0))],
         False)],
    "inside": [
        ("inside, touching nothing", triangles_of(sum(faces(*HALL), [])), triangles_of(sum(faces(*CAR), [])),
         False),
        ("through the wall", triangles_of(sum(faces(*HALL), [])), triangles_of(sum(faces(*OUT), [])), True)],
    "gap": [
        ("apart by 0.4", [FLOOR], [tip(0.4)], False), ('apart by 10<tspan dy="-5" font-size="11">-300</tspan>', [FLOOR], [tip(LEAST)], False),
        ("apart by nothing", [FLOOR], [tip(0.0)], True)],
}

# (words, triangles of A, triangles of B, their distance, its ends on A and B where there is one such pair)
NEAREST = [
    ("corner and face", [FLOOR], [tip(0.75)], 0.75, [(1.25, 0.75, 0.0), (1.25, 0.75, 0.75)]),
    ("edge and edge", [FLOOR], [((1.0, -1.0, -0.4), (2.0, -1.0, 0.4), (1.2, -1.6, 1.4))], 1.0,
     [(1.5, 0.0, 0.0), (1.5, -1.0, 0.0)]),
    ("one inside the other", triangles_of(sum(faces(*HALL), [])), triangles_of(sum(faces(*CAR), [])), 0.4, None),
]


def verdict(x, y, title, overlaps):
    return [words(x, y, title),
            words(x, y + 21, "overlap" if overlaps else "no overlap", "both strong" if overlaps else "faint strong")]


def panels(name):
    """(middle of the panel, scene) for each scene of a drawing."""
    scenes = SCENES[name]
    return [(WIDTH * (2 * k + 1) / (2 * len(scenes)), *scene) for k, scene in enumerate(scenes)]


def touching():
    shared = [[(3, 0, 0)], [(1.25, 0.75, 0)], [(1, 0, 0), (3, 0, 0)]]
    made = []
    for (x, title, a, b, overlaps), common in zip(panels("touching"), shared):
        view = View(x - 80, 118, 46)
        made += two_triangles(view, a[0], b[0])
        made.append(dot(view(common[0]), "both") if len(common) == 1 else
                    line(view.path(common), "thick both-line"))
        made += verdict(x, 184, title, overlaps)
    return drawing("Touching: triangles that share a single point or a piece of an edge overlap", 220, made)


def crossing():
    (_, title, a, b, overlaps), = panels("crossing")
    view = View(80, 130, 70)
    made = two_triangles(view, a[0], b[0])
    ends = [p for p in half(b[0], (0, 0, 0), (0, 0, 1), 1) if abs(p[2]) < 1e-9]
    made.append(line(view.path(ends), "thick both-line"))
    made += [words(360, 72, "triangle i of A", "a strong", "start"),
             words(360, 96, "triangle j of B", "b strong", "start"),
             words(360, 128, title, "ink", "start"),
             words(360, 152, "the answer lists (i, j), once", "ink", "start"),
             words(360, 176, "overlap" if overlaps else "", "both strong", "start")]
    return drawing("Crossing: two triangles cut through each other along a segment", 230, made)


def coplanar():
    made = []
    for x, title, a, b, overlaps in panels("coplanar"):
        view = View(x - 85, 140, 36, flat=True)
        made += [polygon(view.path(a[0]), "a pale a-line"), polygon(view.path(b[0]), "b pale b-line")]
        common = list(b[0])
        for k in range(3):
            p, q = a[0][k], a[0][(k + 1) % 3]
            common = half(common, p, (p[1] - q[1], q[0] - p[0], 0), 1)
        if overlaps and len(common) > 2:
            made.append(polygon(view.path(common), "both solid both-line"))
        elif overlaps:
            made.append(line(view.path(common), "thick both-line"))
        made += verdict(x, 184, title, overlaps)
    return drawing("Coplanar: triangles of one plane, seen from above", 220, made)


def inside():
    made = []
    for (x, title, _, _, overlaps), small in zip(panels("inside"), (CAR, OUT)):
        view = View(x - 105, 146, 42)
        hall, car = faces(*HALL), faces(*small)
        made += [polygon(view.path(f), "a pale a-line") for f in hall[0]]
        if overlaps:  # what stands in the hall, its wall, what looks out of it
            wall = HALL[1][0]
            halves = [faces(small[0], (wall, *small[1][1:])), faces((wall, *small[0][1:]), small[1])]
            made += [polygon(view.path(f), "b solid b-line") for f in halves[0][1][1:]]
        else:
            made += [polygon(view.path(f), "b solid b-line") for f in car[1]]
        made += [line(view.path([*f, f[0]]), "a-line") for f in hall[1]]
        if overlaps:
            made += [polygon(view.path(f), "b solid b-line") for f in halves[1][1]]
            y, z, v, w = *small[0][1:], *small[1][1:]
            made.append(line(view.path([(wall, y, z), (wall, v, z), (wall, v, w), (wall, y, w), (wall, y, z)]),
                             "thick both-line"))
        made += verdict(x, 214, title, overlaps)
    return drawing("A body wholly inside another touches none of its surface", 250, made)


def gap():
    made = []
    for x, title, a, b, overlaps in panels("gap"):
        view = View(x - 80, 126, 46)
        made += two_triangles(view, a[0], b[0])
        place = view(b[0][0])
        if overlaps:
            made.append(dot(place, "both"))
        elif b[0][0][2] == LEAST:  # a lens on the place
            eye = (x + 66, 40)
            made += [line([place, (eye[0] - 20, eye[1] + 20)], "faint-line"),
                     f'<circle cx="{number(eye[0])}" cy="{eye[1]}" r="28" class="card faint-line"/>',
                     polygon([(eye[0] - 13, eye[1] - 22), (eye[0] + 13, eye[1] - 22), (eye[0], eye[1] + 2)],
                             "b solid b-line"),
                     line([(eye[0] - 26, eye[1] + 10), (eye[0] + 26, eye[1] + 10)], "a-line")]
        else:
            made.append(line([place, view((1.25, 0.75, 0))], "dashed faint-line"))
        made += verdict(x, 190, title, overlaps)
    return drawing("Gap: without a tolerance the least gap parts, and none touches", 226, made)


def nearest():
    made = []
    for k, (title, a, b, distance, ends) in enumerate(NEAREST):
        x = WIDTH * (2 * k + 1) / 6
        if ends:
            view = View(x - 80, 118, 46)
            made += two_triangles(view, a[0], b[0])
        else:
            view = View(x - 82, 134, 33)
            hall, car = faces(*HALL), faces(*CAR)
            made += [polygon(view.path(f), "a pale a-line") for f in hall[0]]
            made += [polygon(view.path(f), "b solid b-line") for f in car[1]]
            (u, v, top), (w, z, _) = CAR
            ends = [((u + w) / 2, v, 0), ((u + w) / 2, v, top)]
            made += [line(view.path([*f, f[0]]), "a-line") for f in hall[1]]
        made.append(line(view.path(ends), "thick both-line"))
        made += [dot(view(p), "both", 4) for p in ends]
        made += [words(x, 190, title), words(x, 211, f"distance {distance:g}", "both strong")]
    return drawing("Distance: the length of a shortest segment between two surfaces", 228, made)


# --- Drawings without triangles to test -----------------------------------------------------------


def outline(move):
    """A car from the side, wheels and all, each point moved."""
    body = [(0, 0.4), (0, 1), (0.9, 1.1), (1.4, 1.7), (3, 1.7), (3.6, 1.1), (4.4, 1), (4.4, 0.4)]
    made = [polygon([move(p) for p in body], "a pale a-line")]
    for x in (0.9, 3.4):
        ring = ((0.4, 0), (0.32, 0.24), (0.24, 0.32), (0, 0.4))
        quarter = [(u, v) for u, v in ring] + [(-v, u) for u, v in ring[1:]]
        wheel = quarter + [(-u, -v) for u, v in quarter[1:-1]]
        made.append(polygon([move((x + u, 0.4 + v)) for u, v in wheel], "card a-line"))
    return made


def axes(origin, turn, size=44):
    ends = [(origin[0] + size * e[0], origin[1] + size * e[1]) for e in (turn((1, 0)), turn((0, 1)))]
    return [arrow(origin, ends[0], "ink"), arrow(origin, ends[1], "ink"), dot(origin, "ink", 4)]


def pose():
    made = outline(lambda p: (50 + 33 * p[0], 150 - 33 * p[1]))
    made += axes((50, 150), lambda p: (p[0], -p[1]))
    made += [words(115, 186, "the body in its own frame,", "a"), words(115, 206, "vertices as read", "a")]

    place = (425, 140)

    def turn(p):  # by the angle of the triangle 3, 4, 5
        return (0.8 * p[0] - 0.6 * p[1], -(0.6 * p[0] + 0.8 * p[1]))
    made += [arrow((225, 90), (325, 90), "ink"), words(275, 74, "pose [R | t]"),
             words(275, 116, "turns by R,", "faint"), words(275, 136, "shifts by t", "faint")]
    made += outline(lambda p: tuple(place[i] + 33 * turn(p)[i] for i in (0, 1)))
    made += axes(place, turn)
    made += axes((365, 158), lambda p: (p[0], -p[1]))
    made += [line([(365, 158), place], "dashed faint-line"), words(388, 138, "t", "faint"),
             words(480, 186, "in the world's frame: every decision", "a"),
             words(480, 206, "is about these moved vertices", "a")]
    return drawing("Pose and frame: a rigid pose carries a body from its own frame into the world", 220, made)


def parts():
    runs = [("terrain", 3, "faint"), ("roads", 4, "a"), ("house 0", 3, "b"), ("house 1", 4, "b")]
    made, x, first = [], 33, 0
    made.append(words(33, 34, "triangles of the file, in order:", "ink", "start"))
    for name, count, color in runs:
        for k in range(count):
            made += [box(x, 48, 38, 34, f"{color} pale {color}-line"), words(x + 19, 70, first + k, "ink mono")]
            x += 41
        middle = x - 41 * count / 2 - 1.5
        made += [line([(x - 41 * count + 2, 90), (x - 41 * count + 2, 96), (x - 5, 96), (x - 5, 90)], f"{color}-line"),
                 words(middle, 116, name, f"{color} strong"),
                 words(middle, 136, f"first {first}, count {count}", "faint mono")]
        first += count
    made += [line([(320 + 6, 144), (326, 154), (600, 154), (600, 144)], "b-line"),
             words(463, 174, "buildings: parent of both", "b strong")]
    return drawing("Parts: named runs of a model's triangles, one within another", 190, made)


def tree_boxes():
    """Boxes of a binary tree over eight short lines of a curve, and of a small body."""
    heights = [0.9, 0.3, 0.8, 1.6, 2.2, 1.8, 1.0, 1.5, 2.4]
    curve = [(1.3 * k, heights[k]) for k in range(9)]
    boxes = {}
    for level in range(4):
        for k in range(1 << level):
            part = curve[k * 8 >> level:((k + 1) * 8 >> level) + 1]
            ys = [p[1] for p in part]
            boxes[level, k] = (part[0][0], min(ys), part[-1][0], max(ys))
    return curve, boxes


def visits_of(boxes, other):
    """Which boxes are entered, left and found by the box of a small body, from the root down."""
    kinds, todo = {}, [(0, 0)]
    while todo:
        level, k = todo.pop()
        x, y, u, v = boxes[level, k]
        if u < other[0] or other[2] < x or v < other[1] or other[3] < y:
            kinds[level, k] = "pruned"
        elif level == 3:
            kinds[level, k] = "found"
        else:
            kinds[level, k] = "visited"
            todo += [(level + 1, 2 * k), (level + 1, 2 * k + 1)]
    return kinds


def traversal():
    colors = {"visited": "a-line", "pruned": "faint-line dashed", "found": "b-line"}
    curve, boxes = tree_boxes()
    small = (4.35, 1.75, 4.85, 2.75)
    kinds = visits_of(boxes, small)

    def at(p):
        return (24 + 31 * p[0], 156 - 46 * p[1])
    made = [line([at(p) for p in curve], "ink-line"),
            polygon([at((small[0], small[3])), at((small[2], small[3])), at((4.6, small[1]))], "both solid both-line")]
    order = sorted(kinds, key=lambda n: list(colors).index(kinds[n]) if kinds[n] != "pruned" else -1)
    for level, k in order:
        x, y, u, v = boxes[level, k]
        pad = 0.13 * (3 - level) / 3 + 0.03
        (left, top), (right, bottom) = at((x - pad, v + pad)), at((u + pad, y - pad))
        made.append(box(left, top, right - left, bottom - top, f"line {colors[kinds[level, k]]}"))

    def node(level, k):
        return (380 + 240 * (2 * k + 1) / (2 << level), 40 + 38 * level)
    for level, k in sorted(kinds):
        if level:
            made.append(line([node(level - 1, k // 2), node(level, k)], "faint-line"))
    for level, k in sorted(kinds):
        made.append(f'<circle cx="{number(node(level, k)[0])}" cy="{number(node(level, k)[1])}" r="9" '
                    f'class="card {colors[kinds[level, k]]}" stroke-width="3"/>')
    for x, kind, tells, color in ((24, "visited", "boxes meet: go on below", "a"),
                                  (235, "pruned", "boxes apart: nothing below", "faint"),
                                  (450, "found", "leaf: look at triangles", "b")):
        made += [words(x, 190, kind, f"{color} strong", "start"), words(x, 210, tells, color, "start")]
    return drawing("Traversal: which boxes of a tree are visited, pruned and found", 224, made)


def coverage():
    made = []
    rows = [("complete", 8, "every pair; none means none"),
            ("first", 1, "stopped at the first pair, as requested"),
            ("cut", 5, "ended by a limit or deadline")]
    for k, (name, known, tells) in enumerate(rows):
        y = 22 + 48 * k
        made.append(words(24, y + 22, name, "ink strong", "start"))
        for cell in range(8):
            kind = "both solid both-line" if cell < known else "card faint-line dashed"
            made.append(box(112 + 22 * cell, y + 8, 18, 18, kind, 3))
        made.append(words(304, y + 22, tells, "faint", "start"))
        if name == "cut":
            x = 112 + 22 * known - 2
            made.append(line([(x, y + 1), (x, y + 33)], "ink-line"))
    return drawing("Coverage: how much of the answer is there", 166, made)


def fnv(data):
    total = 0xcbf29ce484222325
    for byte in data:
        total = (total ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return f"{total:016x}"


PAIRS = [(3, 17), (3, 18), (260, 4)]


def bytes_of(pairs):
    return b"".join(n.to_bytes(4, "little") for pair in pairs for n in pair)


def hashes():
    made = [words(24, 36, "pairs, sorted", "ink strong", "start"),
            words(150, 36, "as bytes: 32 bits each, the least byte first", "ink strong", "start")]
    for k, pair in enumerate(PAIRS):
        y = 62 + 24 * k
        made += [words(24, y, f"({pair[0]}, {pair[1]})", "mono both", "start"),
                 words(150, y, " ".join(f"{byte:02x}" for byte in bytes_of([pair])), "mono a", "start")]
    made += [arrow((350, 84), (426, 84), "ink"), words(388, 74, "FNV-1a", "faint"),
             words(440, 88, fnv(bytes_of(PAIRS)), "mono ink strong", "start"),
             words(24, 148, "no pairs", "faint", "start"), words(150, 148, "no bytes", "faint", "start"),
             arrow((350, 144), (426, 144), "ink"), words(440, 148, fnv(b""), "mono ink strong", "start")]
    return drawing("Hash: sixteen hex digits that stand for a whole list of pairs", 166, made)


def bracket():
    """The line of numbers near the root of 8, which lies between two doubles."""
    left, step, y = 80, 80, 70
    ticks = [left + step * k for k in range(7)]
    lower, upper = ticks[3], ticks[4]
    truth = lower + 0.43 * step  # where it lies between them
    made = [line([(40, y), (600, y)], "ink-line")]
    made += [line([(x, y - 8), (x, y + 8)], "ink-line") for x in ticks]
    made += [line([(lower, y), (upper, y)], "thick both-line"), dot((truth, y), "both"),
             words(truth, y - 22, "the distance", "both strong"),
             words(lower - 8, y + 30, "lower", "both strong"), words(upper + 8, y + 30, "upper", "both strong"),
             words(left - 40, y - 22, "each line is a double", "faint", "start")]
    y = 142
    made += [arrow((lower, y), (44, y), "a"), arrow((upper, y), (596, y), "b"), dot((lower, y), "a", 4),
             dot((upper, y), "b", 4), words((44 + lower) / 2, y + 24, "D up to here: not within D", "a"),
             words((596 + upper) / 2, y + 24, "D from here on: within D", "b")]
    return drawing("Bracket: the doubles next to a distance, and within, which is decided exactly", 182, made)


def closest():
    """A triangle seen from above, cut off from what is nearest to its corners and edges."""
    a, b, c = (190, 170), (350, 170), (240, 60)  # a to b is level

    def out(p, q, r, far):
        """From p across the side from p to q, away from r."""
        across = (q[1] - p[1], p[0] - q[0])
        inward = across[0] * (r[0] - p[0]) + across[1] * (r[1] - p[1])
        length = (across[0] ** 2 + across[1] ** 2) ** 0.5 * (-1 if inward > 0 else 1)
        return (p[0] + far * across[0] / length, p[1] + far * across[1] / length)

    made = [polygon([a, b, c], "a pale a-line")]
    for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
        made += [line([p, out(p, q, r, 54)], "faint-line dashed"), line([q, out(q, p, r, 54)], "faint-line dashed")]
    samples = [((255, 128), (255, 128), "both"), ((270, 210), (270, 170), "both"), ((150, 196), a, "both")]
    for point, nearest_to, color in samples:
        made += [line([point, nearest_to], f"thick {color}-line"), dot(point, "ink", 4), dot(nearest_to, color, 4)]
    made += [words(255, 118, "face", "a strong"), words(278, 228, "edge", "a strong", "start"),
             words(142, 216, "vertex", "a strong", "end"),
             words(410, 84, "seen from above", "faint", "start"),
             words(410, 112, "face: above or below it", "ink", "start"),
             words(410, 140, "edge: beside a side", "ink", "start"),
             words(410, 168, "vertex: beyond a corner", "ink", "start"),
             words(410, 196, "red: the nearest point", "both", "start")]
    return drawing("Feature: where on a triangle its nearest point to another point lies", 244, made)


def ray():
    """A ray through a body, along the ridge of a roof, into a second body where it ends."""
    y = 96
    through = [(110, 60), (210, 44), (238, 128), (128, 146)]
    roof = [(296, 150), (340, y), (384, 150)]
    last = [(442, 48), (560, 66), (548, 146), (432, 138)]

    def where(p, q):
        """The x at which the side from p to q is at the height of the ray."""
        return p[0] + (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1])

    end = (508, y)
    hits = [((where(through[3], through[0]), y), "enter", "a"), ((where(through[1], through[2]), y), "leave", "b"),
            (roof[1], "graze", "both"), ((where(last[3], last[0]), y), "enter", "a")]
    made = [polygon(body, "card rim-line") for body in (through, roof, last)]
    made += [line([*body, body[0]], "ink-line") for body in (through, roof, last)]
    made += [line([(44, y), end], "faint-line"), dot((44, y), "ink"), words(44, y - 14, "origin", "ink strong"),
             line([(end[0], y - 9), (end[0], y + 9)], "faint-line"), words(end[0], y - 17, "length", "faint")]
    for place, kind, color in hits:
        low = kind != "graze"
        at = (place[0], 176) if low else (place[0], 30)
        made += [line([place, (at[0], at[1] + (-16 if low else 8))], f"{color}-line dashed"), dot(place, color),
                 words(at[0], at[1], kind, f"{color} strong")]
    return drawing("Ray: where it enters bodies, leaves them, and grazes a ridge", 196, made)


def own_axes(view, origin, up, color):
    """The axes x and `up` of a file, named at their ends."""
    made = []
    for name, step in (("x", (1.3, 0, 0)), up):
        end = view([origin[k] + step[k] for k in range(3)])
        made += [arrow(view(origin), end, color), words(end[0] + 5, end[1] - 4, name, f"{color} strong", "start")]
    return [*made, dot(view(origin), color, 4)]


def two_axes():
    made = []
    for (x, title, _, _, overlaps), duct in zip(panels("axes"), (DUCT, TURNED)):
        view = View(x - 95, 150, 31)
        start, end = duct
        if overlaps:  # its half behind the wall, the wall, its half before it
            halves = [(start, (3, *end[1:])), ((3.25, *start[1:]), end)]
        else:
            halves = [duct]
        made += [polygon(view.path(f), "b solid b-line") for f in faces(*halves[0])[1] if not overlaps]
        made += [polygon(view.path(f), "a pale a-line") for f in faces(*SLAB)[1]]
        made += [polygon(view.path(f), "b solid b-line") for f in faces(*halves[0])[1] if overlaps]
        made += [polygon(view.path(f), "card") for f in faces(*WALL)[1] if overlaps]
        made += [polygon(view.path(f), "a pale a-line") for f in faces(*WALL)[1]]
        if overlaps:
            made += [polygon(view.path(f), "b solid b-line") for f in faces(*halves[1])[1]]
            y, z, v, w = *start[1:], *end[1:]
            made.append(line(view.path([(3.25, y, z), (3.25, v, z), (3.25, v, w), (3.25, y, w), (3.25, y, z)]),
                             "thick both-line"))
        made += own_axes(view, (0, 0, 0.25), ("z", (0, 0, 1.3)), "a")
        # What is up in the file of B: its y, which lies down until it is turned.
        made += own_axes(view, (end[0], end[1], end[2]), ("y", (0, 0, 1.3) if overlaps else (0, 1.3, 0)), "b")
        made += verdict(x, 244, title, overlaps)
    return drawing("Axes: a duct with y up lies under a hall with z up until it is turned", 280, made)


DRAWINGS = {
    "axes": two_axes, "touching": touching, "crossing": crossing, "coplanar": coplanar, "inside": inside, "gap": gap,
    "pose": pose, "parts": parts, "traversal": traversal, "coverage": coverage, "hash": hashes,
    "nearest": nearest, "bracket": bracket, "closest": closest, "ray": ray, "motion": motion,
}


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    if len(sys.argv) > 2 or any(word.startswith("-") for word in sys.argv[1:]):
        sys.exit("usage: draw_terms.py [FOLDER]   (without it: docs/pictures/terms)")
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else root / "docs/pictures/terms"
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in DRAWINGS.items():
        (folder / f"{name}.svg").write_text(draw(), encoding="utf-8")


if __name__ == "__main__":
    main()
