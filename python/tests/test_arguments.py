# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of arguments: which arrays are taken, and what is said of wrong ones."""

import importlib.util
import inspect
import unittest

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, SQUARE, circle

import vfc

BALL = vfc.Ball((0, 0, 0), 2)


class Wrong_arguments(unittest.TestCase):
    def check(self, error, calls):
        """Each call raises an error whose message has the name of the argument."""
        for name, call in calls:
            with self.subTest(inspect.getsource(call).strip()):
                with self.assertRaisesRegex(error, name) as raised:
                    call()
                self.assertNotIn("incompatible function arguments", str(raised.exception))

    def test_a_value_of_a_wrong_type_is_a_type_error_with_the_name(self):
        self.check(TypeError, [
            ("p is 2.5", lambda: vfc.torus_knot(2.5, 3)),
            ("points is 100.0", lambda: vfc.torus_knot(2, 3, points=100.0)),
            ("points is None", lambda: vfc.random_polygon(None)),
            ("moves is 'many'", lambda: vfc.hard_unknot(moves="many")),
            ("random_seed is 1.5", lambda: vfc.closed_braid([1, 1], random_seed=1.5)),
            ("a letter of the word is 'a'", lambda: vfc.closed_braid("aB")),
            ("thickness is 'a'", lambda: vfc.measure(circle(), thickness="a")),
            ("thickness is neither", lambda: vfc.coverage(circle(), BALL, "thin")),
            ("samples is 1000.0", lambda: vfc.coverage(circle(), BALL, 0.1, samples=1e3)),
            ("radius is None", lambda: vfc.tube(circle(), None)),
            ("sides is '6'", lambda: vfc.tube(circle(), 0.1, sides="6")),
            ("alpha is \\[1\\]", lambda: vfc.repair(CUBE_VERTICES, CUBE_FACES, alpha=[1])),
            ("radius is '1'", lambda: vfc.Ball((0, 0, 0), "1")),
            ("center must hold numbers", lambda: vfc.Ball("abc", 1)),
            ("low must hold numbers", lambda: vfc.Box(None, (1, 1, 1))),
            ("a polygon is 3", lambda: vfc.Polygons(3)),
            ("a polygon is \\[\\]", lambda: vfc.Polygons([])),
            ("function is 3", lambda: vfc.Implicit(3, (0, 0, 0), (1, 1, 1))),
            ("lipschitz_bound", lambda: vfc.Implicit(max, (0, 0, 0), (1, 1, 1), lipschitz_bound="1")),
            ("wall_distance is 'a'", lambda: vfc.check_curves(circle(), wall_distance="a")),
            ("the domain is a NoneType", lambda: vfc.outside(circle(), None)),
            ("the domain is a NoneType", lambda: vfc.wall_distance(circle(), None)),
            ("the domain is a NoneType", lambda: vfc.coverage(circle(), None, 0.1)),
            ("a curve must hold numbers", lambda: vfc.length(circle().astype(str))),
            ("a curve must hold numbers", lambda: vfc.length(circle() + 0j)),
            ("vertices must hold numbers", lambda: vfc.check_mesh([["a"] * 3], CUBE_FACES)),
            ("the curves are None", lambda: vfc.length(None)),
            ("the curves are 5", lambda: vfc.length(5)),
            ("pass its member curves", lambda: vfc.length(vfc.simplify(circle()))),
            ("function returned None at .*must return a number",
             lambda: vfc.fill(vfc.Implicit(lambda p: None, (0, 0, 0), (1, 1, 1)), thickness=0.2)),
            ("closed is 'no'", lambda: vfc.length(circle(), closed="no")),
            ("certificate is None", lambda: vfc.verify(None, circle(), circle())),
            ("progress is 5", lambda: vfc.measure(circle(), progress=5)),
            ("progress is 5", lambda: vfc.check_mesh(CUBE_VERTICES, CUBE_FACES, progress=5)),
            ("number_of_iterations has a value of the type float",
             lambda: vfc.untangle(circle(), number_of_iterations=5.0)),
            ("closed and pin are about curves", lambda: vfc.fill(BALL, pin="ends")),
            ("closed and pin are about curves", lambda: vfc.fill(BALL, closed=False))])

    def test_a_value_out_of_its_range_is_a_value_error_with_the_name(self):
        self.check(ValueError, [
            ("points is -5, but must not be negative", lambda: vfc.random_polygon(-5)),
            ("moves is -1", lambda: vfc.hard_unknot(moves=-1)),
            ("random_seed is -1", lambda: vfc.torus_knot(2, 3, random_seed=-1)),
            ("p is 10+, but must be at most", lambda: vfc.torus_knot(10**20, 3)),
            ("samples is -1", lambda: vfc.coverage(circle(), BALL, 0.1, samples=-1)),
            ("thickness is -1.0, but must not", lambda: vfc.measure(circle(), thickness=-1)),
            ("thickness is nan, but must not", lambda: vfc.measure(circle(), thickness=np.nan)),
            ("sides is -1", lambda: vfc.tube(circle(), 0.1, sides=-1)),
            ("pin: there is no point -1", lambda: vfc.untangle(circle(), pin=[-1])),
            ("pin: there is no point 16", lambda: vfc.untangle(circle(), pin=[16])),
            ("pin is 18446744073709551615, but", lambda: vfc.untangle(circle(), pin=[2**64 - 1])),
            ("faces is 18446744073709551615, but",
             lambda: vfc.Mesh(CUBE_VERTICES, CUBE_FACES.astype(np.uint64) - np.uint64(1))),
            ("pin has the shape", lambda: vfc.untangle(circle(), pin=3)),
            ("center .*three coordinates", lambda: vfc.Ball((0, 0), 1)),
            ("radius is 1.*too large", lambda: vfc.Ball((0, 0, 0), 10**400)),
            ("a curve has masked values", lambda: vfc.length(np.ma.masked_greater(circle(), 0.99))),
            ("thickness has masked values",
             lambda: vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=np.ma.masked_less([0.2, 0.3], 0.25))),
            ("closed has the shape", lambda: vfc.length(circle(), closed=[[True]])),
            ("letter 0 of the braid", lambda: vfc.closed_braid([1, 0])),
            ("low has a coordinate that is not finite", lambda: vfc.Box((np.nan, 0, 0), (1, 1, 1))),
            ("high has .* not finite", lambda: vfc.Implicit(max, (0, 0, 0), (1, np.nan, 1))),
            ("sides is 1025, but must be at most 1024", lambda: vfc.tube(circle(), 0.1, sides=1025)),
            ("sides is 2, but must be at least 3", lambda: vfc.tube(circle(), 0.1, sides=2)),
            ("null character", lambda: vfc.write("cut\0.obj", circle())),
            ("a curve has rows of different lengths", lambda: vfc.length([[0, 0, 0], [1, 0]])),
            ("random_seed is -1", lambda: vfc.untangle(circle(), random_seed=-1)),
            ("random_seed is 1.*less than 2", lambda: vfc.untangle(circle(), random_seed=2**64)),
            ("number_of_iterations is -1, but must not be negative",
             lambda: vfc.untangle(circle(), number_of_iterations=np.int64(-1))),
            ("closures is -1", lambda: vfc.identify_chain(circle(), closures=np.int32(-1)))])

    def test_indices_that_are_no_integers_are_refused(self):
        network = vfc.Network(circle()[:2], [[0.0, 1.0]])
        for wrong in (CUBE_FACES + 0.5, CUBE_FACES.astype(float), CUBE_FACES * np.nan):
            self.check(TypeError, [("faces must hold integers", lambda: vfc.Mesh(CUBE_VERTICES, wrong)),
                                   ("faces must hold", lambda: vfc.check_mesh(CUBE_VERTICES, wrong)),
                                   ("faces must hold", lambda: vfc.repair(CUBE_VERTICES, wrong))])
        self.check(TypeError, [("edges must hold integers", lambda: vfc.length(network)),
                               ("pin must hold", lambda: vfc.untangle(circle(), pin=[0.0])),
                               ("pin must hold", lambda: vfc.untangle(circle(), pin=[True] * 16))])

    def test_numpy_integers_are_integers(self):
        points = vfc.torus_knot(np.int8(2), np.uint16(3), np.int64(60), random_seed=np.uint64(7))
        self.assertTrue(np.array_equal(points, vfc.torus_knot(2, 3, 60, random_seed=7)))
        self.assertEqual(vfc.untangle(vfc.torus_knot(2, 3), number_of_iterations=np.uint8(2),
                                      strategy="flow").status, "limit")


