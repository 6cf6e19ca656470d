"""Pages of bodies and answers: what they hold, how a notebook shows them, and what is refused."""
import html
import json
import os
import re
import tempfile
import unittest

import numpy as np

import soms
from models import shifts, tetrahedron


def scene_of(page):
    """The data of its view."""
    return json.loads(re.search(r'id="soms-scene">(.*?)</script>', page.html, re.DOTALL)[1])


class Pages(unittest.TestCase):
    def setUp(self):
        self.mover = soms.Body(tetrahedron(), [0.5, 0, 0], "mover & <co>")
        self.fixed = soms.Body(tetrahedron(), name="fixed")

    def test_a_notebook_shows_what_can_be_drawn(self):
        scene = soms.Scene()
        scene.add_environment(self.fixed)
        scene.add_mover(self.mover)
        for given in (tetrahedron(), soms.Shape(tetrahedron()), self.mover, scene):
            shown = given._repr_html_()
            self.assertTrue(shown.startswith('<iframe srcdoc="<!DOCTYPE html>'), shown[:99])
            text = re.fullmatch(r'<iframe srcdoc="([^"]*)" sandbox="allow-scripts" [^>]*></iframe>',
                                shown)
            self.assertTrue(text)
            self.assertEqual(html.unescape(text[1]),
                             soms.Page(given, triangles=60_000).html)

    def test_nothing_is_fetched(self):
        page = soms.Page(self.mover)
        self.assertIn("default-src 'none'", page.html)
        self.assertIn("<h1>mover &amp; &lt;co&gt;</h1>", page.html)
        self.assertNotIn("<co>", page.html)

    def test_contacts_of_a_pair(self):
        answer = soms.overlap(self.mover, self.fixed)
        page = soms.Page([self.mover, self.fixed], answer, title="two")
        data = scene_of(page)
        self.assertIn("<h1>two</h1>", page.html)
        self.assertEqual((data["contacts"]["all"], len(data["bodies"]["names"])), (1, 2))
        self.assertEqual((page.triangles, page.triangles_in_all), (8, 8))
        self.assertIn("<dt>bodies that touch</dt><dd>1 pair</dd>", page.html)

    def test_contacts_and_gaps_of_a_step(self):
        scene = soms.Scene()
        scene.add_environment(self.fixed)
        for x in (0.5, 3, 9):
            scene.add_mover(self.mover.at([x, 0, 0]))
        page = soms.Page(scene, scene.step(clearance=5))
        data = scene_of(page)
        self.assertEqual(data["contacts"]["all"], 1)
        self.assertEqual(data["gaps"]["all"], 3)
        self.assertIn("<td>2</td>", page.html)  # from 1 to 3

    def test_poses(self):
        poses = shifts([0, 0, 0], [0.25, 0, 0], [5, 0, 0], [0.5, 0, 0])
        answer = soms.overlap(self.mover, self.fixed, poses)
        data = scene_of(soms.Page([self.mover, self.fixed], answer, poses=poses))
        self.assertEqual(data["contacts"]["all"], 2)  # two stretches
        gaps = soms.distance(self.mover, self.fixed, poses)
        page = soms.Page([self.mover, self.fixed], gaps, poses=poses)
        self.assertIn("<td>4</td><td>2</td>", page.html)  # distance 4 at pose 2
        for wrong in (poses[:3], None, np.zeros((0, 3))):
            with self.assertRaises(soms.Error):
                soms.Page([self.mover, self.fixed], answer, poses=wrong)

    def test_large_models_are_drawn_coarser_and_it_says_so(self):
        ball = soms.generate("sphere", 20_000)
        page = soms.Page(ball, triangles=2000)
        self.assertTrue(0 < page.triangles <= 2000)
        self.assertEqual(page.triangles_in_all, 20_000)
        self.assertLess(len(page.html), 800_000)
        self.assertIn("of 20000 triangles", repr(page))

    def test_files(self):
        page = soms.Page(self.mover)
        with tempfile.TemporaryDirectory() as folder:
            page.write(os.path.join(folder, "it.html"))
            with open(os.path.join(folder, "it.html"), encoding="utf-8") as file:
                self.assertEqual(file.read(), page.html)

    def test_answers_of_other_bodies_are_refused(self):
        ball = soms.generate("sphere", 800)
        of_balls = soms.overlap(ball, ball)
        scene = soms.Scene()
        for _ in range(9):
            scene.add_mover(ball)
        for given, answer in (([self.mover, self.fixed], of_balls), ([self.mover], of_balls),
                              (soms.Scene(), scene.step()), ([ball, ball], 7)):
            with self.assertRaises(soms.Error) as caught:
                soms.Page(given, answer)
            self.assertEqual(caught.exception.kind, "usage")
        self.assertIn("0 bodies", soms.Page([]).html)


if __name__ == "__main__":
    unittest.main()
