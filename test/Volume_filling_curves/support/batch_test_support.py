# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What the tests of many runs share."""

import json
import os
import pathlib
import subprocess
import sys

SKIPPED = 77
VFC = os.environ["VFC_PROGRAM"]
EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "examples" / "Volume_filling_curves"


def skip(why):
    print(why)
    sys.exit(SKIPPED)


def vfc(folder, *arguments):
    """The finished program, in one thread: there are several at a time."""
    return subprocess.run([VFC, *map(str, arguments), "--threads", "1"], cwd=folder,
                          capture_output=True, text=True)


def make_knots(folder, number):
    """Random polygons, and a list of them, knots.txt. Returns their names without endings."""
    folder.mkdir()
    names = [f"knot_{seed:03}" for seed in range(number)]
    for seed, name in enumerate(names):
        made = vfc(folder, "generate", "random-polygon", "--nodes", 16, "--seed", seed, "-o",
                   f"{name}.obj")
        assert made.returncode == 0, made.stderr
    (folder / "knots.txt").write_text("".join(f"{name}.obj\n" for name in names))
    return names


def reports(file):
    """The reports of a batch by their inputs, each of which has one."""
    lines = file.read_text().split("\n")
    assert lines.pop() == "", "the last line is complete"
    result = [json.loads(line) for line in lines]
    inputs = [report["input"] for report in result]
    assert len(set(inputs)) == len(inputs), "no curve is done twice"
    return dict(zip(inputs, result, strict=True))


def check_results(folder, results, names):
    """Each curve is there once, as a run of its own makes it, and nothing else."""
    found = reports(results / "results.jsonl")
    assert set(found) == {f"{name}.obj" for name in names}, set(found)
    files = {file.name for file in results.iterdir()}
    assert files == {f"{name}.obj" for name in names} | {"results.jsonl"}, files
    for name in names:
        single = folder / f"{name}.single.obj"
        if not single.exists():
            vfc(folder, "untangle", f"{name}.obj", "-o", single.name, "--report", f"{name}.json")
        assert (results / f"{name}.obj").read_bytes() == single.read_bytes(), name
        report = json.loads((folder / f"{name}.json").read_text())
        assert list(report) == list(found[f"{name}.obj"]), "the same keys"
        for key in report:
            if "seconds" not in key and key != "peak_memory_bytes":
                assert report[key] == found[f"{name}.obj"][key], (name, key)
