# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of the Python module: python3 -m unittest, with the built package on the path."""

import concurrent.futures
import pathlib
import unittest
import weakref

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
        with self.assertRaisesRegex(ValueError, "'fast' is none of flow, search, auto"):
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


class Filling(unittest.TestCase):
    def test_a_cube_is_filled(self):
        result = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1, certificate=True)
        self.assertEqual(result.status, "converged")
        self.assertGreater(result.coverage.fraction_within_r, 0.7)
        self.assertEqual(vfc.outside(result.curves, vfc.Mesh(CUBE_VERTICES, CUBE_FACES)), ([], []))
        self.assertTrue(vfc.verify(result.certificate, result.start, result.curves))

    def test_each_kind_of_domain_is_filled_and_the_record_proves_that_it_was_not_left(self):
        sphere = vfc.Implicit(lambda p: np.linalg.norm(p) - 1, (-1, -1, -1), (1, 1, 1))
        for domain, thickness in [(vfc.Mesh(CUBE_VERTICES, CUBE_FACES), 0.2),
                                  (vfc.Box((0, 0, 0), (1, 1, 2)), 0.3),
                                  (vfc.Ball((0, 0, 5), 1), 0.3), (sphere, 0.4),
                                  (vfc.Polygons([SQUARE, 0.4 + 0.2 * SQUARE], SQUARE + 2), 0.1)]:
            result = vfc.fill(domain, thickness=thickness, certificate=True)
            self.assertIn(result.status, ("converged", "partial"), domain)
            self.assertGreater(result.coverage.fraction_within_r, 0.6, domain)
            self.assertEqual(vfc.outside(result.curves, domain), ([], []))
            verdict = vfc.verify(result.certificate, result.start, result.curves, domain=domain)
            self.assertTrue(verdict, verdict.message)
            self.assertTrue(verdict.has_domain)
            measured = vfc.coverage(result.curves, domain, result.thickness)
            self.assertAlmostEqual(measured.p50, result.coverage.p50, delta=0.05)

    def test_polygons_are_filled_in_their_plane_and_each_gets_a_curve(self):
        result = vfc.fill(vfc.Polygons(SQUARE, SQUARE + 2), thickness=0.1)
        self.assertEqual([np.abs(curve[:, 2]).max() for curve in result.curves], [0, 0])

    def test_parts_of_an_implicit_domain_get_a_curve_each(self):
        def two_balls(p):
            return min(np.linalg.norm(p), np.linalg.norm(p - [3, 0, 0])) - 1
        result = vfc.fill(vfc.Implicit(two_balls, (-1, -1, -1), (4, 1, 1)), thickness=0.5)
        self.assertEqual(len(result.curves), 2)

    def test_a_record_that_leaves_a_domain_is_rejected(self):
        knot = vfc.hard_unknot(random_seed=3)
        record = vfc.untangle(knot, certificate=True)
        self.assertTrue(vfc.verify(record.certificate, knot, record.curves))
        self.assertFalse(vfc.verify(record.certificate, knot, record.curves,
                                    domain=vfc.Box((-1, -1, -1), (1, 1, 0.01))))

    def test_fields_of_domains_without_vertices_are_functions(self):
        result = vfc.fill(vfc.Ball((0, 0, 0), 1), thickness=lambda p: 0.3 + 0.1 * p[2],
                          direction_field=lambda p: (0, 0, 1), round_bends=False)
        self.assertEqual(result.status, "converged")
        with self.assertRaisesRegex(ValueError, "the domain is no mesh"):
            vfc.fill(vfc.Ball((0, 0, 0), 1), thickness=[1, 2, 3])

    def test_fields_of_a_wrong_shape_are_refused(self):
        cube = vfc.Mesh(CUBE_VERTICES, CUBE_FACES)
        for call in (lambda r: vfc.fill(cube, thickness=r), lambda r: vfc.coverage(circle(), cube, r)):
            with self.assertRaisesRegex(ValueError, r"thickness must have the shape \(n,\)"):
                call(CUBE_VERTICES)
            with self.assertRaisesRegex(ValueError, "thickness: the array does not hold numbers"):
                call(["thin"] * len(CUBE_VERTICES))

    def test_one_direction_is_a_vector(self):
        def coordinates(direction):
            return np.concatenate(vfc.fill(vfc.Box((0, 0, 0), (1, 1, 1)), thickness=0.2,
                                           direction_field=direction).curves)
        self.assertTrue(np.array_equal(coordinates((0, 0, 1)), coordinates(lambda p: (0, 0, 1))))

    def test_arrays_of_a_wrong_shape_or_type_are_value_errors(self):
        for options, message in [({"thickness": [0.1]}, ""), ({"thickness": ["a"] * 8}, "numbers"),
                                 ({"direction_field": np.ones((8, 2))}, r"\(n, 3\)"),
                                 ({"direction_field": (0, 1)}, "three coordinates")]:
            with self.assertRaisesRegex(ValueError, message):
                vfc.fill(CUBE_VERTICES, CUBE_FACES, **options)

    def test_coverage_takes_the_thickness_of_the_filling(self):
        cube = vfc.Mesh(CUBE_VERTICES, CUBE_FACES)
        thickness = 0.1 + 0.05 * CUBE_VERTICES[:, 2]
        result = vfc.fill(cube, thickness=thickness)
        measured = vfc.coverage(result.curves, cube, thickness)
        self.assertAlmostEqual(measured.p50, result.coverage.p50, delta=0.05)
        halved = vfc.coverage(result.curves, cube, lambda p: 0.05 + 0.025 * p[2])
        self.assertGreater(halved.p50, 1.5 * measured.p50)

    def test_fillings_in_threads_give_the_bits_of_fillings_in_turn(self):
        def filling(seed):
            return np.concatenate(vfc.fill(vfc.Box((0, 0, 0), (1, 1, 1)), thickness=0.2,
                                           random_seed=seed).curves)
        in_turn = [filling(seed) for seed in range(4)]
        with concurrent.futures.ThreadPoolExecutor(4) as pool:
            self.assertTrue(all(map(np.array_equal, in_turn, pool.map(filling, range(4)))))

    def test_a_function_is_let_go_with_its_domain(self):
        def inside(p):
            return np.linalg.norm(p) - 1
        domain, function = vfc.Implicit(inside, (-1, -1, -1), (1, 1, 1)), weakref.ref(inside)
        vfc.coverage(circle(radius=0.5), domain, 0.1, samples=100)
        del inside, domain
        self.assertIsNone(function())

    def test_an_exception_of_a_domain_comes_out(self):
        def fail(p):
            raise ZeroDivisionError("of the domain")
        with self.assertRaisesRegex(ZeroDivisionError, "of the domain"):
            vfc.fill(vfc.Implicit(fail, (0, 0, 0), (1, 1, 1)), thickness=0.2)

    def test_what_is_wrong_with_a_domain_is_a_value_error(self):
        for make, message in [(lambda: vfc.Ball((0, 0, 0), -1), "positive"),
                              (lambda: vfc.Box((0, 0, 0), (1, 1, 0)), "flat"),
                              (lambda: vfc.Box((0, 0), (1, 1)), "three coordinates"),
                              (lambda: vfc.Polygons([SQUARE, SQUARE + 2]), "hole"),
                              (lambda: vfc.Polygons(np.zeros((4, 3))), r"\(n, 2\)")]:
            with self.assertRaisesRegex(ValueError, message):
                make()
        with self.assertRaisesRegex(TypeError, "a Domain"):
            vfc.fill(CUBE_VERTICES, thickness=0.1)
        with self.assertRaisesRegex(TypeError, "is a tuple, but must be a Domain"):
            vfc.coverage(circle(), (CUBE_VERTICES, CUBE_FACES), 0.1)

    def test_the_thickness_can_vary(self):
        by_function = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=lambda p: 0.1 + 0.05 * p[2])
        by_vertex = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1 + 0.05 * CUBE_VERTICES[:, 2])
        lengths = [vfc.length(result.curves) for result in (by_function, by_vertex)]
        self.assertLess(abs(lengths[0] / lengths[1] - 1), 0.3)

    def test_two_ports_make_an_arc_with_straight_necks(self):
        result = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1, ports=[(0.5, 0.5, 0), (0.5, 0.5, 1, 0, 0, -1)])
        self.assertEqual([neck.is_free for neck in result.necks], [True, True])
        self.assertLess(np.abs(result.curves[0][[0, -1], :2] - 0.5).max(), 1e-12)

    def test_arcs_divide_the_volume_by_their_shares(self):
        ports = [(0.2, 0.5, 0), (0.2, 0.5, 1), (0.8, 0.5, 0), (0.8, 0.5, 1)]
        result = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1, ports=ports, volume_shares=[1, 3], round_bends=False)
        self.assertGreater(len(result.curves[1]), 2 * len(result.curves[0]))

    def test_an_open_mesh_is_a_value_error(self):
        with self.assertRaisesRegex(ValueError, "not closed"):
            vfc.fill(CUBE_VERTICES, CUBE_FACES[1:], thickness=0.1)
        with self.assertRaisesRegex(ValueError, "row 0 has the index 9"):
            vfc.fill(CUBE_VERTICES, [[0, 1, 9]], thickness=0.1)


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
