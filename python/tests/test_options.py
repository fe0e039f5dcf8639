# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of options: each has an effect, and the one that is said."""

import unittest

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, circle

import vfc
from vfc import _options

TREFOIL = vfc.torus_knot(2, 3, 100)
CUBE = vfc.Mesh(CUBE_VERTICES, CUBE_FACES)
UPWARDS = np.tile([0.0, 0, 1], (8, 1))

# A value of each option, and the options with which it is given, if it needs any.
SHORT = {"number_of_iterations": 30}
MEDIAL = {"preconditioner": "medial"} | SHORT
SEARCH = {"strategy": "search", "number_of_iterations": 3}
UNTANGLING = {
    "strategy": ("search", {}), "number_of_chains": (1, SEARCH), "tolerance": (0.1, {}),
    "lower_ropelength": (True, {"number_of_iterations": 300}),
    "keep_length": (True, {}), "bend_radius": (1.0, {}), "strand_distance": (1.0, {}),
    "number_of_iterations": (3, {}), "time_limit": (0, {}), "random_seed": (5, SEARCH),
    "thickness": (0.3, {}), "number_of_directions": (4, SHORT), "max_radius": (0.8, SHORT),
    "spacing": (0.5, SHORT), "screening": (3, SHORT), "medial_weight": (5, SHORT),
    "coupling": (0.5, MEDIAL), "preconditioner": ("medial", SHORT), "max_displacement": (0.1, SHORT),
    "time_step": (0.05, SHORT)}
THICK = {"thickness": 0.2}
FILLING = {
    "thickness": (0.3, {}), "direction_field": (UPWARDS, THICK),
    "direction_weight": (2, {"direction_field": (0, 0, 1)} | THICK), "length": (8, {}),
    "wall_distance": (0.1, THICK), "ports": ([(0.5, 0.5, 0), (0.5, 0.5, 1)], THICK),
    "volume_shares": ([1, 3], {"curves": [0.5 + 0.1 * circle(), 0.5 + 0.2 * circle()]} | THICK),
    "start": ("circle", THICK), "bend_radius": (0.25, THICK), "strand_distance": (0.5, THICK),
    "round_bends": (False, THICK), "number_of_iterations": (3, THICK), "time_limit": (0, THICK),
    "random_seed": (5, THICK), "number_of_directions": (4, THICK), "max_radius": (3, THICK),
    "spacing": (0.5, THICK), "screening": (3, THICK), "medial_weight": (5, THICK),
    "coupling": (0.5, THICK), "preconditioner": ("h1", THICK), "wall": ("keep clear", THICK),
    "max_displacement": (0.1, THICK), "time_step": (0.05, THICK)}


def points_of(result):
    """The bits of a result."""
    return np.concatenate(result.curves if isinstance(result.curves, list) else [result.curves]).tobytes()


def upright_share(curves):
    """The share of the length along z, squared."""
    edges = np.concatenate([np.roll(curve, -1, axis=0) - curve for curve in curves])
    lengths = np.linalg.norm(edges, axis=1)
    return np.sum(edges[:, 2]**2 / lengths) / np.sum(lengths)


class Every_option(unittest.TestCase):
    def check(self, function, argument, values):
        self.assertEqual(set(values), set(_options.DEFAULTS[function.__name__]) - {"stop_at_proof"})
        for name, (value, others) in values.items():
            with self.subTest(name):
                given = function(argument, **{**others, name: value})
                self.assertTrue(points_of(given) != points_of(function(argument, **others)))

    def test_of_untangle_changes_the_result(self):
        knot = vfc.closed_braid([1, -2] * 4, 100, random_seed=1)
        self.check(vfc.untangle, knot, UNTANGLING)

    def test_of_fill_changes_the_result(self):
        self.check(vfc.fill, CUBE, FILLING)

    def test_of_simplify_changes_the_result(self):
        self.check(vfc.simplify, TREFOIL, {"clearance": (0.5, {}), "max_distance": (0.05, {})})


