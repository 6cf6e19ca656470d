"""Errors are soms.Error with kind, place and remedy; what is given wrongly is said with its shape."""
import pickle
import unittest

import numpy as np

import soms
from models import FACES, TETRAHEDRON, Foreign, tetrahedron


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
        with self.fails("out_of_range", "2^53"):
            soms.Mesh(np.full((3, 3), 2**60), [[0, 1, 2]])

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
        with self.fails("usage", "seconds"):
            soms.overlap(tetrahedron(), tetrahedron(), seconds=float("nan"))
        with self.fails("usage"):
            soms.distance(tetrahedron(), tetrahedron(), at_most=-1)
        with self.fails("usage", "directions and ends"):
            soms.any_hit(tetrahedron(), [0, 0, 0])

    def test_surfaces_that_are_open(self):
        with self.fails("not_closed"):
            soms.contains(soms.Mesh(TETRAHEDRON, FACES[:3]), [0, 0, 0])

    def test_a_foreign_mesh_is_checked_too(self):
        with self.fails("out_of_range", "-1"):
            soms.overlap(tetrahedron(), Foreign(faces=-np.ones((1, 3), dtype=int)))

    def test_truth_of_answers(self):
        answer = soms.overlap(tetrahedron(), tetrahedron(), seconds=0)
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
