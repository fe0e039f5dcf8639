# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The runs of a suite, as tables and plots want them."""

import statistics
from collections import Counter

from .ratios import ratio


class Measured:
    """A case as one program has done it, once or several times."""

    def __init__(self, lines):
        self.lines = lines
        self.first = lines[0]
        self.report = self.first["report"]

    def __getitem__(self, key):
        return self.first[key]

    def median(self, key):
        return statistics.median(line[key] for line in self.lines)

    def by_turn(self, key):
        return {line["turn"]: line[key] for line in self.lines if "error" not in line}

    @property
    def seconds(self):
        return self.median("cpu_seconds")

    @property
    def megabytes(self):
        return self.median("peak_memory_bytes") / 1e6

    @property
    def end(self):
        return self.first.get("error") or self.report.get("status") or "done"

    @property
    def is_done(self):
        return "error" not in self.first

    @property
    def nodes(self):
        return self.report.get("nodes_end") or 0

    def stages(self):
        """CPU seconds of each stage: its share of the wall time, which a report contains."""
        seconds = self.report.get("seconds_by_stage") or {}
        total = sum(seconds.values()) or 1
        return {stage: self.seconds * s / total for stage, s in seconds.items()}


class Suite:
    """The runs of a suite by case and program."""

    def __init__(self, lines, name):
        found = {}
        for line in lines:
            if line["suite"] == name:
                found.setdefault(line["case"], {}).setdefault(line["program"], []).append(line)
        self.cases = {case: {program: Measured(runs) for program, runs in programs.items()}
                      for case, programs in found.items()}
        self.programs = list(Counter(p for programs in self.cases.values() for p in programs))

    def of(self, program, series=None):
        """What a program has done, in all cases or those of a series."""
        measured = (programs.get(program) for programs in self.cases.values())
        return [m for m in measured if m and (series is None or m["series"] == series)]

    def series(self):
        return list(dict.fromkeys(m["series"] for programs in self.cases.values() for m in programs.values()))

    def groups(self):
        return list(dict.fromkeys(m["group"] for programs in self.cases.values() for m in programs.values()))

    def ratio(self, case, other, key):
        """Of the first program to another one."""
        programs = self.cases[case]
        if self.programs[0] not in programs or other not in programs:
            return None
        return ratio(*(programs[p].by_turn(key) for p in (self.programs[0], other)))

    def ratio_of_sums(self, other, key, group=None):
        """Over the cases that both have done. A case that was run less often counts with its last turn."""
        names, pairs = (self.programs[0], other), []
        for programs in self.cases.values():
            if all(name in programs for name in names) and group in (None, programs[other]["group"]):
                first, second = (programs[name].by_turn(key) for name in names)
                pairs.append([(first[turn], second[turn]) for turn in sorted(first.keys() & second.keys())])
        pairs = [turns for turns in pairs if turns]
        sums = [{turn: sum(turns[min(turn, len(turns) - 1)][side] for turns in pairs)
                 for turn in range(max(map(len, pairs), default=0))} for side in (0, 1)]
        return ratio(*sums)


def per_node_and_iteration(measured):
    """Microseconds; None where nothing was done."""
    work = (measured.report.get("iterations") or 0) * measured.nodes
    return 1e6 * measured.seconds / work if work else None
