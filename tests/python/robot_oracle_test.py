"""Robots against an oracle of its own: forward kinematics by other arithmetic, and each pair of closed
bodies decided in whole numbers, triangle by triangle. Links lie in each other, touch and are far; meshes
are cut into groups that are open alone."""
import itertools
import math
import pathlib
import random
import tempfile
import unittest

import numpy as np

import soms

ROBOTS = 200
STATES = 10
# Vertices are multiples of 2^-6, so that untouched and flush bodies occur; poses are doubles of any kind.
GRID = 64
SCALE = 1 << 120
BOX = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
       (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)]
TETRAHEDRON = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def whole(x):
    """A double times SCALE, exactly."""
    numerator, denominator = float(x).as_integer_ratio()
    quotient, rest = divmod(numerator * SCALE, denominator)
    assert rest == 0, x
    return quotient


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def sign(x):
    return (x > 0) - (x < 0)


def side(a, b, c, d):
    """On which side of the plane of a, b, c is d?"""
    return sign(dot(cross(minus(b, a), minus(c, a)), minus(d, a)))


def turn(a, b, c, axes):
    i, j = axes
    return sign((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]))


def flat_segments_meet(p, q, a, b, axes):
    if turn(p, q, a, axes) * turn(p, q, b, axes) > 0 or turn(a, b, p, axes) * turn(a, b, q, axes) > 0:
        return False
    return all(max(min(p[i], q[i]), min(a[i], b[i])) <= min(max(p[i], q[i]), max(a[i], b[i])) for i in axes)


def segment_meets(p, q, triangle):
    """Do a closed segment and a closed triangle that has area share a point?"""
    a, b, c = triangle
    first, second = side(a, b, c, p), side(a, b, c, q)
    if first * second > 0:
        return False
    if first == 0 and second == 0:
        normal = cross(minus(b, a), minus(c, a))
        axes = [i for i in range(3) if i != max(range(3), key=lambda k: abs(normal[k]))]
        turns = {turn(*edge, p, axes) for edge in ((a, b), (b, c), (c, a))}
        return (not {-1, 1} <= turns) or any(
            flat_segments_meet(p, q, *edge, axes) for edge in ((a, b), (b, c), (c, a)))
    signs = {side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)}
    return not {-1, 1} <= signs


def edges(triangle):
    return ((triangle[0], triangle[1]), (triangle[1], triangle[2]), (triangle[2], triangle[0]))


def box_of(points):
    return [(min(p[i] for p in points), max(p[i] for p in points)) for i in range(3)]


def apart(x, y):
    return any(x[i][1] < y[i][0] or y[i][1] < x[i][0] for i in range(3))


def triangles_meet(s, t):
    return any(segment_meets(*edge, t) for edge in edges(s)) or any(segment_meets(*edge, s) for edge in edges(t))


def is_inside(point, triangles):
    """Parity of crossings along a ray that meets no edge. The point is not on the surface."""
    low_high = box_of([corner for t in triangles for corner in t])
    reach = 3 * sum(high - low for low, high in low_high) + sum(abs(x) for x in point) + 1
    for attempt in itertools.count(1):
        far = (point[0] + reach * (7 + attempt), point[1] + reach * 3 + attempt, point[2] + reach * 2 - 5 * attempt)
        inside = False
        for t in triangles:
            begin, end = side(*t, point), side(*t, far)
            around = [side(point, far, *edge) for edge in edges(t)]
            if begin == 0 and end != 0:
                continue  # the ray leaves the plane in the point, which is not of the triangle
            if end == 0 or 0 in around:
                break
            inside ^= begin != end and len(set(around)) == 1
        else:
            return inside


