"""Clash lists: those of the command, row by row; parts, keys, tables, pairs, and open parts."""
import json
import os
import pathlib
import pickle
import signal
import subprocess
import unittest

import numpy as np

import soms
from models import FACES, TETRAHEDRON, tetrahedron

DATA = pathlib.Path(__file__).resolve().parent.parent / "data/clash"
COMMAND = pathlib.Path(soms.__file__).resolve().parents[2] / "bin/soms"

BOX = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1],
                [1, 1, 1]], dtype=float)
BOX_FACES = [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7],
             [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]]


def box(lower, size, name="box"):
    part = soms.Part(name, 0, len(BOX_FACES))
    return soms.Mesh(BOX * size + np.asarray(lower, dtype=float), BOX_FACES, [part])


def building():
    structure = soms.read_mesh(DATA / "structure.obj")
    services = soms.read_mesh(DATA / "services.gltf")
    return soms.PartBodies(structure), soms.PartBodies(services.transformed(1, services.up))


def command_rows(*arguments):
    said = subprocess.run([COMMAND, "clash", *arguments, "--json"], capture_output=True, text=True,
                          check=False)
    rows = [json.loads(line) for line in said.stdout.splitlines()]
    return [row for row in rows if "key" in row]


def spoken(clashes, files=None):
    """Rows as the command has them, by their parts."""
    first, second = clashes.parts
    found = {}
    for clash, key in zip(clashes, clashes.key.tolist()):
        sides = tuple((int(parts.model[number]) if files else 0, int(parts.part[number]))
                      for parts, number in ((first, clash.a), (second, clash.b)))
        row = {"class": clash.kind.name, "relation": clash.relation.name, "gap": list(clash.gap),
               "place": clash.place.tolist(), "box": clash.box.tolist(),
               "triangle_pairs": clash.triangle_pairs, "key": f"{key:016x}"}
        if clash.penetration is not None:
            row["depth"] = clash.penetration.depth
            row["direction"] = clash.penetration.direction.tolist()
        found[sides] = row
    return found


class SameAsCommand(unittest.TestCase):
    KEYS = ("class", "relation", "gap", "place", "box", "triangle_pairs", "key", "depth", "direction")

    def setUp(self):
        if not COMMAND.exists():
            self.skipTest("the command is not built")

    def check_same(self, clashes, rows, files=None):
        wanted = {}
        for row in rows:
            sides = tuple((files.index(row[side]["file"]) if files else 0, row[side]["index"])
                          for side in "ab")
            wanted[sides] = {key: row[key] for key in self.KEYS if key in row}
        self.assertEqual(spoken(clashes, files), wanted)
        self.assertGreater(len(wanted), 0)

    def test_a_building(self):
        structure, services = building()
        clashes = soms.clash(structure, services, within=0.05, threads=2)
        self.check_same(clashes, command_rows(DATA / "structure.obj", "--against",
                                              DATA / "services.gltf", "--clearance", "0.05"))

    def test_every_class(self):
        files = [str(DATA / "special.obj"), str(DATA / "special_b.obj")]
        clashes = soms.clash([soms.read_mesh(file) for file in files], within=0.01)
        self.check_same(clashes, command_rows(*files, "--clearance", "0.01"), files)
        self.assertEqual(set(clashes.kind.tolist()), set(soms.ClashKind) - {soms.ClashKind.undecided})


