"""What workers of a cluster write is byte by byte what the command writes, and `soms join` takes it.

usage: shards_test.py SOMS
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from cluster_models import ROWS, job_in, make_files
from soms import _shards

SOMS = None
CASES = {"overlap": [("overlap", {"mode": "all", "pairs": True}, []), ("overlap", {"mode": "first", "pairs": True}, ["--first"]),
                     ("overlap", {"mode": "any", "pairs": False}, ["--any", "--no-pairs"])],
         "near": [("distance", {}, []), ("distance", {"at_most": 3.0}, ["--at-most", "3"]),
                  ("within", {"clearance": 2.5}, ["--clearance", "2.5"])]}


class Shards(unittest.TestCase):
    def check(self, cases):
        with tempfile.TemporaryDirectory() as place:
            files = make_files(place)
            for number, (verb, question, words) in enumerate(cases):
                whole, folder = files / f"{number}.npz", files / str(number)
                words = [verb, "car.ply", "city.ply", "--pose", "poses.npy", *words]
                self.run_soms(files, *words, "-o", whole)
                parts = [(0, 1000), (1000, 1001), (1001, ROWS)]
                for rows in parts:
                    _shards.work(job_in(files, folder, verb, question), rows)
                _shards.join(folder, parts, folder / "answer.npz")
                self.assertEqual((folder / "answer.npz").read_bytes(), whole.read_bytes(), words)
                self.run_soms(files, "join", folder, "-o", "joined.npz")
                self.assertEqual((files / "joined.npz").read_bytes(), whole.read_bytes(), words)
                self.run_soms(files, *words, "-o", folder / "shard.npz", "--shard", "1/1")
                one = (folder / "shard-1.json").read_text()
                other = (folder / f"{_shards.name_of(parts[0])}.json").read_text()
                self.assertEqual(one.partition(',"rows"')[0], other.partition(',"rows"')[0])

    def run_soms(self, folder, *words):
        done = subprocess.run([SOMS, *map(str, words)], cwd=folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_overlap(self):
        self.check(CASES["overlap"])

    def test_a_tree_file_is_the_model_that_it_was_built_of(self):
        with tempfile.TemporaryDirectory() as place:
            files = make_files(place)
            self.run_soms(files, "build", "city.ply", "-o", "city.somst")
            words = ["distance", "car.ply", "city.somst", "--pose", "poses.npy", "-o"]
            self.run_soms(files, *words, "whole.npz")
            job = job_in(files, files / "answers", "distance", {})
            tree = _shards.job_of("distance", job["a"], files / "city.somst", job["poses"], job["folder"], {})
            self.assertEqual(_shards.identity(tree), _shards.identity(job))
            _shards.work(tree, (0, 1000))
            _shards.work(job, (1000, ROWS))
            _shards.join(files / "answers", [(0, 1000), (1000, ROWS)], files / "joined.npz")
            self.assertEqual((files / "joined.npz").read_bytes(), (files / "whole.npz").read_bytes())

    def test_tiles_answer_as_the_model_that_was_cut(self):
        with tempfile.TemporaryDirectory() as place:
            files = make_files(place)
            self.run_soms(files, "tile", "city.ply", "--most", "700", "-o", "tiles")
            self.run_soms(files, "distance", "car.ply", "city.ply", "--pose", "poses.npy", "-o", "whole.npz")
            self.run_soms(files, "distance", "car.ply", "tiles", "--pose", "poses.npy", "--shard", "2/2", "-o", "shards/shard.npz")
            job = _shards.job_of("distance", files / "car.ply", files / "tiles", files / "poses.npy", files / "answers", {})
            with open(files / "shards" / "shard-2.json", encoding="utf-8") as file:
                self.assertEqual(json.load(file)["models"], _shards.identity(job)["models"])
            _shards.work(job, (0, 1000))
            _shards.work(job, (1000, ROWS))
            _shards.join(files / "answers", [(0, 1000), (1000, ROWS)], files / "joined.npz")
            self.assertEqual((files / "joined.npz").read_bytes(), (files / "whole.npz").read_bytes())

    def test_a_model_that_states_where_it_lies(self):
        with tempfile.TemporaryDirectory() as place:
            files = make_files(place)
            self.run_soms(files, "build", "city.ply", "--crs", "EPSG:25833", "-o", "placed.somst")
            for verb, question, words in (("distance", {}, []), ("within", {"clearance": 2.5}, ["--clearance", "2.5"])):
                self.run_soms(files, verb, "car.ply", "placed.somst", "--pose", "poses.npy", *words, "-o", "whole.npz")
                job = _shards.job_of(verb, files / "car.ply", files / "placed.somst", files / "poses.npy", files / verb, question)
                _shards.work(job, (0, ROWS))
                _shards.join(files / verb, [(0, ROWS)], files / "joined.npz")
                self.assertEqual((files / "joined.npz").read_bytes(), (files / "whole.npz").read_bytes(), verb)

    def test_distance_and_within(self):
        self.check(CASES["near"])


if __name__ == "__main__":
    SOMS = os.path.abspath(sys.argv.pop(1))
    unittest.main()
