"""Robots: states as the command answers them, poses of links by other arithmetic, errors."""
import json
import os
import pathlib
import pickle
import signal
import subprocess
import tempfile
import unittest

import numpy as np

import soms

DATA = pathlib.Path(__file__).resolve().parent.parent / "data/robots"
COMMAND = pathlib.Path(soms.__file__).resolve().parents[2] / "bin/soms"
COUNT = 300


def arm(srdf=True):
    return soms.read_robot(DATA / "arm.urdf", DATA / "arm.srdf" if srdf else None)


def wall():
    part = soms.Part("wall", 0, 2)
    return soms.Mesh([[0.7, -3, -3], [0.7, 3, -3], [0.7, 3, 3], [0.7, -3, 3]],
                     [[0, 1, 2], [0, 2, 3]], [part])


def turned(axis, angle):
    """Rodrigues' formula: (3, 3)."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)


def whole(pose):
    return np.vstack([pose, [0, 0, 0, 1]])


def poses_by_numpy(robot, state):
    """Poses of all links, by a recursion over the joints."""
    given = dict(zip(robot.movable.tolist(), state))

    def value(number):
        joint = robot.joints[number]
        if joint.mimic:
            followed, multiplier, offset = joint.mimic
            return multiplier * value(followed) + offset
        return given.get(number, 0.0)

    poses = {robot.root: np.eye(4)}
    while len(poses) < len(robot.links):
        for number, joint in enumerate(robot.joints):
            if joint.parent in poses and joint.child not in poses:
                motion = np.eye(4)
                if joint.type == soms.JointType.prismatic:
                    motion[:3, 3] = value(number) * joint.axis / np.linalg.norm(joint.axis)
                elif joint.type != soms.JointType.fixed:
                    motion[:3, :3] = turned(joint.axis, value(number))
                poses[joint.child] = poses[joint.parent] @ whole(joint.origin.matrix[:3]) @ motion
    return np.array([poses[link][:3] for link in range(len(robot.links))])


class SameAsCommand(unittest.TestCase):
    def command_rows(self, states, *arguments):
        if not COMMAND.exists():
            self.skipTest("the command is not built")
        with tempfile.TemporaryDirectory() as folder:
            np.save(f"{folder}/states.npy", states)
            soms.write_mesh(f"{folder}/cell.obj", wall())
            said = subprocess.run(
                [COMMAND, "robot", DATA / "arm.urdf", *arguments, "--states", f"{folder}/states.npy",
                 "--cell", f"{folder}/cell.obj", "--distance", "--json"],
                capture_output=True, text=True, check=False)
        rows = [json.loads(line) for line in said.stdout.splitlines()]
        rows = [row for row in rows if "verdict" in row]
        self.assertEqual(len(rows), len(states), said.stderr)
        return rows

    def check_same(self, robot, *arguments):
        model = soms.RobotModel(robot, wall())
        states = robot.random_states(COUNT)
        states[5, 1] = 0.8  # beyond its limit
        rows = self.command_rows(states, *arguments)
        batch = soms.robot_contacts(model, states, distance=True)
        names = model.link_names

        def pair(link, other, cell):
            return names[link], ("cell", int(other)) if cell else names[other]

        def pair_of_row(row):
            b = row["b"]
            return (row["a"]["link"],
                    ("cell", b["cell"]["index"]) if "cell" in b else b["link"])

        for i, row in enumerate(rows):
            answer = batch.at(i)
            self.assertEqual(answer.verdict.name, row["verdict"])
            self.assertEqual([(*pair(c["link"], c["other"], c["cell"]), bool(c["surfaces_meet"]))
                              for c in answer.contacts],
                             [(*pair_of_row(c), c["surfaces_meet"]) for c in row["contacts"]])
            self.assertEqual([robot.joints[joint].name for joint in answer.beyond_limits],
                             row["out_of_limits"])
            self.assertEqual([answer.gap.lower, answer.gap.upper], row["gap"]["distance"])
            self.assertEqual(batch.gap[i].tolist(), row["gap"]["distance"])
            self.assertEqual(pair(*answer.gap.pair), pair_of_row(row["gap"]))
            if answer.gap.points is not None:
                self.assertEqual(answer.gap.points.tolist(), row["gap"]["points"])
        self.assertEqual({row["verdict"] for row in rows}, {"free", "contact"})
        self.assertFalse(batch.within_limits[5])

    def test_with_srdf(self):
        self.check_same(arm(), "--srdf", DATA / "arm.srdf")

    def test_without_srdf(self):
        self.check_same(arm(srdf=False))


class Robots(unittest.TestCase):
    def test_what_a_robot_is(self):
        robot = arm()
        self.assertEqual(robot.name, "arm")
        self.assertEqual([link.name for link in robot.links],
                         ["base", "column", "boom", "flange", "left", "right"])
        joints = {joint.name: joint for joint in robot.joints}
        self.assertEqual([robot.joints[k].name for k in robot.movable],
                         ["turn", "lift", "wrist", "grip"])
        self.assertEqual((joints["lift"].lower, joints["lift"].upper), (0, 0.7))
        self.assertEqual(joints["turn"].lower, -np.inf)
        self.assertEqual(joints["turn"].type, soms.JointType.continuous)
        self.assertEqual(joints["grip_too"].mimic, (3, 1.0, 0.0))
        self.assertIsNone(joints["grip"].mimic)
        self.assertEqual([len(link.collisions) for link in robot.links], [1, 1, 2, 0, 1, 1])
        self.assertTrue(robot.links[0].collisions[0].closedness().whole.closed)
        self.assertGreater(len(robot.allowed), 0)
        self.assertGreater(len(robot.states), 0)
        self.assertIsNone(arm(srdf=False).allowed)
        self.assertEqual(robot, arm())
        self.assertNotEqual(robot, arm(srdf=False))
        self.assertIn("arm", repr(robot))

    def test_a_robot_of_bytes(self):
        robot = soms.read_robot((DATA / "arm.urdf").read_bytes(), name="it.urdf")
        self.assertEqual(robot.source, "it.urdf")
        self.assertEqual(len(robot.links), 6)

    def test_poses_of_links(self):
        robot = arm()
        states = robot.random_states(50, seed=3)
        poses = robot.link_poses(states)
        self.assertEqual(poses.shape, (50, 6, 3, 4))
        for state, found in zip(states, poses):
            np.testing.assert_allclose(found, poses_by_numpy(robot, state), atol=1e-14)
        self.assertTrue((robot.link_poses(states[7]) == poses[7]).all())
        self.assertTrue((robot.link_poses(states, threads=2) == poses).all())
        moved = robot.link_poses(states, base=[1, 2, 3])
        np.testing.assert_allclose(moved[..., 3], poses[..., 3] + [1, 2, 3], atol=1e-14)
        self.assertEqual(robot.link_poses(states[:0]).shape, (0, 6, 3, 4))

    def test_values_of_joints(self):
        robot = arm()
        values = robot.joint_values([0.1, 0.2, 0.3, 0.04])
        self.assertEqual(values.tolist(), [0.1, 0.2, 0.3, 0.04, 0.04])
        self.assertEqual(robot.joint_values(np.zeros((3, 4))).shape, (3, 5))

    def test_random_states_are_within_limits(self):
        robot = arm()
        states = robot.random_states(COUNT)
        answer = soms.robot_contacts(soms.RobotModel(robot), states)
        self.assertTrue(answer.within_limits.all())
        self.assertTrue((states == robot.random_states(COUNT)).all())
        self.assertFalse((states == robot.random_states(COUNT, seed=2)).any())


class Paths(unittest.TestCase):
    def test_what_is_between_two_states(self):
        robot = arm()
        model = soms.RobotModel(robot, wall(), off_cell=["base"])
        states = np.array([[3, .1, 0, .03], [1.8, .1, 0, .03], [-1.8, .1, 0, .03], [0, .1, 0, .03],
                           [3, .1, 0, .03]])
        path = soms.robot_path(model, states, threads=2)
        self.assertEqual(len(path), 4)
        names = [soms.ContactVerdict(code).name for code in path.verdict]
        self.assertEqual(names, ["free", "contact", "contact", "started"])
        self.assertEqual(path.free.tolist(), [True, False, False, False])
        self.assertEqual(path.blocked, 1)
        self.assertEqual(path.states, soms.robot_contacts(model, states))
        self.assertEqual(path.upper[0], np.inf)
        self.assertEqual(path.at(0).pair, None)
        self.assertEqual(path.at(0).point, None)
        self.assertEqual(path.pairs[0].tolist(), [-1, -1, -1])
        self.assertTrue(np.isnan(path.point[0]).all())
        hit = path.at(1)
        self.assertEqual((hit.lower, hit.upper), (path.lower[1], path.upper[1]))
        self.assertEqual(path.pairs[1].tolist(), [5, 0, 1])
        self.assertEqual(hit.pair, (5, 0, True))
        self.assertAlmostEqual(hit.point[0], 0.7)
        at = states[1] + hit.upper * (states[2] - states[1])
        before = states[1] + (hit.lower - 1e-9) * (states[2] - states[1])
        self.assertEqual(soms.robot_contacts(model, [at, before]).free.tolist(), [False, True])
        first = soms.robot_path(model, states, first_blocked=True)
        self.assertEqual(len(first), 2)
        self.assertEqual(first.at(1), hit)

    def test_errors_name_the_segment(self):
        model = soms.RobotModel(arm(), wall(), off_cell=["base"])
        with self.assertRaisesRegex(soms.Error, "segment 1: joint turn turns"):
            soms.robot_path(model, [[3, .1, 0, .03], [2.9, .1, 0, .03], [1e7, .1, 0, .03]])


class Attached(unittest.TestCase):
    def test_a_part_in_the_gripper(self):
        robot = arm()
        model = soms.RobotModel(robot, off_cell=["base"])
        part = soms.generate("sphere", 80)
        held = model.with_attached("part", "flange", part, [0, 0, 1.2], touching=["left", "right"])
        self.assertEqual(held.link_names, [*model.link_names, "part"])
        self.assertEqual(held.robot.links[6].name, "part")
        self.assertEqual(len(model.link_names), 6)
        self.assertIn([4, 6], held.skipped.tolist())
        self.assertIn([0, 6], held.compared.tolist())
        self.assertNotIn([5, 6], held.compared.tolist())
        states = robot.random_states(100)
        near = soms.Body(wall(), [0.8, 0, 0])
        alone = soms.robot_contacts(model.with_cell(near), states)
        both = soms.robot_contacts(held.with_cell(near), states)
        self.assertTrue((both.free <= alone.free).all())
        self.assertGreater(np.count_nonzero(alone.free), np.count_nonzero(both.free))
        again = pickle.loads(pickle.dumps(held.with_cell(near)))
        self.assertEqual(soms.robot_contacts(again, states), both)
        self.assertEqual(again.skipped.tolist(), held.skipped.tolist())
        with self.assertRaisesRegex(soms.Error, "name"):
            held.with_attached("part", 0, part)

    def test_pairs_that_may_touch(self):
        model = soms.RobotModel(arm())
        less = model.with_ignored([("right", "left")])
        self.assertEqual(len(less.compared), len(model.compared) - 1)
        self.assertIn([4, 5], less.skipped.tolist())
        self.assertEqual(pickle.loads(pickle.dumps(less)).compared.tolist(), less.compared.tolist())


class Contacts(unittest.TestCase):
    def test_surfaces_meet_as_overlap_says(self):
        robot = arm(srdf=False)
        model = soms.RobotModel(robot, wall())
        states = robot.random_states(60, seed=5)
        batch = soms.robot_contacts(model, states)
        poses = robot.link_poses(states)
        seen = 0
        for i in range(len(states)):
            bodies = [[soms.Body(mesh, poses[i, k]) for mesh in link.collisions]
                      for k, link in enumerate(robot.links)]
            met = {(a, b, False) for a, b in model.compared.tolist()
                   for x in bodies[a] for y in bodies[b] if soms.overlap(x, y, mode="any")}
            met |= {(a, 0, True) for a in model.on_cell.tolist()
                    for x in bodies[a] if soms.overlap(x, wall(), mode="any")}
            found = {(c["link"], c["other"], c["cell"]) for c in batch.of(i) if c["surfaces_meet"]}
            self.assertEqual({tuple(map(int, c)) for c in found}, {tuple(map(int, c)) for c in met})
            seen += len(met)
        self.assertGreater(seen, 0)

    def test_one_state_threads_and_first_contact(self):
        robot = arm()
        model = soms.RobotModel(robot, wall(), threads=2)
        states = robot.random_states(COUNT)
        batch = soms.robot_contacts(model, states, distance=True)
        again = soms.robot_contacts(model, states, distance=True, threads=2)
        for name in ("verdict", "contacts", "offsets", "gap", "free", "undecided"):
            self.assertTrue((getattr(batch, name) == getattr(again, name)).all(), name)
        for i in range(0, COUNT, 29):
            one = soms.robot_contacts(model, states[i], distance=True)
            self.assertEqual((one.verdict, one.gap, one.contacts.tolist()),
                             (batch.verdict[i], batch.at(i).gap, batch.of(i).tolist()))
        first = soms.robot_contacts(model, states, first_contact=True)
        self.assertTrue((first.free == batch.free).all())
        self.assertLessEqual(np.diff(first.offsets.astype(int)).max(), 1)
        self.assertTrue(np.isnan(first.gap).all())
        self.assertIsNone(first.at(0).gap)
        self.assertEqual(batch.first_blocked, int(np.flatnonzero(~batch.free)[0]))
        self.assertIsNone(soms.robot_contacts(model, states[batch.free]).first_blocked)

    def test_pairs_that_are_not_compared(self):
        robot = arm(srdf=False)
        plain = soms.RobotModel(robot, wall())
        fewer = soms.RobotModel(robot, wall(), ignored=[("left", "right"), (0, 2)],
                                off_cell=["boom", 0])
        gone = {tuple(pair) for pair in plain.compared.tolist()} - {
            tuple(pair) for pair in fewer.compared.tolist()}
        self.assertEqual(gone, {(0, 2), (4, 5)})
        self.assertEqual(set(plain.on_cell.tolist()) - set(fewer.on_cell.tolist()), {0, 2})
        self.assertEqual((plain.cell_names, plain.open), (["wall"], ["wall"]))

    def test_the_cell_and_the_base_have_poses(self):
        robot = arm()
        states = robot.random_states(COUNT)
        placed = soms.RobotModel(robot, soms.Body(wall(), [0.25, 0, 0]))
        vertices = wall().vertices + [0.25, 0, 0]
        moved = soms.RobotModel(robot, soms.Mesh(vertices, wall().triangles, wall().parts))
        based = soms.RobotModel(robot, wall(), base=[-0.25, 0, 0])
        answers = [soms.robot_contacts(model, states, distance=True)
                   for model in (placed, moved, based)]
        self.assertTrue((answers[0].gap == answers[1].gap).all())
        self.assertTrue((answers[0].free == answers[2].free).all())
        self.assertFalse(answers[0].free.all())

    def test_a_robot_that_does_not_move(self):
        robot = soms.read_robot(b"<robot name='r'><link name='a'/></robot>", name="r.urdf")
        model = soms.RobotModel(robot)
        for rows in (0, 1, 3):
            answer = soms.robot_contacts(model, np.zeros((rows, 0)))
            self.assertEqual((len(answer), answer.free.all()), (rows, True))
        self.assertEqual(soms.robot_contacts(model, []).verdict, soms.RobotVerdict.free)
        self.assertEqual(robot.link_poses(np.zeros((3, 0))).shape, (3, 1, 3, 4))

    def test_at_most(self):
        model = soms.RobotModel(arm())
        gap = soms.robot_contacts(model, [0.0, 0.5, 0.0, 0.02], distance=True, at_most=1e-6).gap
        self.assertTrue(gap.farther or gap.upper == 0)

    def test_ctrl_c_and_progress(self):
        robot = arm()
        model = soms.RobotModel(robot, wall())
        states = robot.random_states(5000)

        def stop(_):
            raise LookupError("enough")

        def interrupt(_):
            os.kill(os.getpid(), signal.SIGINT)

        for threads in (1, 2):
            with self.assertRaisesRegex(LookupError, "enough"):
                soms.robot_contacts(model, states, threads=threads, progress=stop)
            with self.assertRaises(KeyboardInterrupt):
                soms.robot_contacts(model, states, threads=threads, progress=interrupt)


class Errors(unittest.TestCase):
    def fails(self, kind, call, word=""):
        with self.assertRaises(soms.Error) as caught:
            call()
        self.assertEqual(caught.exception.kind, kind, caught.exception)
        self.assertIn(word, str(caught.exception))

    def test_reading(self):
        missing = b"""<robot name="r"><link name="a"><collision><geometry>
            <mesh filename="package://nowhere/a.stl"/></geometry></collision></link></robot>"""
        self.fails("cannot_open", lambda: soms.read_robot(missing, name="r.urdf"), "nowhere")
        self.fails("cannot_open", lambda: soms.read_robot("nowhere.urdf"), "nowhere.urdf")
        self.fails("bad_file", lambda: soms.read_robot(b"<robot", name="r.urdf"), "r.urdf")
        self.fails("usage", lambda: soms.read_robot(DATA / "arm.urdf", tessellation_error=-1))
        with self.assertRaises(TypeError):
            soms.read_robot(3)

    def test_packages(self):
        text = b"""<robot name="r"><link name="a"><collision><geometry>
            <mesh filename="package://mine/a.stl"/></geometry></collision></link></robot>"""
        with tempfile.TemporaryDirectory() as folder:
            soms.write_mesh(f"{folder}/a.stl", wall())
            robot = soms.read_robot(text, name="r.urdf", packages={"mine": pathlib.Path(folder)})
        self.assertEqual(len(robot.links[0].collisions[0]), 2)

    def test_states(self):
        model = soms.RobotModel(arm())
        wrong = np.zeros((9, 4))
        wrong[7, 2] = np.nan
        for call in (lambda s: soms.robot_contacts(model, s), model.robot.link_poses):
            self.fails("usage", lambda: call(np.zeros(5)), "(5,)")
            self.fails("usage", lambda: call(np.zeros((2, 3))), "(n, 4)")
            self.fails("usage", lambda: call(np.zeros((2, 2, 4))))
            self.fails("usage", lambda: call("states"))
            self.fails("not_finite", lambda: call(wrong), "state 7")
            self.fails("not_finite", lambda: call(wrong[7]), "wrist")

    def test_options(self):
        robot = arm()
        model = soms.RobotModel(robot)
        state = np.zeros(4)
        self.fails("usage", lambda: soms.robot_contacts(model, state, at_most=1))
        self.fails("usage", lambda: soms.robot_contacts(model, state, distance=True, at_most=-1))
        self.fails("usage", lambda: soms.RobotModel(robot, off_cell=["nose"]), "nose")
        self.fails("out_of_range", lambda: soms.RobotModel(robot, off_cell=[6]))
        self.fails("usage", lambda: soms.RobotModel(robot, ignored=[("left", "left")]))
        self.fails("usage", lambda: soms.RobotModel(robot, ignored=["left"]))
        self.fails("usage", lambda: soms.RobotModel(robot, 3))
        with self.assertRaises(TypeError):
            soms.robot_contacts(robot, state)


if __name__ == "__main__":
    unittest.main()
