# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What is concluded from times: ratios of runs that took turns, and how a time grows."""

import math
import statistics

LEAST_SECONDS = 1e-3  # what the system counts


class Spread:
    """The median of some numbers, and their range."""

    def __init__(self, numbers):
        self.low, self.median, self.high = min(numbers), statistics.median(numbers), max(numbers)
        self.is_single = len(numbers) == 1

    def text(self):
        middle = f"{self.median:.3g}"
        return middle if self.is_single else f"{middle} ({self.low:.3g} to {self.high:.3g})"


def ratio(first, second):
    """The spread of the ratios of times of the same turn, given as dicts; None if there is none."""
    turns = first.keys() & second.keys()
    ratios = [max(first[turn], LEAST_SECONDS) / max(second[turn], LEAST_SECONDS) for turn in turns]
    return Spread(ratios) if ratios else None


class Growth:
    """The line of least squares in logarithms through points (size, value), at least two."""

    def __init__(self, points):
        logs = [(math.log(x), math.log(y)) for x, y in points]
        self.x, self.y = (statistics.mean(axis) for axis in zip(*logs))
        self.exponent = (sum((x - self.x) * (y - self.y) for x, y in logs) /
                         sum((x - self.x) ** 2 for x, _ in logs))

    def at(self, size):
        return math.exp(self.y + self.exponent * (math.log(size) - self.x))


def growth(points, least_value=0.0):
    """None if fewer than two points are large enough to be significant."""
    points = [(x, y) for x, y in points if x > 0 and y > least_value]
    return Growth(points) if len({x for x, _ in points}) > 1 else None


def growth_of_large(points, least_value=0.0):
    """The same of the last decade of sizes, where what is constant or small at first no longer matters."""
    largest = max((x for x, _ in points), default=0)
    return growth([(x, y) for x, y in points if 10.5 * x >= largest], least_value)
