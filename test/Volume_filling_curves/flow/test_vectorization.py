#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors

"""Flows have the same bits whether Eigen vectorizes or not, so that they depend on no processor."""

import os
import subprocess
import unittest


def lines(program):
    return subprocess.run([os.environ[program]], capture_output=True, check=True, text=True).stdout.splitlines()


class TestVectorization(unittest.TestCase):
    def test_flows_have_the_same_bits_without_vectorization(self):
        vectorized, scalar = lines("VFC_VECTORIZED_FLOWS"), lines("VFC_SCALAR_FLOWS")
        self.assertGreater(len(vectorized), 500)
        differing = [(k, a, b) for k, (a, b) in enumerate(zip(vectorized, scalar)) if a != b]
        self.assertEqual(differing[:1], [])
        self.assertEqual(len(vectorized), len(scalar))


if __name__ == "__main__":
    unittest.main()
