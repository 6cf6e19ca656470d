"""Tree files: saved, opened by each check, pickled by path and hash."""
import copy
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import soms


class TreeFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "city.somst"
        self.built = soms.Shape(soms.generate("city", 3000))
        self.built.save(self.path)

    def test_opens_what_was_saved(self):
        car = soms.Shape(soms.generate("car"))
        poses = np.random.default_rng(1).uniform(-300, 300, (50, 3))
        for check in soms.TreeCheck:
            for load in (False, True):
                opened = soms.open_shape(self.path, check=check, load=load)
                self.assertEqual(opened, self.built)
                self.assertEqual(opened.mesh, self.built.mesh)
                self.assertEqual(soms.overlap(car, opened, poses), soms.overlap(car, self.built, poses))
        self.assertEqual(soms.open_shape(self.path.read_bytes(), check="full", threads=2), self.built)

    def test_says_where_it_comes_from(self):
        self.assertIsNone(self.built.tree_file)
        self.assertEqual(soms.open_shape(self.path).tree_file, str(self.path))
        self.assertEqual(soms.open_shape(self.path.read_bytes()).tree_file, "bytes")

    def test_is_pickled_by_path_and_hash(self):
        opened = soms.open_shape(self.path)
        text = pickle.dumps(opened)
        self.assertLess(len(text), 1000)
        again = pickle.loads(text)
        self.assertEqual(again, opened)
        self.assertEqual(again.tree_file, str(self.path))
        self.assertEqual(copy.deepcopy(opened), opened)
        self.assertGreater(len(pickle.dumps(soms.open_shape(self.path.read_bytes()))), 10_000)
        body = pickle.loads(pickle.dumps(soms.Body(opened, name="city")))
        self.assertEqual(body.shape, opened)

    def test_a_relative_path_is_pickled_whole(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.path.parent)
        text = pickle.dumps(soms.open_shape("city.somst"))
        os.chdir(here)
        self.assertEqual(pickle.loads(text), self.built)

    def test_another_file_of_the_name_is_refused_where_it_is_unpickled(self):
        text = pickle.dumps(soms.open_shape(self.path))
        soms.Shape(soms.generate("car")).save(self.path)
        code = "import pickle, sys; pickle.loads(sys.stdin.buffer.read())"
        ended = subprocess.run([sys.executable, "-c", code], input=text, capture_output=True, check=False)
        self.assertNotEqual(ended.returncode, 0)
        self.assertIn(b"not the tree file that the shape was opened from", ended.stderr)

    def test_damage_is_an_error(self):
        bytes_ = bytearray(self.path.read_bytes())
        bytes_[20_000] ^= 1
        with self.assertRaises(soms.Error) as raised:
            soms.open_shape(bytes(bytes_))
        self.assertEqual(raised.exception.kind, "bad_file")
        with self.assertRaises(soms.Error) as raised:
            soms.open_shape(self.path.parent / "none.somst")
        self.assertEqual(raised.exception.kind, "cannot_open")
        with self.assertRaises(soms.Error) as raised:
            soms.read_mesh(self.path)
        self.assertEqual(raised.exception.kind, "unsupported")
        with self.assertRaises(soms.Error) as raised:
            self.built.save(self.path.parent / "none" / "a.somst")
        self.assertEqual(raised.exception.kind, "cannot_write")


if __name__ == "__main__":
    unittest.main()
