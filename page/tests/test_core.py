# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The core of the live page in node, against the one compiled natively."""

import json
import pathlib
import shutil
import subprocess
import unittest

from cases import BUILD, PACKAGE, In_folder, coordinates, native

DRIVE = pathlib.Path(__file__).with_name("drive.js")
HARD_UNKNOT, TORUS = PACKAGE / "data/hard_unknot.obj", PACKAGE / "data/torus.off"
PAPER = PACKAGE.parent / "shared/data/paper"


def drive(*arguments):
    """What the core in WebAssembly says. Without fetch, which emscripten takes for a browser's."""
    command = ["node", "--no-experimental-fetch", DRIVE, BUILD / "core.js", *arguments]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


@unittest.skipUnless(shutil.which("node"), "there is no node")
class The_core(In_folder):
    def check_bits(self, command, knot, parameter):
        ours, theirs = self.folder / "wasm.obj", self.folder / "native.obj"
        drive(command, knot, parameter, ours)
        self.assertEqual(native(command, knot, parameter, theirs).returncode, 0)
        self.assertEqual(coordinates(ours), coordinates(theirs))
        self.assertNotEqual(coordinates(ours), coordinates(knot))

    # Drawn by hand, and with enough iterations for every sum to be rounded many times.
    def test_flows_with_the_bits_of_native_code(self):
        if not PAPER.exists():
            print(f"skipped: {PAPER} is absent")
        for knot in [HARD_UNKNOT, *sorted(PAPER.glob("*.obj"))]:
            with self.subTest(knot.name):
                self.check_bits("steps", knot, "30")

    def test_searches_with_the_bits_of_native_code(self):
        self.check_bits("search", HARD_UNKNOT, "5")

    def test_fills_with_the_bits_of_native_code(self):
        for bend, ratio in (("0", "1"), ("0", "2.5"), ("0.85", "1")):
            with self.subTest(bend=bend, ratio=ratio):
                seen = drive("fill", TORUS, "0.05", bend, ratio, self.folder)
                theirs = self.folder / "native.obj"
                done = native("fill", TORUS, *map(repr, seen["asked"]), ratio, theirs)
                self.assertEqual(done.returncode, 0)
                self.assertEqual(coordinates(self.folder / "curve.obj"), coordinates(theirs))
                self.assertEqual(seen["status"], "converged")
                self.assertGreater(seen["withinThickness"], 0.7)
                self.assertGreater(seen["bendRadius"], 0.99 * seen["asked"][1])
                self.assertEqual(seen["stages"], ["preparing", "branching", "flowing", "measuring"])
                self.assertLess(seen["nodes"][0], 20)  # a circle, whose branches are seen to grow
                self.assertGreater(len(set(seen["nodes"])), 10)
                self.check_certificate()

    def test_flows_in_time_for_the_eye(self):
        seen = drive("rate", "20", "21", "2000", "60")
        self.assertGreater(seen["nodes"], 1900)
        self.assertGreater(seen["stepsPerSecond"], 20)  # 56 were measured

    def test_pulls_no_ring_through_another(self):
        seen = drive("pull", self.folder)
        before, after = (int(native("linking", self.folder / name).stdout) for name in ("start.obj", "curve.obj"))
        self.assertEqual(abs(before), 1)
        self.assertEqual(after, before)
        self.assertGreater(seen["refused"], 100)
        self.assertGreater(seen["gone"], 0.05)  # up to the other ring
        self.assertLess(seen["gone"], seen["asked"] / 2)
        self.check_certificate()

    def test_adopts_what_a_stopped_search_shows(self):
        seen = drive("stop", self.folder)
        self.assertLess(seen["found"], seen["before"])
        self.assertEqual(seen["adopted"], seen["found"])
        self.assertEqual(seen["undone"], seen["before"])
        self.check_certificate()

    def test_certifies_all_that_a_user_does(self):
        seen = drive("play", self.folder)
        before, after_steps, after_undo, again = seen["lengths"]
        self.assertLess(after_steps, before)
        self.assertEqual(after_undo, before)
        self.assertEqual(again, after_steps)
        self.assertEqual(seen["before"]["name"], seen["after"]["name"])
        self.assertEqual(seen["after"]["name"], "5_2")
        self.check_certificate()

if __name__ == "__main__":
    unittest.main()
