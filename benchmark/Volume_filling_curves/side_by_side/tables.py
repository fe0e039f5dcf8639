# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The results of each suite as tables in Markdown, which have names: that of the suite, and what more
there is to say about it. A function for a suite returns its tables by the second part of the name."""

from collections import Counter
from statistics import mean

from .ratios import growth, growth_of_large
from .results import Suite, per_node_and_iteration

LEAST_SECONDS_OF_GROWTH = 0.05  # below, a time is that of starting a program


def table(head, rows):
    cells = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in cells)


def number(value, form=".2f"):
    return "" if value is None else f"{value:{form}}"


def percent(value):
    return "" if value is None else f"{100 * value:.0f} %"


def rows_by_case(suite, cells):
    """A row for each case and program, which is named if there are several."""
    for case, programs in suite.cases.items():
        for program, measured in programs.items():
            named = [case if len(suite.programs) == 1 else f"{case}, {program}"]
            yield named + cells(measured)


RATIOS = {"CPU time": "cpu_seconds", "wall time": "wall_seconds", "memory": "peak_memory_bytes"}


def ratios(suite, with_cases=True):
    """The times of the first program by those of each other: of cases, of groups and of all together."""
    parts = {}
    for other in suite.programs[1:]:
        rows = {case: [suite.ratio(case, other, key) for key in RATIOS.values()]
                for case in suite.cases if with_cases}
        for group in filter(None, suite.groups()):
            rows[group] = [suite.ratio_of_sums(other, key, group) for key in RATIOS.values()]
        rows["all together"] = [suite.ratio_of_sums(other, key) for key in RATIOS.values()]
        found = [[name, *(spread.text() for spread in spreads)]
                 for name, spreads in rows.items() if all(spreads)]
        if found:
            parts[f"by {other}"] = table([f"{suite.programs[0]} / {other}", *RATIOS], found)
    return parts


def fillings(suite):
    def cells(m):
        r, c = m["thickness"], m.report.get("coverage") or {}
        outside = [m.report.get(key) for key in ("outside_nodes", "outside_segments")]
        clearance = m.report.get("min_clearance")
        return [f"{r:g}", m.end, number(m.report.get("iterations"), "d"), f"{m.seconds:.2f}",
                f"{m.megabytes:.0f}", m.nodes, number(m.report.get("length_end"), ".1f"),
                percent(c.get("fraction_within_r")), number(c.get("p99")), number(c.get("max")),
                m.report.get("empty_regions", ""), ", ".join(str(n) for n in outside if n is not None),
                number(clearance / r if clearance is not None else None)]

    head = ["domain", "r", "end", "iterations", "CPU s", "MB", "nodes", "length", "within r", "p99", "max",
            "empty", "outside", "clearance"]
    return {"": table(head, rows_by_case(suite, cells)), **ratios(suite)}


def found_meshes(suite):
    def cells(m):
        r, c = m["thickness"], m.report.get("coverage") or {}
        lengths = [m.report.get(f"min_{key}") for key in ("bend_radius", "strand_distance", "wall_distance")]
        return [f"{r:g}", m.end, f"{m.seconds:.2f}", m.nodes, percent(c.get("fraction_within_r")),
                number(c.get("p99")), *(number(x / r if x is not None else None) for x in lengths),
                percent(m.report.get("crowded_fraction")), number(m.report.get("fitting_thickness"), ".3g")]

    head = ["mesh", "r", "end", "CPU s", "nodes", "within r", "p99", "bend", "strands", "wall", "crowded", "fits"]
    return {"": table(head, rows_by_case(suite, cells))}


def unknots(suite):
    def cells(m):
        return [m.end, number(m.report.get("iterations"), "d"), f"{m.seconds:.3f}", f"{m.megabytes:.0f}",
                m.nodes]

    head = ["curve", "end", "iterations", "CPU s", "MB", "nodes"]
    return {"": table(head, rows_by_case(suite, cells)), **ratios(suite)}


def knots(suite):
    rows = []
    for group in suite.groups():
        for program in suite.programs:
            members = [m for m in suite.of(program) if m["group"] == group]
            iterations = [m.report["iterations"] for m in members if m.report.get("iterations")]
            seconds = [m.seconds for m in members]
            ends = ", ".join(f"{count} {end}" for end, count in Counter(m.end for m in members).items())
            name = group if len(suite.programs) == 1 else f"{group}, {program}"
            rows.append([name, ends, f"{mean(iterations):.0f}, {max(iterations)}" if iterations else "",
                         f"{mean(seconds):.3f}, {max(seconds):.3f}"])
    head = ["set", "ends", "iterations: mean, most", "CPU s: mean, most"]
    return {"": table(head, rows), **ratios(suite, with_cases=False)}


def exponents(series):
    """How measurements grow, given as points (nodes, value) under a name; without those that stay below 1."""
    rows = []
    for name, points in series.items():
        of_all, of_large = (grown(points, LEAST_SECONDS_OF_GROWTH) for grown in (growth, growth_of_large))
        if of_large and of_large.at(1e6) >= 1:
            rows.append([name, f"{of_all.exponent:.2f}", f"{of_large.exponent:.2f}", f"{of_large.at(1e6):.0f}"])
    head = ["", "exponent, all runs", "exponent, largest runs", "predicted for 1,000,000 nodes"]
    return {"growth": table(head, rows)} if rows else {}


def filling_scaling(suite):
    def cells(m):
        c = m.report.get("coverage") or {}
        return [m.nodes, m.end, number(m.report.get("iterations"), "d"), f"{m.seconds:.2f}",
                number(per_node_and_iteration(m), ".1f"), f"{m.megabytes:.0f}",
                percent(c.get("fraction_within_r")), number(c.get("p99")), number(c.get("max")),
                m.report.get("outside_segments", "")]

    head = ["domain", "nodes", "end", "iterations", "CPU s", "us per node and iteration", "MB", "within r",
            "p99", "max", "outside"]
    grown = {}
    for program in suite.programs:
        done = [m for m in suite.of(program) if m.is_done]
        grown[f"{program}, s"] = [(m.nodes, m.seconds) for m in done]
        grown[f"{program}, MB"] = [(m.nodes, m.megabytes) for m in done]
    ours = [m for m in suite.of(suite.programs[0]) if m.is_done]
    stages = dict.fromkeys(stage for m in ours for stage in m.stages())
    for stage in stages:
        grown[f"{stage.replace('_', ' ')}, s"] = [(m.nodes, m.stages().get(stage, 0)) for m in ours]
    return {"": table(head, rows_by_case(suite, cells)), "stages": stage_table(ours, stages),
            **exponents(grown), **ratios(suite)}


def stage_table(measured, stages):
    rows = [[m.nodes, *(f"{m.stages().get(stage, 0):.2f}" for stage in stages)] for m in measured]
    return table(["nodes", *(f"{stage.replace('_', ' ')}, s" for stage in stages)], rows)


def untangling_scaling(suite):
    def cells(m):
        return [m.nodes, m.end, number(m.report.get("iterations") or None, "d"), f"{m.seconds:.2f}",
                number(per_node_and_iteration(m), ".1f"), f"{m.megabytes:.0f}"]

    head = ["nodes at first", "nodes", "end", "iterations", "CPU s", "us per node and iteration", "MB"]
    grown = {f"{program}: {series}, s": [(m["size"], m.seconds) for m in suite.of(program, series) if m.is_done]
             for program in suite.programs for series in suite.series()}
    return {"": table(head, rows_by_case(suite, cells)), **exponents(grown), **ratios(suite)}


def coverage(suite):
    rows = []
    for m in suite.of(suite.programs[0]):
        c = m.report.get("coverage") or {}
        rows.append([m["series"], m.report.get("iterations", ""), m.end, percent(c.get("fraction_within_r")),
                     number(c.get("p99")), number(c.get("max"))])
    return {"": table(["start", "iterations", "end", "within r", "p99", "max"], rows)}


def threads(suite):
    rows = []
    for series in suite.series():
        measured = suite.of(suite.programs[0], series)
        for m in measured:
            faster = measured[0].median("wall_seconds") / m.median("wall_seconds")
            same = "same" if m["curve"] == measured[0]["curve"] else "OTHER"
            rows.append([series, m["threads"], f"{m.median('wall_seconds'):.2f}", f"{m.seconds:.2f}",
                         f"{faster:.2f}", f"{100 * faster / m['threads']:.0f} %", same])
    head = ["", "threads", "wall s", "CPU s", "times as fast", "efficiency", "bits of the curve"]
    return {"": table(head, rows)}


TABLES = {"fillings": fillings, "found-meshes": found_meshes, "unknots": unknots, "knots": knots,
          "filling-scaling": filling_scaling, "untangling-scaling": untangling_scaling, "coverage": coverage,
          "threads": threads}


def tables(lines):
    """The tables of all suites that have been run, by their names."""
    named = {}
    for name, make in TABLES.items():
        suite = Suite(lines, name)
        if suite.cases:
            named.update({f"{name} {more}".strip(): text for more, text in make(suite).items()})
    return named
