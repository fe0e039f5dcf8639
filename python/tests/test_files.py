# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of curves in files."""

import os
import pathlib
import tempfile
import unittest

import numpy as np
from support import circle

import vfc

ARC = [[0, 0, 3], [0.1, 0, 4]]
ATOM = "ATOM  {number:5}  CA  GLY A{number:4}    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           C\n"


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_each_format_that_is_written_is_read_without_loss(self):
        for name in ("a.obj", "a.polylines.txt", "a.ply", "a.vtp", "a.vect", "a.xyz", "a.TXT", "a.dat"):
            file = self.folder / name
            vfc.write(file, [circle(), ARC], closed=[True, False])
            curves, closed = vfc.read(file)
            self.assertEqual(closed, [True, False], name)
            self.assertTrue(np.array_equal(curves[0], circle()) and np.array_equal(curves[1], ARC), name)
            self.assertTrue(np.array_equal(vfc.read(str(file))[0][0], circle()))

    def test_no_curve_is_not_written(self):
        for name in ("a.obj", "a.polylines.txt", "a.ply", "a.vtp", "a.vect", "a.xyz", "a.txt", "a.dat"):
            for nothing in ([], vfc.Network(ARC, np.zeros((0, 2), int))):
                with self.assertRaisesRegex(ValueError, f"{name}: there is no curve"):
                    vfc.write(self.folder / name, nothing)
        self.assertEqual(os.listdir(self.folder), [])

    def test_names_that_are_no_utf_8(self):
        name = os.fsencode(self.folder) + b"/\xff.obj"
        for file in (name, os.fsdecode(name)):
            vfc.write(file, circle())
            self.assertTrue(np.array_equal(vfc.read(file)[0][0], circle()))
        with open(name, "w") as file:
            file.write("v 1 2 x\n")
        with self.assertRaisesRegex(ValueError, r"\\xff.obj:1: error: unparsable number"):
            vfc.read(name)
        with self.assertRaisesRegex(ValueError, r"\\xff.stl: curves are written to"):
            vfc.write(name.replace(b".obj", b".stl"), circle())

    def test_junctions_are_read_as_a_network(self):
        star = vfc.Network([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1], [0, 2], [0, 3]])
        for name in ("star.obj", "star.ply", "star.vtp"):
            file = self.folder / name
            vfc.write(file, star)
            network = vfc.read(file, network=True)
            self.assertEqual((len(network.points), len(network.edges)), (4, 3))
            self.assertEqual(vfc.length(network), 3)
            with self.assertRaisesRegex(ValueError, "junction"):
                vfc.read(file)

    def test_the_backbone_of_a_protein_is_an_open_curve(self):
        points = np.round(10 * vfc.torus_knot(2, 3, 60), 3)[:-1]
        file = self.folder / "protein.pdb"
        file.write_text("".join(ATOM.format(number=i, x=x, y=y, z=z)
                                for i, (x, y, z) in enumerate(points, start=1)) + "END\n")
        (chain,), closed = vfc.read(file)
        self.assertEqual(closed, [False])
        self.assertTrue(np.array_equal(chain, points))
        self.assertEqual(vfc.identify_chain(chain, closures=20).name, "3_1")

    def test_what_is_closed_can_be_said(self):
        file = self.folder / "points.xyz"
        np.savetxt(file, circle())
        with self.assertRaisesRegex(ValueError, "points.xyz.*closed=True or closed=False"):
            vfc.read(file)
        self.assertEqual(vfc.read(file, closed=True)[1], [True])
        self.assertEqual(vfc.read(file, closed=False)[1], [False])
        with self.assertRaisesRegex(TypeError, "closed is 'yes'"):
            vfc.read(file, closed="yes")

    def test_what_is_read_is_no_curve_but_a_pair(self):
        vfc.write(self.folder / "curve.obj", circle())
        with self.assertRaisesRegex(ValueError, r"shape \(1, 16, 3\).*read\(\) returns curves, and"):
            vfc.identify(vfc.read(self.folder / "curve.obj"))

    def test_errors_name_the_file_and_the_line(self):
        file = self.folder / "curves.obj"
        file.write_text("v 1 2 x\n")
        with self.assertRaisesRegex(ValueError, "curves.obj:1: error: unparsable number"):
            vfc.read(file)
        with self.assertRaises(FileNotFoundError):
            vfc.read(self.folder / "absent.obj")
        with self.assertRaises(FileNotFoundError):
            vfc.write(self.folder / "absent" / "curves.obj", circle())
        for name in ("curves.stl", "curves.pdb"):
            with self.assertRaisesRegex(ValueError, rf"{name}: curves are written to .*\.vtp"):
                vfc.write(self.folder / name, circle())
        self.assertEqual(os.listdir(self.folder), ["curves.obj"])


if __name__ == "__main__":
    unittest.main()
