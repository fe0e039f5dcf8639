#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Runs the example whose output README.md and the manual quote, and compares."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
MANUAL = PACKAGE / "doc/Volume_filling_curves"
EXAMPLES = pathlib.Path(os.environ.get("VFC_EXAMPLES", ""))

if not (EXAMPLES / "tour").is_file():
    print("the examples are not built")
    sys.exit(77)


class Quotes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def output(self, *command):
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True).stdout

    def test_pages_tell_what_the_tour_prints(self):
        lines = self.output(EXAMPLES / "tour").splitlines()
        self.assertEqual(len(lines), 2)
        for page in PACKAGE / "README.md", MANUAL / "Volume_filling_curves.txt":
            [sentence] = re.findall(r"prints (`.*?`)\. ", page.read_text(), re.DOTALL)
            quotes = re.findall("`(.*?)`", sentence)
            self.assertEqual(len(quotes), len(lines), page)
            for quote, line in zip(quotes, lines):
                # the first page leaves the lengths out
                self.assertIn(quote, (line, line.split(",")[0]), page)


if __name__ == "__main__":
    unittest.main()
