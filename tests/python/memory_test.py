"""R98: calls leave no memory behind, and arrays stay good when their answers are gone.

Bytes are counted: those of the C library that are in use, and blocks of Python's allocator. A call
that lost sixteen bytes would show after ten thousand calls. With SOMS_TEST_LARGE a million calls are
made.
"""
import ctypes
import gc
import os
import sys
import tempfile
import unittest

import numpy as np

import soms

CALLS = 1_000_000 if os.environ.get("SOMS_TEST_LARGE") else 20_000
ALLOWED_BYTES = 64 * 1024
ALLOWED_BLOCKS = 200


class Mallinfo(ctypes.Structure):
    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks",
        "fordblks", "keepcost")]


def bytes_in_use():
    mallinfo = ctypes.CDLL(None).mallinfo2
    mallinfo.restype = Mallinfo
    info = mallinfo()
    return info.uordblks + info.hblkhd


class Memory(unittest.TestCase):
    def setUp(self):
        self.mesh = soms.generate("drone")
        self.shape = soms.Shape(self.mesh)
        self.body = soms.Body(self.shape)
        self.closed = soms.ClosedBody(self.body)
        self.pose = soms.Pose.translation(0.1, 0, 0)
        self.poses = np.zeros((3, 3))
        self.point = np.zeros(3)
        self.scene = soms.Scene()
        self.mover = self.scene.add_mover(self.body)
        self.scene.add_environment(self.shape)
        self.index = soms.BodyIndex([self.body, self.shape])

    def check_flat(self, call, calls=CALLS):
        """The second half of the calls takes no more than the first."""
        for _ in range(calls // 2):
            call()
        gc.collect()
        bytes_before, blocks_before = bytes_in_use(), sys.getallocatedblocks()
        for _ in range(calls // 2):
            call()
        gc.collect()
        self.assertLess(bytes_in_use() - bytes_before, ALLOWED_BYTES)
        self.assertLess(sys.getallocatedblocks() - blocks_before, ALLOWED_BLOCKS)

    def test_queries(self):
        far = self.body.at([9, 0, 0])

        def call():
            self.assertFalse(soms.overlap(far, self.body, mode="any"))

        self.check_flat(call)

    def test_answers_and_their_arrays(self):
        def call():
            answer = soms.overlap(self.shape, self.body, self.poses + 9)
            pairs, flags, costs = answer.of(0), answer.any, answer.costs
            del answer
            self.assertEqual((len(pairs), len(flags), len(costs)), (0, 3, 3))

        self.check_flat(call, CALLS // 10)

    def test_all_other_calls(self):
        def call():
            soms.distance(self.body.at([9, 0, 0]), self.body).triangles
            soms.within(self.body.at([9, 0, 0]), self.body, 1)
            soms.contains(self.closed, self.point).side
            soms.closest(self.body, self.point + 9).point
            soms.closest_hit(self.body, self.point + 9, self.point + 1)
            soms.nearest_triangles(self.body, self.poses + 9, 2).of(1)
            (self.pose @ self.pose).matrix
            soms.Mesh(self.mesh.vertices, self.mesh.triangles).bounds
            self.scene.set_pose(self.mover, [9, 0, 0])
            self.scene.step().environment
            self.index.closest(self.point + 9).body

        self.check_flat(call, CALLS // 20)

    def test_clashes(self):
        body = soms.Body(soms.Mesh(self.mesh.vertices, self.mesh.triangles))
        parts = soms.PartBodies([body, body.at([0.1, 0, 0])])

        def call():
            clashes = soms.clash(parts, within=1)
            place, table = clashes.place, clashes.columns()
            del clashes
            self.assertEqual((len(place), len(table["class"])), (1, 1))
            soms.PartBodies(self.mesh).names

        self.check_flat(call, CALLS // 200)

    def test_robots(self):
        urdf = b"""<robot name="r"><link name="a"/><link name="b"><collision><geometry>
            <box size="1 1 1"/></geometry></collision></link>
            <joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>"""
        robot = soms.read_robot(urdf, name="r.urdf")
        cell = soms.Mesh(self.mesh.vertices, self.mesh.triangles)
        model = soms.RobotModel(robot, cell)

        def call():
            answer = soms.robot_contacts(model, [[0.0], [1.0]], distance=True)
            contacts, gap = answer.of(0), answer.at(0).gap
            del answer
            self.assertEqual((len(contacts), gap.upper), (1, 0))
            robot.link_poses([[0.0], [1.0]])
            soms.RobotModel(soms.read_robot(urdf, name="r.urdf"), cell).compared

        self.check_flat(call, CALLS // 200)

    def test_pages(self):
        self.check_flat(lambda: soms.Page(self.body).html, CALLS // 200)

    def test_recordings(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "it.somsrec")
            scene = soms.Scene()
            scene.add_mover(soms.Body(self.mesh))

            def call():
                with soms.RecordingWriter(path, scene) as recording:
                    recording.add(scene.step())
                poses = soms.Replay(path)[0].poses
                self.assertEqual(poses.shape, (1, 3, 4))

            self.check_flat(call, CALLS // 100)

    def test_errors(self):
        def call():
            for wrong in (lambda: soms.Mesh([[0, 0, 0]], [[0, 0, -1]]), lambda: soms.Pose("x"),
                          lambda: soms.overlap(self.body, self.body, mode="none"),
                          lambda: soms.read_mesh(b"ply", name="x.ply")):
                with self.assertRaises(soms.Error):
                    wrong()

        self.check_flat(call, CALLS // 20)


if __name__ == "__main__":
    unittest.main()
