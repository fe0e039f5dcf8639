#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Plays a film that vfc draws in Chromium, without a display or a network: it starts by itself and
comes to its end, nothing goes wrong, and what is seen is a red curve in gray glass."""

import collections
import contextlib
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import Browser

SKIPPED = 77
VFC = os.environ["VFC_PROGRAM"]
WIDTH, HEIGHT = 640, 480

OCTAHEDRON = """OFF
6 8 0
1 0 0
-1 0 0
0 1 0
0 -1 0
0 0 1
0 0 -1
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
"""


def skip(why):
    print(why)
    sys.exit(SKIPPED)


def vfc(*arguments):
    return subprocess.run([VFC, *arguments, "--quiet"], capture_output=True, text=True)


# Before the film can have gone on, however busy the machine is.
NOTE_FIRST_ITERATION = """addEventListener("DOMContentLoaded", () => {
  window.firstIteration = Number(document.getElementById("iteration").textContent);
})"""


@contextlib.contextmanager
def playing(browser, film):
    """A tab in which the film plays, of which the browser has nothing to complain in the end."""
    browser.open_tab(film.parent)
    browser.ask("Page.addScriptToEvaluateOnNewDocument", source=NOTE_FIRST_ITERATION)
    browser.open(film, WIDTH, HEIGHT)
    browser.wait("document.readyState === 'complete'")
    yield
    assert browser.value("document.getElementById('problem').hidden"), "a problem is shown"
    assert not browser.complaints, f"{film.name}: {browser.complaints}"
    browser.close_tab()


@contextlib.contextmanager
def stopped(browser, film):
    """The same, stopped at its first frame by the slider."""
    with playing(browser, film):
        move_slider(browser, "frame", 0)
        yield


def shown(browser, name):
    return float(browser.value(f"document.getElementById('{name}').textContent"))


def move_slider(browser, name, value):
    browser.value(f"document.getElementById('{name}').value = {value}; "
                  f"document.getElementById('{name}').dispatchEvent(new Event('input'))")


def press_on_canvas(browser, *keys):
    browser.value("document.getElementById('scene').focus()")
    for key in keys:
        browser.press(key)


def wait_for_end(browser, last):
    browser.wait(f"document.getElementById('iteration').textContent === '{last}'", seconds=60)


def pixels(png):
    """The rows of a picture, each a list of (red, green, blue)."""
    data, width, place, packed = png.read_bytes(), 0, 8, b""
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place:place + 8])
        content = data[place + 8:place + 8 + size]
        if kind == b"IHDR":
            width, _, depth, color, *_ = struct.unpack(">IIBBBBB", content)
            assert depth == 8 and color in (2, 6), "a picture in red, green and blue"
            channels = 3 if color == 2 else 4
        if kind == b"IDAT":
            packed += content
        place += size + 12
    raw, stride, rows = zlib.decompress(packed), channels * width, []
    above = bytearray(stride)
    for start in range(0, len(raw), stride + 1):
        above = unfiltered(raw[start], raw[start + 1:start + 1 + stride], above, channels)
        rows.append([tuple(above[i:i + 3]) for i in range(0, stride, channels)])
    return rows


def unfiltered(kind, line, above, channels):
    """A row of bytes, from the differences to what its neighbors predict (PNG, section 9)."""
    if kind == 0:
        return bytearray(line)
    row = bytearray(line)
    for i, up in enumerate(above):
        left, corner = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
        if kind == 4:  # Paeth's
            predicted = min((left, up, corner), key=lambda x: abs(left + up - corner - x))
        else:
            predicted = (left, up, (left + up) // 2)[kind - 1]
        row[i] = (row[i] + predicted) & 255
    return row


def screen(browser, folder):
    """The rows of what is drawn after the events so far."""
    browser.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))",
                  awaitPromise=True)
    browser.save_picture(folder / "screen.png")
    return pixels(folder / "screen.png")


def check_playing(browser, film, iterations):
    with playing(browser, film):
        first = browser.value("firstIteration")
        assert first == iterations[0], f"it begins at iteration {first}"
        wait_for_end(browser, iterations[-1])
        assert shown(browser, "length") > 0
    print(f"{film.name}: played from iteration {first} to {iterations[-1]}")


def check_screen(browser, folder, film, has_domain):
    """Of the last frame."""
    with playing(browser, film):
        move_slider(browser, "frame", "document.getElementById('frame').max")
        rows = screen(browser, folder)[:HEIGHT - 160]  # without the controls
    colors = [color for row in rows for color in row]
    red = sum(r > g + 60 and r > b + 60 for r, g, b in colors) / len(colors)
    [(ground, _)] = collections.Counter(colors).most_common(1)
    glass = sum(30 > b - r > 3 for r, _, b in colors) / len(colors)
    print(f"{film.name}: {100 * red:.1f} % curve, {100 * glass:.1f} % glass on {ground}")
    assert 0.005 < red < 0.5, "the curve is not to be seen"
    assert glass > 0.02 if has_domain else glass < 0.002, "the domain"


def check_controls(browser, film, iterations):
    with stopped(browser, film):
        assert shown(browser, "iteration") == iterations[0]
        for key in "..,":
            browser.press(key)
        assert shown(browser, "iteration") == iterations[1], "keys"
        move_slider(browser, "frame", 2)
        assert shown(browser, "iteration") == iterations[2], "slider"
        browser.press(" ")
        wait_for_end(browser, iterations[-1])
        move_slider(browser, "frame", 0)
        browser.value("document.getElementById('play').click()")
        wait_for_end(browser, iterations[-1])
    print(f"{film.name}: space, comma, point, the button and the slider do what they should")


def red_pixels(browser, folder, film, act):
    with stopped(browser, film):
        act()
        rows = screen(browser, folder)
    return {(x, y) for y, row in enumerate(rows) for x, (r, g, b) in enumerate(row)
            if r > g + 60 and r > b + 60}


def check_view(browser, folder, film):
    still = red_pixels(browser, folder, film, lambda: None)
    for name, turn in {"keys": lambda: press_on_canvas(browser, "ArrowLeft", "ArrowUp"),
                       "mouse": lambda: browser.drag((9, 9), (99, 59))}.items():
        turned = red_pixels(browser, folder, film, turn)
        assert len(still ^ turned) > 0.3 * len(still), f"{name}: nothing turns"
    for name, enlarge in {"keys": lambda: press_on_canvas(browser, *"+++++"),
                          "slider": lambda: move_slider(browser, "tube", 1),
                          "wheel": lambda: browser.wheel(99, 99, -300)}.items():
        larger = red_pixels(browser, folder, film, enlarge)
        assert len(larger) > 1.2 * len(still), f"{name}: nothing grows"
    print(f"{film.name}: it turns, zooms, and has a tube of any radius")


def main():
    if not os.path.exists(VFC):
        skip("there is no program vfc")
    if not shutil.which("chromium"):
        skip("there is no chromium")
    browser = Browser()
    with tempfile.TemporaryDirectory() as name, contextlib.closing(browser):
        folder = pathlib.Path(name)
        (folder / "domain.off").write_text(OCTAHEDRON)
        frames, film = folder / "frames", folder / "film.html"
        vfc("generate", "torus-knot", "-o", f"{folder}/knot.obj")
        vfc("untangle", f"{folder}/knot.obj", "--frames", str(frames), "--strategy", "flow",
            "--every", "8")
        drawn = vfc("draw", "--film", str(frames), "-o", str(film))
        if "libjs-three" in drawn.stderr:
            skip("there is no three.js")
        assert drawn.returncode == 0, drawn.stderr
        iterations = sorted(int(frame.stem.split("_")[1]) for frame in frames.iterdir())
        check_playing(browser, film, iterations)
        check_controls(browser, film, iterations)
        check_view(browser, folder, film)
        check_screen(browser, folder, film, has_domain=False)

        frames, film = folder / "filling", folder / "filling.html"
        vfc("fill", f"{folder}/domain.off", "--thickness", "0.25", "--frames", str(frames),
            "--every", "10")
        drawn = vfc("draw", "--film", str(frames), f"{folder}/domain.off", "-o", str(film))
        assert drawn.returncode == 0, drawn.stderr
        check_screen(browser, folder, film, has_domain=True)


main()
