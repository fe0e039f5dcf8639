# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of curves, untangling, chains and measures: python3 -m unittest, with the built package on the
path."""

import concurrent.futures
import pathlib
import unittest

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, SQUARE, circle

import vfc


class Curves(unittest.TestCase):
    def test_an_array_comes_back_as_an_array_and_a_list_as_a_list(self):
        one = vfc.simplify(circle())
        several = vfc.simplify([circle(), circle(at=(5, 0, 0))])
        self.assertIsInstance(one.curves, np.ndarray)
        self.assertEqual([c.shape for c in several.curves], [(3, 3), (3, 3)])

    def test_a_repeated_first_point_changes_nothing(self):
        repeated = np.vstack([circle(), circle()[:1]])
        self.assertTrue(np.array_equal(vfc.simplify(repeated).curves, vfc.simplify(circle()).curves))

    def test_lists_of_lists_are_curves(self):
        self.assertAlmostEqual(vfc.length([[0, 0, 0], [1, 0, 0], [1, 1, 0]], closed=False), 2)

    def test_each_curve_can_be_open_or_closed(self):
        square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
        self.assertAlmostEqual(vfc.length([square, np.add(square, 5)], closed=[True, False]), 7)

    def test_origins_name_the_points_of_the_input(self):
        result = vfc.simplify(circle())
        self.assertTrue(np.array_equal(circle()[result.origin], result.curves))

    def test_a_network_comes_back_as_a_network(self):
        star = vfc.Network([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1], [0, 2], [0, 3]])
        self.assertAlmostEqual(vfc.length(star), 3)
        self.assertIsInstance(vfc.simplify(star, pin="ends").curves, vfc.Network)

    def test_what_is_wrong_with_an_array_is_a_value_error(self):
        for wrong, message in [(np.zeros((4, 2)), r"\(4, 2\)"), (circle() * np.nan, "point 0"),
                               (circle()[:2], "2 points"), (np.zeros((5, 3)), "")]:
            with self.assertRaisesRegex(ValueError, message):
                vfc.untangle(wrong)
        with self.assertRaisesRegex(ValueError, "3 values, but there are 2 curves"):
            vfc.length([circle(), circle()], closed=[True] * 3)


class Untangling(unittest.TestCase):
    def test_an_unknot_is_untangled_and_the_record_verifies(self):
        knot = vfc.hard_unknot(random_seed=3)
        result = vfc.untangle(knot, certificate=True)
        self.assertEqual(result.status, "unknotted")
        verdict = vfc.verify(result.certificate, knot, result.curves)
        self.assertTrue(verdict.is_valid, verdict.message)
        self.assertFalse(vfc.verify(result.certificate, circle(), result.curves).is_valid)

    def test_enumerations_are_words(self):
        trefoil = vfc.torus_knot(2, 3, 100)
        self.assertEqual(vfc.untangle(trefoil, strategy="flow", preconditioner="quasi-newton",
                                      number_of_iterations=2).status, "limit")
        with self.assertRaisesRegex(ValueError, "strategy is 'fast', but must be one of flow, search, auto"):
            vfc.untangle(trefoil, strategy="fast")

    def test_a_verdict_is_true_if_it_is_valid(self):
        self.assertTrue(vfc.Verdict(True, 0, "", 3, False))
        self.assertFalse(vfc.Verdict(False, 2, "a strand is met", 3, False))

    def test_a_wrong_option_is_named(self):
        with self.assertRaisesRegex(TypeError, "thicknes"):
            vfc.untangle(circle(), thicknes=1)
        with self.assertRaisesRegex(TypeError, "tolerance has a value of the type str"):
            vfc.untangle(circle(), tolerance="small")
        with self.assertRaisesRegex(ValueError, "time_limit is -1, but must not be negative"):
            vfc.untangle(circle(), time_limit=-1)
        with self.assertRaisesRegex(ValueError, "number_of_iterations is -1"):
            vfc.untangle(circle(), number_of_iterations=-1)

    def test_the_name_of_a_file_is_no_curve(self):
        for name in ("knot.obj", pathlib.Path("knot.obj")):
            with self.assertRaisesRegex(TypeError, "name 'knot.obj'.*read"):
                vfc.untangle(name)

    def test_progress_is_a_dict_and_can_end_the_run(self):
        seen = []
        result = vfc.untangle(vfc.random_polygon(3000), progress=lambda p: seen.append(p) or False)
        self.assertEqual(result.status, "interrupted")
        self.assertEqual(len(seen), 1)
        self.assertLessEqual({"stage", "fraction", "seconds", "length"}, set(seen[0]))

    def test_an_exception_of_progress_comes_out(self):
        def fail(progress):
            raise KeyError("mine")
        with self.assertRaisesRegex(KeyError, "mine"):
            vfc.untangle(vfc.random_polygon(3000), progress=fail)

    def test_runs_in_threads_give_the_bits_of_runs_in_turn(self):
        knots = [vfc.hard_unknot(random_seed=seed) for seed in range(4)]
        in_turn = [vfc.untangle(knot).curves for knot in knots]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            at_once = [result.curves for result in pool.map(vfc.untangle, knots)]
        self.assertTrue(all(map(np.array_equal, in_turn, at_once)))

    def test_curves_stay_in_a_domain(self):
        ring = circle(32, radius=0.9)
        cavity = 0.25 + 0.5 * CUBE_VERTICES - 0.5
        outer = 4 * CUBE_VERTICES - 2
        domain = vfc.Mesh(np.vstack([outer, cavity]), np.vstack([CUBE_FACES, CUBE_FACES[:, ::-1] + 8]))
        result = vfc.untangle(ring, domain=domain, certificate=True, stop_at_proof=False,
                              thickness=0.1)
        self.assertEqual(vfc.outside(result.curves, domain), ([], []))
        self.assertLess(vfc.length(result.curves), vfc.length(ring))
        self.assertTrue(vfc.verify(result.certificate, ring, result.curves, domain=domain).has_domain)

    def test_a_domain_that_does_not_fit_is_a_value_error(self):
        with self.assertRaisesRegex(ValueError, "inside the domain"):
            vfc.untangle(circle(), domain=vfc.Ball((0, 0, 0), 0.5))
        with self.assertRaisesRegex(ValueError, "not in polygons"):
            vfc.untangle(circle(), domain=vfc.Polygons(SQUARE))


class Chains(unittest.TestCase):
    def setUp(self):
        closed = vfc.torus_knot(2, 3, 60)
        ends = [closed[0] * 10, closed[-2] * 10]  # far outside
        self.chain = np.vstack([ends[0], closed[:-1], ends[1]])

    def test_an_open_knot_has_shares_and_a_core(self):
        found = vfc.identify_chain(self.chain, closures=50, find_core=True)
        self.assertEqual((found.name, found.direct.name), ("3_1", "3_1"))
        self.assertEqual(sum(knot.count for knot in found.knots), 50)
        self.assertGreater(found.knots[0].share, 0.9)
        core, = zip(found.core.first, found.core.last, found.core.name)
        self.assertTrue(0 <= core[0] < core[1] < len(self.chain) and core[2] == "3_1")
        self.assertRegex(repr(found), r"^ChainIdentity\(name='3_1', knots=\[KnotShare\(name='3_1'")

    def test_the_fingerprint_is_arrays(self):
        found = vfc.identify_chain(self.chain, closures=10, stride=20).fingerprint
        self.assertTrue(set(found.first) <= set(range(0, len(self.chain), 20)))
        self.assertEqual(found.name[(found.first == 0) & (found.last == len(self.chain) - 1)], ["3_1"])
        self.assertTrue(np.all(found.share <= 1))

    def test_what_is_wrong_with_a_chain_or_an_option_is_named(self):
        with self.assertRaisesRegex(ValueError, "closures is 0"):
            vfc.identify_chain(self.chain, closures=0)
        with self.assertRaisesRegex(ValueError, r"shape \(n, 3\)"):
            vfc.identify_chain([self.chain, self.chain])
        with self.assertRaisesRegex(TypeError, "core"):
            vfc.identify_chain(self.chain, core=True)


class Measures(unittest.TestCase):
    def test_linked_circles_are_linked(self):
        other = np.array([1.0, 0, 0]) + circle()[:, [0, 2, 1]]
        measures = vfc.measure([circle(), other])
        self.assertEqual(abs(measures.linking_matrix[0][1]), 1)

    def test_knots_have_names(self):
        trefoil = vfc.identify(vfc.torus_knot(2, 3, 100))
        self.assertEqual((trefoil.name, trefoil.is_proved), ("3_1", True))
        self.assertRegex(trefoil.knottedness, "^knotted by ")
        self.assertEqual(len(trefoil.diagram.crossings), 3)

    def test_arcs_are_tangent_to_the_middles_of_edges(self):
        spline = vfc.arc_spline(circle(32), vfc.Ball((0, 0, 0), 1.1))
        pieces = spline.paths[0].pieces
        self.assertTrue(spline.is_certified)
        self.assertEqual(pieces.start.shape, (32, 3))
        self.assertTrue(np.allclose(np.linalg.norm(pieces.start, axis=1), np.cos(np.pi / 32)))
        self.assertTrue(np.allclose(pieces.radius, np.cos(np.pi / 32)))
        self.assertAlmostEqual(spline.length, pieces.length.sum())
        with self.assertRaisesRegex(ValueError, "node 0 is not inside the domain"):
            vfc.arc_spline(circle(), vfc.Ball((0, 0, 0), 0.9))

    def test_an_arc_in_the_way_of_a_strand_is_a_conflict(self):
        corner = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]
        needle = [[0.95, 0.05, -1], [0.95, 0.05, 1]]
        spline = vfc.arc_spline([corner, needle], closed=False)
        self.assertEqual([(c.node, c.obstacle) for c in spline.conflicts], [(1, "strand")])

    def test_a_tube_is_a_closed_mesh(self):
        vertices, faces = vfc.tube(circle(), 0.1, sides=6)
        self.assertEqual((vertices.shape, faces.shape), ((96, 3), (192, 3)))
        vfc.Mesh(vertices, faces)


if __name__ == "__main__":
    unittest.main()
