"""--only and --ignore: answers are those of a model from which the parts were removed by hand, with the numbers of the file.

usage: parts_test.py COMMAND
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import zipfile

COMMAND = None
# Boxes of 12 triangles each: name, least and greatest corner. The street is the file's, the rest is without the road.
PARTS = [("house", (3, 2, 0), (8, 6, 5)), ("road", (-5, -4, -1), (25, 4, 0)), ("sign", (10, -1, 0.5), (10.5, 1, 3))]
ROAD = range(12, 24)


def obj(parts):
    lines = []
    for k, (name, low, high) in enumerate(parts):
        lines.append(f"o {name}")
        for corner in range(8):
            lines.append("v " + " ".join(str((high if corner >> axis & 1 else low)[axis]) for axis in range(3)))
        for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            lines.append("f " + " ".join(str(8 * k + 1 + corner) for corner in face))
    return "\n".join(lines) + "\n"


def in_file(number):
    """The number in the street of a triangle of the rest."""
    return number if number < ROAD.start else number + len(ROAD)


def lines(text):
    return [json.loads(line) for line in text.splitlines()]


class Parts(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)
        self.write("street.obj", obj(PARTS))
        self.write("rest.obj", obj([PARTS[0], PARTS[2]]))
        self.write("van.obj", obj([("van", (-2, -1, -0.5), (2, 1, 2))]))
        self.write("poses.csv", "x,y,z\n0,0,0\n10,0,0\n4,2,0\n")
        self.write("points.csv", "x,y,z\n5,3,1\n10.25,0,-2\n9,0,1\n5,4,-0.5\n")
        self.write("rays.csv", "ox,oy,oz,dx,dy,dz\n5,3,9,0,0,-1\n0,0,1,1,0,0\n10.25,0,9,0,0,-1\n")

    def tearDown(self):
        self.place.cleanup()

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def run_words(self, *words, status=0):
        done = subprocess.run([COMMAND, *words], cwd=self.folder, capture_output=True, text=True, stdin=subprocess.DEVNULL)
        self.assertEqual(done.returncode, status, f"{words}: {done.stderr}")
        return done

    def both(self, verb, *words, options=("--ignore", "road")):
        """Standard outputs of the street without the road, and of the rest; STREET stands for the model."""
        street = self.run_words(verb, *("street.obj" if w == "STREET" else w for w in words), *options)
        self.assertRegex(street.stderr, "leaves (24 of 36|36 of 48) ")
        rest = self.run_words(verb, *("rest.obj" if w == "STREET" else w for w in words))
        return street.stdout, rest.stdout.replace("rest.obj", "street.obj")

    def same_rows(self, verb, *words, rename, options=("--ignore", "road"), verified=True):
        street, rest = (lines(text) for text in self.both(verb, *words, "--json", options=options))
        for row in rest:
            rename(row)
        for row in street + rest:
            row.pop("hash", None)  # of other numbers
            row.pop("cost", None)
        self.assertEqual(street, rest)
        self.assertEqual(any(row.get("verified") for row in street), verified)
        return street

    def test_pairs_have_the_numbers_of_the_file(self):
        def pairs(row):
            row["pairs"] = [[a, in_file(b)] for a, b in row["pairs"]]
        self.same_rows("overlap", "van.obj", "STREET", "--pose", "poses.csv", "--verify", rename=pairs)

        def near(row):
            if row.get("triangles"):
                row["triangles"][1] = in_file(row["triangles"][1])
        self.same_rows("distance", "van.obj", "STREET", "--pose", "poses.csv", "--verify", rename=near)
        self.same_rows("within", "van.obj", "STREET", "--pose", "poses.csv", "--clearance", "0.75", "--verify", rename=near)
        rows = self.same_rows("motion", "van.obj", "STREET", "--from", "poses.csv", "--by", "0,0,9", rename=near, verified=False)
        rows += self.same_rows("motion", "van.obj", "STREET", "--path", "poses.csv", rename=near, verified=False)
        self.assertTrue(any(row.get("triangles") for row in rows))
        self.same_rows("overlap", "van.obj", "STREET", "--pose", "poses.csv", "--by", "part", "--verify", rename=self.rename_parts)

    def rename_parts(self, row):
        for pair in row["parts"]:
            pair["first"][1] = in_file(pair["first"][1])
            pair["b"]["id"] = {0: 0, 1: 2}[pair["b"]["id"]]

    def test_the_first_model_may_lose_parts(self):
        def pairs(row):
            row["pairs"] = [[in_file(a), b] for a, b in row["pairs"]]
        self.same_rows("overlap", "STREET", "van.obj", "--pose-b", "poses.csv", "--verify", rename=pairs)

    def test_text_csv_and_columns_have_the_numbers_of_the_file(self):
        for verb, more in (("overlap", ()), ("distance", ())):
            text, _ = self.both(verb, "van.obj", "STREET", "--pose", "10 0 0", *more)
            self.assertIn("(sign)", text)
            numbers = [int(word.split(" ")[0]) for word in text.replace("triangle ", "and ").split("and ") if "(sign)" in word]
            self.assertTrue(numbers and all(number >= 24 for number in numbers), text)
        self.run_words("overlap", "van.obj", "street.obj", "--pose", "poses.csv", "--ignore", "road", "--csv", "out.csv")
        with open(self.folder / "out.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertTrue(rows)
        for row in rows:
            self.assertEqual(PARTS[int(row["triangle_b"]) // 12][0], row["name_b"])
            self.assertEqual(int(row["part_b"]), int(row["triangle_b"]) // 12)
        self.assertEqual({row["name_b"] for row in rows}, {"house", "sign"})
        self.run_words("overlap", "van.obj", "street.obj", "--pose", "poses.csv", "--ignore", "road", "--binary", "out.npz")
        listed = [int(row["triangle_b"]) for row in rows]
        with zipfile.ZipFile(self.folder / "out.npz") as archive:
            data = archive.read("pairs.npy")
        flat = [int.from_bytes(data[at:at + 8], "little") for at in range(len(data) - 16 * len(listed), len(data), 8)]
        self.assertEqual(flat[1::2], listed)

    def test_pages_show_the_numbers_of_the_file(self):
        self.run_words("distance", "van.obj", "street.obj", "--pose", "10 0 0", "--ignore", "road", "--report", "out.html")
        page = (self.folder / "out.html").read_text()
        self.assertRegex(page, r"(2[4-9]|3[0-5]) \(sign\)")
        self.assertNotRegex(page, r">(1[2-9]|2[0-3]) \(")
        for verb in ("overlap", "within"):
            clearance = ("--clearance", "1") if verb == "within" else ()
            self.run_words(verb, "van.obj", "street.obj", "--pose", "poses.csv", *clearance, "--ignore", "road", "--report", "out.html")

    def test_points_and_rays_have_the_numbers_of_the_file(self):
        def closest(row):
            row["triangle"] = in_file(row["triangle"])

        def hits(row):
            for hit in row["hits"]:
                hit["triangle"] = in_file(hit["triangle"])

        def hit(row):
            if row["hit"]:
                row["triangle"] = in_file(row["triangle"])

        def crossings(row):
            for place in row["hits"]:
                place["triangles"] = [in_file(number) for number in place["triangles"]]
        points = ("STREET", "--points", "points.csv", "--verify")
        self.same_rows("closest", *points, rename=closest)
        self.same_rows("closest", *points, "--signed", rename=closest)
        self.same_rows("closest", *points, "--nearest", "3", rename=hits)
        self.same_rows("contains", *points, rename=lambda row: None)
        self.same_rows("contains", *points, "--winding", rename=lambda row: None)

        def parts(row):
            for part in row["parts"]:
                part["first"] = in_file(part["first"])
                part["id"] = {0: 0, 1: 2}[part["id"]]
        self.same_rows("contains", *points, "--by", "part", rename=parts)
        rays = ("STREET", "--rays", "rays.csv", "--verify")
        self.same_rows("ray", *rays, rename=hit)
        self.same_rows("ray", *rays, "--all", rename=crossings)

    def test_a_skipped_triangle_is_named_as_in_the_file(self):
        first = lines(self.run_words("ray", "street.obj", "--rays", "rays.csv", "--ignore", "road", "--json").stdout)
        number = first[2]["triangle"]
        self.assertGreaterEqual(number, 24)
        again = lines(self.run_words("ray", "street.obj", "--rays", "rays.csv", "--ignore", "road", "--skip", str(number), "--json").stdout)
        self.assertNotEqual(again[2]["triangle"], number)
        same = lines(self.run_words("ray", "street.obj", "--rays", "rays.csv", "--ignore", "road", "--skip", "12", "--json").stdout)
        self.assertEqual(same[2]["triangle"], number)

    def test_solids_and_clashes_are_those_of_the_rest(self):
        self.same_rows("solid", "van.obj", "STREET", "--pose", "poses.csv", "--verify", rename=lambda row: None)
        street, rest = self.both("solid", "van.obj", "STREET", "--pose", "poses.csv", "--by", "part")
        self.assertEqual(street, rest)
        street, rest = self.both("clash", "van.obj", "STREET", "--clearance", "20", options=("--ignore", "r?ad"))
        listed = [[line for line in text.splitlines() if line.strip().startswith("near ")] for text in (street, rest)]
        self.assertEqual(*listed)
        self.assertEqual(len(listed[0]), 3)
        self.assertNotIn("road", street)

    def test_a_simulation_of_parts(self):
        self.write("path.csv", "x,y,z\n0,0,-0.25\n20,0,-0.25\n")
        for options, name in (((), "road"), (("--ignore", "road"), "sign")):
            done = self.run_words("simulate", "street.obj", "--mover", "van.obj", "--route", "path.csv", "--frames", "900", "--verify",
                                  "--contacts", "out.csv", "-o", "events.csv", "--clearance", "1", *options, "--json")
            with open(self.folder / "out.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertTrue(rows, done.stdout)
            for row in rows:
                self.assertEqual(PARTS[int(row["triangle"]) // 12][0], row["part"])
            names = {row["part"] for row in rows}
            self.assertIn(name, names)
            self.assertEqual("road" in names, not options)
            for touched in json.loads(done.stdout)["most_touched"]:
                self.assertEqual(PARTS[touched["triangle"] // 12][0], touched["part"])
        for output in (("--record", "out.soms"), ("-o", "out.png")):
            done = self.run_words("simulate", "street.obj", "--ignore", "road", *output, status=2)
            self.assertIn("soms convert CITY PARTS.ply --ignore road", done.stderr)

    def test_a_clearance_along_a_path(self):
        self.write("path.csv", "x,y,z\n0,0,0.75\n8,0,0.75\n")
        words = ("--profile", "van.obj", "--path", "path.csv", "--every", "2")
        self.same_rows("clearance", "STREET", *words, "--verify", rename=self.rename_station)

    def rename_station(self, place):
        for value in place.values():
            if isinstance(value, dict):
                self.rename_station(value)
        if place.get("triangles"):
            place["triangles"][1] = in_file(place["triangles"][1])
        if "ignored" in place:
            place["ignored"] = ["road"]

    def test_info_and_convert(self):
        done = self.run_words("info", "street.obj", "--ignore", "road", "--no-trees", "--json")
        report = lines(done.stdout)[0]
        self.assertEqual((report["triangles"], report["vertices"]), (24, 16))
        self.assertEqual([(part["name"], part["first_triangle"]) for part in report["parts"]], [("house", 0), ("sign", 24)])
        self.run_words("convert", "street.obj", "out.obj", "--ignore", "road")
        done = self.run_words("info", "out.obj", "--no-trees", "--json")
        self.assertEqual([part["name"] for part in lines(done.stdout)[0]["parts"]], ["house", "sign"])

    def test_info_names_defects_as_the_file_does(self):
        lines_of_road = obj(PARTS).splitlines()
        lines_of_road.remove([line for line in lines_of_road if line.startswith("f ")][-1])  # the sign is open
        self.write("open.obj", "\n".join(lines_of_road) + "\n")
        whole = lines(self.run_words("info", "open.obj", "--no-trees", "--json").stdout)[0]["places"]["open_edges"]
        left = lines(self.run_words("info", "open.obj", "--no-trees", "--json", "--only", "sign").stdout)[0]["places"]["open_edges"]
        for place in whole + left:
            place.pop("part")
        self.assertEqual(whole, left)

    def test_only_comes_first_and_then_ignore(self):
        def count(*words):
            return lines(self.run_words("info", "street.obj", "--no-trees", "--json", *words).stdout)[0]["triangles"]
        self.assertEqual(count("--only", "road", "--only", "sign"), 24)
        self.assertEqual(count("--only", "*o*", "--ignore", "road"), 12)
        self.assertEqual(count("--only", "*", "--ignore", "s*"), 24)

    def test_a_model_that_only_does_not_name_stays_whole_beside_another(self):
        done = self.run_words("overlap", "van.obj", "street.obj", "--pose", "10 0 0", "--only", "sign", "--json")
        self.assertIn("--only leaves 24 of 48 triangles", done.stderr)
        self.assertTrue(lines(done.stdout)[0]["any"])
        done = self.run_words("clash", "van.obj", "street.obj", "--only", "sign")
        self.assertIn("--only leaves 12 of 48 triangles", done.stderr)

    def test_paths_and_outer_parts_fit(self):
        text = obj(PARTS).replace("o house", "o north\ng house").replace("o sign", "o south\ng sign")
        self.write("nested.obj", text)
        for pattern in ("north", "north/house", "house", "north/*"):
            done = self.run_words("info", "nested.obj", "--no-trees", "--json", "--only", pattern)
            self.assertEqual(lines(done.stdout)[0]["triangles"], 12, pattern)

    def test_what_is_refused(self):
        def says(words, what, status=2):
            done = self.run_words(*words, status=status)
            self.assertIn(what, done.stderr)
            self.assertEqual(done.stdout, "")
        says(("info", "street.obj", "--ignore", "raod"), "--ignore raod: no part fits; did you mean road?")
        says(("info", "street.obj", "--only", "xyz"), "names, ids and types of parts are such as house, road, sign")
        says(("info", "street.obj", "--ignore", "*"), "--ignore leaves nothing")
        says(("overlap", "van.obj", "street.obj", "--ignore", "van"), "van.obj: no part of it is left by --ignore")
        self.write("bare.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        says(("info", "bare.off", "--ignore", "a"), "no model has parts with names")
        self.run_words("build", "bare.off", "-o", "bare.somst")
        says(("closest", "bare.somst", "--points", "points.csv", "--only", "a"), "no")
        self.run_words("tile", "street.obj", "-o", "tiles", "--most", "12")
        says(("closest", "tiles", "--points", "points.csv", "--only", "road"), "--only does not go with tiles: a part may lie in several")
        says(("overlap", "van.obj", "tiles", "--ignore", "road"), "--ignore does not go with tiles")
        says(("info", "tiles", "--ignore", "road"), "--ignore does not go with tiles")

    def test_a_tree_file_with_parts_is_built_again(self):
        self.run_words("build", "street.obj", "-o", "street.somst")
        done = self.run_words("closest", "street.somst", "--points", "points.csv", "--ignore", "road", "--json")
        self.assertIn("its tree is built again: parts are left out", done.stderr)
        model = self.run_words("closest", "street.obj", "--points", "points.csv", "--ignore", "road", "--json")
        self.assertEqual(done.stdout, model.stdout)

    def test_shards_know_the_patterns(self):
        words = ("overlap", "van.obj", "street.obj", "--pose", "poses.csv", "--binary", "shards", "--shard")
        self.run_words(*words, "1/2", "--ignore", "road")
        self.run_words(*words, "2/2", "--ignore", "sign")
        self.assertIn("question.parts", self.run_words("join", "shards", "-o", "all.npz", status=3).stderr)


if __name__ == "__main__":
    COMMAND = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
