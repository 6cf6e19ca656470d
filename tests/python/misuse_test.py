"""What a new user may do wrong, or at the same time: nothing of it breaks the interpreter."""
import gc
import os
import pickle
import sys
import tempfile
import threading
import unittest

import numpy as np

import soms
from models import FACES, TETRAHEDRON, shifts, tetrahedron


class Arrays(unittest.TestCase):
    """Arrays of any memory order, step, byte order and right to write give the same answers."""

    def setUp(self):
        self.mover = soms.Shape(tetrahedron())
        self.poses = shifts([0, 0, 0], [9, 9, 9], [0.5, 0, 0])
        self.matrices = np.tile(np.eye(4), (3, 1, 1))
        self.matrices[:, :3, 3] = self.poses

    def ask(self, poses):
        return soms.overlap(self.mover, self.mover, poses).any.tolist()

    def test_poses_of_any_memory(self):
        wide = np.zeros((3, 6))
        wide[:, ::2] = self.poses
        locked = self.matrices.copy()
        locked.flags.writeable = False
        backward = np.ascontiguousarray(self.matrices[::-1])[::-1]
        for poses in (wide[:, ::2], np.asfortranarray(self.poses), self.poses.astype(">f8"),
                      self.poses.astype(np.float32), self.poses.astype(np.float16), self.matrices,
                      self.matrices[:, :3], np.asfortranarray(self.matrices[:, :3]), locked, backward,
                      self.matrices[:, :3].reshape(3, 12), memoryview(self.poses),
                      self.poses.tolist(), tuple(soms.Pose(row) for row in self.poses),
                      self.poses.view(np.recarray)):
            self.assertEqual(self.ask(poses), [True, False, True], type(poses))

    def test_a_call_keeps_its_own_poses(self):
        poses = self.matrices[:, :3].copy()
        wanted = soms.overlap(self.mover, self.mover, poses, mode="any")

        def disturb(_):
            poses[:] = np.nan

        many = np.repeat(poses, 30_000, axis=0)
        view = many[:]

        def disturb_many(_):
            view[:] = np.nan

        answer = soms.overlap(self.mover, self.mover, many, mode="any", progress=disturb_many)
        self.assertTrue(np.array_equal(answer.any, np.repeat(wanted.any, 30_000)))
        self.assertTrue(np.isnan(many).all())
        soms.overlap(self.mover, self.mover, poses, progress=disturb)
        points = np.full((100_000, 3), 0.1)

        def disturb_points(_):
            points[:] = np.nan

        self.assertTrue((soms.contains(self.mover, points, progress=disturb_points).side
                         == soms.Side.inside).all())

    def test_nothing_to_do(self):
        none = np.zeros((0, 3))
        for answer in (soms.overlap(self.mover, self.mover, none),
                       soms.distance(self.mover, self.mover, np.zeros((0, 3, 4))),
                       soms.within(self.mover, self.mover, 1, np.zeros((0, 4, 4))),
                       soms.solid(self.mover, self.mover, np.zeros((0, 7))),
                       soms.contains(self.mover, none), soms.closest(self.mover, none),
                       soms.winding(self.mover, none), soms.near_triangles(self.mover, none, 1),
                       soms.closest_hit(self.mover, none, none),
                       soms.all_hits(self.mover, none, ends=none)):
            self.assertEqual(len(answer), 0)
        self.assertEqual(soms.Pose().apply(none).shape, (0, 3))

    def test_wrong_numbers_are_errors(self):
        nan = np.full((2, 3), np.nan)
        huge = np.full((2, 3), 1e300)
        for wrong in (lambda: self.ask(nan), lambda: self.ask(huge),
                      lambda: self.ask(np.full((2, 3, 4), np.nan)),
                      lambda: self.ask(np.zeros((2, 3, 4))), lambda: self.ask(np.zeros((3, 4))),
                      lambda: self.ask(np.zeros(3)), lambda: self.ask([]), lambda: self.ask("near"),
                      lambda: self.ask([None]), lambda: self.ask(np.zeros((2, 3), dtype=bool)),
                      lambda: self.ask(np.array([["0", "0", "0"]])),
                      lambda: self.ask(np.zeros((2, 3), dtype="M8[s]")),
                      lambda: self.ask([soms.Pose(), None]),
                      lambda: self.ask(np.ma.masked_array(np.zeros((2, 3)), [[0, 0, 0], [0, 1, 0]])),
                      lambda: soms.Mesh(TETRAHEDRON, FACES, unit=np.nan),
                      lambda: soms.Pose.about_z(np.nan), lambda: soms.Pose.translation(0, np.inf, 0),
                      lambda: soms.Pose.from_axis_angle([0, 0, 1], 1, [np.nan, 0, 0]),
                      lambda: soms.closest_hit(self.mover, [0, 0, 9], [0, 0, -1], skip=-1),
                      lambda: soms.closest_hit(self.mover, [0, 0, 9], [0, 0, -1], skip="first"),
                      lambda: soms.closest_hit(self.mover, [0, 0, 9], [0, 0, -1], skip=[1, 2]),
                      lambda: soms.contains(self.mover, nan),
                      lambda: soms.closest_hit(self.mover, nan, nan),
                      lambda: soms.closest_hit(self.mover, [[0, 0, 0]], [[0, 0, 0]]),
                      lambda: soms.nearest_triangles(self.mover, nan, 1),
                      lambda: soms.near_triangles(self.mover, [[0, 0, 0]], -1),
                      lambda: soms.within(self.mover, self.mover, np.nan),
                      lambda: soms.Shape(tetrahedron(), per_leaf=0),
                      lambda: soms.Shape(tetrahedron()).refit(TETRAHEDRON[:3]),
                      lambda: soms.Scene().step(clearance=np.inf),
                      lambda: soms.Scene().set_poses(np.zeros((1, 3)))):
            with self.assertRaises(soms.Error):
                wrong()

    def test_a_mask_that_leaves_nothing_out_is_no_mask(self):
        poses = np.ma.masked_array(self.poses, mask=np.zeros((3, 3)))
        self.assertEqual(self.ask(poses), [True, False, True])

    def test_numbers_beyond_memory(self):
        endless = np.broadcast_to(np.zeros(3), (10**12, 3))
        whole = np.broadcast_to(np.zeros(3, np.int8), (10**12, 3))
        for wrong in (lambda: self.ask(endless), lambda: soms.contains(self.mover, endless),
                      lambda: soms.Mesh(endless, FACES),
                      lambda: soms.Mesh(TETRAHEDRON, whole)):
            with self.assertRaises(MemoryError):
                wrong()

    def test_numbers_that_do_not_fit(self):
        for wrong in (lambda: soms.nearest_triangles(self.mover, np.zeros((1, 3)), -1),
                      lambda: soms.Scene().mover(-1), lambda: soms.Scene().mover(2**40),
                      lambda: soms.overlap(self.mover, self.mover, limit=-1),
                      lambda: soms.generate("sphere", -4)):
            with self.assertRaises((TypeError, soms.Error)):
                wrong()
        nearest = soms.nearest_triangles(self.mover, np.zeros((1, 3)), 2**62)
        self.assertEqual(len(nearest.of(0)), len(FACES))

    def test_names_that_are_no_text(self):
        name = os.fsdecode(b"\xff\xfe.ply")
        with self.assertRaises(soms.Error) as caught:
            soms.read_mesh(name)
        self.assertEqual(caught.exception.kind, "cannot_open")
        self.assertIn(name, caught.exception.place)
        with self.assertRaises(soms.Error):
            soms.read_mesh(b"", name="")
        for wrong in (lambda: soms.read_mesh("a\0b"), lambda: soms.generate("\ud800"),
                      lambda: soms.Body(self.mover, name="\ud800")):
            with self.assertRaises((UnicodeError, ValueError, TypeError)):
                wrong()

    def test_names_in_files_may_be_of_any_encoding(self):
        file = b"g M\xfcller\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"  # Latin-1
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, os.fsdecode(b"\xff.obj"))
            try:
                with open(path, "wb") as model:
                    model.write(file)
            except OSError:
                self.skipTest("the file system takes no such name")
            mesh = soms.read_mesh(path)
            self.assertEqual(mesh.source, path)
            scene = soms.Scene()
            scene.add_environment(soms.Body(mesh, name=mesh.parts[0].name))
            with soms.RecordingWriter(os.path.join(folder, "it"), scene, title=path) as recording:
                recording.add(scene.step())
                self.assertIn("it", repr(recording))
            replay = soms.Replay(os.path.join(folder, "it"))
            self.assertEqual((replay.title, replay.environment[0].mesh.source), (path, path))
        self.assertEqual(mesh.parts[0].name.encode("utf-8", "surrogateescape"), b"M\xfcller")
        self.assertEqual(pickle.loads(pickle.dumps(mesh)), mesh)
        body = soms.Body(mesh, name=mesh.parts[0].name)
        self.assertEqual(pickle.loads(pickle.dumps(body)), body)
        self.assertIn("<h1>M?ller</h1>", soms.Page(body).html)

    def test_a_list_that_changes_while_it_is_read(self):
        listed = [soms.Pose()]

        class Growing:
            def __array__(self, dtype=None):
                listed.extend([soms.Pose()] * 1000)
                return np.zeros(3)

        listed.append(Growing())
        self.assertEqual(self.ask(listed), [True, True])

        class Shrinking:
            def __array__(self, dtype=None):
                del listed[1:]
                return np.zeros(3)

        listed[1:] = [Shrinking(), soms.Pose(), soms.Pose()]
        with self.assertRaises(IndexError):
            self.ask(listed)


