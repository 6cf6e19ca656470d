"""Errors are soms.Error with kind, place and remedy; what is given wrongly is said with its shape."""
import pathlib
import pickle
import re
import unittest

import numpy as np

import soms
from models import FACES, TETRAHEDRON, Foreign, tetrahedron


SOURCES = pathlib.Path(__file__).resolve().parents[2] / "soms"


def is_in_python(word):
    """`Layout.wide` of the package; the words after "give" are not names."""
    found = soms
    for name in word.split("."):
        if not hasattr(found, name):
            return False
        found = getattr(found, name)
    return True


class Errors(unittest.TestCase):
    def fails(self, kind, *words):
        test = self

        class Context:
            def __enter__(self):
                return self

            def __exit__(self, _, error, __):
                test.assertIsInstance(error, soms.Error, "nothing was raised")
                test.assertEqual(error.kind, kind, error)
                test.assertEqual(str(error), f"{error.place}; {error.remedy}")
                for word in words:
                    test.assertIn(word, str(error))
                return True

        return Context()

    def test_a_file_that_is_missing(self):
        with self.fails("cannot_open", "nowhere.ply"):
            soms.read_mesh("nowhere.ply")

    def test_an_error_is_a_value_error_and_can_be_pickled(self):
        try:
            soms.read_mesh(b"nonsense", name="it.ply")
        except ValueError as error:
            again = pickle.loads(pickle.dumps(error))
            self.assertEqual((again.kind, again.place, again.remedy),
                             (error.kind, error.place, error.remedy))
            self.assertIn("it.ply", error.place)
        else:
            self.fail("nothing was raised")

    def test_shapes_wanted_and_given(self):
        with self.fails("usage", "vertices", "(4, 2)", "(n, 3)"):
            soms.Mesh(TETRAHEDRON[:, :2], FACES)
        with self.fails("usage", "triangles", "(12,)", "(n, 3)"):
            soms.Mesh(TETRAHEDRON, FACES.ravel())
        with self.fails("usage", "poses", "(5, 5)", "(n, 4, 4)"):
            soms.overlap(tetrahedron(), tetrahedron(), np.zeros((5, 5)))
        with self.fails("usage", "pose", "(2, 2)", "(4, 4)"):
            soms.Pose(np.zeros((2, 2)))
        with self.fails("usage", "points", "(3, 3, 3)"):
            soms.contains(tetrahedron(), np.zeros((3, 3, 3)))
        with self.fails("usage", "lengths", "(2,)"):
            soms.any_hit(tetrahedron(), [[0, 0, 9]], [[0, 0, 1]], lengths=[1, 2])
        with self.fails("usage", "1 origins, 2 directions"):
            soms.any_hit(tetrahedron(), [[0, 0, 9]], [[0, 0, 1]] * 2)

    def test_types(self):
        with self.fails("usage", "triangles", "float64", "integers"):
            soms.Mesh(TETRAHEDRON, FACES.astype(float))
        with self.fails("usage", "vertices", "complex128"):
            soms.Mesh(TETRAHEDRON.astype(complex), FACES)
        with self.fails("usage", "float128"):
            soms.Mesh(TETRAHEDRON.astype(np.longdouble), FACES)
        with self.fails("usage", "vertices"):
            soms.Mesh([[1, 2, 3], [4]], FACES)
        with self.fails("usage", "a:", "str"):
            soms.overlap("car.ply", tetrahedron())

    def test_integers_that_a_double_does_not_hold(self):
        exact, beyond = 2**53, 2**53 + 1  # whose double is 2^53
        for sign in (1, -1):
            for row in ([exact] * 3, [exact, 0.5, 0]):
                self.assertEqual(len(soms.contains(tetrahedron(), [[sign * x for x in row]])), 1)
            for row in ([sign * beyond] * 3, [sign * beyond, 0.5, 0], (0, 0.5, sign * 2**62),
                        np.array([sign * beyond, 0, 0])):
                with self.fails("out_of_range", "2^53"):
                    soms.contains(tetrahedron(), [row])
        for given in (np.full((3, 3), 2**60), np.full((3, 3), 2**63 + 1, dtype=np.uint64)):
            with self.fails("out_of_range", "2^53"):
                soms.Mesh(given, [[0, 1, 2]])
        with self.fails("out_of_range", "at_most", "2^53"):
            soms.distance(tetrahedron(), tetrahedron(), at_most=beyond)
        with self.fails("out_of_range", "at_most", "2^53"):
            soms.distance(tetrahedron(), tetrahedron(), at_most=10**400)
        with self.fails("out_of_range", "within", "2^53"):
            soms.clash(tetrahedron(), within=beyond)

    def test_calls(self):
        mesh = tetrahedron()
        for wrong in (lambda: soms.overlap(mesh), lambda: soms.overlap(mesh, mesh, mood="any"),
                      lambda: soms.overlap(mesh, mesh, None, "any"),
                      lambda: soms.overlap(mesh, mesh, a=mesh),
                      lambda: soms.overlap(mesh, mesh, threads=1.5),
                      lambda: soms.distance(mesh, mesh, at_most="far"), lambda: soms.read_mesh(7)):
            with self.assertRaises(TypeError):
                wrong()
        options = {"".join(("mo", "de")): "any"}  # a name that is not interned
        self.assertTrue(soms.overlap(mesh, b=mesh, **options))

    def test_indices_never_wrap(self):
        with self.fails("out_of_range", "-1", "row 2"):
            soms.Mesh(TETRAHEDRON, [[0, 1, 2], [0, 1, 3], [0, 1, -1]])
        with self.fails("out_of_range"):
            soms.Mesh(TETRAHEDRON, np.array([[0, 1, 2**32]]))
        with self.fails("out_of_range"):
            soms.Mesh(TETRAHEDRON, np.array([[0, 1, 2**64 - 1]], dtype=np.uint64))
        with self.assertRaises(soms.Error):
            soms.Mesh(TETRAHEDRON, [[0, 1, 4]])
        with self.fails("out_of_range", "-3"):
            tetrahedron().part_of([-3])

    def test_numbers_that_are_none(self):
        with self.fails("not_finite"):
            soms.Mesh(TETRAHEDRON * np.nan, FACES)
        unused = np.vstack([TETRAHEDRON, [[np.nan] * 3]])
        self.assertEqual(len(soms.Mesh(unused, FACES)), 4)
        with self.fails("not_finite"):
            soms.contains(tetrahedron(), [np.inf, 0, 0])

    def test_poses(self):
        poses = np.array([np.eye(4), 2 * np.eye(4)])
        with self.fails("not_rigid", "pose 1"):
            soms.overlap(tetrahedron(), tetrahedron(), poses)
        with self.fails("not_rigid"):
            soms.Pose([0, 0, 0, 1, 1, 0, 0])
        with self.fails("not_rigid", "last row"):
            soms.Pose(np.ones((4, 4)))

    def test_options(self):
        with self.fails("usage", "'some'", "all, any, first"):
            soms.overlap(tetrahedron(), tetrahedron(), mode="some")
        with self.fails("usage", "threads"):
            soms.overlap(tetrahedron(), tetrahedron(), threads=-1)
        for threads in (1025, 10**6, 2**31 - 1):
            with self.fails("usage", str(threads), "1024"):
                soms.overlap(tetrahedron(), tetrahedron(), threads=threads)
            with self.fails("usage", str(threads)):
                soms.Shape(tetrahedron(), threads=threads)
        with self.fails("usage", "timeout"):
            soms.overlap(tetrahedron(), tetrahedron(), timeout=float("nan"))
        with self.fails("usage"):
            soms.distance(tetrahedron(), tetrahedron(), at_most=-1)
        with self.fails("usage", "directions and ends"):
            soms.any_hit(tetrahedron(), [0, 0, 0])

    def test_what_to_do_is_said_in_names_of_python(self):
        with self.fails("usage", "width must be 0 to 1"):
            soms.winding(tetrahedron(), [0, 0, 0], width=7)
        scene = soms.Scene()
        scene.add_mover(soms.Body(tetrahedron()))
        with self.fails("usage", "StepScope.every_pair"):
            scene.step(scope="first_contact", clearance=1)
        with self.fails("cannot_open", "A::b.ply"):
            soms.read_mesh("/nowhere/A::b.ply")
        with self.fails("bad_file", "Pose::b.ply"):
            soms.read_mesh(b"ply nonsense", name="Pose::b.ply")

    def test_names_of_types_in_errors_are_there(self):
        literal = re.compile(r'"(?:[^"\\\n]|\\.)*"')
        kind = re.compile(r"\b([A-Z]\w+)::(\w+)")
        names = set()
        for path in SOURCES.rglob("*.cpp"):
            if "thesis" not in path.parts:
                for text in literal.findall(path.read_text(encoding="utf-8")):
                    names.update(kind.findall(text))
        self.assertGreater(len(names), 3)
        for of_class, member in sorted(names):
            if not of_class.endswith("Options"):
                self.assertTrue(is_in_python(f"{of_class}.{member}"), (of_class, member))

    def test_surfaces_that_are_open(self):
        with self.fails("not_closed"):
            soms.contains(soms.Mesh(TETRAHEDRON, FACES[:3]), [0, 0, 0])

    def test_a_foreign_mesh_is_checked_too(self):
        with self.fails("out_of_range", "-1"):
            soms.overlap(tetrahedron(), Foreign(faces=-np.ones((1, 3), dtype=int)))

    def test_an_old_name_is_accepted_with_a_warning(self):
        body, index = tetrahedron(), soms.BodyIndex([soms.Body(tetrahedron())])
        for call in (
            lambda: soms.overlap(body, body, seconds=0),
            lambda: soms.near_triangles(body, [[0, 0, 0]], 1, seconds=0).coverage,
            lambda: index.closest([5, 5, 5], seconds=0),
            lambda: index.any_hit([5, 5, 5], [0, 0, 1], seconds=0),
        ):
            with self.assertWarnsRegex(DeprecationWarning, "seconds is named timeout now"):
                call()
        with self.assertRaises(TypeError):
            index.closest([5, 5, 5], minutes=0)
        with self.assertRaises(TypeError):
            index.closest([5, 5, 5], timeout=1, seconds=1)

    def test_truth_of_answers(self):
        answer = soms.overlap(tetrahedron(), tetrahedron(), timeout=0)
        self.assertEqual(answer.coverage, soms.Coverage.cut)
        if not answer.any:
            with self.fails("timed_out"):
                bool(answer)
        with self.assertRaises(TypeError):
            bool(soms.distance(tetrahedron(), tetrahedron()))
        with self.assertRaises(TypeError):
            bool(soms.overlap(tetrahedron(), tetrahedron(), np.zeros((1, 3))))


if __name__ == "__main__":
    unittest.main()
