# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of the checks of meshes and of curves, and of the repair of meshes."""

import unittest

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, SQUARE, circle

import vfc


class Meshes(unittest.TestCase):
    def test_a_sound_mesh_has_no_defects_and_is_not_changed(self):
        self.assertEqual(vfc.check_mesh(CUBE_VERTICES, CUBE_FACES), [])
        mended = vfc.repair(CUBE_VERTICES, CUBE_FACES)
        self.assertEqual((mended.steps, mended.distance_from_input), ([], 0))
        self.assertTrue(np.array_equal(mended.vertices, CUBE_VERTICES))
        self.assertEqual(len(mended.faces), 12)

    def test_defects_have_the_indices_of_the_arrays(self):
        hole, = vfc.check_mesh(CUBE_VERTICES, CUBE_FACES[1:])
        self.assertEqual((hole.kind, hole.is_error), ("open boundary", True))
        self.assertEqual(sorted(hole.vertices), sorted(CUBE_FACES[0]))
        repeated, = vfc.check_mesh(CUBE_VERTICES, np.vstack([CUBE_FACES, CUBE_FACES[:1]]))[:1]
        self.assertEqual((repeated.kind, list(repeated.faces)), ("duplicate face", [0, 12]))

    def test_what_is_mended_can_be_filled(self):
        two = (np.vstack([CUBE_VERTICES, CUBE_VERTICES + 0.5]), np.vstack([CUBE_FACES, CUBE_FACES + 8]))
        for vertices, faces, volume in [(CUBE_VERTICES, CUBE_FACES[1:], 1), (*two, 2 - 0.125)]:
            self.assertTrue(any(defect.is_error for defect in vfc.check_mesh(vertices, faces)))
            mended = vfc.repair(vertices, faces)
            self.assertNotEqual(mended.steps, [])
            self.assertEqual(vfc.check_mesh(mended.vertices, mended.faces), [])
            a, b, c = mended.vertices[mended.faces].transpose(1, 0, 2)
            self.assertAlmostEqual(np.einsum("ij,ij", a, np.cross(b, c)) / 6, volume)
            vfc.Mesh(mended.vertices, mended.faces)

    def test_what_fill_refuses_is_an_error_and_repair_tells_what_it_did(self):
        turned = np.vstack([CUBE_FACES[:1, ::-1], CUBE_FACES[1:]])
        soup = CUBE_VERTICES[CUBE_FACES].reshape(-1, 3), np.arange(36).reshape(-1, 3)
        joined = np.where(CUBE_FACES == 0, 7, CUBE_FACES + 7)
        pair = np.vstack([CUBE_VERTICES, CUBE_VERTICES[1:] + 1]), np.vstack([CUBE_FACES, joined])
        for (vertices, faces), step in [((CUBE_VERTICES, turned), "turned faces"),
                                        (soup, "merged vertices at the same place"),
                                        (pair, "split vertices between surfaces")]:
            with self.assertRaises(ValueError):
                vfc.Mesh(vertices, faces)
            self.assertTrue(any(defect.is_error for defect in vfc.check_mesh(vertices, faces)), step)
            mended = vfc.repair(vertices, faces)
            self.assertIn(step, mended.steps)
            vfc.Mesh(mended.vertices, mended.faces)

    def test_what_cannot_be_mended_is_a_value_error(self):
        for vertices, faces, message in [(CUBE_VERTICES * np.nan, CUBE_FACES, "not finite, vertex 0"),
                                         (CUBE_VERTICES, [[0, 1, 9]], "row 0 has the index 9"),
                                         (CUBE_VERTICES, [[0, 0, 1]], "area"),
                                         (CUBE_VERTICES, np.zeros((0, 3), int), "no faces")]:
            with self.assertRaisesRegex(ValueError, message):
                vfc.repair(vertices, faces)
        with self.assertRaisesRegex(ValueError, "alpha"):
            vfc.repair(CUBE_VERTICES, CUBE_FACES, alpha=-1)

    def test_progress_can_end_a_repair_and_its_exceptions_come_out(self):
        def fail(progress):
            raise KeyError(progress["stage"])
        with self.assertRaises(KeyError):
            vfc.repair(CUBE_VERTICES, CUBE_FACES[1:], progress=fail)
        with self.assertRaises(vfc.Interrupted):
            vfc.repair(CUBE_VERTICES, CUBE_FACES[1:], progress=lambda p: p["stage"] == "checking")


