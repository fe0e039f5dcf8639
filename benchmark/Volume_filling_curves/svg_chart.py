# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Charts as SVG: lines with linear or logarithmic axes, and ranges of ratios."""

import html
import math

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 560, 360, 70, 40, 150, 50
COLORS = ["#1b6ca8", "#c8553d", "#3a7d44", "#7b4b94", "#b8860b", "#444444", "#2a9d8f", "#d1495b"]


class Linear:
    """An axis from a bit below the values to a bit above them; from 0 if that is not far."""

    def __init__(self, values):
        margin = 0.08 * (max(values) - min(values)) or 0.1 * abs(values[0]) or 1
        self.low, self.high = min(values) - margin, max(values) + margin
        if 0 <= min(values) < 0.5 * max(values):
            self.low = 0

    def place(self, value):
        return (value - self.low) / (self.high - self.low)

    def ticks(self):
        step = 10 ** math.floor(math.log10(self.high - self.low))
        step *= min((f for f in (0.2, 0.5, 1, 2) if (self.high - self.low) / (f * step) <= 7), default=2)
        first = math.ceil(self.low / step - 1e-9)
        return [k * step for k in range(first, math.floor(self.high / step + 1e-9) + 1)]


class Logarithmic:
    """An axis for positive values, with ticks at round numbers."""

    def __init__(self, values, margin=0.05):
        logs = [math.log10(value) for value in values]
        margin = margin * (max(logs) - min(logs)) or 0.3
        self.low, self.high = min(logs) - margin, max(logs) + margin

    def place(self, value):
        return (math.log10(value) - self.low) / (self.high - self.low)

    def ticks(self):
        span = self.high - self.low
        digits = range(1, 10) if span < 0.7 else (1, 2, 5) if span < 2 else (1,)
        decades = range(math.floor(self.low), math.ceil(self.high) + 1)
        return [x for x in (digit * 10.0**k for k in decades for digit in digits) if 0 <= self.place(x) <= 1]


class AtValues(Logarithmic):
    """A logarithmic axis from the least value to the largest, with ticks at all of them if they are few."""

    def __init__(self, values):
        self.values = sorted(set(values))
        super().__init__(values, 1e-9)

    def ticks(self):
        return self.values if len(self.values) <= 8 else super().ticks()


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{html.escape(words)}</text>'


def short(number):
    return f"{number:,.0f}" if number >= 1000 else f"{number:.3g}"


def sheet(height, title, lines):
    """A white picture with a title over what is drawn."""
    head = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
            f'viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12">',
            f'<rect width="{WIDTH}" height="{height}" fill="white"/>',
            text(WIDTH / 2, 22, title, more='font-size="14"')]
    return "\n".join(head + lines + ["</svg>"]) + "\n"


def polyline(name, places, color, height):
    """A curve with its points, and its name at the right."""
    path = "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
    line = [f'<path d="M{path}" fill="none" stroke="{color}" stroke-width="2"/>'] if path else []
    dots = [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in places]
    return line + dots + [text(WIDTH - RIGHT + 12, height, name, "start", f'fill="{color}"')]


def chart(title, x_label, y_label, curves, across=AtValues, up=Linear):
    """A chart of curves, a dict from names to lists of points; `across` and `up` are axes."""
    points = [point for curve in curves.values() for point in curve] or [(1, 0), (10, 1)]
    xs, ys = across([x for x, _ in points]), up([y for _, y in points])

    def place(x, y):
        return (LEFT + xs.place(x) * (WIDTH - LEFT - RIGHT),
                HEIGHT - BOTTOM - ys.place(y) * (HEIGHT - TOP - BOTTOM))

    middle = (TOP + HEIGHT - BOTTOM) / 2
    lines = [text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, x_label),
             text(16, middle, y_label, more=f'transform="rotate(-90 16 {middle})"')]
    for y in ys.ticks():
        height = place(points[0][0], y)[1]
        lines += [f'<path d="M{LEFT} {height:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>',
                  text(LEFT - 6, height + 4, short(y), "end")]
    for x in xs.ticks():
        lines.append(text(place(x, points[0][1])[0], HEIGHT - BOTTOM + 18, short(x)))
    lines.append(f'<path d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}" fill="none" stroke="black"/>')
    for k, (name, curve) in enumerate(curves.items()):
        places = [place(*point) for point in curve]
        lines += polyline(name, places, COLORS[k % len(COLORS)], TOP + 12 + 18 * k)
    return sheet(HEIGHT, title, lines)


def range_chart(title, label, ranges):
    """A row for each name of `ranges`, with a dot for the middle of (low, middle, high) and a bar from
    end to end, over a logarithmic axis that shows 1."""
    left, row = 190, 18
    height = TOP + BOTTOM + row * len(ranges)
    axis = Logarithmic([1, *(value for values in ranges.values() for value in values)])

    def place(value):
        return left + axis.place(value) * (WIDTH - left - 30)

    lines = [text((left + WIDTH - 30) / 2, height - 12, label)]
    for tick in axis.ticks():
        stroke = "black" if tick == 1 else "#ddd"
        lines += [f'<path d="M{place(tick):.1f} {TOP}V{height - BOTTOM}" stroke="{stroke}"/>',
                  text(place(tick), height - BOTTOM + 18, short(tick))]
    for k, (name, (low, middle, high)) in enumerate(ranges.items()):
        y = TOP + row * (k + 0.5)
        lines += [text(left - 10, y + 4, name, "end"),
                  f'<path d="M{place(low):.1f} {y}H{place(high):.1f}" stroke="{COLORS[0]}" stroke-width="3"/>',
                  f'<circle cx="{place(middle):.1f}" cy="{y}" r="4" fill="{COLORS[0]}"/>']
    return sheet(height, title, lines)
