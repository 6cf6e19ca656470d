"""Every truth set through the package: single calls and batches, by one thread and by two."""
import math
import unittest

import numpy as np

import data
import soms

EMPTY_HASH = 0xCBF29CE484222325


def runnable(rows):
    kept = [row for row in rows if data.shape(row["meshA"]) and data.shape(row["meshB"])]
    return kept, len(rows) - len(kept)


class Overlaps(unittest.TestCase):
    def test_single_and_batch_by_one_thread_and_two(self):
        cases, skipped = runnable(list(data.rows("truth/cases")))
        self.assertGreaterEqual(len(cases), 3780)
        lists = data.groups(data.rows("truth/lists"), "case")
        for case in cases:
            with self.subTest(case=case["case"]):
                a, b = data.shape(case["meshA"]), data.shape(case["meshB"])
                fixed = soms.Body(b, data.pose(case, "b"))
                single = soms.overlap(soms.Body(a, data.pose(case, "a")), fixed)
                batch = soms.overlap(a, fixed, data.pose(case, "a")[None], threads=2)
                self.check(case, single, batch, lists.get((case["case"],)))
        print(f"{len(cases)} cases, {skipped} skipped without SOMS_DATA")

    def check(self, case, single, batch, listed):
        self.assertEqual(single.any, case["overlap"] == "1")
        self.assertEqual(len(single.pairs), int(case["count"]))
        self.assertEqual(f"{single.hash():016x}", case["hash"])
        self.assertEqual(single.coverage, soms.Coverage.complete)
        self.assertTrue(np.array_equal(batch.of(0), single.pairs))
        self.assertEqual(bool(batch.any[0]), single.any)
        self.assertEqual(int(batch.costs["node_tests"][0]), single.cost.node_tests)
        if listed:
            pairs = [(int(row["i"]), int(row["j"])) for row in listed]
            self.assertEqual(single.pairs.tolist(), [list(pair) for pair in pairs])
            self.assertEqual(
                case["hash"] == f"{EMPTY_HASH:016x}", len(pairs) == 0)

    def test_modes(self):
        cases, _ = runnable(list(data.rows("truth/cases"))[::10])
        for case in cases:
            a = soms.Body(data.shape(case["meshA"]), data.pose(case, "a"))
            b = soms.Body(data.shape(case["meshB"]), data.pose(case, "b"))
            every = soms.overlap(a, b).pairs
            self.assertEqual(bool(soms.overlap(a, b, mode="any")), len(every) > 0)
            first = soms.overlap(a, b, mode=soms.OverlapMode.first).pairs
            self.assertEqual(first.tolist(), every[:1].tolist())

    def test_pairs_of_triangles(self):
        corners = [f"{body}{corner}{axis}" for body in "ab" for corner in "012" for axis in "xyz"]
        for row in data.rows("truth/tritri"):
            vertices = np.array([float(row[name]) for name in corners]).reshape(2, 3, 3)
            if row["kind"] == "huge":
                with self.assertRaises(soms.Error) as caught:
                    soms.overlap(*(soms.Mesh(v, [[0, 1, 2]]) for v in vertices))
                self.assertEqual(caught.exception.kind, "out_of_range")
                continue
            a, b = (soms.Mesh(v, [[0, 1, 2]]) for v in vertices)
            self.assertEqual(soms.overlap(a, b).any, row["overlap"] == "1", row)


