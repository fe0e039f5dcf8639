#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Compares curves before and after `vfc untangle` with the independent knot oracle, chirality
included: some of the shared curves, and random polygons, which are knotted more often than not.
And has the oracle tell a knot from its mirror image, since an oracle that never objects shows
nothing."""

import os
import pathlib
import subprocess
import sys
import tempfile

SHARED_CURVES = [
    "paper/trefoil0001", "knot128/knot_0_1", "knot128/knot_4_1", "knot128/knot_7_7",
    "knot128/knot_8_19", "knot128/knot_9_42", "knot128/knot_10_11", "trefoil100/trefoil0001",
    "trefoil100/trefoil0064", "trefoil_hard/trefoil_hard03", "links/whitehead", "links/borromean",
    "open_arcs/3ulk"
]
RANDOM_POLYGONS = {"nodes": 150, "seeds": [1, 2, 3]}

REACHED, LIMIT, STALLED = 0, 2, 3  # exit statuses; the type is kept with all of them


def skip(reason):
    print(reason)
    sys.exit(77)


def find_oracle():
    tools = pathlib.Path(os.environ["VFC_SHARED_TOOLS"])
    if not (tools / "knot_oracle.py").exists():
        skip(f"there is no knot_oracle.py in {tools}")
    sys.path.insert(0, str(tools))
    try:
        import regina  # noqa: F401
        import knot_oracle
    except ImportError as error:
        skip(f"the knot oracle cannot run: {error}")
    return knot_oracle


def vfc(*arguments):
    command = [os.environ["VFC_PROGRAM"], *map(str, arguments)]
    return subprocess.run(command, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL).returncode


def start_curves(folder):
    data = pathlib.Path(os.environ["VFC_SHARED_DATA"])
    for name in SHARED_CURVES:
        if not (data / f"{name}.obj").exists():
            skip(f"there is no {name}.obj in {data}")
        yield data / f"{name}.obj"
    for seed in RANDOM_POLYGONS["seeds"]:
        path = folder / f"random_polygon{seed}.obj"
        status = vfc("generate", "random-polygon", "--nodes", RANDOM_POLYGONS["nodes"], "--seed", seed,
                     "-o", path)
        assert status == 0, f"vfc generate: exit status {status}"
        yield path


def complaint(oracle, start, end):
    """What is wrong with an untangled curve, None if nothing is."""
    status = vfc("untangle", start, "-o", end, "--strategy", "flow", "--force")
    if status not in (REACHED, LIMIT, STALLED):
        return f"exit status {status}"
    same, reason = oracle.compare(oracle.identify(str(start)), oracle.identify(str(end)), chiral=True)
    print(f"{start.name}: {same}, {reason}", flush=True)
    return None if same == "same type" else f"{same}, {reason}"


def is_mirror_image_noticed(oracle, folder):
    knots = [folder / f"trefoil{sign}.obj" for sign in (3, -3)]
    for knot, q in zip(knots, (3, -3)):
        vfc("generate", "torus-knot", "--p", 2, f"--q={q}", "-o", knot)
    left, right = (oracle.identify(str(knot)) for knot in knots)
    return oracle.compare(left, right, chiral=True)[0] == "different"


def main():
    oracle = find_oracle()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        failures = []
        for start in start_curves(folder):
            if found := complaint(oracle, start, folder / f"untangled_{start.name}"):
                failures.append(f"{start.name}: {found}")
        if not is_mirror_image_noticed(oracle, folder):
            failures.append("the oracle does not tell a trefoil from its mirror image")
    print("\n".join(failures) if failures else "all curves kept their types")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
