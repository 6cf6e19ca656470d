"""A mesh and itself: pairs, duplicates, corners by index and by position."""
import unittest

import numpy as np

import soms

VERTICES = np.array([[0, 0, 0], [2, 0, 0], [1, 2, 0], [1, 1, -1], [1, 1, 1], [3, 1, 0]], float)
TRIANGLES = np.array([[0, 1, 2], [3, 4, 5], [2, 1, 0]])


def soup(mesh):
    return soms.Mesh(np.asarray(mesh.vertices)[np.asarray(mesh.triangles).ravel()],
                     np.arange(3 * len(mesh)).reshape(-1, 3))


class SelfOverlap(unittest.TestCase):
    def test_lists_pairs_and_duplicates(self):
        answer = soms.self_overlap(soms.Mesh(VERTICES, TRIANGLES))
        self.assertTrue(answer)
        self.assertEqual(np.asarray(answer.pairs).tolist(), [[0, 1], [1, 2]])
        self.assertEqual(np.asarray(answer.duplicates).tolist(), [[0, 2]])
        self.assertEqual(answer.coverage, soms.Coverage.complete)

    def test_takes_modes_and_limits(self):
        shape = soms.Shape(soms.Mesh(VERTICES, TRIANGLES))
        self.assertEqual(np.asarray(soms.self_overlap(shape, mode="first").pairs).tolist(), [[0, 1]])
        self.assertEqual(len(soms.self_overlap(shape, mode="any").pairs), 1)
        cut = soms.self_overlap(shape, limit=1)
        self.assertEqual((len(cut.pairs), cut.coverage), (1, soms.Coverage.cut))
        with self.assertRaises(soms.Error):
            soms.self_overlap(shape, by="corner")

    def test_finds_nothing_in_closed_surfaces(self):
        ball = soms.generate("sphere", 500)
        self.assertFalse(soms.self_overlap(ball, threads=2))
        self.assertTrue(soms.self_overlap(soup(ball)))
        self.assertFalse(soms.self_overlap(soup(ball), by="position"))


if __name__ == "__main__":
    unittest.main()
