"""Answers as values: every class is pickled and copied, entries of batches are single answers, and
signed distances are right for closed and for open models."""
import copy
import multiprocessing
import pathlib
import pickle
import re
import tempfile
import unittest

import numpy as np

import soms
from models import FACES, TETRAHEDRON, Foreign, shifts, tetrahedron

SOURCES = pathlib.Path(__file__).resolve().parents[2] / "python/src"
POINTS = shifts([0.1, 0.1, 0.1], [0, 0, 0], [2, 0, 0])
URDF = b"""<robot name="crane"><link name="base"/><link name="boom"><collision><geometry>
  <box size="1 0.1 0.1"/></geometry></collision></link><joint name="turn" type="continuous">
  <parent link="base"/><child link="boom"/><axis xyz="0 0 1"/></joint></robot>"""
SRDF = b'<robot name="crane"><group_state name="home" group="g"><joint name="turn" value="1"/></group_state></robot>'


def sphere():
    return soms.generate("sphere", 800)


def open_sphere(share=0.97):
    mesh = sphere()
    return soms.Mesh(mesh.vertices, mesh.triangles[:int(share * len(mesh))])


def answers_of_bodies():
    a, b = soms.Shape(tetrahedron()), soms.Body(tetrahedron())
    poses = shifts([0.4, 0.3, 0.2], [0, 0, 5])
    closed = soms.ClosedBody(b)
    for one in (soms.Body(a, poses[0]), soms.Body(a, poses[1])):
        yield from (soms.overlap(one, b), soms.distance(one, b), soms.within(one, b, 1),
                    soms.solid(one, b), soms.self_overlap(b))
    yield from (soms.overlap(a, b, poses), soms.distance(a, b, poses), soms.within(a, b, 1, poses),
                soms.solid(a, b, poses), soms.overlap(a, b).cost)
    yield from (soms.first_contact(a, poses[0], poses[1], b), soms.first_contact(a, poses[1], None, b, by=[0, 0, -9]),
                soms.first_contact(a, poses[1], None, b, by=[[0.1, 0.2, -9], [0, 0, 9]]))
    parted = soms.DividedBody(b)
    yield from parted.parts
    for points in (POINTS, POINTS[0]):
        yield from (soms.contains(closed, points), soms.contains(parted, points),
                    soms.closest(b, points), soms.closest(closed, points), soms.winding(b, points),
                    soms.closest_hit(b, points, points + 1), soms.any_hit(b, points, points + 1))
    yield from (soms.nearest_triangles(b, POINTS, 2), soms.near_triangles(b, POINTS, 1),
                soms.all_hits(b, POINTS, POINTS + 1))
    mesh = b.shape.mesh
    yield from (mesh.closedness(), mesh.closedness().whole, open_sphere().defects())
    index = soms.BodyIndex([mesh, soms.Body(mesh, [5, 0, 0])])
    for points in (POINTS, POINTS[0]):
        yield from (index.closest(points), index.closest_hit(points, points + 1))
    yield index.all_hits(POINTS, POINTS + 1)
    shifted = soms.Body(mesh, [0.5, 0.1, 0.1])
    clashes = soms.clash(b, shifted)
    yield from (clashes, clashes[0], soms.penetration(b, shifted))


def answers_of_scenes():
    scene = soms.Scene()
    scene.add_environment(soms.Body(soms.generate("city", 5672), name="city"))
    car = soms.Shape(soms.generate("car"))
    for i in range(2):
        scene.add_mover(soms.Body(car, [10 + i, 0, -2], f"car {i}"))
    report = scene.step(clearance=10)
    tracker, spans = soms.ContactTracker(), soms.ContactSpans()
    spans.follow(0, report, scene)
    yield from (report, tracker.follow(report), spans.spans[0])
    for points in (POINTS, POINTS[0]):
        yield from (scene.closest(points), scene.closest_hit(points, points + 1))
    yield scene.all_hits(POINTS, POINTS + 1)
    with tempfile.TemporaryDirectory() as folder:
        floor = f"{folder}/floor.ply"
        soms.write_mesh(floor, sphere())
        recorded = soms.Scene()
        recorded.add_environment(soms.Body(soms.read_mesh(floor), name="floor"))
        recorded.add_mover(soms.Body(soms.generate("car"), name="car"))
        with soms.RecordingWriter(f"{folder}/run.somsrec", recorded) as recording:
            recording.add(recorded.step())
        replay = soms.Replay(f"{folder}/run.somsrec")
        yield from (replay[0], replay.end, replay.models[0], replay.environment[0])


