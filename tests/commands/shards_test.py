"""Shards: joined they are the bytes of one run; what is there and whole stays, what is foreign or missing is named.

usage: shards_test.py SOMS
"""
import json
import os
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

SOMS = None
ROWS = 23
VERBS = {"overlap": [], "first": ["--first"], "any": ["--any"], "count": ["--no-pairs"], "parts": ["--by", "part"],
         "some": ["--limit", "3"], "distance": [], "near": ["--at-most", "0.4"], "within": ["--clearance", "0.3"]}
WITHOUT_CSV = {"count"}


def npy(rows):
    """The bytes of numpy.save."""
    text = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({len(rows)}, {len(rows[0])}), }}"
    text = text.ljust((10 + len(text) + 64) // 64 * 64 - 11) + "\n"
    return b"\x93NUMPY\x01\0" + struct.pack("<H", len(text)) + text.encode() + b"".join(
        struct.pack("<d", x) for row in rows for x in row)


class Shards(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.kept.name)
        cls.run_soms(cls, "generate", "knot", "--triangles", "600", "-o", "knot.ply")
        cls.run_soms(cls, "generate", "sphere", "--triangles", "320", "-o", "ball.ply")
        dice = random.Random(3)
        rows = [[dice.uniform(-2.5, 2.5) for _ in range(3)] for _ in range(ROWS)]
        (cls.folder / "poses.npy").write_bytes(npy(rows))
        (cls.folder / "poses.csv").write_text("x,y,z\n" + "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in rows))
        (cls.folder / "still.npy").write_bytes(npy([[0, 0, 0.125]] * ROWS))

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def setUp(self):
        self.out = pathlib.Path(self._testMethodName)

    def run_soms(self, *words, status=0):
        done = subprocess.run([SOMS, *map(str, words)], cwd=self.folder, capture_output=True, text=True, check=False)
        if done.returncode != status:
            raise AssertionError(f"{words}: status {done.returncode}: {done.stdout}{done.stderr}")
        return done

    def npz(self):
        return f"{self.out}/shard.npz"

    def question(self, name, poses="poses.npy"):
        verb = {"near": "distance"}.get(name, name if name in ("distance", "within") else "overlap")
        return [verb, "knot.ply", "ball.ply", "--pose", poses, *VERBS[name]]

    def answer(self, name, shards, out, poses="poses.npy", *more):
        csv = [] if name in WITHOUT_CSV else ["-o", f"{out}/shard.csv"]
        for number in random.Random(shards).sample(range(1, shards + 1), shards):
            self.run_soms(*self.question(name, poses), "-o", f"{out}/shard.npz", *csv, "--shard", f"{number}/{shards}", *more)

    def check(self, name, out, *more, kinds=("npz", "csv")):
        kinds = ["npz"] if name in WITHOUT_CSV else kinds
        self.run_soms(*self.question(name), *more, *(word for kind in kinds for word in
                                                     ("-o", f"{out}.whole.{kind}")))
        for kind in kinds:
            self.run_soms("join", out, "-o", f"{out}.{kind}")
            self.assertEqual((self.folder / f"{out}.{kind}").read_bytes(),
                             (self.folder / f"{out}.whole.{kind}").read_bytes(), (name, kind))

    def test_joined_they_are_one_run(self):
        for name in VERBS:
            for shards in (4, ROWS + 5) if name == "some" else (3,):
                out = f"{name}-{shards}"
                self.answer(name, shards, out)
                self.check(name, out)
                if name in ("any", "within"):
                    threads = f"{out}-threads"
                    self.answer(name, shards, threads, "poses.npy", "--threads", "3")
                    self.check(name, threads, "--threads", "1")

    def test_poses_of_csv_and_of_both_models(self):
        self.answer("distance", 3, self.out, "poses.csv")
        self.check("distance", self.out)
        both = f"{self.out}-both"
        self.answer("distance", 3, both, "poses.npy", "--pose-b", "still.npy")
        self.check("distance", both, "--pose-b", "still.npy")

    def test_what_is_whole_stays_and_what_is_damaged_is_answered_again(self):
        self.answer("distance", 3, self.out)
        folder = self.folder / self.out
        before = {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in folder.iterdir()}
        self.answer("distance", 3, self.out)
        self.assertEqual(before, {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in folder.iterdir()})
        damaged = folder / "shard-2.npz"
        damaged.write_bytes(damaged.read_bytes()[:-1] + b"x")
        self.assertIn("shard-2.npz", self.run_soms("join", self.out, "-o", "x.npz", status=3).stderr)
        (folder / "shard-3.npz").unlink()
        self.assertIn("shard-3.npz", self.run_soms("join", self.out, "-o", "x.csv", status=0).stderr + "shard-3.npz")
        self.answer("distance", 3, self.out)
        self.assertEqual({path: data for path, (_, data) in before.items()}, {path: path.read_bytes() for path in folder.iterdir()})

    def test_foreign_receipts_and_holes_are_named(self):
        self.answer("distance", 3, self.out)
        other = f"{self.out}-other"
        self.answer("near", 3, other)
        for words, status in ((["--at-most", "0.4"], 3), (["--tree", "rule=soms"], 3)):
            refused = self.run_soms(*self.question("distance"), *words, "-o", self.npz(), "--shard", "2/3", status=status)
            self.assertRegex(refused.stderr, r"shard-2\.json: is of another run: its question\.(at_most|tree) differs")
        refused = self.run_soms(*self.question("distance"), "-o", self.npz(), "--shard", "2/4", status=3)
        self.assertIn("its rows differs", refused.stderr)
        folder = self.folder / self.out
        kept = (folder / "shard-2.json").read_bytes()
        shutil.copy(self.folder / other / "shard-2.json", folder)
        refused = self.run_soms("join", self.out, "-o", "x.npz", status=3)
        self.assertRegex(refused.stderr, r"shard-2\.json: is of another run than .*shard-1\.json: its question\.at_most differs")
        (folder / "shard-2.json").write_text("{}")
        self.assertIn("shard-2.json: no receipt", self.run_soms("join", self.out, "-o", "x.npz", status=3).stderr)
        (folder / "shard-2.json").unlink()
        self.assertIn("rows 8 to 16 are missing", self.run_soms("join", self.out, "-o", "x.npz", status=3).stderr)
        (folder / "shard-2.json").write_bytes(kept)
        changed = json.loads(kept)
        changed["rows"] = [7, 16]
        (folder / "shard-2.json").write_text(json.dumps(changed))
        self.assertIn("rows 7 to 16", self.run_soms("join", self.out, "-o", "x.npz", status=3).stderr)
        self.assertFalse((self.folder / "x.npz").exists())

    def test_old_names_name_the_folder(self):
        self.answer("distance", 2, self.out)
        old = f"{self.out}-old"
        for number in (1, 2):
            done = self.run_soms(*self.question("distance"), "--binary", old, "--csv", old, "--shard", f"{number}/2")
            self.assertEqual([line for line in done.stderr.splitlines() if " is now " in line],
                             ["--binary is now -o FILE.npz; the old form ends with the next release",
                              "--csv is now -o FILE.csv; the old form ends with the next release"])
        files = {path.name: path.read_bytes() for path in (self.folder / self.out).iterdir()}
        self.assertEqual(files, {path.name: path.read_bytes() for path in (self.folder / old).iterdir()})

    def test_a_shard_has_the_name_of_its_output(self):
        for number in (1, 2):
            self.run_soms(*self.question("distance"), "-o", f"{self.out}/gaps.npz", "--shard", f"{number}/2")
        self.assertEqual(sorted(os.listdir(self.folder / self.out)), ["gaps-1.json", "gaps-1.npz", "gaps-2.json", "gaps-2.npz"])
        self.check("distance", self.out, kinds=("npz",))

    def test_errors_name_rows_of_the_whole_file(self):
        rows = [[0.0, 0.0, 0.0]] * ROWS
        rows[20] = [0.0, float("nan"), 0.0]
        (self.folder / "broken.npy").write_bytes(npy(rows))
        refused = self.run_soms(*self.question("distance", "broken.npy"), "-o", self.npz(), "--shard", "3/3", status=3)
        self.assertIn("broken.npy, row 20: y is nan", refused.stderr)
        self.assertEqual(os.listdir(self.folder / self.out), [])

    def test_what_does_not_go_with_it(self):
        for words in (["--shard", "1/2"], ["--shard", "0/2", "-o", self.npz()], ["--shard", "3/2", "-o", self.npz()],
                      ["--shard", "2", "-o", self.npz()], ["--shard", "1/2", "-o", self.npz(), "--verify"],
                      ["--shard", "1/2", "-o", self.npz(), "-o", "x.html"], ["--shard", "1/2", "-o", self.npz(), "-o", "x.jsonl"],
                      ["--shard", "1/2", "-o", self.npz(), "-o", "elsewhere/shard.csv"]):
            self.run_soms(*self.question("distance"), *words, status=2)
        self.run_soms("distance", "knot.ply", "ball.ply", "--pose", "1 0 0", "--shard", "1/2", "-o", self.npz(), status=2)
        self.run_soms("join", self.out, "-o", "x.txt", status=2)


if __name__ == "__main__":
    SOMS = os.path.abspath(sys.argv.pop(1))
    unittest.main()
