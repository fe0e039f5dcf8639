# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The results of each suite as pictures."""

import svg_chart

from .results import Suite

LEAST_SHARE = 0.02  # of a stage that is drawn


def log_log(title, x_label, y_label, curves):
    positive = {name: [(x, y) for x, y in points if x > 0 and y > 0] for name, points in curves.items()}
    drawn = {name: points for name, points in positive.items() if points}
    return svg_chart.chart(title, x_label, y_label, drawn, svg_chart.Logarithmic, svg_chart.Logarithmic)


def by_nodes(suite, value):
    return {program: [(m.nodes, value(m)) for m in suite.of(program) if m.is_done]
            for program in suite.programs}


def filling_time(suite):
    return log_log("Time of a filling", "nodes", "CPU seconds", by_nodes(suite, lambda m: m.seconds))


def filling_memory(suite):
    return log_log("Memory of a filling", "nodes", "megabytes at the peak",
                   by_nodes(suite, lambda m: m.megabytes))


def filling_stages(suite):
    measured = [m for m in suite.of(suite.programs[0]) if m.is_done]
    last = measured[-1].stages()
    names = [s for s, seconds in last.items() if seconds > LEAST_SHARE * sum(last.values())]
    curves = {name.replace("_", " "): [(m.nodes, 1e6 * m.stages().get(name, 0) / m.nodes) for m in measured]
              for name in sorted(names, key=last.get, reverse=True)}
    return log_log("Where the time of a filling goes", "nodes", "CPU microseconds per node of the result",
                   curves)


def untangling_time(suite):
    curves = {}
    for program in suite.programs:
        for series in suite.series():
            name = series if program == suite.programs[0] else f"{series}, {program}"
            curves[name] = [(m["size"], m.seconds) for m in suite.of(program, series) if m.is_done]
    return log_log("Time to untangle a random polygon", "nodes of the polygon", "CPU seconds", curves)


def coverage(suite):
    curves = {}
    for m in suite.of(suite.programs[0]):
        if m.is_done and m.report["iterations"]:
            point = m.report["iterations"], 100 * m.report["coverage"]["fraction_within_r"]
            points = curves.setdefault(m["series"], [])
            if point not in points:
                points.append(point)
    return svg_chart.chart("How much is covered, by how the curve starts", "iterations",
                           "percent of the volume within r", curves)


def speed(suite):
    """The ratios of all cases to the other programs; None if there are none."""
    ranges = {}
    for other in suite.programs[1:]:
        for case in suite.cases:
            if spread := suite.ratio(case, other, "cpu_seconds"):
                name = case if len(suite.programs) == 2 else f"{case}, {other}"
                ranges[name] = spread.low, spread.median, spread.high
    if not ranges:
        return None
    others = ", ".join(suite.programs[1:])
    return svg_chart.range_chart(f"CPU time of {suite.programs[0]}", f"times that of {others}", ranges)


PLOTS = {"filling_time": ("filling-scaling", filling_time),
         "filling_memory": ("filling-scaling", filling_memory),
         "filling_stages": ("filling-scaling", filling_stages),
         "untangling_time": ("untangling-scaling", untangling_time),
         "coverage_by_iterations": ("coverage", coverage),
         "filling_ratios": ("fillings", speed),
         "unknot_ratios": ("unknots", speed)}


def write_plots(lines, folder):
    """Writes NAME.svg for each plot that there are runs for, and returns the files."""
    files = []
    for name, (suite_name, draw) in PLOTS.items():
        suite = Suite(lines, suite_name)
        picture = draw(suite) if suite.cases else None
        if picture:
            files.append(folder / f"{name}.svg")
            files[-1].write_text(picture)
    return files
