#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Holds the texts of the Python module against the headers that they come from, without compiling
the module: whoever rewords a header learns here what Python's users would read."""

import pathlib
import re
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(PACKAGE / "python"))
sys.dont_write_bytecode = True
import make_interface  # noqa: E402
import read_headers  # noqa: E402


class Python_texts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            make_interface.main(pathlib.Path(folder))
            cls.text = "".join(file.read_text() for file in pathlib.Path(folder).glob("vfc/*"))

    def test_headers_contain_all_phrases_that_are_replaced(self):
        self.assertEqual(set(read_headers.IN_PYTHON) - read_headers.used_phrases, set())

    def test_enumerators_have_become_words(self):
        self.assertEqual(re.findall(r"`[A-Z][A-Z_0-9]+`", self.text), [])
        self.assertIn("`'converged'`", self.text)


if __name__ == "__main__":
    unittest.main()
