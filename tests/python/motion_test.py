"""First contacts on the way: known times, batches beside single calls, threads, and what is refused."""
import math
import unittest

import numpy as np

import soms
from models import box, shifts


def shift(x, y=0, z=0):
    return soms.Pose.translation(x, y, z)


def turned(angle, x=0, y=0):
    """A turn about z as a matrix of 4 rows."""
    matrix = np.eye(4)
    matrix[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
    matrix[:2, 3] = x, y
    return matrix


class Motions(unittest.TestCase):
    def setUp(self):
        self.cube = soms.Shape(box([0, 0, 0], [1, 1, 1]))
        self.wall = soms.Body(box([5, -9, -9], [5.001, 9, 9]))

    def fails(self, kind, word, *given, **options):
        for function in (soms.first_contact, soms.free):
            with self.assertRaises(soms.Error) as caught:
                function(*given, **options)
            self.assertEqual(caught.exception.kind, kind, caught.exception)
            self.assertIn(word, caught.exception.place)

    def test_a_step_of_ten_meters_does_not_pass_a_thin_wall(self):
        found = soms.first_contact(self.cube, shift(0), None, self.wall, by=[10, 0, 0])
        self.assertIs(found.verdict, soms.ContactVerdict.contact)
        self.assertLessEqual(found.lower, 0.4)
        self.assertGreaterEqual(found.upper, 0.4)
        self.assertLessEqual(found.upper, np.nextafter(found.lower, 1))
        self.assertEqual(found.point[0], 5)
        self.assertEqual(found.coverage, soms.Coverage.complete)
        a, b = found.triangles
        self.assertTrue(0 <= a < 12 and 0 <= b < 12)
        for start, end in ((shift(0), shift(10)), (np.eye(4)[:3], turned(0, 10)), ([0, 0, 0], [10, 0, 0])):
            by_poses = soms.first_contact(self.cube, start, end, self.wall)
            self.assertIs(by_poses.verdict, soms.ContactVerdict.contact)
            self.assertAlmostEqual(by_poses.lower, 0.4, delta=1e-9)
            self.assertAlmostEqual(by_poses.upper, 0.4, delta=1e-9)
            self.assertTrue(soms.overlap(soms.Body(self.cube, shift(10 * by_poses.upper)), self.wall).any)

    def test_two_bodies_move_at_the_same_time(self):
        cube = soms.Body(self.cube, [99, 0, 0])  # poses of bodies are not used
        to_right = soms.RigidMotion.along(shift(0), [8, 0, 0])
        to_left = soms.RigidMotion.along(shift(9), [-8, 0, 0])
        met = soms.first_contact(cube, to_right, cube, to_left)
        self.assertIs(met.verdict, soms.ContactVerdict.contact)
        self.assertAlmostEqual(met.lower, 0.5, delta=1e-9)
        self.assertAlmostEqual(met.upper, 0.5, delta=1e-9)
        self.assertIs(soms.free(cube, to_right, cube, to_left), False)
        behind = soms.RigidMotion.along(shift(9), [8, 0, 0])
        self.assertIs(soms.free(cube, to_right, cube, behind), True)
        self.assertIs(soms.free(cube, to_right, cube, behind, within=8.5), False)
        # Both turn about one place: they stay as they are to each other.
        turns = [soms.RigidMotion.turn(shift(x), [0, 0, 0], [0, 0, 1], 1) for x in (2, 5)]
        self.assertIs(soms.free(cube, turns[0], cube, turns[1], within=1.9), True)
        self.fails("usage", "a list of motions", cube, [to_right], cube, to_left)
        self.fails("usage", "pivot and by", cube, to_right, cube, to_left, by=[1, 0, 0])

    def test_what_touches_may_part(self):
        beside = soms.Body(box([1, 0, 0], [2, 1, 1]))
        self.assertEqual(soms.first_contact(self.cube, shift(0), None, beside, by=[-3, 0, 0]).upper, 0)
        away = soms.first_contact(self.cube, shift(0), None, beside, by=[-3, 0, 0], parting=True)
        self.assertIs(away.verdict, soms.ContactVerdict.started)
        self.assertEqual((away.lower, away.upper, away.triangles), (1, math.inf, None))
        ways = [soms.RigidMotion.along(soms.Pose(), [s, 0, 0]) for s in (-3, 3)]
        both = soms.first_contact(self.cube, ways, beside, parting=True)
        self.assertEqual(both.lower[0], 1)
        self.assertLessEqual(both.upper[1], 1)
        with self.assertRaises(soms.Error):
            soms.first_contact(self.cube, ways, beside, parting=True, within=1)

    def test_a_clearance_is_met_sooner(self):
        found = soms.first_contact(self.cube, shift(0), shift(10), self.wall, within=1)
        self.assertAlmostEqual(found.upper, 0.3, delta=1e-9)
        self.assertIsNone(found.normal)
        beside = soms.Body(box([0, 3, 0], [1, 4, 1]))
        self.assertTrue(soms.free(self.cube, shift(-9), shift(9), beside, within=1.999))
        self.assertFalse(soms.free(self.cube, shift(-9), shift(9), beside, within=2.001))

    def test_a_turning_blade_meets_a_post_in_the_middle(self):
        blade = soms.Shape(box([0, -0.01, -0.01], [2, 0.01, 0.01]))
        post = soms.Body(box([-0.3, 1.5, -1], [0.3, 1.6, 1]))
        found = soms.first_contact(blade, np.eye(4), turned(3), post)
        self.assertIs(found.verdict, soms.ContactVerdict.contact)
        self.assertTrue(0.4 < found.lower <= found.upper < 0.5)
        # The same turn about the tip of the blade goes the other way round the post.
        tip = soms.first_contact(blade, np.eye(4), turned(3, 2 - 2 * math.cos(3), -2 * math.sin(3)), post, pivot=[2, 0, 0])
        self.assertIs(tip.verdict, soms.ContactVerdict.free)
        self.assertEqual((tip.lower, tip.upper, tip.triangles), (1, math.inf, None))

    def test_a_normal_where_a_corner_meets_a_face(self):
        spike = soms.Shape(soms.Mesh([[0, 0, 0], [-1, -1, -1], [-1, 1, -1], [-1, 0, 1]],
                                     [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]))
        found = soms.first_contact(spike, [0, 0.3, 0.4], None, self.wall, by=[8, 0, 0])
        self.assertAlmostEqual(found.upper, 5 / 8, delta=1e-15)
        np.testing.assert_allclose(found.normal, [-1, 0, 0], atol=1e-12)
        np.testing.assert_allclose(found.point, [5, 0.3, 0.4])
        batch = soms.first_contact(spike, shifts([0, 0.3, 0.4], [-9, 0, 0]), None, self.wall, by=[8, 0, 0])
        np.testing.assert_array_equal(batch.normal[0], found.normal)
        self.assertTrue(np.isnan(batch.normal[1]).all())
        np.testing.assert_array_equal(batch.triangles, [found.triangles, (-1, -1)])

    def test_batches_are_single_calls_for_any_number_of_threads(self):
        shape = soms.Shape(soms.generate("knot", 500))
        fixed = soms.Body(shape, turned(0.4))
        angles = np.linspace(0, 6, 40)
        starts = np.array([turned(a, 9 - a, a) for a in angles])
        # Every second one ends next to its start; shifts get longer, up to one that ends in the other.
        ends = np.array([turned(a + 1, -a, 2 - a) if k % 2 else turned(a, 9.1 - a, a) for k, a in enumerate(angles)])
        moves = np.linspace(0, 1, 40)[:, None] * np.column_stack([angles - 9, -angles, 0 * angles])
        for options in ({"end": ends, "pivot": [1, 0, 0]}, {"end": ends, "within": 0.5}, {"end": None, "by": moves}):
            end, by = options.pop("end"), options.pop("by", None)
            batch = soms.first_contact(shape, starts, end, fixed, by=by, **options)
            self.assertEqual(batch, soms.first_contact(shape, starts, end, fixed, by=by, threads=2, **options))
            self.assertEqual(len(batch), 40)
            self.assertGreater(len(set(batch.verdict.tolist())), 1)
            for k in range(40):
                one = soms.first_contact(shape, starts[k], None if end is None else end[k], fixed,
                                         by=None if by is None else by[k], **options)
                self.assertEqual(batch.at(k), one)
                self.assertEqual((batch.lower[k], batch.upper[k]), (one.lower, one.upper))
            flags = soms.free(shape, starts, end, fixed, by=by, threads=2, **options)
            self.assertEqual((flags.dtype, flags.shape), (np.bool_, (40,)))
            np.testing.assert_array_equal(flags, batch.verdict == soms.ContactVerdict.free)

    def test_one_goes_with_many(self):
        ends = shifts([3, 0, 0], [10, 0, 0], [-9, 0, 0])
        expected = [True, False, True]
        self.assertEqual(soms.free(self.cube, shift(0), ends, self.wall).tolist(), expected)
        self.assertEqual(soms.free(self.cube, ends, shift(0), self.wall).tolist(), expected)
        self.assertEqual(soms.free(self.cube, shift(0), None, self.wall, by=ends).tolist(), expected)
        starts = [shift(0), shift(-7), shift(7)]
        self.assertEqual(soms.free(self.cube, starts, None, self.wall, by=[9, 0, 0]).tolist(), [False, True, True])
        self.assertIs(soms.free(self.cube, shift(0), shift(3), self.wall), True)
        self.assertEqual(len(soms.first_contact(self.cube, np.zeros((0, 4, 4)), shift(1), self.wall)), 0)
        self.assertEqual(soms.free(self.cube, np.zeros((0, 3)), None, self.wall, by=np.zeros((0, 3))).shape, (0,))
        self.assertEqual(len(soms.first_contact(self.cube, [[0, 0, 0]], None, self.wall, by=[[1, 0, 0]])), 1)

    def test_what_starts_in_contact_and_what_time_leaves(self):
        found = soms.first_contact(self.cube, shift(4.5), shift(9), self.wall)
        self.assertIs(found.verdict, soms.ContactVerdict.started)
        self.assertEqual((found.lower, found.upper), (0, 0))
        starts = shifts([0, 0, 0], [1, 0, 0])
        batch = soms.first_contact(self.cube, starts, shift(9), self.wall, timeout=0)
        self.assertEqual(batch.coverage.tolist(), [soms.Coverage.cut] * 2)
        self.assertEqual(batch.verdict.tolist(), [soms.ContactVerdict.grazing] * 2)
        # Nothing is proved, so nothing is free.
        self.assertEqual(soms.free(self.cube, starts, shift(9), self.wall, timeout=0).tolist(), [False, False])

    def test_the_pose_of_a_body_that_moves_is_not_used(self):
        body = soms.Body(self.cube, shift(100))
        self.assertEqual(soms.first_contact(body, shift(0), shift(10), self.wall),
                         soms.first_contact(self.cube, shift(0), shift(10), self.wall))

    def test_motions_have_poses_on_the_way(self):
        turn = soms.RigidMotion.turn(shift(2), [1, 1, 0], [0, 0, 2], 1)
        self.assertEqual(turn.pose_at(0), turn.start)
        self.assertEqual(turn.pose_at(1.0), turn.end)
        times = np.linspace(0, 1, 9)
        poses = turn.pose_at(times)
        self.assertEqual(poses.shape, (9, 4, 4))
        for t, pose in zip(times, poses):
            np.testing.assert_array_equal(pose[:3], turn.pose_at(t).matrix)
            np.testing.assert_array_equal(pose[3], [0, 0, 0, 1])
            np.testing.assert_allclose(soms.Pose(pose).apply(turn.pivot), [1, 1, 0], atol=1e-15)
        self.assertEqual(turn.pose_at([]).shape, (0, 4, 4))
        along = soms.RigidMotion.along(turned(1), [4, 0, 0])
        self.assertTrue(along.straight and not turn.straight)
        np.testing.assert_array_equal(along.pose_at(0.5).matrix[:, :3], along.start.matrix[:, :3])
        np.testing.assert_allclose(along.pose_at(0.5).shift, [2, 0, 0])
        self.assertEqual(soms.RigidMotion(), soms.RigidMotion.between(shift(0), shift(0)))
        self.assertNotEqual(along, turn)
        for t in (-0.1, 1.1, math.nan, [0, 2]):
            with self.assertRaises(soms.Error) as caught:
                turn.pose_at(t)
            self.assertEqual(caught.exception.kind, "usage")
        with self.assertRaises(soms.Error):
            turn.pose_at([[0.5]])
        for make in (lambda: soms.RigidMotion.turn(shift(0), [0, 0, 0], [0, 0, 1], 4),
                     lambda: soms.RigidMotion.turn(shift(0), [0, 0, 0], [0, 0, 0], 1),
                     lambda: soms.RigidMotion.along(shift(0), [math.inf, 0, 0]),
                     lambda: soms.RigidMotion.between(2 * np.eye(4)[:3], shift(0))):
            self.assertRaises(soms.Error, make)

    def test_motions_stand_for_their_poses(self):
        starts = [shift(0), turned(1), shift(9)]
        ends = [turned(2, 10), shift(3), shift(9, 9)]
        motions = [soms.RigidMotion.between(start, end, [0, 1, 0]) for start, end in zip(starts, ends)]
        given = [soms.Pose(start) for start in starts], [soms.Pose(end) for end in ends]
        batch = soms.first_contact(self.cube, motions, self.wall, threads=2)
        self.assertEqual(batch, soms.first_contact(self.cube, *given, self.wall, pivot=[0, 1, 0]))
        self.assertEqual(batch, soms.first_contact(self.cube, tuple(motions), body=self.wall))
        self.assertEqual(soms.free(self.cube, motions, self.wall).tolist(), [False, True, True])
        for k, motion in enumerate(motions):
            self.assertEqual(soms.first_contact(self.cube, motion, self.wall), batch.at(k))
            self.assertIs(soms.free(self.cube, motion, self.wall), k > 0)
        straight = soms.RigidMotion.along(shift(0), [10, 0, 0])
        self.assertEqual(soms.first_contact(self.cube, straight, self.wall, within=1),
                         soms.first_contact(self.cube, shift(0), None, self.wall, by=[10, 0, 0], within=1))

    def test_the_first_that_is_blocked(self):
        path = shifts([0, 0, 0], [3, 0, 0], [3, 5, 0], [9, 5, 0], [0, 0, 0])
        batch = soms.first_contact(self.cube, path[:-1], path[1:], self.wall)
        self.assertEqual(batch.first_blocked, 2)
        self.assertIsNone(soms.first_contact(self.cube, path[:2], path[1:3], self.wall).first_blocked)

    def test_what_is_refused(self):
        cube, wall = self.cube, self.wall
        self.fails("usage", "neither", cube, shift(0), None, wall)
        self.fails("usage", "both", cube, shift(0), shift(1), wall, by=[1, 0, 0])
        self.fails("usage", "pivot", cube, shift(0), None, wall, by=[1, 0, 0], pivot=[0, 0, 0])
        self.fails("usage", "pivot", cube, shift(0), shift(1), wall, pivot=[0, 0])
        self.fails("usage", "2 and 3", cube, np.zeros((2, 3)), np.zeros((3, 3)), wall)
        self.fails("usage", "2 and 3", cube, np.zeros((2, 3)), None, wall, by=np.zeros((3, 3)))
        self.fails("usage", "start: ", cube, np.zeros((2, 5)), shift(1), wall)
        self.fails("usage", "end: ", cube, shift(1), np.zeros(5), wall)
        self.fails("usage", "by", cube, shift(1), None, wall, by=[1, 2])
        self.fails("usage", "within", cube, shift(0), shift(1), wall, within=-1)
        self.fails("not_rigid", "start: ", cube, 2 * np.eye(4)[:3], shift(1), wall)
        bad = np.array([np.eye(4)[:3]] * 4)
        bad[2] *= 2
        self.fails("not_rigid", "motion 2: ", cube, bad, shift(1), wall)
        self.fails("not_finite", "motion 1: ", cube, shift(0), None, wall, by=[[0, 0, 1], [0, math.nan, 0]])
        self.fails("out_of_range", "motion 1: ", cube, shift(0), None, wall, by=[[0, 0, 1], [0, 2.0**301, 0]])
        motion = soms.RigidMotion()
        self.fails("usage", "pivot and by", cube, motion, wall, by=[1, 0, 0])
        self.fails("usage", "pivot and by", cube, [motion], wall, pivot=[1, 0, 0])
        self.fails("usage", "an end is given", cube, motion, shift(1), wall)
        for given in ((shift(0), shift(1)), (motion,), ([motion, shift(0)], wall)):
            for function in (soms.first_contact, soms.free):
                self.assertRaises(TypeError, function, cube, *given)


if __name__ == "__main__":
    unittest.main()
