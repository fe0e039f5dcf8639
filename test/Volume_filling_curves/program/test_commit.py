#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The commit that builds of the program carry, with and without git."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[3]
SCRIPT = PACKAGE / "demo/Volume_filling_curves/reports/commit.cmake"
GIT = shutil.which("git") or ""
IDENTITY = {f"GIT_{role}_{key}": "test" for role in ("AUTHOR", "COMMITTER")
            for key in ("NAME", "EMAIL")}
# Hooks and settings of the user, and a repository that git was told of, do not matter.
ENVIRONMENT = {key: value for key, value in os.environ.items() if not key.startswith("GIT_")}
ENVIRONMENT |= IDENTITY | {"GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_NOSYSTEM": "1"}

if not shutil.which("cmake"):
    print("there is no cmake")
    sys.exit(77)


def run(*command, folder):
    return subprocess.run(command, cwd=folder, env=ENVIRONMENT, check=True, capture_output=True,
                          text=True).stdout.strip()


class Commit(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.header = pathlib.Path(folder.name).resolve() / "commit.h"
        self.sources = self.header.parent / "sources"
        self.sources.mkdir()

    def commit(self, git=GIT, sources=None):
        """The commit that the script writes into the header."""
        run("cmake", "-D", f"GIT={git}", "-D", f"SOURCES={sources or self.sources}", "-D",
            f"FILE={self.header}", "-P", str(SCRIPT), folder=self.sources)
        return re.search('"(.*)"', self.header.read_text())[1]

    def make_repository(self):
        run(GIT, "init", "-q", folder=self.sources)
        (self.sources / "file").write_text("1")
        run(GIT, "add", "file", folder=self.sources)
        run(GIT, "commit", "-q", "-m", "First", folder=self.sources)
        return run(GIT, "rev-parse", "HEAD", folder=self.sources)

    @unittest.skipUnless(GIT, "there is no git")
    def test_is_that_of_the_checkout_and_marked_if_files_were_changed(self):
        commit = self.make_repository()
        clean = self.commit()
        self.assertTrue(commit.startswith(clean) and len(clean) >= 7, clean)
        (self.sources / "file").write_text("2")
        self.assertEqual(self.commit(), clean + "-dirty")

    @unittest.skipUnless(GIT, "there is no git")
    def test_is_not_that_of_a_checkout_around_the_sources(self):
        self.make_repository()
        (self.sources / "unpacked").mkdir()
        self.assertEqual(self.commit(sources=self.sources / "unpacked"), "")

    def test_is_empty_without_a_checkout_or_without_git(self):
        self.assertEqual(self.commit(), "")
        self.assertEqual(self.commit(git=""), "")

    def test_leaves_the_header_alone_if_nothing_changed(self):
        self.commit()
        before = self.header.stat().st_mtime_ns
        self.commit()
        self.assertEqual(self.header.stat().st_mtime_ns, before)


if __name__ == "__main__":
    unittest.main()
