# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The suites: lists of cases. The quick ones need only what the project brings along."""

import os

from .cases import Case

# Domains with their thickness; those of the paper's domains are the paper's.
DOMAINS = {"bunny.off": 0.0672, "spot.obj": 0.0531, "anapsidea.off": 0.0400, "torus.ply": 0.0804,
           "three_rings_smooth.off": 0.0889, "bracket_sharp.off": 0.0823, "nested_shells.off": 0.0943,
           "thin_plate.off": 0.03, "dumbbell_neck.off": 0.05}
CUBE_THICKNESS = 0.06

# Meshes that were found, some of them faulty, with about 0.1 times the cube root of their volume
FOUND_MESHES = {"1002_tray_bottom.STL": 7.03, "520644.stl": 2.54, "79741.stl": 1.44, "88566.stl": 3.65,
                "Cray_left.obj": 1250, "Havocglass8_left.obj": 14.1, "angle_block.STL": 0.105,
                "box.STL": 0.252, "capsule.obj": 0.194, "cow-low-resolution.obj": 0.353, "cow.obj": 0.377,
                "fox.ply": 3.05, "hourglass_ico.obj": 0.172, "round.stl": 0.653,
                "scorpion_low_resolution.obj": 0.23, "sword.obj": 0.003568}

UNKNOTS = ["freedman_he_wang", "goeritz", "thistlethwaite", "ochiai1", "ochiai2", "ochiai3", "ochiai4"]
KNOT_SETS = ["knot128", "trefoil100", "trefoil_hard"]
BY_FLOW = ("--strategy", "flow")

# Thickness and about how many nodes a filling with it has, from which follows the thickness for others
BUNNY_NODES = 0.0672, 5300
TORUS_NODES = 0.12, 1750
FILLING_SIZES = [1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000]
POLYGON_SIZES = [1000, 2000, 5000, 10_000, 20_000, 50_000, 100_000]


def fillings(inputs, quick):
    """Domains filled, each with a curve of its own thickness."""
    torus = inputs.bundled / "torus.off"
    if quick:
        return [Case("fillings", "torus, bundled", "fill", torus, 0.2)]
    found = [(inputs.of_shared_data(f"domains/{name}"), r) for name, r in DOMAINS.items()]
    found += [(inputs.cube(), CUBE_THICKNESS)]
    cases = [Case("fillings", mesh.stem, "fill", mesh, r) for mesh, r in found if mesh]
    return cases + [Case("fillings", "torus, bundled", "fill", torus, 0.12)]


def found_meshes(inputs, quick):
    """Meshes that were made for other purposes, mended where necessary, and filled."""
    if quick:
        files = {inputs.bundled / "torus.off": 0.2}
    else:
        files = {inputs.of_shared_data(f"real/meshes/{name}"): r for name, r in FOUND_MESHES.items()}
    return [Case("found-meshes", file.name, "fill", inputs.mended(file), r)
            for file, r in files.items() if file]


def unknots(inputs, quick):
    """Unknots that look knotted, untangled by the flow alone; and the trefoil that the paper shows."""
    def cases(files, group=""):
        return [Case("unknots", file.stem, "untangle", file, options=BY_FLOW, group=group)
                for file in files if file]

    names = [] if quick else [*UNKNOTS, "trefoil0001"]
    files = [inputs.of_shared_data(f"paper/{name}.obj") for name in names]
    seven, others = files[:len(UNKNOTS)], files[len(UNKNOTS):] + [inputs.bundled / "hard_unknot.obj"]
    return cases(seven, "the seven of the paper") + cases(others)


def knots(inputs, quick):
    """Tangled knots, made tight by the flow alone."""
    if quick:
        sets = {"torus knots": [inputs.torus_knot(2, 3), inputs.torus_knot(3, 4)]}
    else:
        sets = {name: inputs.all_of_shared_data(name) for name in KNOT_SETS}
    return [Case("knots", file.stem, "untangle", file, options=BY_FLOW, group=name)
            for name, files in sets.items() for file in files]


def filling_scaling(inputs, quick):
    """A domain filled with thinner and thinner curves."""
    bunny = None if quick else inputs.of_shared_data("domains/bunny.off")
    name, mesh, (r, nodes) = ("bunny", bunny, BUNNY_NODES) if bunny else (
        "torus", inputs.bundled / "torus.off", TORUS_NODES)
    cases = []
    for size in [100, 200, 400] if quick else FILLING_SIZES:
        thickness = float(f"{r * (nodes / size) ** (1 / 3):.3g}")
        cases.append(Case("filling-scaling", f"{name}, r = {thickness:g}", "fill", mesh, thickness,
                          series=name, size=size))
    return cases


def untangling_scaling(inputs, quick):
    """Random polygons: every node removed that can be, and what remains made tight by the flow."""
    cases = []
    for size in [100, 200, 400] if quick else POLYGON_SIZES:
        cases += [Case("untangling-scaling", f"{size}, simplify", "simplify", inputs.random_polygon(size),
                       series="simplify", size=size),
                  Case("untangling-scaling", f"{size}, flow", "untangle", inputs.simplified_polygon(size),
                       options=BY_FLOW, series="flow", size=size)]
    return cases


def coverage(inputs, quick):
    """How much of a torus is covered after some iterations, with either way to start."""
    mesh, r = inputs.bundled / "torus.off", 0.25 if quick else 0.12
    numbers = [1, 4, 16] if quick else [1, 2, 4, 8, 16, 32, 64, 128, 256]
    return [Case("coverage", f"{start}, at most {n}", "fill", mesh, r,
                 ("--start", start, "--max-iterations", n), series=start, size=n, for_others=False)
            for start in ("tree", "circle") for n in numbers]


def threads(inputs, quick):
    """The same work with one thread, and with as many as there are processors."""
    filled, flowed = (100, 200) if quick else (50_000, 10_000)
    bunny = None if quick else inputs.of_shared_data("domains/bunny.off")
    (r, nodes), mesh = (BUNNY_NODES, bunny) if bunny else (TORUS_NODES, inputs.bundled / "torus.off")
    r = float(f"{r * (nodes / filled) ** (1 / 3):.3g}")
    counts = sorted({1, min(2, os.cpu_count()), os.cpu_count()})
    works = [(f"{mesh.stem}, r = {r:g}", "fill", mesh, r, ()),
             (f"polygon of {flowed}", "untangle", inputs.simplified_polygon(flowed), None, BY_FLOW)]
    return [Case("threads", f"{name}, threads: {n}", job, file, thickness, options, series=name, size=n,
                 threads=n, for_others=False)
            for name, job, file, thickness, options in works for n in counts]


SUITES = {"fillings": fillings, "found-meshes": found_meshes, "unknots": unknots, "knots": knots,
          "filling-scaling": filling_scaling, "untangling-scaling": untangling_scaling, "coverage": coverage,
          "threads": threads}