class Simplification(unittest.TestCase):
    def test_the_clearance_is_kept(self):
        clearances = [vfc.measure(vfc.simplify(TREFOIL, clearance=distance).curves).min_clearance
                      for distance in (0, 0.5)]
        self.assertLess(clearances[0], 0.5)
        self.assertGreaterEqual(clearances[1], 0.5)

    def test_the_distance_from_the_input_is_kept(self):
        coarse = vfc.simplify(circle(100), max_distance=0.01).curves
        middles = (coarse + np.roll(coarse, 1, axis=0)) / 2
        self.assertLess(1 - np.linalg.norm(middles, axis=1).min(), 0.01)
        self.assertTrue(3 < len(coarse) < 50)


class Untangling(unittest.TestCase):
    def test_limits_of_the_shape_are_kept(self):
        loose = vfc.untangle(TREFOIL, thickness=0.3)
        bent = vfc.untangle(TREFOIL, thickness=0.3, bend_radius=0.4)
        apart = vfc.untangle(TREFOIL, thickness=0.3, strand_distance=0.4)
        self.assertLess(vfc.measure(loose.curves).min_bend_radius, 0.3)
        self.assertGreaterEqual(vfc.measure(bent.curves).min_bend_radius, 0.4)
        self.assertLess(vfc.measure(loose.curves, thickness=0.3).min_clearance, 0.4)
        self.assertGreaterEqual(vfc.measure(apart.curves, thickness=0.4).min_clearance, 0.4)
        self.assertEqual((bent.status, apart.status), ("converged", "converged"))

    def test_a_proved_unknot_can_become_round(self):
        knot = vfc.hard_unknot(60, random_seed=3)
        self.assertEqual([vfc.untangle(knot, strategy="flow", stop_at_proof=stops).is_round
                          for stops in (True, False)], [False, True])

    def test_the_length_is_kept(self):
        before, after = (vfc.length(curve) for curve in (
            TREFOIL, vfc.untangle(TREFOIL, keep_length=True).curves))
        self.assertAlmostEqual(after / before, 1)
        self.assertLess(vfc.length(vfc.untangle(TREFOIL).curves), before / 2)

    def test_a_limit_that_cannot_be_reached_is_a_status(self):
        result = vfc.untangle(TREFOIL, bend_radius=1, number_of_iterations=1)
        self.assertEqual(result.status, "limit")
        self.assertTrue(all(excess.value < excess.limit for excess in result.shape_excesses))


class Filling(unittest.TestCase):
    def filling(self, **options):
        return vfc.fill(CUBE, thickness=0.2, **options)

    def test_the_length_is_reached(self):
        result = vfc.fill(CUBE, length=10)
        self.assertEqual(result.status, "converged")
        self.assertAlmostEqual(vfc.length(result.curves), 10, delta=0.2)

    def test_the_wall_is_kept_clear(self):
        self.assertLess(self.filling().min_wall_distance, 0.1)
        self.assertGreater(self.filling(wall="keep clear").min_wall_distance, 0.2)
        self.assertGreaterEqual(self.filling(wall_distance=0.1).min_wall_distance, 0.1)

    def test_bends_and_strands_keep_their_limits(self):
        self.assertLess(self.filling().min_bend_radius, 0.2)
        self.assertGreaterEqual(self.filling(bend_radius=0.25).min_bend_radius, 0.25)
        self.assertLess(self.filling().min_strand_distance, 0.4)
        self.assertGreaterEqual(self.filling(strand_distance=0.5).min_strand_distance, 0.5)

    def test_the_curve_follows_a_direction_at_each_vertex(self):
        plain, upright = self.filling(), self.filling(direction_field=UPWARDS)
        self.assertGreater(upright_share(upright.curves), upright_share(plain.curves) + 0.1)
        self.assertEqual(points_of(upright), points_of(self.filling(direction_field=(0, 0, 1))))

    def test_it_begins_with_given_curves_and_has_their_form(self):
        ring = 0.5 + 0.2 * circle()
        result = self.filling(curves=ring, certificate=True)
        self.assertIsInstance(result.curves, np.ndarray)
        self.assertEqual((result.closed, result.start), ([True], []))
        self.assertTrue(vfc.verify(result.certificate, ring, result.curves, domain=CUBE))
        arc = [[0.3, 0.5, 0.5], [0.5, 0.5, 0.5], [0.7, 0.5, 0.5]]
        self.assertEqual(self.filling(curves=[ring + [0, 0, 0.2], arc], closed=[True, False]).closed,
                         [True, False])

    def test_pinned_points_stay(self):
        ring = 0.5 + 0.2 * circle()
        result = self.filling(curves=ring, pin=[0, 8])
        for point in ring[[0, 8]]:
            self.assertIn(point.tolist(), result.curves.tolist())

    def test_it_can_start_from_a_circle(self):
        steps = [self.filling(start=start, number_of_iterations=1) for start in ("tree", "circle")]
        self.assertGreater(vfc.length(steps[0].curves), 2 * vfc.length(steps[1].curves))


