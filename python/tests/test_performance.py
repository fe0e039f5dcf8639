# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of times and memory, with limits that a busy machine keeps."""

import pathlib
import resource
import tempfile
import time
import unittest

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, circle

import vfc


def growth_of_memory(call, warm_up=20, calls=100):
    """By how many KiB the memory grows from the end of the warm-up to the last call."""
    sizes = []
    for _ in range(calls):
        call()
        pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])  # present, not the most
        sizes.append(pages * resource.getpagesize() // 1024)
    return sizes[-1] - sizes[warm_up]


def seconds(call, repetitions):
    """The time of a processor for a call, the least of five measurements."""
    def measured():
        start = time.process_time()
        for _ in range(repetitions):
            call()
        return (time.process_time() - start) / repetitions
    return min(measured() for _ in range(5))


class Times(unittest.TestCase):
    def test_a_million_points_go_in_and_out_in_less_than_a_second(self):
        points = np.cumsum(np.random.default_rng(0).normal(size=(10**6, 3)), axis=0)
        back = []

        def go_in_and_out():
            back[:] = [vfc.curves.from_core(vfc.curves.to_core(points), points)]
        self.assertLess(seconds(go_in_and_out, 1), 1)  # 0.2 s alone
        self.assertTrue(np.array_equal(points, back[0]))

    def test_a_call_with_ten_points_takes_microseconds(self):
        ten = circle(10)
        self.assertLess(seconds(lambda: vfc.length(ten), 1000), 2e-4)  # 2e-5 s alone


class Memory(unittest.TestCase):
    """What is lost in a call would grow by megabytes: 100,000 points take 2.4 MB."""

    def check(self, call, **counts):
        self.assertLess(growth_of_memory(call, **counts), 4096)

    def test_it_stays_constant_while_curves_are_untangled(self):
        knot = vfc.torus_knot(2, 3, 3000)  # of 72 kB, with a record of more
        self.check(lambda: vfc.untangle(knot, strategy="flow", certificate=True, number_of_iterations=1))

    def test_it_stays_constant_while_a_mesh_is_filled(self):
        def thickness(p):
            return 0.5 + 0.05 * p[2]
        self.check(lambda: vfc.fill(CUBE_VERTICES, CUBE_FACES, thickness=thickness,
                                    certificate=True, number_of_iterations=3), calls=60)

    def test_it_stays_constant_with_long_curves(self):
        large = circle(100000)
        record = vfc.simplify(large, certificate=True)
        vertices, faces = vfc.tube(circle(300), 1e-3)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "large.obj"
            vfc.write(file, large)
            for call in [lambda: vfc.identify(large), lambda: vfc.tube(large, 1e-6, sides=3),
                         lambda: vfc.verify(record.certificate, large, record.curves),
                         lambda: vfc.read(file), lambda: vfc.repair(vertices, faces)]:
                self.check(call, warm_up=2, calls=6)


if __name__ == "__main__":
    unittest.main()
