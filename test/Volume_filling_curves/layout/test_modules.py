#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Compares the plan of the modules, the table in internal/README.md, with the code: headers use modules
of lower layers only, and every module and public header stands where the plan says."""

import pathlib
import re
import unittest
from functools import cache

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
HEADERS = PACKAGE / "include/CGAL/Volume_filling_curves"
INTERNAL = HEADERS / "internal"
TESTS = PACKAGE / "test/Volume_filling_curves"
PROGRAM = PACKAGE / "demo/Volume_filling_curves"
# Shared parts of tests, and tests of more than one module
OTHER_TESTS = {"data", "fuzz", "layout", "program", "support", "usage"}


def read_plan():
    """The layer of each module, and of each public header."""
    modules, public = {}, {}
    for line in (INTERNAL / "README.md").read_text().splitlines():
        if row := re.fullmatch(r"\| (\d+) \| (\w+) \| (.+) \|", line):
            layer, name, text = row.groups()
            if name == "public":
                public.update(dict.fromkeys(re.findall(r"`(.+?)`", text), int(layer)))
            else:
                modules[name] = int(layer)
    return modules, public


MODULES, PUBLIC = read_plan()


def folders(parent):
    """The folders with a source, not those left by a build or an older version."""
    return {file.relative_to(parent).parts[0] for file in parent.glob("*/*.*")} - {"__pycache__"}


def headers():
    """All headers, as they are included."""
    return sorted(file.relative_to(HEADERS).as_posix() for file in HEADERS.rglob("*.h"))


@cache
def includes(header):
    """The headers of the package that one of them includes."""
    text = (HEADERS / header).read_text()
    return re.findall(r"^#include <CGAL/Volume_filling_curves/(.+)>", text, re.MULTILINE)


def module(header):
    """The module of an internal header, None for a public one."""
    parts = header.split("/")
    return parts[1] if parts[0] == "internal" else None


@cache
def layer(header, above=()):
    """The layer of a header's module; of a public one, that of the highest module that it uses."""
    if module(header):
        return MODULES[module(header)]
    if header in above:
        raise AssertionError(f"public headers in a circle: {' '.join(above)}")
    return max((layer(used, (*above, header)) for used in includes(header)), default=0)


class Layout(unittest.TestCase):
    maxDiff = None

    def test_each_module_is_on_the_plan(self):
        self.assertEqual(folders(INTERNAL), set(MODULES))

    def test_modules_are_folders_of_headers(self):
        files = {file.relative_to(INTERNAL).as_posix() for file in INTERNAL.rglob("*.*")}
        others = {file for file in files if not re.fullmatch(r"\w+/(\w+\.h|README\.md)", file)}
        self.assertEqual(others, {"README.md"})

    def test_each_public_header_is_on_its_layer(self):
        used = {used for header in filter(module, headers()) for used in includes(header)}
        top = max(MODULES.values()) + 1
        layers = {header: layer(header) if header in used else top
                  for header in headers() if not module(header)}
        self.assertEqual(layers, PUBLIC)

    def test_the_front_is_small(self):
        self.assertLessEqual(len(PUBLIC), 24)

    def test_each_module_uses_lower_layers_only(self):
        wrong = [
            f"{header} uses {used}"
            for header in filter(module, headers())
            for used in includes(header)
            if module(used) != module(header) and layer(used) >= layer(header)
        ]
        self.assertEqual(wrong, [])

    def test_tests_are_in_modules(self):
        self.assertLessEqual(folders(TESTS), set(MODULES) | folders(PROGRAM) | OTHER_TESTS)
        self.assertFalse(list(TESTS.glob("test_*")))

    def test_the_program_has_modules(self):
        files = {entry.name for entry in PROGRAM.iterdir() if entry.is_file()}
        self.assertEqual(files, {"CMakeLists.txt", "main.cpp"})


if __name__ == "__main__":
    unittest.main()