class Checks(unittest.TestCase):
    def kinds(self, *arguments, **options):
        return [(d.kind, d.is_error, d.points.tolist()) for d in vfc.check_curves(*arguments, **options)]

    def test_a_sound_curve_has_no_defect(self):
        self.assertEqual(vfc.check_curves([circle(), circle(at=(3, 0, 0))]), [])
        self.assertEqual(vfc.check_curves(circle(), domain=vfc.Ball((0, 0, 0), 1.1)), [])

    def test_points_of_defects_are_those_of_all_curves_together(self):
        cross = [[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]
        self.assertEqual(self.kinds([circle(at=(5, 0, 0)), cross]),
                         [("self-contact", True, [16, 17, 18, 19])])
        self.assertEqual(self.kinds([circle(), np.array([0, 0, 5]) + circle()[:1]], closed=[True, False]),
                         [("short line", True, [16])])
        not_finite = circle()
        not_finite[3, 1] = np.inf
        self.assertEqual(self.kinds(not_finite), [("non-finite coordinate", True, [3])])

    def test_what_is_an_error_is_refused_and_what_is_none_is_not(self):
        twice = np.insert(circle(), 4, circle()[4], axis=0)
        star = vfc.Network([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [9, 9, 9]], [[0, 1], [0, 2], [0, 3]])
        again = vfc.Network(star.points, star.edges + [[1, 0]])
        nearly = circle(radius=1 + 1e-14)
        nearly = np.insert(circle(), 4, nearly[4], axis=0)
        for curves, kind in [(twice, "coincident nodes"), (star, "isolated vertex"),
                             (again, "duplicate edge"), (circle()[:2], "degenerate loop"),
                             (nearly, "nearly coincident nodes")]:
            found = vfc.check_curves(curves)
            self.assertIn(kind, [defect.kind for defect in found])
            if any(defect.is_error for defect in found):
                with self.assertRaises(ValueError):
                    vfc.simplify(curves)
            else:
                vfc.simplify(curves)

    def test_a_curve_outside_or_near_the_wall_is_an_error(self):
        ball = vfc.Ball((0, 0, 0), 0.9 + 1e-3)
        ring = circle(radius=0.9)
        self.assertEqual(self.kinds(ring, domain=ball), [])
        (kind, is_error, edge), = self.kinds(ring, domain=ball, wall_distance=0.01)
        self.assertEqual((kind, is_error, len(edge)), ("near wall", True, 2))
        ring[5] *= 1.1
        self.assertEqual(self.kinds(ring, domain=ball),
                         [("outside node", True, [5]), ("outside segment", True, [4, 5]),
                          ("outside segment", True, [5, 6])])
        self.assertEqual(vfc.outside(ring, ball), ([5], [[4, 5], [5, 6]]))

    def test_nothing_that_is_asked_for_is_left_unchecked(self):
        ball = vfc.Ball((0, 0, 0), 2)
        for distance in (-1, np.nan, np.inf):
            with self.assertRaisesRegex(ValueError, "wall_distance is"):
                vfc.check_curves(circle(), domain=ball, wall_distance=distance)
        with self.assertRaisesRegex(ValueError, "needs a domain"):
            vfc.check_curves(circle(), wall_distance=0.1)
        with self.assertRaisesRegex(TypeError, "must be a Domain"):
            vfc.check_curves(circle()[:2], domain=CUBE_VERTICES)
        with self.assertRaisesRegex(ValueError, r"points must have the shape \(n, 3\)"):
            vfc.check_curves(vfc.Network(circle()[:, :2], [[0, 1]]))

    def test_the_wall_distance_is_that_of_whole_edges(self):
        square = 0.25 + 0.5 * np.column_stack([SQUARE, [0.5] * 4])
        nearest = vfc.wall_distance(square, vfc.Mesh(CUBE_VERTICES, CUBE_FACES))
        self.assertAlmostEqual(nearest.distance, 0.25)
        self.assertRegex(repr(nearest), r"^WallDistance\(distance=0.25, point=<array \(3,\)>, edge=\[")
        in_square = 0.3 * np.column_stack([SQUARE, [0] * 4]) + [0.1, 0.2, 0]
        self.assertAlmostEqual(vfc.wall_distance(in_square, vfc.Polygons(SQUARE)).distance, 0.1)
        with self.assertRaisesRegex(ValueError, "not inside"):
            vfc.wall_distance(circle(radius=2), vfc.Ball((0, 0, 0), 1))


if __name__ == "__main__":
    unittest.main()
