#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Holds the pages in Markdown against the files: links lead somewhere, scripts that are named exist,
and the code of the first page is that of an example, which is compiled."""

import pathlib
import re
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
PAGES = [PACKAGE / name for name in (
    "README.md", "CONTRIBUTING.md", "CHANGES.md", "benchmark/Volume_filling_curves/README.md",
    "include/CGAL/Volume_filling_curves/internal/README.md")]
TOUR = PACKAGE / "examples/Volume_filling_curves/tour.cpp"


class Front_pages(unittest.TestCase):
    def test_links_lead_to_files(self):
        for page in PAGES:
            for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text()):
                self.assertTrue((page.parent / target).is_file(), f"{page.name}: {target}")

    def test_scripts_that_are_named_exist(self):
        for page in PAGES:
            for name in re.findall(r"(?<![\w/])(?:scripts|benchmark)/[\w/.-]*\w", page.read_text()):
                self.assertTrue((PACKAGE / name).exists(), f"{page.name}: {name}")

    def test_code_is_that_of_an_example(self):
        example = {line.strip() for line in TOUR.read_text().splitlines()}
        blocks = re.findall(r"```cpp\n(.*?)```", (PACKAGE / "README.md").read_text(), re.DOTALL)
        self.assertTrue(blocks)
        for line in "".join(blocks).splitlines():
            self.assertIn(line.strip(), example)


if __name__ == "__main__":
    unittest.main()
