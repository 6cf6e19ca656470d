"""Scenes: steps, gaps, queries of points and rays, contacts from step to step; R97: whose body it is."""
import unittest

import numpy as np

import soms
from models import shifts, tetrahedron


class Named:
    """An object of the caller, which has vertices and faces and more."""

    def __init__(self, name):
        mesh = tetrahedron()
        self.name, self.vertices, self.faces = name, mesh.vertices, mesh.triangles


class Scenes(unittest.TestCase):
    def setUp(self):
        self.scene = soms.Scene()
        self.given = [Named(f"body {i}") for i in range(4)]
        self.floor = self.scene.add_environment(self.given[0])
        self.movers = [self.scene.add_mover(body) for body in self.given[1:]]
        self.scene.set_poses(shifts([0.5, 0, 0], [0.6, 0, 0], [9, 0, 0]))

    def test_answers_name_the_bodies_of_the_caller(self):
        report = self.scene.step()
        touching = {(self.scene.given_mover(row["mover"]), self.scene.given_environment(row["part"]))
                    for row in report.environment}
        self.assertEqual(touching, {(self.given[1], self.given[0]), (self.given[2], self.given[0])})
        pairs = {(self.scene.given_mover(row["a"]), self.scene.given_mover(row["b"]))
                 for row in report.movers}
        self.assertEqual(pairs, {(self.given[1], self.given[2])})
        body = soms.Body(tetrahedron(), name="by name")
        number = self.scene.add_mover(body)
        self.assertIs(self.scene.given_mover(number), body)
        self.assertEqual(self.scene.mover(number).name, "by name")
        self.scene.remove_mover(number)
        with self.assertRaises(soms.Error):
            self.scene.given_mover(number)

    def test_steps_are_those_of_overlap_by_any_number_of_threads(self):
        one, two = (self.scene.step(threads=n) for n in (1, 2))
        self.assertEqual(one, two)
        self.assertEqual(one.hash(), two.hash())
        self.assertEqual(one.touching_movers.tolist(), self.movers[:2])
        rows = one.environment[one.environment["mover"] == self.movers[0]]
        pairs = soms.overlap(self.scene.mover(self.movers[0]), tetrahedron()).pairs
        self.assertEqual(np.stack([rows["i"], rows["j"]], axis=1).tolist(), pairs.tolist())

    def test_gaps(self):
        report = self.scene.step(clearance=100)
        gap = report.environment_gaps[report.environment_gaps["mover"] == self.movers[2]][0]
        self.assertEqual((gap["lower"], gap["upper"]), (8, 8))
        self.assertEqual(gap["point_a"][0] - gap["point_b"][0], 8)

    def test_passages(self):
        self.scene.step()
        before = self.scene.mover(self.movers[2]).pose
        self.scene.set_pose(self.movers[2], [-10, 0, 0])
        report = self.scene.step(swept=True, threads=2)
        rows = report.environment_passages
        self.assertEqual((report.swept, rows["mover"].tolist()), (True, [self.movers[2]]))
        self.assertEqual(soms.ContactVerdict(int(rows["verdict"][0])), soms.ContactVerdict.contact)
        found = soms.first_contact(
            self.scene.mover(self.movers[2]).shape, before, [-10, 0, 0], self.scene.environment(self.floor),
            pivot=[0.5, 0.5, 0.5])
        self.assertEqual((rows["lower"][0], rows["upper"][0]), (found.lower, found.upper))
        self.assertEqual(set(report.mover_passages["b"]), {self.movers[2]})

    def test_ignored_pairs_and_groups(self):
        self.scene.ignore(self.movers[0], self.movers[1])
        self.assertEqual(len(self.scene.step().movers), 0)
        self.scene.unignore(self.movers[0], self.movers[1])
        self.scene.ignore_environment(self.movers[0], self.floor)
        self.assertEqual(set(self.scene.step().environment["mover"]), {self.movers[1]})
        for mover in self.movers:
            self.scene.set_group(mover, 1)
        self.assertEqual(len(self.scene.step().movers), 0)

    def test_points_and_rays(self):
        nearest = self.scene.closest([20, 0, 0])
        self.assertEqual(nearest.body, (soms.SceneBodyKind.mover, self.movers[2]))
        self.assertEqual((nearest.lower, nearest.upper), (10, 10))
        batch = self.scene.closest([[20, 0, 0]], threads=2)
        self.assertEqual(batch.at(0), nearest)
        self.assertEqual(batch.body.tolist(), [[1, self.movers[2]]])
        hit = self.scene.closest_hit([20, 0.25, 0.25], [-1, 0, 0], ignore=("mover", self.movers[2]))
        self.assertEqual(hit.body, (soms.SceneBodyKind.mover, self.movers[1]))
        self.assertFalse(self.scene.any_hit([20, 0.25, 0.25], [1, 0, 0]))
        every = self.scene.all_hits([[20, 0.25, 0.25]], [[-1, 0, 0]])
        self.assertEqual(len(every.body), 8)

    def test_contacts_from_step_to_step(self):
        tracker, spans = soms.ContactTracker(), soms.ContactSpans()
        for step, x in enumerate((0.5, 0.55, 50)):
            self.scene.set_pose(self.movers[0], [x, 0, 0])
            report = self.scene.step()
            events = tracker.follow(report)
            spans.follow(step, report, self.scene)
            changes = [int(e["change"]) for e in events.environment
                       if e["mover"] == self.movers[0]]
            self.assertEqual(changes, [step])
        found = [s for s in spans.spans if s.a[1] == self.movers[0] and s.b[1] == self.floor
                 and s.b[0] == soms.SceneBodyKind.environment]
        self.assertEqual([(s.begin, s.end, s.steps, s.lasts) for s in found], [(0, 1, 2, False)])

    def test_steps_say_what_is_done_and_end_where_that_raises(self):
        shares = []
        self.scene.step(progress=shares.append)
        self.assertEqual(shares, [0.5, 1.0])
        self.scene.step(mover_mover=False, progress=shares.append)
        self.assertEqual(shares[2:], [1.0])

        def enough(_share):
            raise KeyError("enough")
        with self.assertRaises(KeyError):
            self.scene.step(progress=enough)

    def test_one_caller_at_a_time(self):
        def again(_):
            self.scene.step()

        with self.assertRaisesRegex(soms.Error, "another call is running"):
            self.scene.closest(np.zeros((1000, 3)), progress=again)
        self.scene.step()


if __name__ == "__main__":
    unittest.main()