class Arrays(unittest.TestCase):
    """Arrays of each type and order in memory give the same bits."""

    def test_points(self):
        knot = vfc.torus_knot(2, 3, 60).astype(np.float32).astype(float)
        wide = np.zeros((120, 6))
        wide[::2, ::2] = knot
        for same in (knot.astype(np.float32), np.asfortranarray(knot), wide[::2, ::2], knot.tolist(),
                     knot[::-1][::-1], list(map(tuple, knot)), knot.astype(">f8"), knot.astype(object)
                     .astype(np.longdouble)):
            self.assertTrue(np.array_equal(vfc.simplify(same).curves, vfc.simplify(knot).curves))
        matrix = vfc.simplify(np.asmatrix(knot)).curves
        self.assertTrue(np.array_equal(matrix, vfc.simplify(knot).curves))
        self.assertEqual(repr(vfc.Polygons(np.asmatrix(SQUARE))), repr(vfc.Polygons(SQUARE)))
        self.assertAlmostEqual(vfc.length(4 * SQUARE.astype(int) @ np.eye(2, 3, dtype=int)), 16)

    def test_points_that_memory_does_not_hold(self):
        with self.assertRaises(MemoryError):
            vfc.length(np.broadcast_to(np.zeros(3), (2**50, 3)))

    def test_faces(self):
        wide = np.zeros((24, 6), int)
        wide[::2, ::2] = CUBE_FACES
        expected = vfc.repair(CUBE_VERTICES, CUBE_FACES).faces
        for dtype in ("i1", "u1", "i4", "u4", "i8", "u8", ">i4"):
            same = vfc.repair(CUBE_VERTICES, CUBE_FACES.astype(dtype)).faces
            self.assertTrue(np.array_equal(same, expected), dtype)
        for faces in (np.asfortranarray(CUBE_FACES), wide[::2, ::2], CUBE_FACES.tolist()):
            self.assertTrue(np.array_equal(vfc.repair(CUBE_VERTICES, faces).faces, expected))

    def test_the_input_is_not_changed(self):
        knot = vfc.torus_knot(2, 3, 60)
        copy = knot.copy()
        vfc.untangle(knot)
        self.assertTrue(np.array_equal(knot, copy))

    @unittest.skipUnless(importlib.util.find_spec("meshio"), "meshio is absent")
    def test_a_mesh_of_meshio(self):
        import meshio
        mesh = meshio.Mesh(CUBE_VERTICES, [("triangle", CUBE_FACES)])
        self.assertEqual(vfc.check_mesh(mesh.points, mesh.cells_dict["triangle"]), [])

    @unittest.skipUnless(importlib.util.find_spec("trimesh"), "trimesh is absent")
    def test_a_mesh_of_trimesh(self):
        import trimesh
        mesh = trimesh.Trimesh(CUBE_VERTICES, CUBE_FACES)
        self.assertEqual(vfc.check_mesh(mesh.vertices, mesh.faces), [])