class Distances(unittest.TestCase):
    def test_single_and_batch_by_one_thread_and_two(self):
        cases, _ = runnable(list(data.rows("distance/cases")))
        self.assertGreaterEqual(len(cases), 150)
        for case in cases:
            with self.subTest(case=case["case"]):
                a = data.shape(case["meshA"])
                fixed = soms.Body(data.shape(case["meshB"]), data.pose(case, "b"))
                mover = soms.Body(a, data.pose(case, "a"))
                single = soms.distance(mover, fixed)
                lo, hi = float(case["lo"]), float(case["hi"])
                self.assertEqual((single.lower, single.upper), (lo, hi))
                self.assertEqual(single.triangles, (int(case["i"]), int(case["j"])))
                batch = soms.distance(a, fixed, data.pose(case, "a")[None], threads=2)
                self.assertEqual(batch.at(0), single)
                self.assertEqual(batch.triangles.tolist(), [list(single.triangles)])
                self.assertEqual((batch.lower[0], batch.upper[0]), (lo, hi))
                self.check_within(case, mover, fixed, lo, hi)

    def check_within(self, case, mover, fixed, lo, hi):
        self.assertEqual(soms.within(mover, fixed, lo).within, case["within_lo"] == "1")
        self.assertEqual(soms.within(mover, fixed, hi).within, case["within_hi"] == "1")
        if case["within_below"]:
            below = math.nextafter(lo, -math.inf)
            batch = soms.within(mover.shape, fixed, below, [mover.pose], threads=2)
            self.assertEqual(bool(batch.within[0]), case["within_below"] == "1")

    def test_points(self):
        for (mesh,), rows in data.groups(data.rows("distance/closest"), "mesh").items():
            if data.shape(mesh) is None:
                continue
            points = np.array([data.point(row, "p") for row in rows])
            one, two = (soms.closest(data.shape(mesh), points, threads=n) for n in (1, 2))
            self.assertEqual(one, two)
            for i, row in enumerate(rows):
                with self.subTest(mesh=mesh, row=i):
                    single = soms.closest(data.shape(mesh), points[i])
                    self.assertEqual(single, one.at(i))
                    self.assertEqual((single.lower, single.upper),
                                     (float(row["lo"]), float(row["hi"])))
                    self.assertEqual(single.triangle, int(row["triangle"]))
                    self.assertEqual(one.triangle[i], int(row["triangle"]))
                    self.assertEqual(single.point.tolist(), data.point(row, "q").tolist())
                    self.assertEqual(single.feature.name, row["feature"])
            nearest = soms.nearest_triangles(data.shape(mesh), points, 1)
            self.assertEqual(nearest.triangle.tolist(), [int(row["triangle"]) for row in rows])
            near = soms.near_triangles(data.shape(mesh), points, 0)
            on = [len(near.of(i)) > 0 for i in range(len(rows))]
            self.assertEqual(on, [row["on"] == "1" for row in rows])


class Points(unittest.TestCase):
    def test_inside(self):
        count = 0
        for (mesh,), rows in data.groups(data.rows("questions/inside"), "mesh").items():
            if data.shape(mesh) is None:
                continue
            body = data.closed(mesh)
            points = np.array([data.point(row, "p") for row in rows])
            answers = [soms.Side[row["answer"]] for row in rows]
            one, two = (soms.contains(body, points, threads=n) for n in (1, 2))
            self.assertEqual(one, two)
            self.assertEqual(one.side.tolist(), answers)
            signed = soms.closest(body, points)
            self.assertEqual(signed.side.tolist(), answers)
            for i, point in enumerate(points):
                single = soms.contains(body, point)
                self.assertEqual(single.side, answers[i])
                self.assertEqual(single.cost, one.at(i).cost)
                distance = soms.closest(body, point)
                self.assertEqual(distance, signed.at(i))
                self.assertEqual(distance.upper < 0, answers[i] == soms.Side.inside)
            count += len(rows)
        self.assertGreater(count, 900)

    def test_closed(self):
        for (mesh,), rows in data.groups(data.rows("questions/closed"), "mesh").items():
            if data.shape(mesh) is None:
                continue
            found = data.shape(mesh).mesh.closedness(connected=True)
            for row in rows:
                part = found.whole if row["part"] == "-1" else found.connected[int(row["part"])]
                self.assertEqual((part.first, part.triangles, part.degenerate, part.odd_edges),
                                 tuple(int(row[k]) for k in ("first", "triangles", "flat", "odd")))

    def test_winding_of_closed_bodies(self):
        for (mesh,), rows in data.groups(data.rows("questions/inside"), "mesh").items():
            if data.shape(mesh) is None or not data.shape(mesh).mesh.defects().closed:
                continue
            index = soms.WindingIndex(soms.Body(data.shape(mesh)))
            points = np.array([data.point(row, "p") for row in rows])
            one, two = (soms.winding(index, points, threads=n) for n in (1, 2))
            self.assertEqual(one, two)
            for i, row in enumerate(rows):
                self.assertEqual(soms.winding(index, points[i]), one.at(i))
                if row["answer"] == "on":
                    self.assertEqual(one.side[i], soms.Side.on)
                else:
                    self.assertEqual(one.lower[i], one.upper[i])


class Solids(unittest.TestCase):
    def test_single_and_batch_by_one_thread_and_two(self):
        cases, _ = runnable(list(data.rows("questions/solid")))
        self.assertGreaterEqual(len(cases), 500)
        names = {"a_in_b_touching": "a_in_b", "b_in_a_touching": "b_in_a"}
        for case in cases:
            with self.subTest(case=case["case"]):
                a, b = data.closed(case["meshA"]), data.closed(case["meshB"])
                pose_a, fixed = data.pose(case, "a"), b.at(data.pose(case, "b"))
                single = soms.solid(a.at(pose_a), fixed)
                answer = names.get(case["answer"], case["answer"])
                self.assertEqual(single.relation.name, answer)
                self.assertTrue(single.surfaces_meet)
                batch = soms.solid(a, fixed, [pose_a], threads=2)
                self.assertEqual(batch.at(0).relation, single.relation)