class Solid:
    """A closed body: its corners and faces, and a file that cuts it into groups."""

    def __init__(self, rng, folder, number):
        center = [rng.randint(-GRID, GRID) for _ in range(3)]
        half = rng.choice([GRID // 8, GRID // 2, GRID, 2 * GRID])
        if rng.random() < 0.5:
            extents = [rng.randint(1, half) for _ in range(3)]
            corners = [[c + (e if k >> i & 1 else -e) for i, (c, e) in enumerate(zip(center, extents))]
                       for k in range(8)]
            self.faces = BOX
        else:
            while True:
                corners = [[c + rng.randint(-half, half) for c in center] for _ in range(4)]
                if side(*corners) != 0:
                    break
            self.faces = TETRAHEDRON
        self.corners = np.array(corners) / GRID
        self.groups = rng.choice([1, 1, 2, 3])
        lines = ["v " + " ".join(repr(x) for x in corner) for corner in self.corners.tolist()]
        for k, face in enumerate(self.faces):
            if self.groups > 1 or k == 0:
                lines.append(f"g part{rng.randrange(self.groups)}")
            lines.append("f " + " ".join(str(i + 1) for i in face))
        self.path = folder / f"{number}.obj"
        self.path.write_text("\n".join(lines) + "\n")

    def moved(self, pose):
        """Triangles in whole numbers, of the corners that meaning.md states: rounded sums in this order."""
        points = []
        for x, y, z in self.corners.tolist():
            points.append(tuple(whole(((float(r[0]) * x + float(r[1]) * y) + float(r[2]) * z) + float(r[3]))
                                for r in pose))
        return [tuple(points[i] for i in face) for face in self.faces]


def relation(a, b):
    """'meet', 'inside' or 'apart' of two closed bodies, by their triangles."""
    if apart(box_of([c for t in a for c in t]), box_of([c for t in b for c in t])):
        return "apart"
    boxes = [box_of(t) for t in b]
    for s in a:
        around = box_of(s)
        if any(not apart(around, box) and triangles_meet(s, t) for t, box in zip(b, boxes)):
            return "meet"
    return "inside" if is_inside(a[0][0], b) or is_inside(b[0][0], a) else "apart"


def rotation(axis, angle):
    """Rodrigues' formula, (3, 3)."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)


def motion(shift, turned):
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = turned, shift
    return result


class Arm:
    """A random tree of links, all with meshes, and the poses of its links by numpy."""

    def __init__(self, rng, folder):
        self.links = [Solid(rng, folder, k) for k in range(rng.randint(2, 5))]
        self.joints = []
        text = [f'<link name="l{k}"><collision><geometry><mesh filename="file://{s.path}"/></geometry></collision></link>'
                for k, s in enumerate(self.links)]
        for child in range(1, len(self.links)):
            kind = rng.choice(["revolute", "continuous", "prismatic", "fixed"])
            shift = [rng.choice([0, 0.5, 1, -1.25, 0.1]) for _ in range(3)]
            rpy = [rng.choice([0, 0, math.pi / 2, 0.3, -1.1]) for _ in range(3)]
            axis = rng.choice([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 2, -2), (0.3, 0, 1)])
            parent = rng.randrange(child)
            moving = [k for k, joint in enumerate(self.joints) if joint["kind"] != "fixed" and joint["mimic"] is None]
            mimic = rng.choice(moving) if kind != "fixed" and moving and rng.random() < 0.2 else None
            self.joints.append({"kind": kind, "shift": shift, "rpy": rpy, "axis": axis, "parent": parent,
                                "child": child, "mimic": mimic})
            text.append(f'<joint name="j{child}" type="{kind}"><parent link="l{parent}"/><child link="l{child}"/>'
                        f'<origin xyz="{" ".join(map(repr, shift))}" rpy="{" ".join(map(repr, rpy))}"/>'
                        f'<axis xyz="{" ".join(map(repr, axis))}"/><limit lower="-4" upper="4"/>'
                        + (f'<mimic joint="j{self.joints[mimic]["child"]}" multiplier="-0.5" offset="0.25"/>'
                           if mimic is not None else "") + "</joint>")
        path = folder / "robot.urdf"
        path.write_text('<robot name="r">' + "".join(text) + "</robot>")
        self.robot = soms.read_robot(path)
        self.free = [k for k, joint in enumerate(self.joints) if joint["kind"] != "fixed" and joint["mimic"] is None]

    def value(self, number, state):
        joint = self.joints[number]
        if joint["kind"] == "fixed":
            return 0.0
        if joint["mimic"] is not None:
            return -0.5 * self.value(joint["mimic"], state) + 0.25
        return state[self.free.index(number)]

    def poses(self, state):
        poses = [np.eye(4)] + [None] * (len(self.links) - 1)
        for number, joint in enumerate(self.joints):
            roll, pitch, yaw = joint["rpy"]
            turned = rotation((0, 0, 1), yaw) @ rotation((0, 1, 0), pitch) @ rotation((1, 0, 0), roll)
            value = self.value(number, state)
            moved = np.eye(4)
            if joint["kind"] == "prismatic":
                moved = motion(value * np.asarray(joint["axis"]) / np.linalg.norm(joint["axis"]), np.eye(3))
            elif joint["kind"] != "fixed":
                moved = motion([0, 0, 0], rotation(joint["axis"], value))
            poses[joint["child"]] = poses[joint["parent"]] @ motion(joint["shift"], turned) @ moved
        return poses

    def compared(self):
        """Pairs of links but those that a joint connects: all links have meshes."""
        joined = {frozenset((joint["parent"], joint["child"])) for joint in self.joints}
        return [pair for pair in itertools.combinations(range(len(self.links)), 2) if frozenset(pair) not in joined]


class Oracle(unittest.TestCase):
    def test_random_robots_answer_as_whole_numbers_do(self):
        counts = {"states": 0, "free": 0, "pairs": 0, "meet": 0, "inside": 0, "apart": 0, "cut": 0}
        for number in range(ROBOTS):
            rng = random.Random(number)
            with self.subTest(robot=number), tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                arm = Arm(rng, folder)
                cell = Solid(rng, folder, "cell")
                model = soms.RobotModel(arm.robot, soms.read_mesh(cell.path))
                self.assertEqual([tuple(pair) for pair in model.compared.tolist()], arm.compared())
                counts["cut"] += sum(s.groups > 1 for s in (*arm.links, cell))
                states = np.array([[rng.choice([0, 1, -1, math.pi / 2, rng.uniform(-4, 4)]) for _ in arm.free]
                                   for _ in range(STATES)]).reshape(STATES, len(arm.free))
                self.check(arm, cell, model, states, counts)
        print(f"{ROBOTS} robots:", ", ".join(f"{value:,} {key}" for key, value in counts.items()))
        for key in counts:
            self.assertGreater(counts[key], 50, key)

    def check(self, arm, cell, model, states, counts):
        answer = soms.robot_contacts(model, states, distance=True)
        fixed = cell.moved(np.eye(4))
        for k, (state, poses) in enumerate(zip(states, arm.robot.link_poses(states))):
            for own, given in zip(arm.poses(state), poses):
                self.assertLess(np.abs(own[:3] - given).max(), 1e-12)
            bodies = [link.moved(pose) for link, pose in zip(arm.links, poses)]
            relations = {(a, b, False): relation(bodies[a], bodies[b]) for a, b in arm.compared()}
            relations.update({(a, 0, True): relation(body, fixed) for a, body in enumerate(bodies)})
            wanted = sorted((a, other, of_cell, found == "meet") for (a, other, of_cell), found in relations.items()
                            if found != "apart")
            rows = answer.of(k)
            self.assertEqual(sorted(zip(rows["link"].tolist(), rows["other"].tolist(), rows["cell"].tolist(),
                                        rows["surfaces_meet"].tolist())), wanted)
            self.assertEqual(soms.RobotVerdict(answer.verdict[k]),
                             soms.RobotVerdict.contact if wanted else soms.RobotVerdict.free)
            self.assertEqual(bool(answer.free[k]), not wanted)
            self.assertEqual(answer.gap[k, 1] == 0, bool(wanted))
            counts["states"] += 1
            counts["free"] += not wanted
            counts["pairs"] += len(relations)
            for found in relations.values():
                counts[found] += 1


if __name__ == "__main__":
    unittest.main()
