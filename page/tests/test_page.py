# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The live page that scripts/page has made: its core in node, against the one compiled natively, and
the page itself in a browser, opened from the disk, with mouse and keys."""

import json
import math
import pathlib
import re
import shutil
import subprocess
import tempfile
import time
import unittest

from browser import Browser

FOLDER = pathlib.Path(__file__).resolve().parent
PACKAGE = FOLDER.parent.parent
CORE, NATIVE = PACKAGE / "build-page/core.js", PACKAGE / "build-page/native/native"
PAGE = PACKAGE / "out/page.html"
TORUS = PACKAGE / "data/torus.off"
# Drawn by hand, and with enough iterations for every sum to be rounded many times.
KNOTS = [PACKAGE / "data/hard_unknot.obj", PACKAGE.parent / "shared/data/paper/ochiai1.obj"]

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


def drive(*arguments):
    """What the core in WebAssembly says. Without fetch, which emscripten takes for a browser's."""
    command = ["node", "--no-experimental-fetch", FOLDER / "drive.js", CORE, *arguments]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


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
        files = [self.folder / name for name in ("curve.cert", "start.obj", "curve.obj")]
        verdict = native("verify", *files)
        self.assertEqual(verdict.returncode, 0, verdict.stdout)
        wrong = native("verify", files[0], files[1], files[1])
        self.assertEqual(wrong.returncode, 1, "it proves nothing")


@unittest.skipUnless(shutil.which("node"), "there is no node")
class The_core(In_folder):
    def test_has_the_bits_of_native_code(self):
        for knot in filter(pathlib.Path.exists, KNOTS):
            with self.subTest(knot.name):
                ours, theirs = self.folder / "wasm.obj", self.folder / "native.obj"
                drive("steps", knot, "30", ours)
                self.assertEqual(native("steps", knot, "30", theirs).returncode, 0)
                self.assertEqual(coordinates(ours), coordinates(theirs))
                self.assertNotEqual(coordinates(ours), coordinates(knot))

    def test_fills_with_the_bits_of_native_code(self):
        for ratio in ("1", "2.5"):
            with self.subTest(ratio):
                seen = drive("fill", TORUS, "0.05", ratio, self.folder)
                theirs = self.folder / "native.obj"
                done = native("fill", TORUS, repr(seen["asked"]), ratio, theirs)
                self.assertEqual(done.returncode, 0)
                self.assertEqual(coordinates(self.folder / "curve.obj"), coordinates(theirs))
                self.assertEqual(seen["status"], "converged")
                self.assertGreater(seen["withinThickness"], 0.7)
                self.assertEqual(seen["stages"], ["preparing", "branching", "flowing", "measuring"])
                self.assertLess(seen["nodes"][0], 20)  # a circle, whose branches are seen to grow
                self.assertGreater(len(set(seen["nodes"])), 10)
                self.check_certificate()

    def test_pulls_no_ring_through_another(self):
        seen = drive("pull", self.folder)
        self.assertEqual(abs(seen["before"]), 1)
        self.assertEqual(seen["after"], seen["before"])
        self.assertGreater(seen["refused"], 100)
        self.assertGreater(seen["gone"], 0.05)  # up to the other ring
        self.assertLess(seen["gone"], seen["asked"] / 2)
        self.check_certificate()

    def test_certifies_all_that_a_user_does(self):
        seen = drive("play", self.folder)
        before, after_steps, after_undo, again = seen["lengths"]
        self.assertLess(after_steps, before)
        self.assertEqual(after_undo, before)
        self.assertEqual(again, after_steps)
        self.assertEqual(seen["before"]["name"], seen["after"]["name"])
        self.assertEqual(seen["after"]["name"], "5_2")
        self.check_certificate()


