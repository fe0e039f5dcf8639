# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Line charts with logarithmic axes across, as SVG."""

import html
import math

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 560, 360, 70, 40, 150, 50
COLORS = ["#1b6ca8", "#c8553d", "#3a7d44", "#7b4b94", "#b8860b", "#444444"]


def ticks(low, high):
    """Round numbers in a range."""
    step = 10 ** math.floor(math.log10(high - low))
    step *= min((f for f in (0.2, 0.5, 1, 2) if (high - low) / (f * step) <= 7), default=2)
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, math.floor(high / step + 1e-9) + 1)]


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{html.escape(words)}</text>'


def chart(title, x_label, y_label, curves):
    """A chart of curves, a dict from names to lists of points with positive x."""
    points = [point for curve in curves.values() for point in curve]
    if not points:
        points = [(1, 0), (10, 1)]
    xs, ys = sorted({x for x, _ in points}), [y for _, y in points]
    left, right = math.log(xs[0]), math.log(xs[-1]) if xs[-1] > xs[0] else math.log(xs[0]) + 1
    margin = 0.08 * (max(ys) - min(ys)) or 0.1 * abs(ys[0]) or 1
    low, high = min(ys) - margin, max(ys) + margin
    if 0 <= min(ys) < 0.5 * max(ys):
        low = 0

    def place(x, y):
        across, up = (math.log(x) - left) / (right - left), (y - low) / (high - low)
        return (LEFT + across * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - up * (HEIGHT - TOP - BOTTOM))

    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="12">',
             f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
             text((LEFT + WIDTH - RIGHT) / 2, 22, title, more='font-size="14"'),
             text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, x_label),
             text(16, (TOP + HEIGHT - BOTTOM) / 2, y_label,
                  more=f'transform="rotate(-90 16 {(TOP + HEIGHT - BOTTOM) / 2})"')]
    for y in ticks(low, high):
        height = place(xs[0], y)[1]
        lines += [f'<path d="M{LEFT} {height:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>',
                  text(LEFT - 6, height + 4, f"{y:g}", "end")]
    for x in xs:
        lines.append(text(place(x, low)[0], HEIGHT - BOTTOM + 18, f"{x:.3g}"))
    lines.append(f'<path d="M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{WIDTH - RIGHT}" fill="none" stroke="black"/>')
    for k, (name, curve) in enumerate(curves.items()):
        color, height = COLORS[k % len(COLORS)], TOP + 12 + 18 * k
        places = [place(*point) for point in curve]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
        if path:
            lines.append(f'<path d="M{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        lines += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>' for x, y in places]
        lines.append(text(WIDTH - RIGHT + 12, height, name, "start", f'fill="{color}"'))
    return "\n".join(lines + ["</svg>"]) + "\n"
