#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Holds the controls of the live page against its scripts and tests, without Emscripten or a browser:
scripts name elements that exist, and every control has a listener and a test."""

import pathlib
import re
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
PAGE = (PACKAGE / "page/page.html").read_text()
SCRIPTS = "".join(file.read_text() for file in sorted((PACKAGE / "page").glob("*.js")))
TESTS = "".join(file.read_text() for file in sorted((PACKAGE / "page/tests").glob("*.py")))

IDS = set(re.findall(r'\bid="([\w-]+)"', PAGE))
CONTROLS = set(re.findall(r'<(?:button|input|select)\s[^>]*?\bid="([\w-]+)"', PAGE))


def listened():
    """The elements to which listeners are added: by name, in loops over names, and those of files."""
    loops = re.findall(r"of \[([^\]]*)\]\)\s*element\(\w+\)\.addEventListener", SCRIPTS)
    files = re.search(r"savedFiles = \{([^}]*)\}", SCRIPTS)[1]
    names = re.findall(r'"([\w-]+)"', "".join(loops)) + re.findall(r'"([\w-]+)":', files)
    return {*re.findall(r'element\("([\w-]+)"\)\.addEventListener', SCRIPTS), *names}


class Page_controls(unittest.TestCase):
    def test_every_control_has_a_name(self):
        self.assertEqual(len(CONTROLS), len(re.findall(r"<(?:button|input|select)\s", PAGE)))
        self.assertGreater(len(CONTROLS), 15)

    def test_scripts_name_elements_that_exist(self):
        named = set(re.findall(r'element\("([\w-]+)"\)', SCRIPTS))
        self.assertEqual(named - IDS, set())

    def test_every_control_has_a_listener(self):
        self.assertEqual(CONTROLS - listened(), set())

    def test_every_control_is_used_by_a_test(self):
        self.assertEqual({name for name in CONTROLS if not re.search(rf"""["']{name}["']""", TESTS)}, set())


if __name__ == "__main__":
    unittest.main()
