"""Tiles: cut, opened, queried as one shape, pickled by path and hash."""
import pathlib
import pickle
import shutil
import tempfile
import unittest

import numpy as np

import soms


class Tiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "tiles"
        self.mesh = soms.generate("city", 4000)
        self.whole = soms.Shape(self.mesh)
        self.tiles = soms.cut_tiles(self.path, [self.mesh], most=600)
        self.car = soms.Shape(soms.generate("car"))
        self.places = np.random.default_rng(1).uniform(*self.mesh.bounds, (200, 3))

    def test_answers_as_one_shape(self):
        rng = np.random.default_rng(2)
        directions = rng.uniform(-1, 1, (200, 3))
        for tiles in (self.tiles, soms.TileSet(self.path, max_memory=1, check="full")):
            for mode in ("all", "first"):
                one = soms.overlap(self.car, self.whole, self.places, mode=mode)
                many = soms.overlap(self.car, tiles, self.places, mode=mode, threads=2)
                np.testing.assert_array_equal(many.pairs, one.pairs)
                np.testing.assert_array_equal(many.offsets, one.offsets)
            for ask, fields in (
                (lambda b: soms.distance(self.car, b, self.places, at_most=20), ("lower", "upper", "triangles", "point_b", "farther")),
                (lambda b: soms.within(self.car, b, 5, self.places), ("within", "at_least")),
                (lambda b: soms.closest(b, self.places), ("lower", "triangle", "point", "feature")),
                (lambda b: soms.closest_hit(b, self.places, directions, lengths=300), ("lower", "triangle", "front")),
                (lambda b: soms.closest_hit(b, self.places, ends=directions, skip=7), ("upper", "triangle", "point")),
                (lambda b: soms.any_hit(b, self.places, directions), ("hit",)),
            ):
                one, many = ask(self.whole), ask(tiles)
                for field in fields:
                    np.testing.assert_array_equal(getattr(many, field), getattr(one, field), field)

    def test_answers_one_row_as_rows(self):
        place = self.places[0]
        self.assertEqual(soms.distance(soms.Body(self.car, place), self.tiles).triangles,
                         soms.distance(soms.Body(self.car, place), self.whole).triangles)
        self.assertEqual(soms.closest(self.tiles, place).triangle, soms.closest(self.whole, place).triangle)
        self.assertEqual(soms.closest_hit(self.tiles, place, [0, 0, -1]).triangle,
                         soms.closest_hit(self.whole, place, [0, 0, -1]).triangle)
        self.assertEqual(bool(soms.any_hit(self.tiles, place, [0, 0, -1])), bool(soms.any_hit(self.whole, place, [0, 0, -1])))

    def test_says_what_it_holds(self):
        self.assertEqual(len(self.tiles), 4000)
        self.assertGreater(self.tiles.tiles, 6)
        self.assertEqual(self.tiles.folder, str(self.path))
        np.testing.assert_array_equal(self.tiles.bounds, self.mesh.bounds)
        self.assertEqual(self.tiles.bytes, sum(file.stat().st_size for file in self.path.glob("tile-*")))
        self.assertIn("4000 triangles", repr(self.tiles))

    def test_cuts_meshes_of_a_generator_once(self):
        again = soms.cut_tiles(self.path, (mesh for mesh in [self.mesh]), most=600, threads=2)
        self.assertEqual(again, self.tiles)
        two = soms.cut_tiles(self.path.parent / "two", [self.mesh, self.mesh], layout="compact", rule="quick")
        self.assertEqual(len(two), 8000)
        with self.assertRaises(soms.Error) as caught:
            soms.cut_tiles(self.path.parent / "none", [soms.Mesh([[0, 0, 0]], np.zeros((0, 3), int), unit=1), self.mesh])
        self.assertEqual(caught.exception.kind, "usage")

    def test_is_pickled_by_path_and_hash(self):
        text = pickle.dumps(self.tiles)
        self.assertLess(len(text), 1000)
        again = pickle.loads(text)
        self.assertEqual(again.hash(), self.tiles.hash())

    def test_is_not_taken_for_other_tiles(self):
        text = pickle.dumps(self.tiles)
        with self.assertRaises(soms.Error) as caught:
            soms.cut_tiles(self.path, [self.mesh], most=300)
        self.assertEqual(caught.exception.kind, "usage")
        shutil.rmtree(self.path)
        soms.cut_tiles(self.path, [self.mesh], most=300)
        with self.assertRaises(soms.Error) as caught:
            pickle.loads(text)
        self.assertEqual(caught.exception.kind, "bad_file")

    def test_names_what_is_wrong(self):
        with self.assertRaises(soms.Error) as caught:
            soms.TileSet(self.path.parent)
        self.assertEqual(caught.exception.kind, "cannot_open")
        for ask in (lambda: soms.solid(self.car, self.tiles), lambda: soms.contains(self.tiles, [0, 0, 0])):
            with self.assertRaises((TypeError, soms.Error)):
                ask()


if __name__ == "__main__":
    unittest.main()
