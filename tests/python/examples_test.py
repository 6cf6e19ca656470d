"""Each example of python/examples runs, small, and prints what it says of its answer."""
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "python/examples"
CLASH = pathlib.Path(__file__).resolve().parents[1] / "data/clash"
ARGUMENTS = {
    "robot_cell": ["300"],
    "robot_states": ["300"],
    "robot_path": ["60", "20000"],
    "robot_roadmap": ["40", "20000"],
    "inside_or_not": ["2000"],
    "city_clashes": ["20000"],
    "many_poses": ["3000", "{folder}/poses"],
    "building_clashes": [CLASH / "structure.obj", CLASH / "services.gltf", "{folder}/clashes.csv"],
}
PRINTS = {
    "robot_cell": r"(\d+) of 300 positions are free",
    "inside_or_not": r"(\d+) of 2000 points are inside",
    "robot_states": r"(\d+) of 300 states are free",
    "robot_path": r"(\d+) of 59 segments are free",
    "robot_roadmap": r"40 edges: (\d+) free",
    "city_clashes": r"(\d+) pairs of triangles",
    "many_poses": r"(\d+) of 3000 poses are free",
    "building_clashes": r"(\d+) pairs of parts clash",
}


class Examples(unittest.TestCase):
    def test_each_runs(self):
        names = sorted(path.stem for path in EXAMPLES.glob("*.py"))
        self.assertEqual(names, sorted(ARGUMENTS))
        for name in names:
            if name == "many_poses" and importlib.util.find_spec("distributed") is None:
                print("skipped: many_poses, as the package distributed is not there")
                continue
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                arguments = [str(each).format(folder=folder) for each in ARGUMENTS[name]]
                said = subprocess.run([sys.executable, EXAMPLES / f"{name}.py", *arguments],
                                      check=True, capture_output=True, text=True).stdout
                found = re.search(PRINTS[name], said)
                self.assertTrue(found and int(found[1]) > 0, said)


if __name__ == "__main__":
    unittest.main()