class Lifetimes(unittest.TestCase):
    def test_bodies_that_are_gone_stay_in_scenes_and_answers(self):
        scene = soms.Scene()
        body = soms.Body(soms.Shape(soms.generate("car")), name="car")
        scene.add_mover(body)
        index = soms.BodyIndex([body])
        closed = soms.ClosedBody(body)
        vertices = body.shape.mesh.vertices
        copy = vertices.copy()
        del body
        gc.collect()
        churn = [soms.generate("car") for _ in range(20)]
        self.assertEqual(len(scene.step().environment), 0, len(churn))
        self.assertEqual(index.closest([9, 0, 0]).body, 0)
        self.assertEqual(soms.contains(closed, [99, 0, 0]).side, soms.Side.outside)
        self.assertTrue(np.array_equal(vertices, copy))
        report, name = scene.step(clearance=1), scene.mover(0).name
        del scene
        gc.collect()
        self.assertEqual((len(report.movers), name), (0, "car"))

    def test_what_was_pickled_wrongly_is_refused(self):
        for made in (soms.Pose, soms.Mesh, soms.Shape, soms.Body, soms.BodyIndex):
            broken = made.__new__(made)
            with self.assertRaises(Exception):
                made.__setstate__(broken, ("?",))
            with self.assertRaises(Exception):
                made.__setstate__(broken, ())
        with self.assertRaises(TypeError):
            pickle.dumps(soms.Scene())


