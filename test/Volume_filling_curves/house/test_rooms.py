#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Holds the plan of the house, the table in internal/README.md, against the code: headers use rooms
of lower floors only, and every room and public header stands where the plan says. Tests and the
program have rooms too."""

import pathlib
import re
import unittest
from functools import cache

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
HEADERS = PACKAGE / "include/CGAL/Volume_filling_curves"
INTERNAL = HEADERS / "internal"
TESTS = PACKAGE / "test/Volume_filling_curves"
PROGRAM = PACKAGE / "demo/Volume_filling_curves"
# What tests share, and tests of more than one room
OTHER_TESTS = {"data", "fuzz", "house", "program", "support", "usage"}


def read_plan():
    """The floor of each room, and of each public header that uses rooms."""
    rooms, public = {}, {}
    for line in (INTERNAL / "README.md").read_text().splitlines():
        if row := re.fullmatch(r"\| (\d+) \| (\w+) \| (.+) \|", line):
            floor, name, text = row.groups()
            if name == "public":
                public.update(dict.fromkeys(re.findall(r"`(.+?)`", text), int(floor)))
            else:
                rooms[name] = int(floor)
    return rooms, public


ROOMS, PUBLIC = read_plan()


def folders(parent):
    """The folders in which there is a source; what a build or an older version left is none."""
    return {file.relative_to(parent).parts[0] for file in parent.glob("*/*.*")} - {"__pycache__"}


def headers():
    """All headers, as they are included."""
    return sorted(file.relative_to(HEADERS).as_posix() for file in HEADERS.rglob("*.h"))


@cache
def includes(header):
    """The headers of the package that one of them includes."""
    text = (HEADERS / header).read_text()
    return re.findall(r"^#include <CGAL/Volume_filling_curves/(.+)>", text, re.MULTILINE)


def room(header):
    """The room of an internal header, None for a public one."""
    parts = header.split("/")
    return parts[1] if parts[0] == "internal" else None


@cache
def floor(header, above=()):
    """The floor of a header's room; of a public one, that of the highest room that it uses."""
    if room(header):
        return ROOMS[room(header)]
    if header in above:
        raise AssertionError(f"public headers in a circle: {' '.join(above)}")
    return max((floor(used, (*above, header)) for used in includes(header)), default=0)


class House(unittest.TestCase):
    maxDiff = None

    def test_each_room_is_on_the_plan(self):
        self.assertEqual(folders(INTERNAL), set(ROOMS))

    def test_rooms_are_folders_of_headers(self):
        files = {file.relative_to(INTERNAL).as_posix() for file in INTERNAL.rglob("*.*")}
        others = {file for file in files if not re.fullmatch(r"\w+/(\w+\.h|README\.md)", file)}
        self.assertEqual(others, {"README.md"})

    def test_each_public_header_is_on_its_floor(self):
        floors = {header: floor(header) for header in headers() if not room(header)}
        self.assertEqual({header: at for header, at in floors.items() if at}, PUBLIC)

    def test_each_room_uses_lower_floors_only(self):
        wrong = [
            f"{header} uses {used}"
            for header in filter(room, headers())
            for used in includes(header)
            if room(used) != room(header) and floor(used) >= floor(header)
        ]
        self.assertEqual(wrong, [])

    def test_tests_are_in_rooms(self):
        self.assertLessEqual(folders(TESTS), set(ROOMS) | folders(PROGRAM) | OTHER_TESTS)
        self.assertFalse(list(TESTS.glob("test_*")))

    def test_the_program_has_rooms(self):
        files = {entry.name for entry in PROGRAM.iterdir() if entry.is_file()}
        self.assertEqual(files, {"CMakeLists.txt", "main.cpp"})


if __name__ == "__main__":
    unittest.main()
