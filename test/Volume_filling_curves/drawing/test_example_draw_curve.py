#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Has CGAL draw a link in a window of a virtual display, and looks at the picture: there must be the
two colors of its components. The display keeps its picture in a file, in the format of xwd."""

import contextlib
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
EXAMPLE = os.environ["VFC_DRAW_EXAMPLE"]
SECONDS = 120  # on a busy machine, with OpenGL in software


def skip(why):
    print(why)
    sys.exit(SKIPPED)


@contextlib.contextmanager
def running(*command, **options):
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        process.terminate()
        process.wait(timeout=60)


@contextlib.contextmanager
def virtual_display(folder):
    """The number of a display, whose picture is in the folder."""
    read, write = os.pipe()
    with running("Xvfb", "-displayfd", str(write), "-screen", "0", "800x600x24", "-fbdir", folder,
                 pass_fds=[write], stderr=subprocess.DEVNULL):
        os.close(write)
        with os.fdopen(read) as numbers:
            yield int(numbers.readline())


def colors(picture):
    """How often each (red, green, blue) occurs in a picture of 32 bits per pixel."""
    data = picture.read_bytes()
    header = struct.unpack(">25I", data[:100])
    header_size, width, height, byte_order, depth, stride = (header[i] for i in (0, 4, 5, 7, 11, 12))
    assert (byte_order, depth) == (0, 32), "little-endian pixels of four bytes"
    start, counts = header_size + 12 * header[19], {}
    for y in range(height):
        row = data[start + y * stride:start + y * stride + 4 * width]
        for x in range(0, len(row), 4):
            color = (row[x + 2], row[x + 1], row[x])
            counts[color] = counts.get(color, 0) + 1
    return counts


def share(counts, is_hue):
    total = sum(counts.values())
    return sum(n for color, n in counts.items() if is_hue(*color)) / total


def main():
    if not os.path.exists(EXAMPLE):
        skip("the example draw_curve is not built; it needs CGAL's Qt support")
    if not shutil.which("Xvfb"):
        skip("there is no Xvfb")
    with tempfile.TemporaryDirectory() as folder, virtual_display(folder) as display:
        environment = {**os.environ, "DISPLAY": f":{display}", "LIBGL_ALWAYS_SOFTWARE": "1"}
        environment.pop("CGAL_TEST_SUITE", None)
        with running(EXAMPLE, env=environment) as example:
            end = time.monotonic() + SECONDS
            blue = pink = 0
            while min(blue, pink) < 0.001 and time.monotonic() < end:
                assert example.poll() is None, "the example has ended"
                time.sleep(0.5)
                counts = colors(pathlib.Path(folder) / "Xvfb_screen0")
                blue = share(counts, lambda r, g, b: b > r + 80 and b > g + 30)
                pink = share(counts, lambda r, g, b: r > g + 80 and r >= b)
            print(f"{100 * blue:.2f} % blue, {100 * pink:.2f} % red of the other component")
            assert min(blue, pink) >= 0.001, "the link is not to be seen"


main()
