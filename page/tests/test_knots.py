# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Knots on the live page."""

import math
import unittest

from cases import STRANDS_AT_ONE_DEPTH, On_page, coordinates, native

ROPELENGTH_OF_TREFOIL = 32.743  # the best known one, over the radius


class Knots(On_page):
    def test_untangles_names_and_undoes(self):
        self.open()
        self.choose("Prime knots/5_2")
        self.browser.wait("element('name').textContent === '5_2 (proved)'")
        self.browser.wait("element('proof').textContent === 'knotted by determinant'")
        length = self.number("length")
        self.browser.click("run")
        self.wait_until_tight(length)
        self.browser.click("undo")
        self.browser.wait(f"element('length').textContent == {length}")
        self.assertEqual(self.text("message"), "")
        self.choose("Unknots/Hard unknot")
        self.browser.click("search")
        self.wait_for_message("certified")
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
        self.check_saved_curve()
        self.assertEqual(self.saved("save-picture", "curve.png").read_bytes()[1:4], b"PNG")
        self.check_calm()

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

    def test_shows_what_it_measures(self):
        self.open()
        self.choose("Prime knots/3_1")
        length = self.number("length")
        self.browser.click("run")
        self.wait_until_tight(length)
        self.assertAlmostEqual(self.number("ropelength"), ROPELENGTH_OF_TREFOIL, delta=0.2 * ROPELENGTH_OF_TREFOIL)
        self.assertEqual(self.number("nodes"), len(coordinates(self.saved("save-curve", "curve.obj"))))
        self.assertEqual(self.number("crossings"), 3)
        self.check_calm()

    def test_runs_until_the_same_button_pauses_it(self):
        self.open()
        self.choose("Prime knots/10_165")
        self.slide("thickness", -2)  # which makes a long run
        self.browser.click("run")
        self.browser.wait("picture.isRunning && element('run').textContent.endsWith('Pause')")
        self.browser.click("run")
        self.browser.wait("!picture.isRunning && element('run').textContent.endsWith('Run')")
        length = self.number("length")
        self.browser.click("step")
        self.browser.wait(f"Number(element('length').textContent) < {length}")
        self.check_calm()

    def test_disturbs_no_search(self):
        self.open()
        self.choose("Prime knots/10_165")
        self.browser.value("showPicture({...picture, isSearching: true})")  # a search can be too short to see
        self.assertTrue(self.text("run").endswith("Stop"))
        for name in ("step", "search", "thickness"):
            self.assertTrue(self.browser.value(f"element('{name}').disabled"), name)
        self.browser.value("showPicture({...picture, isSearching: false})")
        self.browser.value("""element('search').click(); // and the others, as if they were still enabled
          ask('step'); ask('search', {seed: 1}); ask('step')""")
        self.wait_for_message("Search finished. The simpler curve is certified")
        self.browser.wait("!picture.isSearching")
        self.assertFalse(self.browser.value("element('step').disabled"))
        self.check_saved_curve()
        self.browser.click("undo")
        self.browser.wait("element('undo').disabled")  # the search was all there was to undo
        self.check_calm()

    def test_adopts_what_a_stopped_search_has_found(self):
        self.open()
        self.choose("Unknots/Another tangle")
        length, nodes = self.number("length"), self.number("nodes")
        self.browser.value("element('search').click(); element('run').click()")
        self.wait_for_message("Search stopped. The curve so far is certified")
        self.browser.wait(f"!picture.isSearching && Number(element('nodes').textContent) < {nodes / 2}")
        self.assertAlmostEqual(self.number("length"), length, delta=1e-3 * length)
        low, high = self.browser.value("corners(picture.coordinates)")
        self.assertGreater(self.browser.value("scene.size"), 0.6 * math.dist(low, high))  # all of it is seen
        self.check_saved_curve()
        self.browser.click("undo")
        self.browser.wait(f"element('nodes').textContent == {int(nodes)}")
        self.assertEqual(self.number("length"), length)
        self.assertTrue(self.browser.value("element('undo').disabled"))
        self.check_calm()

    def test_undoes_pulls_but_no_touches(self):
        self.open()
        self.choose("Links/Hopf link")
        x, y, *_ = self.browser.value(STRANDS_AT_ONE_DEPTH)
        length = self.number("length")
        self.browser.mouse("mousePressed", x, y)
        self.browser.wait("picture.held >= 0")
        self.browser.mouse("mouseReleased", x, y)
        self.browser.wait("picture.held < 0")
        self.assertTrue(self.browser.value("element('undo').disabled"))
        for modifier in ("Ctrl", "Meta", None):
            x, y, *_ = self.browser.value(STRANDS_AT_ONE_DEPTH)
            self.browser.drag((x, y), (x + 20, y), (x + 40, y))
            self.browser.wait(f"picture.held < 0 && Number(element('length').textContent) !== {length}")
            self.assertFalse(self.browser.value("element('undo').disabled"))
            self.browser.press("z", modifier)
            self.browser.wait(f"element('length').textContent == {length} && !view.isMoving")
            self.assertTrue(self.browser.value("element('undo').disabled"))
        self.browser.click("step")  # which an undone pull must not leave without the held node
        self.browser.wait(f"Number(element('length').textContent) < {length}")
        self.check_saved_curve()
        self.check_calm()

    def test_keeps_two_rings_linked_in_200_drags(self):
        self.open()
        self.choose("Links/Hopf link")
        self.browser.value("scene.meshes.forEach((mesh) => mesh.visible = false)")  # to save the time of drawing
        self.browser.value("""(refusals = 0, new MutationObserver(() => refusals += picture.isRefused)
          .observe(scene.canvas, {attributes: true, attributeFilter: ["class"]}))""")
        for _ in range(200):
            x, y, far_x, far_y = self.browser.value(STRANDS_AT_ONE_DEPTH)
            self.browser.drag((x, y), ((x + far_x) / 2, (y + far_y) / 2), (far_x, far_y))
        self.browser.wait("picture.held < 0 && refusals > 10")
        self.check_saved_curve()
        start, end = (int(native("linking", self.folder / name).stdout) for name in ("start.obj", "curve.obj"))
        self.assertEqual(abs(start), 1)
        self.assertEqual(end, start)
        self.check_calm()

    def check_thickness(self):
        """The slider and the number beside it are those of the curve."""
        self.browser.wait("picture.thicknessRequest === thicknessRequest && !picture.isSearching")
        thickness, ratio, shown, slid = self.browser.value(
            """[picture.thickness * picture.unit, picture.thicknessFactor,
                Number(element("thickness-value").textContent), element("thickness").valueAsNumber]""")
        self.assertAlmostEqual(shown, thickness, delta=0.01 * thickness)
        self.assertAlmostEqual(slid, min(max(math.log2(ratio), -2), 2), delta=0.06)

    def test_shows_the_thickness_that_the_curve_has(self):
        self.open()
        self.choose("Prime knots/3_1")
        self.check_thickness()
        self.slide("thickness", -0.5)
        self.browser.click("run")
        self.slide("thickness", -1)  # also while it runs
        self.check_thickness()
        self.wait_for_message("The curve is tight.")
        self.browser.wait("!picture.isRunning")
        self.assertAlmostEqual(self.browser.value("picture.thicknessFactor"), 0.5)
        self.slide("thickness", -2)
        self.check_thickness()
        self.browser.click("undo")
        self.browser.wait("element('undo').disabled && element('thickness').valueAsNumber === -0.5")
        self.check_thickness()
        self.browser.click("search")
        self.wait_for_message("Search finished")
        self.browser.wait("element('thickness').valueAsNumber === 0")  # it is measured anew
        self.check_thickness()
        turns = [2 * math.pi * k / 400 for k in range(400)]
        nodes = "".join(f"v {math.cos(t)} {0.004 * math.sin(t)} 0\n" for t in turns)
        self.open_content("flat.obj", f"{nodes}l {' '.join(map(str, range(1, 401)))} 1\n")
        self.assertEqual(self.browser.value("element('thickness').valueAsNumber"), 0)
        self.slide("thickness", -2)
        self.browser.click("run")
        self.browser.wait("element('thickness').valueAsNumber > 0")  # which is raised for a loose ring
        self.browser.wait("!picture.isRunning")
        self.check_thickness()
        self.check_calm()


if __name__ == "__main__":
    unittest.main()
