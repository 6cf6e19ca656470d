"""Each example of python/examples runs, small, and prints what it says of its answer."""
import pathlib
import re
import subprocess
import sys
import unittest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "python/examples"
SIZES = {"robot_cell": "300", "inside_or_not": "2000", "city_clashes": "20000"}
PRINTS = {
    "robot_cell": r"(\d+) of 300 positions are free",
    "inside_or_not": r"(\d+) of 2000 points are inside",
    "city_clashes": r"(\d+) pairs of triangles",
}


class Examples(unittest.TestCase):
    def test_each_runs(self):
        names = sorted(path.stem for path in EXAMPLES.glob("*.py"))
        self.assertEqual(names, sorted(SIZES))
        for name in names:
            with self.subTest(name):
                said = subprocess.run([sys.executable, EXAMPLES / f"{name}.py", SIZES[name]],
                                      check=True, capture_output=True, text=True).stdout
                found = re.search(PRINTS[name], said)
                self.assertTrue(found and int(found[1]) > 0, said)


if __name__ == "__main__":
    unittest.main()
