# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Test of the manual's chapter: its code runs from top to bottom, as a reader would type it."""

import contextlib
import importlib.util
import inspect
import io
import os
import pathlib
import re
import tempfile
import unittest

import vfc

CHAPTER = pathlib.Path(__file__).parents[2] / "doc/Volume_filling_curves/python.txt"
OPTIONAL = ("matplotlib", "tqdm")


def blocks():
    return [block for block in re.findall(r"\\verbatim\n(.*?)\\endverbatim", CHAPTER.read_text(), re.S)
            if not block.startswith(("apt-get", "cmake"))]


def absent(block):
    """The packages that a block needs and that are not there."""
    wanted = set(re.findall(r"^(?:import|from) (\w+)", block, re.M)) & set(OPTIONAL)
    return {name for name in wanted if not importlib.util.find_spec(name)}


class Chapter(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def test_its_code_runs_and_prints_what_it_says(self):
        names, printed = {}, io.StringIO()
        for block in blocks():
            if missing := absent(block):
                print(f"A block of the chapter is skipped, without {', '.join(missing)}:\n{block}")
                continue
            with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
                exec(compile(block, str(CHAPTER), "exec"), names)
        for words in ("3_1* True", "3_1* 0.71", "8_18", "8_18 [True]", "near wall", "open boundary"):
            self.assertIn(words, printed.getvalue())

    def test_it_names_every_function_and_every_domain(self):
        text = CHAPTER.read_text()
        for name, value in vars(vfc).items():
            if inspect.isfunction(value) or inspect.isclass(value) and issubclass(
                    value, (vfc.Domain, vfc.Interrupted)) and value is not vfc.Domain:
                self.assertIn(f"vfc.{name}", text)


if __name__ == "__main__":
    unittest.main()
