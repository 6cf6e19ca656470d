"""Whatever soms exports is pickled: functions and classes by their names, an object of every class as an equal one, so
that tasks and answers pass between processes. HANDLES are the exceptions, each with its reason."""
import pickle
import tempfile
import unittest

import numpy as np

import soms
from answers_test import every_answer, robot_model
from models import shifts, tetrahedron

HANDLES = {
    "ContactSpans": "grows with the steps that it follows: its spans are pickled",
    "ContactTracker": "follows steps: its events are pickled",
    "Page": "a page is text: its html is pickled",
    "RecordingWriter": "an open file",
    "Replay": "an open file: its frames are pickled",
    "Scene": "changes with its steps: its bodies and reports are pickled",
}
# Rather than == which these do not have, what is compared.
COMPARED = {
    "BodyIndex": lambda index: index.closest(shifts([5, 5, 5])),
    "ClosedBody": lambda body: soms.contains(body, shifts([0.1, 0.1, 0.1])),
    "PartBodies": lambda parts: (parts.names, parts.ids),
    "DividedBody": lambda body: soms.contains(body, shifts([0.1, 0.1, 0.1])),
    "RobotModel": lambda model: soms.robot_contacts(model, [0.0]),
    "WindingIndex": lambda index: soms.winding(index, shifts([0.1, 0.1, 0.1])),
}


def objects():
    """An object or more of every class that is no handle."""
    mesh = tetrahedron()
    body = soms.Body(mesh, [1, 2, 3], "box")
    robot, model = robot_model()
    yield from every_answer()
    yield from (mesh, body, body.shape, body.pose, soms.Pose.identity())
    yield from (soms.RigidMotion(), soms.RigidMotion.along([1, 2, 3], [0, 0, 1]),
                soms.RigidMotion.turn([1, 2, 3], [0, 1, 0], [1, 1, 1], 2.5))
    for options in ({"rule": "quality", "per_leaf": 1}, {"layout": "compact"}, {"rule": "soms", "level": 3}):
        yield soms.Shape(mesh, **options)
    yield from (soms.Part("roof", 0, 2, id="r1", attributes=[("height", "3")]), soms.ClosedBody(body),
                soms.DividedBody(body), soms.WindingIndex(body), soms.BodyIndex([body]), robot, model)
    yield soms.clash(body, soms.Body(mesh, [1.5, 2.1, 3.1])).parts[0]
    with tempfile.TemporaryDirectory() as folder:
        yield soms.cut_tiles(f"{folder}/tiles", [mesh], most=2)
    yield from (soms.Georeference(), soms.MapConversion(), soms.Error("usage", "here", "do this"))
    for name in soms.__all__:
        of = getattr(soms, name)
        if isinstance(of, type) and issubclass(of, int):
            yield from of


class Pickles(unittest.TestCase):
    def test_functions_and_classes_are_pickled_by_their_names(self):
        functions = 0
        for name in soms.__all__:
            self.assertIs(pickle.loads(pickle.dumps(getattr(soms, name))), getattr(soms, name), name)
            functions += not isinstance(getattr(soms, name), type)
        self.assertGreater(functions, 20)

    def test_an_object_of_every_class_is_pickled(self):
        seen = set()
        for given in objects():
            name = type(given).__name__
            seen.add(name)
            with self.subTest(of=name):
                again = pickle.loads(pickle.dumps(given))
                self.assertIs(type(again), type(given))
                self.assertEqual(repr(again), repr(given))
                if isinstance(given, soms.Error):
                    self.assertEqual((again.kind, again.place, again.remedy), (given.kind, given.place, given.remedy))
                elif name in COMPARED:
                    self.assertEqual(COMPARED[name](again), COMPARED[name](given))
                else:
                    self.assertEqual(again, given)
        classes = {name for name in soms.__all__ if isinstance(getattr(soms, name), type)}
        self.assertEqual(classes - seen, set(HANDLES))
        self.assertFalse(seen & set(HANDLES))

    def test_handles_say_that_they_are_not_pickled(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = soms.Scene()
            writer = soms.RecordingWriter(f"{folder}/run.somsrec", scene)
            for handle in (scene, writer, soms.ContactTracker(), soms.ContactSpans()):
                with self.assertRaises((TypeError, soms.Error)):
                    pickle.dumps(handle)

    def test_a_shape_keeps_how_it_was_built(self):
        shape = soms.Shape(soms.generate("sphere", 800), rule="quality", layout="compact", per_leaf=4)
        again = pickle.loads(pickle.dumps(shape))
        self.assertEqual((again.rule, again.layout, again), (shape.rule, shape.layout, shape))
        poses = np.eye(4)[None]
        self.assertEqual(soms.overlap(again, shape, poses), soms.overlap(shape, again, poses))


if __name__ == "__main__":
    unittest.main()