class Identification(unittest.TestCase):
    def test_of_knots(self):
        for word, name, chirality, homfly, jones in [
                ([1, 1, 1], "3_1", "chiral", "2 v^2 + v^2 z^2 - v^4", "t + t^3 - t^4"),
                ([-1] * 3, "3_1*", "chiral", "-v^-4 + 2 v^-2 + v^-2 z^2", "-t^-4 + t^-3 + t^-1"),
                ([1, -2] * 2, "4_1", "amphichiral", "v^-2 - 1 - z^2 + v^2",
                 "t^-2 - t^-1 + 1 - t + t^2")]:
            found = vfc.identify(vfc.closed_braid(word))
            self.assertEqual((found.name, found.chirality, found.homfly_polynomial,
                              found.jones_polynomial, found.is_proved), (name, chirality, homfly, jones, True))

    def test_a_diagram_names_each_arc_twice(self):
        diagram = vfc.identify(vfc.closed_braid([1, -2] * 2)).diagram
        arcs = sorted(arc for crossing in diagram.crossings for arc in crossing)
        self.assertEqual(arcs, sorted(2 * list(range(8))))

    def test_what_is_proved_of_links(self):
        for curves, words in [(vfc.torus_knot(2, 4), "linked by linking number"),
                              (circle(), "unknotted")]:
            self.assertEqual(vfc.identify(curves).knottedness, words)
        self.assertEqual(vfc.identify([circle(), circle(at=(5, 0, 0))]).name, "unlink of 2 components")


class Generators(unittest.TestCase):
    def test_a_torus_link_has_as_many_curves_as_the_common_divisor(self):
        self.assertEqual([len(vfc.torus_knot(p, q)) for p, q in [(2, 4), (3, 3), (4, 6)]], [2, 3, 2])
        self.assertEqual(vfc.torus_knot(2, 3, 50).shape, (50, 3))

    def test_a_braid_closes_to_the_knot_of_its_word(self):
        self.assertEqual(vfc.identify(vfc.closed_braid([1] * 5)).name, "5_1")
        self.assertEqual(len(vfc.closed_braid([1, 1])), 2)

    def test_a_hard_unknot_is_an_unknot(self):
        self.assertEqual(vfc.identify(vfc.hard_unknot(60, random_seed=1)).name, "0_1")

    def test_a_random_polygon_has_edges_of_length_1(self):
        polygon = vfc.random_polygon(50, random_seed=2)
        edges = np.linalg.norm(polygon - np.roll(polygon, 1, axis=0), axis=1)
        self.assertTrue(np.allclose(edges, 1))
        self.assertFalse(np.array_equal(polygon, vfc.random_polygon(50, random_seed=3)))


if __name__ == "__main__":
    unittest.main()
