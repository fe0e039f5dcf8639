#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Runs the commands whose output the manual quotes, and compares."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

MANUAL = pathlib.Path(__file__).resolve().parents[3] / "doc/Volume_filling_curves"
BOW_TIE = "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 4 1\n"


class Quotes(unittest.TestCase):
    def test_pages_tell_what_the_program_prints(self):
        number = 0
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "bow_tie.obj").write_text(BOW_TIE)
            for page in MANUAL.glob("*.txt"):
                text = page.read_text()
                for block in re.findall(r"\\verbatim\n> vfc (.*?)\\endverbatim", text, re.S):
                    arguments, quoted = block.split("\n", 1)
                    run = subprocess.run([os.environ["VFC_PROGRAM"], *arguments.split()],
                                         cwd=folder, capture_output=True, text=True)
                    self.assertEqual(run.stdout, quoted, page)
                    number += 1
        self.assertGreater(number, 0)


if __name__ == "__main__":
    unittest.main()