def robot_model():
    with tempfile.TemporaryDirectory() as folder:
        srdf = pathlib.Path(folder) / "crane.srdf"
        srdf.write_bytes(SRDF)
        robot = soms.read_robot(URDF, srdf, name="crane.urdf")
    wall = soms.Mesh([[0.5, -3, -3], [0.5, 3, -3], [0.5, 3, 3], [0.5, -3, 3]],
                     [[0, 1, 2], [0, 2, 3]])
    return robot, soms.RobotModel(robot, soms.Body(wall, [-0.1, 0, 0]))


def answers_of_robots():
    robot, model = robot_model()
    one = soms.robot_contacts(model, [0.0], distance=True)
    yield from (one, one.gap, soms.robot_contacts(model, [[0.0], [1.5]], distance=True))
    path = soms.robot_path(model, [[3.0], [1.5], [0.0]])
    yield from (path, path.at(1), robot.joints[0], robot.links[1], robot.states[0])


def every_answer():
    yield from answers_of_bodies()
    yield from answers_of_scenes()
    yield from answers_of_robots()


def of_a_child(answer):
    return answer, repr(answer)


class Pickles(unittest.TestCase):
    def test_every_answer_is_pickled_and_copied(self):
        seen = set()
        for answer in every_answer():
            name = type(answer).__name__
            with self.subTest(answer=name):
                seen.add(name)
                for protocol in (2, pickle.HIGHEST_PROTOCOL):
                    again = pickle.loads(pickle.dumps(answer, protocol))
                    self.assertEqual(again, answer)
                    self.assertEqual(repr(again), repr(answer))
                    self.assertEqual(pickle.dumps(again, protocol), pickle.dumps(answer, protocol))
                self.assertEqual(copy.deepcopy(answer), answer)
        text = "".join(path.read_text(encoding="utf-8") for path in SOURCES.rglob("*.cpp"))
        bound = set(re.findall(r"AnswerClass<\w+> \w+\(\s*module, \"(\w+)\"", text))
        bound |= set(re.findall(r"bind_answers?(?:_of)?<(\w+)>\(module\)", text))
        bound |= {name + "Batch" for name in re.findall(r"bind_(?:answers_of|batch)<(\w+)>\(module\)", text)}
        self.assertGreater(len(bound), 45)
        self.assertEqual(bound, seen)

    def test_a_list_of_clashes_keeps_its_parts(self):
        body = soms.Body(tetrahedron())
        clashes = soms.clash(body, soms.Body(tetrahedron(), [0.5, 0.1, 0.1]))
        again = pickle.loads(pickle.dumps(clashes))
        self.assertEqual(again.parts[0].names, clashes.parts[0].names)
        self.assertEqual(list(again.columns()["key"]), list(clashes.columns()["key"]))
        two = soms.Mesh(np.vstack([TETRAHEDRON, TETRAHEDRON + 0.1]), np.vstack([FACES, FACES + 4]),
                        [soms.Part("one", 0, 4), soms.Part("two", 4, 4)])
        alone = pickle.loads(pickle.dumps(soms.clash(two)))
        self.assertIs(alone.parts[0], alone.parts[1])

    def test_answers_pass_between_processes(self):
        answer = soms.closest(soms.Body(tetrahedron()), POINTS)
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            again, text = pool.apply(of_a_child, (answer,))
        self.assertEqual((again, text), (answer, repr(answer)))

    def test_damaged_pickles_are_errors(self):
        for answer in (soms.overlap(tetrahedron(), tetrahedron()),
                       soms.closest(soms.Body(tetrahedron()), POINTS), robot_model()[0].states[0]):
            version, data = answer.__getstate__()[:2]
            blank = type(answer).__new__(type(answer))
            for state in ((version, data[:-1]), (version, data + b"x"), (version, b""),
                          ("0.0.0", data), (version, "text"), (version,),
                          (version, b"\xff" * len(data))):
                with self.assertRaises(soms.Error) as caught:
                    blank.__setstate__(state)
                self.assertEqual(caught.exception.kind, "bad_file")


