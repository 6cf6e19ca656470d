"""Recordings: what a scene writes is what Replay reads, models are found again, and damage is reported."""
import os
import tempfile
import unittest

import numpy as np

import soms
from models import tetrahedron

FRAMES = 130  # more than a chunk holds


class Recordings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.path = os.path.join(self.folder, "run.somsrec")
        self.scene = soms.Scene()
        soms.write_mesh(f"{self.folder}/floor.ply", tetrahedron())
        self.scene.add_environment(
            soms.Body(soms.read_mesh(f"{self.folder}/floor.ply"), name="floor"))
        car = soms.Shape(soms.generate("car"))
        self.cars = [self.scene.add_mover(soms.Body(car, name=f"car {i}")) for i in range(2)]

    def test_passages_of_swept_steps_are_kept(self):
        reports = []
        with soms.RecordingWriter(self.path, self.scene, swept=True) as recording:
            for x in (-9, 9, -9):
                self.scene.set_poses(np.array([[x, 0, 0], [50, 0, 0]]))
                reports.append(self.scene.step(swept=True))
                recording.add(reports[-1])
            with self.assertRaises(soms.Error) as caught:
                recording.add(self.scene.step())
            self.assertEqual(caught.exception.kind, "usage")
        replay = soms.Replay(self.path)
        self.assertTrue(replay.swept)
        self.assertEqual(len(replay), 3)
        for report, frame in zip(reports, replay):
            np.testing.assert_array_equal(frame.environment_passages, report.environment_passages)
            self.assertEqual(len(frame.mover_passages), 0)
        self.assertEqual([len(frame.environment_passages) for frame in replay], [0, 1, 1])

    def record(self, frames=FRAMES, clearance=2.0):
        """The reports of the frames, with the poses of each."""
        steps = []
        with soms.RecordingWriter(self.path, self.scene, title="two cars", frames=frames,
                                  frames_a_second=30, clearance=clearance) as recording:
            for i in range(frames):
                poses = np.array([[0.1 * i, 0, 0], [5 - 0.1 * i, 0.5, 0]])
                self.scene.set_poses(poses)
                report = self.scene.step(clearance=clearance)
                recording.add(report)
                steps.append((poses, report))
            self.assertEqual(recording.so_far.frames, frames)
        return steps

    def bytes(self):
        with open(self.path, "rb") as file:
            return file.read()

    def check_frame(self, frame, poses, report):
        self.assertEqual(frame.poses.shape, (2, 3, 4))
        self.assertTrue(np.array_equal(frame.poses[:, :, 3], poses))
        for name in ("environment", "movers", "environment_gaps", "mover_gaps"):
            self.assertTrue(np.array_equal(getattr(frame, name), getattr(report, name)), name)

    def test_what_is_written_is_read(self):
        steps = self.record()
        for file in (self.path, self.bytes()):
            replay = soms.Replay(file)
            self.assertEqual(len(replay), FRAMES)
            for frame, step in zip(replay, steps):
                self.check_frame(frame, *step)
            for number in (FRAMES - 1, 3, 64, 63, 0):
                self.check_frame(replay[number], *steps[number])
            self.check_frame(replay[-1], *steps[-1])
            for number in (FRAMES, -FRAMES - 1, 2**62):
                with self.assertRaises(IndexError):
                    replay[number]
            self.assertIsNone(replay.fault)
            self.assertEqual((replay.end.ending, replay.end.frames),
                             (soms.RecordingEnding.complete, FRAMES))
            self.assertEqual((replay.title, replay.frames_a_second, replay.clearance,
                              replay.frames_requested), ("two cars", 30, 2, FRAMES))

    def test_models_are_found_again(self):
        self.record(3)
        replay = soms.Replay(self.path)
        self.assertEqual(replay.movers.tolist(), [0, 0])
        floor, car = replay.environment[0].mesh, replay.models[0]
        self.assertEqual((floor.name, floor.origin), ("floor", soms.RecordedOrigin.file))
        self.assertEqual(soms.read_mesh(floor.source).hash(), floor.hash)
        self.assertEqual(os.path.getsize(floor.source), floor.file_size)
        self.assertEqual((car.name, car.origin, car.source),
                         ("car 0", soms.RecordedOrigin.mover, "car"))
        self.assertEqual(soms.generate(car.source).hash(), car.hash)

    def test_a_recording_that_is_cut_plays_up_to_there(self):
        steps = self.record()
        replay = soms.Replay(self.bytes()[:-200], name="cut.somsrec")
        self.assertEqual(len(replay), 128)  # whole chunks
        self.check_frame(replay[-1], *steps[len(replay) - 1])
        self.assertIsNone(replay.end)
        self.assertIsInstance(replay.fault, soms.Error)
        self.assertEqual(replay.fault.kind, "bad_file")
        self.assertIn("cut.somsrec", replay.fault.place)
        with self.assertRaises(soms.Error):
            soms.Replay(b"no recording")
        with self.assertRaises(soms.Error):
            soms.Replay(f"{self.folder}/nowhere.somsrec")

    def test_an_exception_ends_it_as_interrupted(self):
        with self.assertRaises(LookupError):
            with soms.RecordingWriter(self.path, self.scene) as recording:
                recording.add(self.scene.step())
                raise LookupError
        end = soms.Replay(self.path).end
        self.assertEqual((end.ending, end.frames), (soms.RecordingEnding.interrupted, 1))
        for call in (recording.finish, lambda: recording.add(self.scene.step())):
            with self.assertRaisesRegex(soms.Error, "is finished"):
                call()
        self.assertEqual(recording.so_far.frames, 1)

    def test_meshes_that_no_file_holds_are_refused(self):
        for mesh in (tetrahedron(), soms.generate("city", 3000),
                     soms.read_mesh(f"{self.folder}/floor.ply").transformed(2.0)):
            scene = soms.Scene()
            scene.add_environment(mesh)
            with self.assertRaisesRegex(soms.Error, "write it with write_mesh"):
                soms.RecordingWriter(self.path, scene)
        with self.assertRaises(soms.Error) as caught:
            soms.RecordingWriter(f"{self.folder}/no/where", self.scene)
        self.assertEqual(caught.exception.kind, "cannot_write")

    def test_reports_of_other_bodies_are_refused(self):
        recording = soms.RecordingWriter(self.path, self.scene)
        other = soms.Scene()
        for _ in range(4):
            other.add_mover(tetrahedron())
        for report in (other.step(), self.scene.step(clearance=1),
                       self.scene.step(scope="first_contact")):
            with self.assertRaises(soms.Error) as caught:
                recording.add(report)
            self.assertEqual(caught.exception.kind, "usage")
        recording.add(self.scene.step())
        self.scene.remove_mover(self.cars[1])
        with self.assertRaisesRegex(soms.Error, "other bodies"):
            recording.add(self.scene.step())
        with self.assertRaisesRegex(soms.Error, "bodies were removed"):
            self.scene.remove_mover(self.cars[0])
            self.scene.add_mover(tetrahedron())
            soms.RecordingWriter(self.path, self.scene)
        recording.finish("timed_out")
        self.assertEqual(soms.Replay(self.path).end.ending, soms.RecordingEnding.timed_out)


if __name__ == "__main__":
    unittest.main()