class Clashes(unittest.TestCase):
    def test_the_building_has_260(self):
        structure, services = building()
        clashes = soms.clash(structure, services)
        self.assertEqual((len(structure), len(services), len(clashes)), (166, 72, 260))
        self.assertEqual(int(clashes.triangle_pairs.sum()), 13_252)
        self.assertEqual((clashes.coverage, clashes.left_out), (soms.Coverage.complete, 0))
        self.assertGreaterEqual(clashes.compared, 260)
        self.assertEqual(clashes, soms.clash(structure, services, threads=2))
        self.assertEqual(len(set(clashes.key.tolist())), 260)
        met = soms.overlap(structure.body(int(clashes.a[0])), services.body(int(clashes.b[0])))
        self.assertEqual(len(met.pairs), clashes.triangle_pairs[0])

    def test_parts_that_close_each_other_are_one_body(self):
        mesh = soms.Mesh(TETRAHEDRON, FACES, [soms.Part("front", 0, 2), soms.Part("back", 2, 2)])
        bodies = soms.PartBodies(mesh)
        self.assertEqual((bodies.closed.tolist(), bodies.part.tolist()), ([True], [0]))
        self.assertEqual((bodies.joined, bodies.names), ([[1]], ["front + back"]))
        parted = soms.DividedBody(mesh)
        self.assertEqual([(part.named, part.joined, part.closed) for part in parted.parts],
                         [(0, [1], True)])
        self.assertEqual(soms.contains(parted, TETRAHEDRON.mean(axis=0)).parts["part"].tolist(), [0])
        alone = soms.PartBodies(soms.Mesh(TETRAHEDRON, FACES, [soms.Part("all", 0, 4)]))
        self.assertEqual(alone.joined, [[]])

    def test_columns(self):
        clashes = soms.clash(*building())
        table = clashes.columns()
        self.assertEqual({len(column) for column in table.values()}, {260})
        for i in (0, 17, 259, -1):
            row = clashes[i]
            self.assertEqual(table["class"][i], row.kind.name)
            self.assertEqual(table["a_name"][i], clashes.parts[0].names[row.a])
            self.assertEqual(table["b_name"][i], clashes.parts[1].names[row.b])
            self.assertEqual((table["gap_lower"][i], table["gap_upper"][i]), row.gap)
            self.assertEqual((table["x"][i], table["y"][i], table["z"][i]), tuple(row.place))
            self.assertEqual(clashes.box[i].tolist(), row.box.tolist())
            self.assertEqual(table["depth"][i], row.penetration.depth)
            self.assertEqual(clashes.direction[i].tolist(), row.penetration.direction.tolist())
        self.assertEqual([clash.a for clash in clashes], clashes.a.tolist())
        with self.assertRaises(IndexError):
            clashes[260]
        with self.assertRaises(TypeError):
            bool(clashes)
        empty = soms.clash(tetrahedron(), box([5, 5, 5], 1))
        self.assertEqual({len(column) for column in empty.columns().values()}, {0})
        self.assertEqual((len(empty), empty.place.shape, empty.box.shape), (0, (0, 3), (0, 2, 3)))

    def test_columns_outlive_their_list(self):
        kinds = soms.clash(box([0, 0, 0], 1), box([0.5, 0, 0], 1)).kind
        self.assertEqual(kinds.tolist(), [soms.ClashKind.crossing])
        with self.assertRaises(ValueError):
            kinds[0] = 1

    def test_a_page_escapes_names(self):
        shown = soms.clash(box([0, 0, 0], 1, "<b>"), box([0.5, 0, 0], 1))._repr_html_()
        self.assertIn("&lt;b&gt;", shown)
        self.assertNotIn("<b>", shown)
        self.assertIn("and 220 more", soms.clash(*building())._repr_html_())

    def test_bodies_stand_at_their_poses(self):
        shape = soms.Shape(box([0, 0, 0], 1))
        near = soms.clash([soms.Body(shape), soms.Body(shape, [1.25, 0, 0])], within=0.25)
        self.assertEqual([clash.kind for clash in near], [soms.ClashKind.near])
        self.assertEqual(near[0].gap, (0.25, 0.25))
        for shift, kind in ((1, "touching"), (0, "same"), (0.5, "crossing")):
            found = soms.clash(shape, soms.Body(shape, [shift, 0, 0]))
            self.assertEqual([clash.kind.name for clash in found], [kind])

    def test_pairs(self):
        structure, services = building()
        every = soms.clash(structure, services)
        chosen = np.column_stack([every.a, every.b])[[200, 3, 3]]
        some = soms.clash(structure, services, pairs=chosen)
        self.assertEqual(some.key.tolist(), every.key[[3, 200]].tolist())
        self.assertEqual(len(soms.clash(structure, services, pairs=[])), 0)
        special = soms.PartBodies(soms.read_mesh(DATA / "special.obj"))
        alone = soms.clash(special)
        turned = soms.clash(special, pairs=np.column_stack([alone.b, alone.a]))
        self.assertEqual(turned.key.tolist(), alone.key.tolist())

    def test_open_parts(self):
        closed = box([0, 0, 0], 4)
        bowl = soms.Mesh(TETRAHEDRON * 9 - 1, FACES[:3])
        found = soms.clash(bowl, box([0.1, 0.1, 0.1], 0.5))
        self.assertEqual([(clash.kind.name, clash.why.name) for clash in found],
                         [("undecided", "open")])
        parts = found.parts[0]
        self.assertEqual((parts.closed.tolist(), parts.odd_edges.tolist()), ([False], [3]))
        inside = soms.clash(closed, soms.Mesh(TETRAHEDRON + 1, FACES[:3]))
        self.assertEqual([(clash.kind.name, clash.relation.name) for clash in inside],
                         [("inside", "b_in_a")])
        self.assertTrue(np.isnan(inside.depth[0]) and np.isnan(inside.direction).all())

    def test_a_deadline_cuts(self):
        cut = soms.clash(*building(), timeout=0)
        self.assertEqual(cut.coverage, soms.Coverage.cut)
        self.assertGreater(cut.left_out, 0)

    def test_errors(self):
        structure, services = building()
        for kind, call in (
                ("usage", lambda: soms.clash(structure, structure)),
                ("usage", lambda: soms.clash(structure, 3)),
                ("usage", lambda: soms.clash(structure, within=-1)),
                ("usage", lambda: soms.clash(structure, within=float("nan"))),
                ("usage", lambda: soms.clash(structure, pairs=[1, 2])),
                ("out_of_range", lambda: soms.clash(structure, services, pairs=[[0, 72]])),
                ("out_of_range", lambda: soms.clash(structure, services, pairs=[[-1, 0]])),
                ("usage", lambda: soms.clash(structure, threads=-1))):
            with self.assertRaises(soms.Error) as caught:
                call()
            self.assertEqual(caught.exception.kind, kind, caught.exception)
        with self.assertRaises(TypeError):
            soms.clash(structure, tolerance=1)

    def test_ctrl_c_and_progress(self):
        parts = building()

        def stop(_):
            raise LookupError("enough")

        def interrupt(_):
            os.kill(os.getpid(), signal.SIGINT)

        for threads in (1, 2):
            with self.assertRaisesRegex(LookupError, "enough"):
                soms.clash(*parts, threads=threads, progress=stop)
            with self.assertRaises(KeyboardInterrupt):
                soms.clash(*parts, threads=threads, progress=interrupt)
        self.assertEqual(len(soms.clash(*parts)), 260)


