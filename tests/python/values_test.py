"""Meshes, shapes, bodies and poses as values: arrays, equality, repr, pickling, lifetimes."""
import copy
import gc
import math
import pickle
import unittest

import numpy as np

import soms
from models import FACES, TETRAHEDRON, Foreign, shifts, tetrahedron


class Meshes(unittest.TestCase):
    def test_arrays_are_views_that_cannot_be_written(self):
        mesh = tetrahedron()
        self.assertTrue(np.array_equal(mesh.vertices, TETRAHEDRON))
        self.assertTrue(np.array_equal(mesh.triangles, FACES))
        self.assertTrue(np.shares_memory(mesh.vertices, mesh.vertices))
        self.assertTrue(np.shares_memory(mesh.faces, mesh.triangles))
        for array in (mesh.vertices, mesh.triangles):
            with self.assertRaises(ValueError):
                array[0, 0] = 7

    def test_what_goes_in_is_copied(self):
        vertices = TETRAHEDRON.copy()
        mesh = soms.Mesh(vertices, FACES)
        vertices[:] = 9
        self.assertTrue(np.array_equal(mesh.vertices, TETRAHEDRON))

    def test_types_and_layouts_of_arrays(self):
        for vertices in (TETRAHEDRON.astype(np.float32), TETRAHEDRON.astype(int),
                         np.asfortranarray(TETRAHEDRON), TETRAHEDRON.tolist(),
                         TETRAHEDRON.astype(">f8")):
            for faces in (FACES.astype(np.uint8), FACES.astype(np.uint64), FACES[::1, ::1],
                          np.asfortranarray(FACES), FACES.tolist()):
                self.assertEqual(soms.Mesh(vertices, faces), tetrahedron())

    def test_a_city_is_read_by_level_and_surface(self):
        city = (b'{"type":"CityJSON","version":"2.0","transform":{"scale":[1,1,1],"translate":[0,0,0]},'
                b'"CityObjects":{"house":{"type":"Building","geometry":['
                b'{"type":"MultiSurface","lod":"1","boundaries":[[[0,1,2]]]},'
                b'{"type":"MultiSurface","lod":"2.2","boundaries":[[[0,1,2]],[[0,2,3]]],"semantics":'
                b'{"surfaces":[{"type":"RoofSurface"}],"values":[0,null]}}]}},'
                b'"vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]}')
        self.assertEqual(len(soms.read_mesh(city, name="a.city.json").triangles), 2)
        self.assertEqual(len(soms.read_mesh(city, name="a.city.json", lod=1).triangles), 1)
        parts = soms.read_mesh(city, name="a.city.json", surfaces=True).parts
        self.assertEqual([(part.name, part.type) for part in parts],
                         [("house", "Building"), ("RoofSurface 0", "RoofSurface")])
        with self.assertRaisesRegex(soms.Error, "it has no levels of detail"):
            soms.read_mesh(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", name="a.off", lod=1)

    def test_an_empty_mesh_touches_nothing(self):
        empty = soms.Mesh(np.zeros((0, 3)), [])
        self.assertEqual(len(empty), 0)
        self.assertFalse(soms.overlap(empty, tetrahedron()))

    def test_views_outlive_what_they_are_of(self):
        mesh = soms.generate("car")
        kept, copied = mesh.vertices, mesh.vertices.copy()
        del mesh
        gc.collect()
        churn = [soms.generate("car") for _ in range(20)]
        self.assertTrue(np.array_equal(kept, copied), len(churn))
        answer = soms.overlap(soms.generate("car"), soms.generate("person"))
        pairs, copied = answer.pairs, answer.pairs.copy()
        del answer
        gc.collect()
        self.assertTrue(np.array_equal(pairs, copied))

    def test_parts(self):
        parts = [soms.Part("all", 0, 4), soms.Part("half", 2, 2, parent=0)]
        mesh = soms.Mesh(TETRAHEDRON, FACES, parts, unit=0.001, up="y", source="here")
        self.assertEqual(mesh.parts, parts)
        self.assertEqual(mesh.part_of([[0, 3]]).tolist(), [[0, 1]])
        self.assertEqual((mesh.unit, mesh.up, mesh.source), (0.001, soms.UpAxis.y, "here"))
        self.assertEqual(tetrahedron().part_of([0]).tolist(), [-1])

    def test_georeferences(self):
        self.assertFalse(tetrahedron().georeference)
        conversion = soms.MapConversion(eastings=311988.0, northings=5996148.0, height=10.0,
                                        abscissa=0.6, ordinate=0.8, factors=(1, 1, 2), unit=1.0)
        place = soms.Georeference("EPSG:25833", "DHHN2016", conversion)
        mesh = soms.Mesh(TETRAHEDRON, FACES, georeference=place)
        self.assertTrue(mesh.georeference)
        self.assertEqual(mesh.georeference, place)
        self.assertNotEqual(mesh, tetrahedron())
        self.assertEqual((place.crs, place.vertical_datum), ("EPSG:25833", "DHHN2016"))
        self.assertEqual((conversion.eastings, conversion.northings, conversion.height),
                         (311988.0, 5996148.0, 10.0))
        self.assertEqual((conversion.abscissa, conversion.ordinate, conversion.scale),
                         (0.6, 0.8, 1.0))
        self.assertEqual((conversion.factors, conversion.unit), ((1.0, 1.0, 2.0), 1.0))
        self.assertEqual(mesh.transformed(2.0).georeference.map_conversion.scale, 0.5)
        self.assertIsNone(soms.Georeference("EPSG:7415").map_conversion)
        self.assertTrue(str(place).startswith("EPSG:25833; vertical datum DHHN2016; origin at"))

    def test_bounds_hash_and_transformed(self):
        mesh = tetrahedron()
        self.assertEqual(mesh.bounds.tolist(), [[0, 0, 0], [1, 1, 1]])
        self.assertEqual(mesh.transformed(2.0).bounds.tolist(), [[0, 0, 0], [2, 2, 2]])
        self.assertEqual(mesh.hash(), tetrahedron().hash())
        self.assertNotEqual(mesh.hash(), mesh.transformed(2.0).hash())
        self.assertTrue(mesh.closedness().whole.closed and mesh.defects().closed)

    def test_pickling_and_copies(self):
        parts = [soms.Part("all", 0, 4)]
        mesh = soms.Mesh(TETRAHEDRON, FACES, parts, unit=1.0, up="z", source="x", notes=["n"],
                         file_faces=[5, 6, 7, 8],
                         georeference=soms.Georeference("c", "d", soms.MapConversion(scale=3.0)))
        shape = soms.Shape(mesh, rule="sah", layout="compact", per_leaf=2)
        body = soms.Body(shape, [1, 2, 3], "name")
        place = mesh.georeference
        for value in (mesh, shape, body, body.pose, parts[0], soms.ClosedBody(body), place,
                      place.map_conversion):
            self.assertEqual(pickle.loads(pickle.dumps(value)), value)
            self.assertEqual(copy.deepcopy(value), value)
            self.assertTrue(repr(value).startswith(type(value).__name__), repr(value))

    def test_files(self):
        mesh = soms.generate("drone")
        import tempfile
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.ply", "a.off", "a.obj"):
                soms.write_mesh(f"{folder}/{name}", mesh)
                read = soms.read_mesh(f"{folder}/{name}")
                self.assertEqual(read.hash(), mesh.hash())
                with open(f"{folder}/{name}", "rb") as file:
                    self.assertEqual(soms.read_mesh(file.read(), name=name).hash(), mesh.hash())
            np.save(f"{folder}/poses.npy", shifts([1, 2, 3], [4, 5, 6]))
            poses = soms.read_poses(f"{folder}/poses.npy")
            self.assertEqual(poses[:, :, 3].tolist(), [[1, 2, 3], [4, 5, 6]])


class Shapes(unittest.TestCase):
    def test_what_stands_for_a_body(self):
        mesh = tetrahedron()
        answers = [soms.overlap(given, mesh) for given in
                   (mesh, soms.Shape(mesh), soms.Body(mesh), Foreign(), soms.Body(Foreign()))]
        self.assertTrue(all(answer == answers[0] for answer in answers))
        self.assertTrue(answers[0].any)

    def test_shapes_share_their_mesh(self):
        mesh = tetrahedron()
        shape = soms.Shape(mesh, rule=soms.Rule.quality)
        self.assertIs(shape.mesh, mesh)
        self.assertEqual((shape.rule, shape.layout), (soms.Rule.quality, soms.Layout.wide))

    def test_refit(self):
        shape = soms.Shape(tetrahedron())
        moved = shape.refit(TETRAHEDRON + 10)
        self.assertFalse(soms.overlap(moved, shape))
        self.assertEqual(moved.mesh.bounds[0].tolist(), [10, 10, 10])


class Poses(unittest.TestCase):
    def test_every_form_is_the_same_pose(self):
        half = math.sqrt(0.5)
        pose = soms.Pose.from_quaternion(half, 0, 0, half, [1, 2, 3])
        matrix = pose.matrix
        self.assertEqual(matrix.shape, (3, 4))
        square = np.vstack([matrix, [0, 0, 0, 1]])
        for given in (pose, matrix, square, [1, 2, 3, half, 0, 0, half]):
            self.assertEqual(soms.Pose(given), pose)
        self.assertEqual(soms.Pose([1, 2, 3]), soms.Pose.translation(1, 2, 3))

    def test_batches_take_every_form(self):
        mover, fixed = soms.Shape(tetrahedron()), soms.Body(tetrahedron())
        pose = soms.Pose.about_z(0.3, [0.4, 0.3, 0.2])
        single = soms.overlap(soms.Body(mover, pose), fixed)
        self.assertGreater(len(single.pairs), 0)
        square = np.vstack([pose.matrix, [0, 0, 0, 1]])
        for poses in ([pose], pose.matrix[None], square[None], pose.matrix.reshape(1, 12)):
            batch = soms.overlap(mover, fixed, poses)
            self.assertEqual(batch.of(0).tolist(), single.pairs.tolist())
        self.assertEqual(len(soms.overlap(mover, fixed, np.zeros((0, 4, 4)))), 0)

    def test_floats_need_the_nearest_rotation(self):
        matrix = soms.Pose.about_z(0.3).matrix.astype(np.float32)
        coarse = np.round(matrix, 4)
        with self.assertRaises(soms.Error):
            soms.Pose(coarse)
        pose = soms.Pose.from_matrix(coarse, rotation="nearest")
        self.assertLess(abs(pose.matrix[0, 0] - math.cos(0.3)), 1e-4)

    def test_products_and_points(self):
        a, b = soms.Pose.about_z(0.5, [1, 0, 0]), soms.Pose.translation(0, 2, 0)
        self.assertEqual(a @ b, a * b)
        self.assertTrue(np.allclose((a @ b).apply([0, 0, 0]), a.apply(b.apply([0, 0, 0]))))
        self.assertTrue(np.allclose(a.inverse().apply(a.apply(TETRAHEDRON)), TETRAHEDRON))
        self.assertEqual(soms.Pose(), soms.Pose.identity())


class Batches(unittest.TestCase):
    def test_rows_of_any_length(self):
        mover, fixed = soms.Shape(tetrahedron()), soms.Body(tetrahedron())
        answer = soms.overlap(mover, fixed, shifts([0, 0, 0], [9, 9, 9], [0.5, 0, 0]))
        self.assertEqual(answer.any.tolist(), [True, False, True])
        self.assertEqual(answer.any.dtype, bool)
        self.assertEqual(len(answer.of(1)), 0)
        self.assertEqual(answer.offsets[-1], len(answer.pairs))
        self.assertTrue(np.shares_memory(answer.of(0), answer.pairs))
        with self.assertRaises(ValueError):
            answer.pairs[0] = 0
        for row in (3, 2**63):
            with self.assertRaises(IndexError):
                answer.of(row)

    def test_one_progress_for_all(self):
        shares = []
        soms.overlap(soms.generate("car"), soms.generate("drone"), np.zeros((5000, 3)), mode="any",
                     threads=2, progress=shares.append)
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(shares[-1], 1)


if __name__ == "__main__":
    unittest.main()
