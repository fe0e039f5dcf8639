#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Runs the manual's recipe for GNU parallel."""

import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from batch_test_support import EXAMPLES, VFC, check_results, make_knots, skip


def has_gnu_parallel():
    try:
        version = subprocess.run(["parallel", "--version"], capture_output=True, text=True)
    except FileNotFoundError:
        return False
    return version.stdout.startswith("GNU parallel")


def main():
    if not os.path.exists(VFC):
        skip("there is no program vfc")
    if not has_gnu_parallel():
        skip("there is no GNU parallel")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "knots"
        names = make_knots(folder, 20)
        path = os.pathsep.join([str(pathlib.Path(VFC).parent), os.environ["PATH"]])
        environment = {**os.environ, "PATH": path, "HOME": name}
        for _ in range(2):
            subprocess.run([EXAMPLES / "untangle_in_parallel.sh"], cwd=folder, env=environment,
                           check=True)
            check_results(folder, folder / "untangled", names)


main()