class Parts(unittest.TestCase):
    def test_what_parts_are(self):
        mesh = soms.read_mesh(DATA / "special.obj")
        parts = soms.PartBodies([mesh, soms.Body(box([0, 0, 0], 1), [5, 0, 0])])
        self.assertEqual(parts.model.tolist(), [0] * (len(parts) - 1) + [1])
        for number in range(len(parts) - 1):
            part = mesh.parts[parts.part[number]]
            self.assertEqual(parts.names[number], "/".join(mesh.part_path(parts.part[number])))
            self.assertEqual((parts.ids[number], parts.types[number]), (part.id, part.type))
            self.assertEqual(parts.triangles(number).tolist(),
                             np.flatnonzero(mesh.part_of() == parts.part[number]).tolist())
            self.assertEqual(parts.body(number).name, part.name)
        self.assertEqual(parts.bounds[-1].tolist(), [[5, 0, 0], [6, 1, 1]])
        self.assertTrue(parts.closed.all())
        again = pickle.loads(pickle.dumps(parts))
        self.assertEqual(again, parts)
        self.assertEqual(soms.clash(again).key.tolist(), soms.clash(parts).key.tolist())
        self.assertIn("2 models", repr(parts))
        with self.assertRaises(IndexError):
            parts.body(len(parts))

    def test_triangles_of_no_part(self):
        parts = soms.PartBodies(tetrahedron())
        self.assertEqual((parts.part.tolist(), parts.names), ([-1], [tetrahedron().source]))

    def test_part_of_all_triangles(self):
        mesh = soms.read_mesh(DATA / "special.obj")
        self.assertEqual(mesh.part_of().tolist(), mesh.part_of(np.arange(len(mesh))).tolist())
        with self.assertRaises(IndexError):
            mesh.part_path(len(mesh.parts))


class Penetrations(unittest.TestCase):
    def test_boxes(self):
        found = soms.penetration(box([0, 0, 0], 1), soms.Body(box([0, 0, 0], 1), [0.75, 0.1, 0]))
        self.assertAlmostEqual(found.depth, 0.25, delta=1e-12)
        self.assertEqual(found.direction.tolist(), [1, 0, 0])
        self.assertEqual(soms.penetration(box([0, 0, 0], 1), box([3, 0, 0], 1)).depth, 0)

    def test_both_are_checked(self):
        bowl = soms.Mesh(TETRAHEDRON, FACES[:3])
        with self.assertRaisesRegex(soms.Error, "a: is not closed"):
            soms.penetration(bowl, bowl)

    def test_errors(self):
        bowl = soms.Mesh(TETRAHEDRON, FACES[:3])
        for kind, wrong in (("not_closed", bowl), ("usage", soms.generate("drone"))):
            with self.assertRaises(soms.Error) as caught:
                soms.penetration(box([0, 0, 0], 1), wrong)
            self.assertEqual(caught.exception.kind, kind, caught.exception)
            self.assertIn("b: ", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
