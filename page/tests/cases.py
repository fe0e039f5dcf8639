# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What the tests of the live page share: the files that scripts/page makes, certificates, and the page in a
browser, opened from the disk, with mouse and keys."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PACKAGE / "test/Volume_filling_curves/support"))
from browser import Browser

BUILD = PACKAGE / "build-page"
NATIVE = BUILD / "native/native"
PAGE = PACKAGE / "out/page.html"

# A node of the first ring that can be seen, and a point of the screen beyond the nearest node of the
# other one at the same distance from the viewer.
STRANDS_AT_ONE_DEPTH = """(() => {
  const box = scene.canvas.getBoundingClientRect(), n = picture.strands[0];
  const ends = [...Array(2 * n).keys()].map((v) => {
    const p = new THREE.Vector3(...nodeOf(v)).project(scene.camera);
    return {v, x: (p.x + 1) / 2 * box.width, y: (1 - p.y) / 2 * box.height, z: p.z}; });
  const isSeen = (p) => nodeBelow({clientX: p.x, clientY: p.y}).join() === nodeOf(p.v).join();
  let best = null, least = Infinity;
  for (const p of ends.slice(0, n).filter(isSeen))
    for (const q of ends.slice(n))
      if (Math.abs(p.z - q.z) < least) [best, least] = [[p, q], Math.abs(p.z - q.z)];
  const [p, q] = best;
  return [p.x, p.y, p.x + 3 * (q.x - p.x), p.y + 3 * (q.y - p.y)]; })()"""


def native(*arguments):
    return subprocess.run([NATIVE, *arguments], capture_output=True, text=True)


def coordinates(obj):
    return [tuple(map(float, line.split()[1:]))
            for line in obj.read_text().splitlines() if line.startswith("v ")]


class In_folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check_certificate(self):
        """That of the curve in the folder."""
        files = [self.folder / name for name in ("curve.cert", "start.obj", "curve.obj")]
        verdict = native("verify", *files)
        self.assertEqual(verdict.returncode, 0, verdict.stdout)
        wrong = native("verify", files[0], files[1], files[1])
        self.assertEqual(wrong.returncode, 1, "it proves nothing")


@unittest.skipUnless(shutil.which("chromium"), "there is no chromium")
class On_page(In_folder):
    # One browser for all tests of a class: its start takes 4 CPU s, more than the rest of a test.
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()
        cls.addClassCleanup(cls.browser.close)

    def setUp(self):
        super().setUp()
        self.browser.open_tab(self.folder)
        self.addCleanup(self.browser.close_tab)

    # Small, since without a graphics card drawing takes most of the time.
    def open(self, width=900, height=600):
        self.browser.open(PAGE, width, height)
        self.browser.wait("typeof picture !== 'undefined' && picture !== null")

    def choose(self, name):
        self.browser.value(f"element('knot').value = {json.dumps(name)};"
                           "element('knot').dispatchEvent(new Event('change'))")
        self.browser.wait("(picture ? picture.number : domain ? domain.number : 0) === number && !view.isMoving")

    def open_content(self, name, content):
        """Opens a file of a curve with this name and content."""
        number = self.browser.value("number")
        self.browser.value(f"openFile(new File([{json.dumps(content)}], '{name}'))")
        self.browser.wait(f"picture && picture.number > {number}")

    def slide(self, name, value):
        self.browser.value(f"element('{name}').value = {value}; "
                           f"element('{name}').dispatchEvent(new Event('input', {{bubbles: true}}))")

    def open_domain(self, name):
        self.open()
        self.choose("Domains to fill/" + name)

    def tubes(self):
        """What is drawn of the curve, as a checksum of the positions of its triangles."""
        return self.browser.value("""scene.meshes.reduce((sum, {geometry}) =>
          sum + geometry.attributes.position.array.reduce((a, x, k) => a + x * (k % 7), 0), 0)""")

    def text(self, name):
        return self.browser.value(f"element('{name}').textContent")

    def number(self, name):
        return float(self.text(name))

    def wait_until_tight(self, length):
        """Waits for the picture of the tight curve, which is shorter than this. It comes after the message;
        until then the page may still show the curve before the run, which does not run either."""
        self.wait_for_message("The curve is tight.")
        self.browser.wait(f"!picture.isRunning && Number(element('length').textContent) < {length}")

    def wait_for_message(self, part):
        self.browser.wait(f"element('message').textContent.includes({json.dumps(part)})")

    def check_calm(self):
        self.assertEqual(self.browser.complaints, [])

    def saved(self, button, name):
        self.browser.click(button)
        file, end = self.folder / name, time.monotonic() + 300
        while not file.exists():
            self.assertLess(time.monotonic(), end, f"{name} is not saved")
            time.sleep(0.05)
        return file

    def check_saved_curve(self):
        for button, name in (("save-start", "start.obj"), ("save-curve", "curve.obj"),
                             ("save-certificate", "curve.cert")):
            self.saved(button, name)
        self.check_certificate()
