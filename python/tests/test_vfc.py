# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of the Python module: python3 -m unittest, with the built package on the path."""

import concurrent.futures
import os
import pathlib
import resource
import signal
import tempfile
import threading
import time
import unittest

import numpy as np

import vfc

CUBE_VERTICES = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
CUBE_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
                       [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])


def circle(points=16, at=(0, 0, 0), radius=1.0):
    angle = np.linspace(0, 2 * np.pi, points, endpoint=False)
    return radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle]) + at


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

    def test_a_million_points_go_in_and_out(self):
        points = np.cumsum(np.random.default_rng(0).normal(size=(10**6, 3)), axis=0)
        start = time.process_time()
        core = vfc.curves.to_core(points)
        back = vfc.curves.from_core(core, points)
        print(f"{time.process_time() - start:.2f} s for a million points")
        self.assertTrue(np.array_equal(points, back))

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

    def test_a_wrong_option_is_named(self):
        with self.assertRaisesRegex(TypeError, "thicknes"):
            vfc.untangle(circle(), thicknes=1)
        with self.assertRaisesRegex(TypeError, "tolerance has a value of the type str"):
            vfc.untangle(circle(), tolerance="small")
        with self.assertRaisesRegex(ValueError, "time_limit is -1, but must not be negative"):
            vfc.untangle(circle(), time_limit=-1)
        with self.assertRaisesRegex(ValueError, "number_of_iterations is -1"):
            vfc.untangle(circle(), number_of_iterations=-1)

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

    def test_memory_stays_constant(self):
        knot = vfc.torus_knot(2, 3, 100)
        sizes = []
        for _ in range(100):
            vfc.untangle(knot, certificate=True, number_of_iterations=3)
            sizes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
        self.assertLess(sizes[-1] - sizes[20], 4096)  # KiB


class Interruption(unittest.TestCase):
    def setUp(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in a background job

    def interrupted_after(self, call, seconds=0.3):
        """How long it took from Ctrl-C until the call ended, in seconds."""
        sent = []

        def send():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)
        timer = threading.Timer(seconds, send)
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                call()
                time.sleep(5)
        finally:
            timer.cancel()
        return time.monotonic() - sent[0]

    def test_ctrl_c_ends_every_long_call(self):
        polygon = vfc.random_polygon(20000)
        tangle = vfc.random_polygon(4000)
        record = vfc.simplify(polygon, certificate=True)
        domain = vfc.Domain(CUBE_VERTICES, CUBE_FACES)
        for call in [lambda: vfc.untangle(tangle), lambda: vfc.untangle(tangle, strategy="flow"),
                     lambda: vfc.simplify(polygon), lambda: vfc.measure(polygon),
                     lambda: vfc.verify(record.certificate, polygon, record.curves),
                     lambda: vfc.fill(domain, thickness=0.01)]:
            self.assertLess(self.interrupted_after(call, 0.1), 2)  # on a busy machine


class Filling(unittest.TestCase):
    def test_a_cube_is_filled(self):
        result = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1, certificate=True)
        self.assertEqual(result.status, "converged")
        self.assertGreater(result.coverage.fraction_within_r, 0.7)
        self.assertEqual(vfc.outside(result.curves, vfc.Domain(CUBE_VERTICES, CUBE_FACES)), ([], []))
        self.assertTrue(vfc.verify(result.certificate, result.start, result.curves).is_valid)

    def test_the_thickness_can_vary(self):
        by_function = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=lambda p: 0.1 + 0.05 * p[2])
        by_vertex = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1 + 0.05 * CUBE_VERTICES[:, 2])
        lengths = [vfc.length(result.curves) for result in (by_function, by_vertex)]
        self.assertLess(abs(lengths[0] / lengths[1] - 1), 0.3)

    def test_two_ports_make_an_arc_with_straight_necks(self):
        result = vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=0.1, ports=[(0.5, 0.5, 0), (0.5, 0.5, 1, 0, 0, -1)])
        self.assertEqual([neck.is_free for neck in result.necks], [True, True])
        self.assertLess(np.abs(result.curves[0][[0, -1], :2] - 0.5).max(), 1e-12)

    def test_an_open_mesh_is_a_value_error(self):
        with self.assertRaisesRegex(ValueError, "not closed"):
            vfc.fill(CUBE_VERTICES, CUBE_FACES[1:], thickness=0.1)
        with self.assertRaisesRegex(ValueError, "row 0 has the index 9"):
            vfc.fill(CUBE_VERTICES, [[0, 1, 9]], thickness=0.1)


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

    def test_a_tube_is_a_closed_mesh(self):
        vertices, faces = vfc.tube(circle(), 0.1, sides=6)
        self.assertEqual((vertices.shape, faces.shape), ((96, 3), (192, 3)))
        vfc.Domain(vertices, faces)


class Files(unittest.TestCase):
    def test_files_are_read_without_loss(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "curves.obj"
            arc = [[0, 0, 3], [0.1, 0, 4]]
            vfc.write(file, [circle(), arc], closed=[True, False])
            curves, closed = vfc.read(file)
            self.assertEqual(closed, [True, False])
            self.assertTrue(np.array_equal(curves[0], circle()) and np.array_equal(curves[1], arc))
            file.write_text("v 1 2 x\n")
            with self.assertRaisesRegex(ValueError, "curves.obj:1: error: unparsable number"):
                vfc.read(file)


class Documentation(unittest.TestCase):
    def test_every_function_describes_its_options(self):
        for function in (vfc.untangle, vfc.fill, vfc.simplify):
            self.assertIn("progress : function", function.__doc__)
        self.assertIn("lower_ropelength : bool, default", vfc.untangle.__doc__)
        self.assertIn("unfilled_fraction:", vfc.Filled.__doc__)


if __name__ == "__main__":
    unittest.main()
