#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Plays a film that vfc draws in Chromium, without a display or a network: it starts by itself and
comes to its end, nothing goes wrong, and what is seen is a red curve in gray glass."""

import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

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


def chromium(folder, film, *arguments):
    """The finished browser, after that much of its own time, in milliseconds."""
    command = [shutil.which("chromium"), "--headless", "--no-sandbox", "--use-angle=swiftshader",
               "--enable-unsafe-swiftshader", "--enable-logging=stderr", "--hide-scrollbars",
               "--force-color-profile=srgb", f"--user-data-dir={folder}/profile",
               "--host-resolver-rules=MAP * ~NOTFOUND", f"--window-size={WIDTH},{HEIGHT}",
               *arguments, film.as_uri()]
    return subprocess.run(command, capture_output=True, text=True, timeout=300, check=True)


def shown(page, name):
    return float(re.search(rf'id="{name}">([^<]*)<', page).group(1))


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
    """A row of bytes, from the differences to its neighbors (PNG, section 9)."""
    row = bytearray(line)
    for i in range(len(row)):
        left = row[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        paeth = min((left, above[i], corner), key=lambda x: abs(left + above[i] - corner - x))
        row[i] = (row[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) & 255
    return row


def check_console(browser, film):
    messages = [line for line in browser.stderr.splitlines() if "CONSOLE" in line]
    assert not messages, f"{film}: " + "\n".join(messages)


def check_playing(folder, film, last):
    iterations = []
    for milliseconds in (1, 60000):
        browser = chromium(folder, film, "--dump-dom", f"--virtual-time-budget={milliseconds}")
        check_console(browser, film)
        assert 'id="problem" role="alert" hidden' in browser.stdout, "a problem is shown"
        iterations.append(shown(browser.stdout, "iteration"))
        length = shown(browser.stdout, "length")
    assert iterations[0] < iterations[1] == last, f"iterations {iterations}, {last} is the last"
    assert length > 0
    print(f"{film.name}: played from iteration {iterations[0]} to {iterations[1]}")


def check_screen(folder, film, has_domain):
    screen = folder / "screen.png"
    check_console(chromium(folder, film, f"--screenshot={screen}", "--virtual-time-budget=60000"),
                  film)
    rows = pixels(screen)[:HEIGHT - 160]  # without the controls
    colors = [color for row in rows for color in row]
    red = sum(r > g + 60 and r > b + 60 for r, g, b in colors) / len(colors)
    ground = max(set(colors), key=colors.count)
    glass = sum(30 > b - r > 3 for r, _, b in colors) / len(colors)
    print(f"{film.name}: {100 * red:.1f} % curve, {100 * glass:.1f} % glass on {ground}")
    assert 0.005 < red < 0.5, "the curve is not to be seen"
    assert glass > 0.02 if has_domain else glass < 0.002, "the domain"


# What a user does with keys, mouse and sliders, after the film has been stopped.
USER = """
const press = (key, target = document) =>
  target.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
const set = (id, value) => {
  document.getElementById(id).value = value;
  document.getElementById(id).dispatchEvent(new Event("input"));
};
const canvas = document.getElementById("scene");
canvas.setPointerCapture = () => {}; // there is no real pointer
const point = (kind, clientX, clientY) =>
  canvas.dispatchEvent(new PointerEvent(kind, {pointerId: 1, clientX, clientY}));
press(" ");
"""


def with_user(folder, film, actions):
    page = folder / f"{film.stem}_with_user.html"
    page.write_text(film.read_text().replace("</body>", f"<script>{USER}{actions}</script></body>"))
    return page


def check_controls(folder, film, iterations):
    for actions, frame in (("", 0), ('press("."); press("."); press(",")', 1), ('set("frame", 2)', 2),
                           ('document.getElementById("play").click()', len(iterations) - 1)):
        page = with_user(folder, film, actions)
        browser = chromium(folder, page, "--dump-dom", "--virtual-time-budget=60000")
        check_console(browser, page)
        iteration = shown(browser.stdout, "iteration")
        assert iteration == iterations[frame], f"{actions}: iteration {iteration}"
    print(f"{film.name}: space, comma, point, the button and the slider do what they should")


def red_pixels(folder, film, actions):
    page, screen = with_user(folder, film, actions), folder / "screen.png"
    check_console(chromium(folder, page, f"--screenshot={screen}", "--virtual-time-budget=5000"),
                  page)
    return {(x, y) for y, row in enumerate(pixels(screen)) for x, (r, g, b) in enumerate(row)
            if r > g + 60 and r > b + 60}


def check_view(folder, film):
    still = red_pixels(folder, film, "")
    for actions in ('press("ArrowLeft", canvas); press("ArrowUp", canvas)',
                    'point("pointerdown", 9, 9); point("pointermove", 99, 59); point("pointerup", 99, 59)'):
        turned = red_pixels(folder, film, actions)
        assert len(still ^ turned) > 0.3 * len(still), f"{actions}: nothing turns"
    for actions in ('for (let k = 0; k < 5; ++k) press("+")', 'set("tube", 1)',
                    'canvas.dispatchEvent(new WheelEvent("wheel", {deltaY: -300}))'):
        larger = red_pixels(folder, film, actions)
        assert len(larger) > 1.2 * len(still), f"{actions}: nothing grows"
    print(f"{film.name}: it turns, zooms, and has a tube of any radius")


def main():
    if not os.path.exists(VFC):
        skip("there is no program vfc")
    if not shutil.which("chromium"):
        skip("there is no chromium")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "domain.off").write_text(OCTAHEDRON)
        frames, film = folder / "frames", folder / "film.html"
        vfc("generate", "torus-knot", "-o", f"{folder}/knot.obj")
        vfc("untangle", f"{folder}/knot.obj", "--frames", str(frames), "--strategy", "flow")
        drawn = vfc("draw", "--film", str(frames), "-o", str(film))
        if "libjs-three" in drawn.stderr:
            skip("there is no three.js")
        assert drawn.returncode == 0, drawn.stderr
        iterations = sorted(int(frame.stem.split("_")[1]) for frame in frames.iterdir())
        check_playing(folder, film, iterations[-1])
        check_controls(folder, film, iterations)
        check_view(folder, film)
        check_screen(folder, film, has_domain=False)

        frames, film = folder / "filling", folder / "filling.html"
        vfc("fill", f"{folder}/domain.off", "--thickness", "0.25", "--frames", str(frames),
            "--every", "10")
        drawn = vfc("draw", "--film", str(frames), f"{folder}/domain.off", "-o", str(film))
        assert drawn.returncode == 0, drawn.stderr
        check_screen(folder, film, has_domain=True)


main()
