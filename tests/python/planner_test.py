"""The motion checker of docs/motion.md serves a planner: a small tree of random states finds its way through a door."""
import math
import pathlib
import random
import re
import unittest

import numpy as np

import soms
from models import box

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/motion.md"
BLOCK = re.compile(r"^```python\n((?:(?!```).)*?def checkMotion.*?)^```", re.MULTILINE | re.DOTALL)


class Rotation:
    def __init__(self, angle):
        self.w, self.x, self.y, self.z = math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2)


class State:
    """As a state of OMPL's SE3 is read; in the plane."""

    def __init__(self, x, y, angle):
        self.values = x, y, angle

    def getX(self):
        return self.values[0]

    def getY(self):
        return self.values[1]

    def getZ(self):
        return 0.0

    def rotation(self):
        return Rotation(self.values[2])


class Tree:
    """Random states, each joined to the nearest one before if both checks allow it."""

    def __init__(self, checker, start, most):
        self.checker, self.most = checker, most
        self.states, self.parents, self.refused = [start], [-1], 0

    def grow(self, aim):
        distances = [math.dist(aim.values[:2], state.values[:2]) for state in self.states]
        nearest = int(np.argmin(distances))
        near = self.states[nearest].values
        share = min(1, self.most / max(distances[nearest], 1e-9))
        state = State(*(a + share * (b - a) for a, b in zip(near, aim.values)))
        if not self.checker.isValid(state):
            return False
        if not self.checker.checkMotion(self.states[nearest], state):
            self.refused += 1
            return False
        self.states.append(state)
        self.parents.append(nearest)
        return share == 1

    def path(self):
        at, found = len(self.states) - 1, []
        while at >= 0:
            found.append(self.states[at])
            at = self.parents[at]
        return found[::-1]


def checker_of_the_page():
    names = {}
    exec(BLOCK.search(PAGE.read_text(encoding="utf-8"))[1], names)  # what a reader would copy
    return names["Checker"]


class Planner(unittest.TestCase):
    def setUp(self):
        self.robot = soms.Shape(box([-0.6, -0.1, -0.1], [0.6, 0.1, 0.1]))
        # Two walls of a millimeter with a door of 1 between them: next to no state is inside of one.
        walls = [box([0, -9, -1], [0.001, -0.5, 1]), box([0, 0.5, -1], [0.001, 9, 1])]
        points = np.concatenate([mesh.vertices for mesh in walls])
        triangles = np.concatenate([np.asarray(mesh.triangles) + 8 * k for k, mesh in enumerate(walls)])
        self.world = soms.Body(soms.Mesh(points, triangles))
        self.checker = checker_of_the_page()(self.robot, self.world)

    def test_a_tree_finds_the_door(self):
        chance = random.Random(7)
        goal = State(4, 2, 1.5)
        tree = Tree(self.checker, State(-4, 2, 1.5), 3)
        for step in range(4000):
            aim = goal if step % 10 == 9 else State(chance.uniform(-5, 5), chance.uniform(-3, 3), chance.uniform(-1.5, 1.5))
            if tree.grow(aim) and aim is goal:
                break
        path = tree.path()
        self.assertIs(tree.parents[0], -1)
        self.assertEqual(path[-1].values, goal.values, "no way was found")
        self.assertGreater(tree.refused, 0)
        for start, end in zip(path, path[1:]):
            motion = soms.RigidMotion.between(self.checker.pose(start), self.checker.pose(end))
            poses = motion.pose_at(np.linspace(0, 1, 200))
            self.assertFalse(soms.overlap(self.robot, self.world, poses, mode="any").any.any())

    def test_a_motion_through_a_thin_wall_is_refused_between_valid_states(self):
        start, end = State(-2, 2, 0), State(2, 2, 0)
        self.assertTrue(self.checker.isValid(start) and self.checker.isValid(end))
        self.assertFalse(self.checker.checkMotion(start, end))
        self.assertFalse(self.checker.isValid(State(0, 2, 0)))
        self.assertTrue(self.checker.checkMotion(State(-2, 0, 0), State(2, 0, 0)))


if __name__ == "__main__":
    unittest.main()