class Rays(unittest.TestCase):
    def test_hits(self):
        rows = list(data.rows("questions/ray"))
        for number, row in enumerate(rows):
            row["number"] = number
        lists = data.groups(data.rows("questions/ray_lists"), "ray")
        for (mesh,), rays in data.groups(rows, "mesh").items():
            if data.shape(mesh) is not None:
                self.check(data.shape(mesh), rays, lists)

    def check(self, shape, rows, lists):
        origins = np.array([data.point(row, "o") for row in rows])
        directions = np.array([data.point(row, "d") for row in rows])
        lengths = np.array([float(row["length"]) for row in rows])
        first, again = (soms.closest_hit(shape, origins, directions, lengths=lengths, threads=n)
                        for n in (1, 2))
        self.assertEqual(first, again)
        any_hit = soms.any_hit(shape, origins, directions, lengths=lengths)
        every = soms.all_hits(shape, origins, directions, lengths=lengths, threads=2)
        for i, row in enumerate(rows):
            with self.subTest(ray=row["number"]):
                single = soms.closest_hit(shape, origins[i], directions[i], lengths=lengths[i])
                self.assertEqual(single, first.at(i))
                self.assertEqual(bool(any_hit.hit[i]), row["any"] == "1")
                if row["any"] == "1":
                    self.assertEqual((single.lower, single.upper, single.triangle),
                                     (float(row["t_lo"]), float(row["t_hi"]), int(row["triangle"])))
                else:
                    self.assertIsNone(single.triangle)
                begin, end = every.offsets[i:i + 2]
                triangles = every.triangle[every.triangle_offsets[begin]:every.triangle_offsets[end]]
                self.assertEqual(len(triangles), int(row["hits"]))
                listed = lists.get((str(row["number"]),))
                if listed:
                    self.assertEqual(sorted(triangles.tolist()),
                                     sorted(int(hit["triangle"]) for hit in listed))


class Motions(unittest.TestCase):
    """The tables of tests/data/motion, whose README says how far times are known."""

    WORDS = {"free": "free", "contact": "contact", "start": "started"}

    def holds(self, row, found, answer, lower, upper, tolerance):
        with self.subTest(**{name: row[name] for name in ("meshA", "meshB", "kind") if name in row}):
            self.assertEqual(found.coverage, soms.Coverage.complete)
            self.assertEqual(found.verdict.name, self.WORDS[answer])
            if answer == "contact":
                self.assertLessEqual(found.lower, upper + tolerance)
                self.assertGreaterEqual(found.upper, lower - tolerance)
                self.assertLessEqual(found.upper - found.lower, 100 * tolerance + 1e-9)

    def test_paths_single_and_batch_by_one_thread_and_two(self):
        rows = list(data.rows("motion/motion_path"))
        self.assertEqual(len(rows), 107)
        for row in rows:
            shape, fixed = data.shape(row["meshA"]), soms.Body(data.shape(row["meshB"]), data.point(row, "b"))
            start, end, pivot = data.pose(row, "a"), data.pose(row, "e"), data.point(row, "c")
            found = soms.first_contact(shape, start, end, fixed, pivot=pivot)
            size = 8 + max(abs(start[:, 3]).max(), abs(end[:, 3]).max(), abs(pivot).max())
            self.holds(row, found, row["answer"], float(row["t_lo"] or 0), float(row["t_hi"] or 0),
                       1e-13 * size / max(float(row["speed"] or 0), 1e-9))
            batch = soms.first_contact(shape, np.array([start] * 9), end, fixed, pivot=pivot, threads=2)
            self.assertEqual([batch.at(k) for k in range(9)], [found] * 9)
            self.assertEqual(soms.free(shape, start, end, fixed, pivot=pivot), row["answer"] == "free")

    def test_shifts_are_exact(self):
        rows = list(data.rows("motion/translation"))
        self.assertGreater(len(rows), 600)
        for row in rows:
            moving, resting = ([data.point(row, f"{body}{corner}") for corner in "012"] for body in "ba")
            found = soms.first_contact(soms.Mesh(moving, [[0, 1, 2]]), soms.Pose(), None,
                                       soms.Mesh(resting, [[0, 1, 2]]), by=data.point(row, "d"))
            answer = "free" if row["contact"] != "1" else "contact" if row["free_until"] else "start"
            self.holds(row, found, answer, float(row["free_until"] or 0), float(row["touching_by"] or 0), 0)
            if answer == "contact":
                self.assertLessEqual(found.upper, np.nextafter(found.lower, 2))


if __name__ == "__main__":
    unittest.main()
