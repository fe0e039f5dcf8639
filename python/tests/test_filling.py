# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of fillings: domains, fields, ports, and what is wrong with them."""

import concurrent.futures
import unittest
import weakref

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, SQUARE, circle

import vfc


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
                                  (vfc.Ball((0, 0, 5), 1), 0.3), (sphere, 0.35),
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
            with self.assertRaisesRegex(ValueError, "thickness has 7 rows, but the mesh has 8 vertices"):
                call([0.1] * 7)
            for wrong in (["thin"] * 8, ["0.1"] * 8, np.full(8, 0.1 + 1j)):
                with self.assertRaisesRegex(TypeError, "thickness must hold numbers, but has the dtype"):
                    call(wrong)

    def test_one_direction_is_a_vector(self):
        def coordinates(direction):
            return np.concatenate(vfc.fill(vfc.Box((0, 0, 0), (1, 1, 1)), thickness=0.2,
                                           direction_field=direction).curves)
        self.assertTrue(np.array_equal(coordinates((0, 0, 1)), coordinates(lambda p: (0, 0, 1))))

    def test_directions_of_a_wrong_shape_are_refused(self):
        for options, message in [({"direction_field": np.ones((8, 2))}, r"\(n, 3\)"),
                                 ({"direction_field": np.ones((7, 3))}, "direction_field has 7 rows"),
                                 ({"direction_field": np.array(1)}, r"\(n, 3\) or \(3,\)"),
                                 ({"direction_field": (0, 1)}, r"direction_field .* or \(3,\)")]:
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


if __name__ == "__main__":
    unittest.main()