class Entries(unittest.TestCase):
    def test_an_entry_of_a_batch_is_the_single_answer(self):
        a, b = soms.Shape(tetrahedron()), soms.Body(tetrahedron())
        poses = shifts([0.4, 0.3, 0.2], [0, 0, 5], [0, 0, 1])
        for mode in soms.OverlapMode:
            batch = soms.overlap(a, b, poses, mode=mode)
            for i, pose in enumerate(poses):
                self.assertEqual(batch.at(i), soms.overlap(soms.Body(a, pose), b, mode=mode))
            with self.assertRaises(IndexError):
                batch.at(len(poses))

    def test_every_batch_has_entries(self):
        checked = 0
        for name in soms.__all__:
            of_class = getattr(soms, name)
            if isinstance(of_class, type) and hasattr(of_class, "__len__") and name.endswith("Batch"):
                self.assertTrue(hasattr(of_class, "at"), name)
                checked += 1
        self.assertGreater(checked, 12)

    def test_a_robot_state_says_that_it_is_free(self):
        _, model = robot_model()
        states = np.linspace(0, np.pi, 7)[:, None]
        batch = soms.robot_contacts(model, states)
        self.assertEqual([batch.at(i).free for i in range(7)], batch.free.tolist())
        self.assertEqual(set(batch.free.tolist()), {False, True})
        self.assertIs(soms.robot_contacts(model, states[0]).free, bool(batch.free[0]))


class SignedDistances(unittest.TestCase):
    def check(self, model, signed, points, radius=1.0, tolerance=0.05):
        self.assertEqual((signed.shape, signed.dtype), ((len(points),), np.dtype(float)))
        self.assertTrue(np.allclose(signed, np.linalg.norm(points, axis=1) - radius,
                                    atol=tolerance), (model, signed))

    def test_of_closed_and_open_models(self):
        points = np.random.default_rng(1).uniform(-1.5, 1.5, (200, 3))
        points[:, 2] = -np.abs(points[:, 2])  # the opening is on top
        mesh = sphere()
        body = soms.Body(mesh)
        foreign = Foreign(mesh.vertices, mesh.triangles)
        expected = soms.signed_distance(mesh, points)
        self.check("closed", expected, points)
        for model in (body, soms.Shape(mesh), soms.ClosedBody(body), soms.WindingIndex(body), foreign):
            self.assertTrue(np.array_equal(soms.signed_distance(model, points, threads=2), expected))
        opened = soms.signed_distance(open_sphere(), points)
        self.assertFalse(np.isnan(opened).any())
        self.assertTrue(np.array_equal(np.sign(opened), np.sign(expected)))

    def test_agrees_with_closest_and_contains(self):
        closed = soms.ClosedBody(soms.Body(tetrahedron()))
        points = np.vstack([np.random.default_rng(2).uniform(-0.5, 1, (300, 3)), POINTS])
        answer = soms.closest(closed, points)
        side = soms.contains(closed, points).side
        expected = np.where(side == soms.Side.inside, -answer.closest.upper, answer.closest.upper)
        expected[side == soms.Side.on] = 0
        self.assertTrue(np.array_equal(answer.signed, expected))
        self.assertTrue(np.array_equal(soms.signed_distance(closed, points), expected))
        self.assertEqual({-1.0, 0.0, 1.0}, set(np.sign(expected).tolist()))
        for i in range(len(points)):
            self.assertEqual(answer.at(i).signed, expected[i])
        one = soms.signed_distance(closed, points[0])
        self.assertIsInstance(one, float)
        self.assertEqual(one, expected[0])

    def test_what_is_not_known_is_no_number(self):
        closed = soms.ClosedBody(soms.Body(tetrahedron()))
        self.assertEqual(soms.signed_distance(closed, [5, 0, 0], at_most=1), np.inf)
        self.assertTrue(np.isnan(soms.signed_distance(closed, POINTS[[0, 2]], timeout=0)).all())
        half = soms.Mesh([[-1e3, -1e3, 0], [1e3, -1e3, 0], [0, 2e3, 0]], [[0, 1, 2]])
        self.assertEqual(soms.signed_distance(half, [0, 0, 0]), 0)
        cup = soms.Mesh(TETRAHEDRON, FACES[[0, 1]])  # 1/2 is met in some place of the opening
        line = TETRAHEDRON.mean(axis=0) + np.linspace(-1, 1, 5)[:, None]
        index = soms.WindingIndex(soms.Body(cup))
        sides = soms.winding(index, line).side
        known = sides != soms.Side.undecided
        self.assertTrue(np.array_equal(~np.isnan(soms.signed_distance(cup, line)), known))

    def test_empty_batches(self):
        self.assertEqual(soms.signed_distance(tetrahedron(), np.zeros((0, 3))).shape, (0,))


if __name__ == "__main__":
    unittest.main()