@unittest.skipUnless(shutil.which("chromium"), "there is no chromium")
class The_page(In_folder):
    def setUp(self):
        super().setUp()
        self.browser = Browser(self.folder)
        self.addCleanup(self.browser.close)

    def open(self, width=1400, height=900):
        self.browser.open(PAGE, width, height)
        self.browser.wait("typeof picture !== 'undefined' && picture !== null")

    def choose(self, name):
        self.browser.value(f"element('knot').value = '{name}'; loadChoice()")
        self.browser.wait("picture && picture.number === number && !view.isMoving")

    def slide(self, name, value):
        self.browser.value(f"element('{name}').value = {value}; "
                           f"element('{name}').dispatchEvent(new Event('input', {{bubbles: true}}))")

    def open_domain(self, name):
        self.open()
        self.browser.value(f"element('knot').value = 'Domains to fill/{name}'; loadChoice()")
        self.browser.wait("domain !== null && domain.number === number")

    def tubes(self):
        """What is drawn of the curve, as a checksum of the positions of its triangles."""
        return self.browser.value("""scene.meshes.reduce((sum, {geometry}) =>
          sum + geometry.attributes.position.array.reduce((a, x, k) => a + x * (k % 7), 0), 0)""")

    def number(self, name):
        return float(self.browser.value(f"element('{name}').textContent"))

    def check_calm(self):
        self.assertEqual(self.browser.complaints, [])

    def saved(self, button, name):
        self.browser.click(button)
        file, end = self.folder / name, time.monotonic() + 300
        while not file.exists():
            self.assertLess(time.monotonic(), end, f"{name} is not saved")
            time.sleep(0.05)
        return file

    def test_is_one_file_below_three_megabytes(self):
        self.assertLess(PAGE.stat().st_size, 3e6)
        self.assertIsNone(re.search(r'(src|href)="', PAGE.read_text()))

    def test_untangles_names_and_undoes(self):
        self.open()
        self.choose("Prime knots/5_2")
        self.browser.wait("element('name').textContent === '5_2 (proved)'")
        self.browser.wait("element('proof').textContent === 'knotted by determinant'")
        length = self.number("length")
        self.browser.click("run")
        self.browser.wait("element('message').textContent === 'The curve is tight.'")
        self.browser.wait(f"Number(element('length').textContent) < {length}")
        self.browser.click("undo")
        self.browser.wait(f"element('length').textContent == {length}")
        self.choose("Unknots/Hard unknot")
        self.browser.click("search")
        self.browser.wait("element('message').textContent.includes('certified')")
        self.browser.wait("picture.isProved && element('proof').textContent === 'unknotted'")
        self.check_calm()

    def test_refuses_to_pull_a_ring_through_another(self):
        self.open()
        self.choose("Links/Hopf link")
        self.browser.wait("element('crossings').textContent === '2'")
        x, y, far_x, far_y = self.browser.value(STRANDS_AT_ONE_DEPTH)
        self.browser.mouse("mousePressed", x, y)
        for k in range(1, 41):
            self.browser.mouse("mouseMoved", x + k * (far_x - x) / 40, y + k * (far_y - y) / 40)
        self.browser.wait("scene.canvas.classList.contains('refused')")
        self.assertIn("Refused", self.browser.value("element('message').textContent"))
        self.browser.mouse("mouseReleased", far_x, far_y)
        self.browser.wait("picture.held < 0 && !scene.canvas.classList.contains('refused')")
        for button, name in (("save-start", "start.obj"), ("save-curve", "curve.obj"),
                             ("save-certificate", "curve.cert")):
            self.saved(button, name)
        self.check_certificate()
        self.assertEqual(self.saved("save-picture", "curve.png").read_bytes()[1:4], b"PNG")
        self.check_calm()

    def test_fills_a_domain_before_ones_eyes(self):
        self.open_domain("Torus")
        self.slide("filling-thickness", -4.4)
        self.slide("bend", 0)
        self.slide("ratio", 1)
        self.assertEqual(self.browser.value("element('ratio-value').textContent"), "1 : 2")
        self.browser.click("fill")
        self.browser.wait("grown !== null && isFilling && element('save-curve').disabled")
        self.browser.wait("!isFilling && !grown.isWaiting && element('status').textContent === 'converged'")
        self.assertGreater(float(self.browser.value("element('within').textContent").rstrip(" %")), 70)
        self.assertEqual(self.number("strands"), 1)
        self.assertGreater(self.number("filling-length"), 10)
        self.assertGreater(self.number("bend-radius"), 0)
        for end, factor in (("low", 2 / 3), ("high", 4 / 3)):  # of the thickness in the middle
            corner = f"[...domain.low].map((x) => x + {int(end == 'high')} * domain.side)"
            self.assertAlmostEqual(self.browser.value(f"thicknessAt({corner})"), factor * 2 ** -4.4)
        tubes = self.tubes()
        self.slide("tube", -1)
        self.browser.wait("!scene.isWaiting")
        self.assertNotEqual(self.tubes(), tubes)
        self.slide("glass", 0)
        self.assertFalse(self.browser.value("scene.domain.visible"))
        self.slide("glass", 0.4)
        self.assertEqual(self.browser.value("scene.domain.material.opacity"), 0.4)
        for button, name in (("save-start", "start.obj"), ("save-curve", "curve.obj"),
                             ("save-certificate", "curve.cert")):
            self.saved(button, name)
        self.check_certificate()
        self.choose("Prime knots/3_1")
        self.assertTrue(self.browser.value("domain === null && scene.domain === null"))
        self.check_calm()

    def test_rounds_bends_and_stops(self):
        self.open_domain("Frame")
        self.slide("filling-thickness", -5.5)
        self.browser.value("scene.canvas.focus()")
        self.browser.press(" ")
        self.browser.wait("grown !== null && isFilling")
        self.browser.value("startWorker(); kept = null; stopFilling()")  # before a state is kept
        self.assertEqual(self.browser.value("element('status').textContent"), "stopped")
        self.assertTrue(self.browser.value("element('save-curve').disabled"))
        self.slide("filling-thickness", -4)
        self.slide("bend", 1.5)  # more than the thickness, which it raises
        self.assertEqual(self.number("filling-thickness-value"), self.number("bend-value"))
        raised = self.browser.value("(grown = {settings: settings()}, thicknessAt(domain.low))")
        self.assertAlmostEqual(raised, self.browser.value("settings().bendRadius"))
        self.slide("bend", 0.8)
        self.browser.click("fill")
        self.browser.wait("!isFilling && element('status').textContent !== 'stopped'")
        required = self.number("bend-value")
        if self.browser.value("element('status').textContent") == "converged":
            self.assertGreater(self.number("bend-radius"), 0.99 * required)
        self.assertGreater(self.number("bend-radius"), 0.5 * required)
        self.check_calm()

    def test_keeps_the_curve_of_a_filling_that_is_stopped(self):
        self.open_domain("Knotted tube")
        self.slide("filling-thickness", -6)
        self.browser.click("fill")
        self.browser.wait("kept !== null")
        self.browser.click("fill")
        self.browser.wait("element('status').textContent === 'interrupted' && !grown.isWaiting")
        self.assertGreater(self.number("filling-length"), 1)
        for button, name in (("save-start", "start.obj"), ("save-curve", "curve.obj"),
                             ("save-certificate", "curve.cert")):
            self.saved(button, name)
        self.check_certificate()
        nodes = len(coordinates(self.folder / "curve.obj"))
        self.assertEqual(self.number("filling-nodes"), nodes)
        self.assertGreater(nodes, len(coordinates(self.folder / "start.obj")))
        self.assertIn("can be saved", self.browser.value("element('message').textContent"))
        self.slide("bend", 0)
        self.slide("filling-thickness", -4)
        self.assertIn("press Fill", self.browser.value("element('message').textContent"))
        self.browser.click("fill")
        self.browser.wait("!isFilling && grown !== null && !grown.isWaiting")
        self.assertGreater(float(self.browser.value("element('within').textContent").rstrip(" %")), 50)
        self.check_calm()

    def test_opens_files_and_says_what_is_wrong_with_them(self):
        self.open()
        square = "v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 1\\nl 1 2 3 4 1\\n"
        self.browser.value(f"openFile(new File(['{square}'], 'square.obj'))")
        self.browser.wait("picture.number === number && element('name').textContent === '0_1 (proved)'")
        self.browser.value("openFile(new File(['v 0 0 0\\nv 1 0 x\\n'], 'bad.obj'))")
        self.browser.wait("element('message').textContent.includes(\"line 2: 'x' is not a number\")")
        self.browser.value("showPicture(picture)")
        self.assertIn("line 2", self.browser.value("element('message').textContent"))
        self.assertEqual(self.browser.value("element('name').textContent"), "0_1 (proved)")
        three_faces = "OFF\\n4 3 0\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n3 0 2 1\\n3 0 1 3\\n3 1 2 3\\n"
        self.browser.value(f"openFile(new File(['{three_faces}'], 'open.off'))")
        self.browser.wait("element('message').textContent.includes('closed')")
        twisted = three_faces.replace("3 0 1 3", "3 1 0 3")
        self.browser.value(f"openFile(new File(['{twisted}'], 'twisted.off'))")
        self.browser.wait("element('message').textContent.startsWith('faces 0 and 1 have opposite')")
        unknown = "v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nv 0 0 1\\nf 1 3 2\\nf 1 2 4\\nf 2 3 10\\n"
        for name, faces, sentence in (
                ("off", three_faces.replace("1 2 3", "1 2 9"), "line 9, face 2: there is no vertex 9"),
                ("obj", unknown, "face 2 has vertex 9, but the file has 4 vertices")):
            self.browser.value(f"openFile(new File(['{faces}'], 'unknown.{name}'))")
            self.browser.wait(f"element('message').textContent.startsWith('{sentence}')")
        self.assertTrue(self.browser.value("domain === null"))
        tetrahedron = three_faces.replace("4 3 0", "4 4 0") + "3 2 0 3\\n"
        self.browser.value(f"openFile(new File(['{tetrahedron}'], 'tetrahedron.OFF'))")
        self.browser.wait("domain !== null && domain.triangles.length === 12")

    def test_steps_once_and_changes_the_thickness(self):
        self.open()
        self.choose("Prime knots/3_1")
        length = self.number("length")
        self.browser.click("step")
        self.browser.wait(f"Number(element('length').textContent) < {length} && !picture.isRunning")
        length = self.number("length")
        self.browser.value("element('run').focus()")  # as after a click
        self.browser.press(".")
        self.browser.wait(f"Number(element('length').textContent) < {length} && !picture.isRunning")
        thickness = self.browser.value("picture.thickness")
        self.slide("thickness", -1)
        self.browser.wait(f"Math.abs(picture.thickness / {thickness} - 0.5) < 1e-6")
        tubes = self.tubes()
        self.slide("tube", 1)
        self.assertNotEqual(self.tubes(), tubes)
        self.check_calm()

    def test_turns_and_zooms_by_keys_and_by_wheel(self):
        self.open()
        self.browser.value("scene.canvas.focus()")
        view = "[scene.azimuth, scene.elevation, scene.distance]"
        azimuth, elevation, distance = self.browser.value(view)
        for key in ("ArrowRight", "ArrowUp", "+"):
            self.browser.press(key)
        turned = self.browser.value(view)
        self.assertNotEqual(turned[0], azimuth)
        self.assertNotEqual(turned[1], elevation)
        self.assertLess(turned[2], distance)
        self.browser.press("-")
        self.assertAlmostEqual(self.browser.value("scene.distance"), distance)
        self.check_calm()

    def test_takes_knots_that_are_drawn(self):
        turns = [2 * math.pi * k / 90 for k in range(90)]
        trefoil = [(500 + 100 * (math.sin(t) + 2 * math.sin(2 * t)),
                    430 - 100 * (math.cos(t) - 2 * math.cos(2 * t))) for t in turns]
        self.open()
        for is_exchanged, names in ((False, ("3_1", "3_1*")), (True, ("0_1",))):
            self.browser.click("draw")
            self.assertEqual(self.browser.value("element('run').clientHeight"), 0)
            self.browser.mouse("mousePressed", *trefoil[0])
            for point in trefoil:
                self.browser.mouse("mouseMoved", *point)
            self.browser.mouse("mouseReleased", *trefoil[-1])
            crossings = self.browser.value("drawing.crossings.map((c) => c.point)")
            self.assertEqual(len(crossings), 3)
            if is_exchanged:
                self.browser.mouse("mousePressed", *crossings[0])
                self.browser.mouse("mouseReleased", *crossings[0])
            self.browser.click("draw")
            self.browser.wait("shownNumber === number && element('name').textContent !== '\u2026'")
            name = self.browser.value("element('name').textContent")
            self.assertIn(name, [f"{name} (proved)" for name in names])
            self.assertEqual(self.browser.value("element('knot').selectedOptions[0].text"), "your own")
        self.browser.click("draw")
        self.choose("Prime knots/3_1")
        self.assertFalse(self.browser.value("drawing.isOn"))
        self.assertGreater(self.browser.value("element('run').clientHeight"), 0)
        self.check_calm()

    def test_can_be_used_with_fingers(self):
        self.open(400, 800)
        self.choose("Links/Hopf link")
        x, y, *_ = self.browser.value(STRANDS_AT_ONE_DEPTH)
        self.browser.touch("touchStart", (x, y))
        self.browser.wait("picture.held >= 0")
        length = self.number("length")
        self.browser.touch("touchMove", (x + 30, y))
        self.browser.wait(f"Number(element('length').textContent) !== {length}")
        self.browser.touch("touchEnd")
        self.browser.wait("picture.held < 0")
        azimuth, distance = self.browser.value("[scene.azimuth, scene.distance]")
        self.browser.touch("touchStart", (5, 5))
        self.browser.touch("touchMove", (65, 5))
        self.browser.touch("touchEnd")
        self.browser.wait(f"scene.azimuth !== {azimuth}")
        self.browser.touch("touchStart", (5, 5), (5, 105))
        self.browser.touch("touchMove", (5, 5), (5, 205))
        self.browser.touch("touchEnd")
        self.browser.wait(f"scene.distance < {distance}")
        self.check_calm()

    def test_can_be_used_on_a_phone_and_with_keys(self):
        self.open(400, 800)
        self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), 400)
        self.assertGreater(self.browser.value("scene.canvas.clientHeight"), 300)
        self.choose("Prime knots/3_1")
        self.browser.value("scene.canvas.focus()")
        self.browser.press("n")
        self.browser.wait("picture.held >= 0")
        length = self.number("length")
        self.browser.value("""scene.canvas.dispatchEvent(
          new KeyboardEvent("keydown", {key: "ArrowUp", shiftKey: true, bubbles: true}))""")
        self.browser.wait(f"Number(element('length').textContent) !== {length}")
        self.browser.press("Escape")
        self.browser.wait("picture.held < 0")
        self.browser.press(" ")
        self.browser.wait("element('message').textContent === 'The curve is tight.'")
        self.browser.value("element('knot').value = 'Domains to fill/Knotted tube'; loadChoice()")
        self.browser.wait("domain !== null")
        self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), 400)
        self.assertGreater(self.browser.value("scene.canvas.clientHeight"), 300)
        self.check_calm()


if __name__ == "__main__":
    unittest.main()
