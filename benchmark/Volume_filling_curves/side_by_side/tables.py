# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The results of each suite in Markdown, to be put into a README."""

from collections import Counter
from statistics import mean

from .results import Suite, growth_of, per_node_and_iteration


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


def ratios(suite, groups=("",)):
    """The times of the first program by those of the others."""
    parts = []
    for other in suite.programs[1:]:
        rows = [[case, spread.text(), wall.text(), memory.text()] for case in suite.cases
                if (spread := suite.ratio(case, other, "cpu_seconds"))
                if (wall := suite.ratio(case, other, "wall_seconds"))
                if (memory := suite.ratio(case, other, "peak_memory_bytes"))]
        if len(groups) > 1 or groups[0]:
            rows = [[group, *(suite.ratio_of_sums(other, key, group).text()
                              for key in ("cpu_seconds", "wall_seconds", "peak_memory_bytes"))]
                    for group in groups if suite.ratio_of_sums(other, "cpu_seconds", group)]
        if not rows:
            continue
        rows.append(["all together", *(suite.ratio_of_sums(other, key).text()
                                       for key in ("cpu_seconds", "wall_seconds")), ""])
        head = [f"{suite.programs[0]} / {other}", "CPU time", "wall time", "memory"]
        parts.append(table(head, rows))
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
    return [table(head, rows_by_case(suite, cells)), *ratios(suite)]


def unknots(suite):
    def cells(m):
        return [m.end, number(m.report.get("iterations"), "d"), f"{m.seconds:.3f}", f"{m.megabytes:.0f}",
                m.nodes]

    return [table(["curve", "end", "iterations", "CPU s", "MB", "nodes"], rows_by_case(suite, cells)),
            *ratios(suite)]


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
    return [table(["set", "ends", "iterations: mean, most", "CPU s: mean, most"], rows),
            *ratios(suite, suite.groups())]


def exponents(rows):
    """Of named series of measurements: the exponent, that of the last two, the value at a million."""
    cells = [[name, f"{g.exponent:.2f}", f"{g.last:.2f}", f"{g.at(1e6):.0f}"] for name, g in rows if g]
    return [table(["", "exponent", "between the last two", "at 1,000,000 nodes by the fit, s"], cells)] if cells else []


def filling_scaling(suite):
    def cells(m):
        c = m.report.get("coverage") or {}
        return [m.nodes, m.end, number(m.report.get("iterations"), "d"), f"{m.seconds:.2f}",
                number(per_node_and_iteration(m), ".1f"), f"{m.megabytes:.0f}",
                percent(c.get("fraction_within_r")), number(c.get("p99")), number(c.get("max")),
                m.report.get("outside_segments", "")]

    head = ["domain", "nodes", "end", "iterations", "CPU s", "us per node and iteration", "MB", "within r",
            "p99", "max", "outside"]
    grown = [(program, growth_of(suite.of(program), lambda m: m.seconds)) for program in suite.programs]
    ours = suite.of(suite.programs[0])
    stages = dict.fromkeys(stage for m in ours for stage in m.stages())
    grown += [(f"{suite.programs[0]}: {stage}", growth_of(ours, lambda m, s=stage: m.stages().get(s, 0)))
              for stage in stages]
    return [table(head, rows_by_case(suite, cells)), stage_table(ours, stages), *exponents(grown),
            *ratios(suite)]


def stage_table(measured, stages):
    rows = [[m.nodes, *(f"{m.stages().get(stage, 0):.2f}" for stage in stages)] for m in measured]
    return table(["nodes", *(f"{stage.replace('_', ' ')}, s" for stage in stages)], rows)


def untangling_scaling(suite):
    def cells(m):
        return [m.nodes, m.end, number(m.report.get("iterations") or None, "d"), f"{m.seconds:.2f}",
                number(per_node_and_iteration(m), ".1f"), f"{m.megabytes:.0f}"]

    head = ["nodes at first", "nodes", "end", "iterations", "CPU s", "us per node and iteration", "MB"]
    grown = [(f"{program}: {series}", growth_of(suite.of(program, series), lambda m: m.seconds, lambda m: m["size"]))
             for program in suite.programs for series in suite.series()]
    return [table(head, rows_by_case(suite, cells)), *exponents(grown), *ratios(suite)]


def coverage(suite):
    rows = []
    for m in suite.of(suite.programs[0]):
        c = m.report.get("coverage") or {}
        rows.append([m["series"], m.report.get("iterations", ""), m.end, percent(c.get("fraction_within_r")),
                     number(c.get("p99")), number(c.get("max"))])
    return [table(["start", "iterations", "end", "within r", "p99", "max"], rows)]


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
    return [table(head, rows)]


TABLES = {"fillings": fillings, "unknots": unknots, "knots": knots, "filling-scaling": filling_scaling,
          "untangling-scaling": untangling_scaling, "coverage": coverage, "threads": threads}


def tables(lines):
    """The tables of all suites that have been run, under headings."""
    parts = []
    for name, make in TABLES.items():
        suite = Suite(lines, name)
        if suite.cases:
            parts += [f"## {name.replace('-', ' ').capitalize()}", *make(suite)]
    return "\n\n".join(parts)