class Together(unittest.TestCase):
    def test_threads_share_what_does_not_change(self):
        car = soms.Shape(soms.generate("car"))
        index = soms.BodyIndex([soms.Body(car, [4 * i, 0, 0]) for i in range(9)])
        poses = shifts(*[[0.01 * i, 0, 0] for i in range(300)])
        wanted = soms.overlap(car, car, poses, mode="any"), index.closest(poses)
        wrong = []

        def work():
            for _ in range(5):
                found = soms.overlap(car, car, poses, mode="any", threads=2), index.closest(poses, threads=2)
                if found != wanted:
                    wrong.append(found)

        workers = [threading.Thread(target=work) for _ in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(wrong, [])

    def test_threads_are_kept_off_a_scene_in_use(self):
        scene = soms.Scene()
        for i in range(40):
            scene.add_mover(soms.Body(tetrahedron(), [0.01 * i, 0, 0]))
        outcomes = []

        def work():
            for _ in range(20):
                try:
                    outcomes.append(len(scene.step().movers))
                except soms.Error as error:
                    outcomes.append(error.kind)

        workers = [threading.Thread(target=work) for _ in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertLessEqual(set(outcomes), {len(scene.step().movers), "usage"})

    @unittest.skipUnless(hasattr(os, "fork"), "no fork here")
    def test_a_child_process_goes_on(self):
        car = soms.Shape(soms.generate("car"))
        poses = np.zeros((2000, 3))
        wanted = soms.overlap(car, car, poses, mode="any", threads=2)
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            same = soms.overlap(car, car, poses, mode="any", threads=1) == wanted
            os._exit(0 if same else 1)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 0)


if __name__ == "__main__":
    unittest.main()
