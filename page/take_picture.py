#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""take_picture.py PICTURE: the picture of the live page for the README, in which a ring of the Hopf
link is pulled against the other one, and refuses. Takes out/page.html, and a Chromium."""

import pathlib
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "tests"))
from cases import PAGE, STRANDS_AT_ONE_DEPTH, Browser  # noqa: E402

MOTIONS = 200  # small ones, since the picture is taken at the first refusal


def pull_until_refused(browser):
    x, y, far_x, far_y = browser.value(STRANDS_AT_ONE_DEPTH)
    browser.mouse("mousePressed", x, y)
    for k in range(1, MOTIONS + 1):
        browser.mouse("mouseMoved", x + k * (far_x - x) / MOTIONS, y + k * (far_y - y) / MOTIONS)
        time.sleep(0.05)
        if browser.value("picture.isRefused"):
            return
    raise AssertionError("no motion is refused")


def main():
    with tempfile.TemporaryDirectory() as folder:
        browser = Browser()
        browser.open_tab(folder)
        browser.open(PAGE, 1100, 640)
        browser.wait("typeof picture !== 'undefined' && picture !== null")
        browser.value("element('knot').value = 'Links/Hopf link'; loadChoice()")
        browser.wait("picture.number === number && element('crossings').textContent === '2'")
        browser.value("element('tube').value = -0.6; element('tube').dispatchEvent(new Event('input'))")
        browser.wait("!view.isMoving")
        pull_until_refused(browser)
        time.sleep(1)  # the proof and the message are drawn
        browser.save_picture(pathlib.Path(sys.argv[1]))
        browser.close()


main()
