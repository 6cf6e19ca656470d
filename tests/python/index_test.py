"""BodyIndex: its answers are the nearest of those of single bodies, and name the bodies of the caller."""
import pickle
import unittest

import numpy as np

import soms
from models import Foreign, tetrahedron


class Indexes(unittest.TestCase):
    def setUp(self):
        shape = soms.Shape(tetrahedron())
        self.bodies = [soms.Body(shape, [3 * i, 0, 0]) for i in range(20)] + [Foreign()]
        self.index = soms.BodyIndex(self.bodies)
        self.points = np.random.default_rng(5).uniform([-5, -5, -5], [65, 5, 5], (200, 3))

    def test_points(self):
        batch = self.index.closest(self.points, threads=2)
        self.assertEqual(batch, self.index.closest(self.points))
        of_each = [soms.closest(body, self.points) for body in self.bodies]
        uppers = np.array([answer.upper for answer in of_each])
        self.assertTrue(np.array_equal(batch.upper, uppers.min(axis=0)))
        self.assertTrue(np.array_equal(batch.body, uppers.argmin(axis=0)))
        for i in (0, 7, 199):
            single = self.index.closest(self.points[i])
            self.assertEqual(single, batch.at(i))
            self.assertEqual(single.body, batch.body[i])

    def test_rays(self):
        along = np.tile([1.0, 0, 0], (200, 1))
        rays = self.points * [1, 0.05, 0.05] + [0, 0.25, 0.25]
        batch = self.index.closest_hit(rays, along, threads=2)
        of_each = np.array([soms.closest_hit(body, rays, along).upper for body in self.bodies])
        self.assertTrue(np.array_equal(batch.upper, of_each.min(axis=0)))
        met = batch.body >= 0
        self.assertTrue(met.any() and not met.all())
        self.assertTrue(np.array_equal(batch.body[met], of_each.argmin(axis=0)[met]))
        self.assertTrue(np.array_equal(self.index.any_hit(rays, along).hit, met))
        every = self.index.all_hits([[-9, 0.25, 0.25]], [[1, 0, 0]])
        self.assertEqual(sorted(every.body.tolist()), sorted([i for i in range(21)] * 2))

    def test_whose_body_it_is(self):
        self.assertIs(self.index.given(20), self.bodies[20])
        self.assertEqual(self.index.body(3), self.bodies[3])
        self.assertEqual(len(self.index), 21)
        self.assertIn("21 bodies", repr(self.index))
        for number in (21, 2**32 - 1):
            with self.assertRaises(soms.Error):
                self.index.given(number)
        self.assertEqual(self.index.closest([0, 0, 0]).body, 0)
        self.assertEqual(self.index.closest([0, 0, 0], ignore=0).body, 20)
        again = pickle.loads(pickle.dumps(self.index))
        self.assertEqual(again.closest(self.points), self.index.closest(self.points))

    def test_none(self):
        answer = soms.BodyIndex([]).closest([1, 2, 3])
        self.assertEqual((answer.body, answer.triangle, answer.upper), (None, None, np.inf))
        self.assertIsNone(soms.BodyIndex([]).closest_hit([0, 0, 0], [1, 0, 0]).body)
        with self.assertRaisesRegex(soms.Error, r"bodies\[1\]"):
            soms.BodyIndex([tetrahedron(), "car.ply"])


if __name__ == "__main__":
    unittest.main()