class Indices(unittest.TestCase):
    """They count over the points of all curves as they are given, repeated first points included."""

    def setUp(self):
        first = np.vstack([circle(), circle()[:1]])  # 17 points
        self.rings = [first, circle(at=(5, 0, 0))]
        self.points = np.vstack(self.rings)

    def test_origins(self):
        result = vfc.simplify(self.rings)
        for origin, curve in zip(result.origin, result.curves):
            self.assertTrue(np.array_equal(self.points[origin], curve))
        self.assertGreaterEqual(result.origin[1].min(), 17)

    def test_points_outside(self):
        ball = vfc.Ball((0, 0, 0), 2)
        self.assertEqual(vfc.outside(self.rings, ball)[0], list(range(17, 33)))
        self.assertIn([32, 17], vfc.outside(self.rings, ball)[1])

    def test_defects(self):
        self.rings[1] = np.insert(self.rings[1], 4, self.rings[1][4], axis=0)
        found, = vfc.check_curves(self.rings)
        self.assertEqual((found.kind, found.points.tolist()), ("coincident nodes", [21, 22]))
        nearest = vfc.check_curves([self.rings[0], circle(at=(5, 0, 0))], wall_distance=1,
                                   domain=vfc.Box((-9, -9, -9), (6.5, 9, 9)))
        self.assertEqual([17 in defect.points for defect in nearest], [True])

    def test_a_repeated_point_is_no_defect(self):
        self.assertEqual(vfc.check_curves(self.rings), [])

    def test_edges_near_a_wall(self):
        edge = vfc.wall_distance(self.rings, vfc.Box((-9, -9, -9), (6.5, 9, 9))).edge
        self.assertIn(17, edge)

    def test_pins(self):
        result = vfc.simplify(self.rings, pin=[20])
        self.assertIn(20, result.origin[1])
        with self.assertRaisesRegex(ValueError, "repeats the first point"):
            vfc.simplify(self.rings, pin=[16])

    def test_arcs(self):
        nodes = np.concatenate([path.pieces.node for path in vfc.arc_spline(self.rings).paths])
        self.assertEqual(set(nodes), set(range(33)) - {16})


class Nothing(unittest.TestCase):
    def test_a_list_that_changes_during_the_run_keeps_its_form(self):
        curves = [circle(), circle(at=(5, 0, 0))]

        def change(progress):
            curves[:] = [[0.0, 0.0, 0.0]]
        self.assertEqual(len(vfc.simplify(curves, progress=change).curves), 2)

    def test_no_curves_are_an_empty_list(self):
        result = vfc.simplify([])
        self.assertEqual((result.curves, result.origin), ([], []))
        self.assertEqual(vfc.length([]), 0)
        self.assertEqual(vfc.check_curves([]), [])


class Progress(unittest.TestCase):
    def status_if_it_returns(self, answer):
        return vfc.untangle(vfc.torus_knot(2, 3), number_of_iterations=5, strategy="flow",
                            progress=lambda p: answer).status

    def test_only_false_ends_a_run(self):
        for answer in (None, True, 0, 0.0, [], "", np.True_, np.zeros(3), {}):
            self.assertEqual(self.status_if_it_returns(answer), "limit", repr(answer))
        for answer in (False, np.False_):
            self.assertEqual(self.status_if_it_returns(answer), "interrupted", repr(answer))

    def test_only_false_ends_a_repair(self):
        vfc.repair(CUBE_VERTICES, CUBE_FACES[1:], progress=lambda p: 0)
        with self.assertRaises(vfc.Interrupted):
            vfc.repair(CUBE_VERTICES, CUBE_FACES[1:], progress=lambda p: np.False_)


if __name__ == "__main__":
    unittest.main()
