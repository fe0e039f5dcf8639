# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The live page itself: its size, views, fingers, phones and keys."""

import re
import unittest

from cases import BUILD, PAGE, STRANDS_AT_ONE_DEPTH, On_page


class Page(On_page):
    def test_is_one_file_below_three_megabytes(self):
        self.assertLess(PAGE.stat().st_size, 3e6)
        self.assertIsNone(re.search(r'(src|href)="', PAGE.read_text()))

    def test_turns_and_zooms_by_keys_and_by_wheel(self):
        self.open()
        self.browser.value("scene.canvas.focus()")
        view = "[scene.azimuth, scene.elevation, scene.distance]"
        azimuth, elevation, distance = self.browser.value(view)
        for key in ("ArrowRight", "ArrowUp", "+"):
            self.browser.press(key)
        turned = self.browser.value(view)
        self.assertLess(turned[0], azimuth)
        self.assertGreater(turned[1], elevation)
        self.assertLess(turned[2], distance)
        for key in ("ArrowLeft", "ArrowDown", "-"):
            self.browser.press(key)
        for value, former in zip(self.browser.value(view), (azimuth, elevation, distance)):
            self.assertAlmostEqual(value, former)
        self.browser.wheel(300, 300, 100)
        self.browser.wait(f"scene.distance > 1.1 * {distance}")
        self.browser.wheel(300, 300, -100)
        self.browser.wait(f"Math.abs(scene.distance - {distance}) < 1e-6")
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

    def test_turns_when_the_mouse_drags_beside_the_curve(self):
        self.open()
        azimuth, elevation = self.browser.value("[scene.azimuth, scene.elevation]")
        self.browser.drag((5, 5), (65, 35))
        self.assertAlmostEqual(self.browser.value("scene.azimuth"), azimuth - 60 / 150)
        self.assertAlmostEqual(self.browser.value("scene.elevation"), elevation + 30 / 150)
        self.assertEqual(self.browser.value("picture.held"), -1)
        self.check_calm()

    def test_pulls_in_four_directions_by_keys(self):
        self.open()
        self.choose("Prime knots/3_1")
        self.browser.value("scene.canvas.focus()")
        self.browser.press("n")
        self.browser.wait("picture.held >= 0")
        for arrow, direction, sign in (("Left", 0, -1), ("Right", 0, 1), ("Up", 4, 1), ("Down", 4, -1)):
            project = f"""(() => {{ const e = scene.camera.matrixWorld.elements.slice({direction}, {direction} + 3);
              return nodeOf(picture.held).reduce((sum, x, k) => sum + x * e[k], 0); }})()"""
            before = self.browser.value(project)
            self.browser.press("Arrow" + arrow, "Shift")
            self.browser.wait(f"{sign} * ({project} - {before}) > 1e-3")
        self.assertEqual(self.browser.value("scene.azimuth"), 0.4)  # it was not turned
        self.check_calm()

    def test_takes_keys_with_caps_lock_and_leaves_combinations_to_the_browser(self):
        self.open()
        takes = """((key, modifiers) => !scene.canvas.dispatchEvent(
          new KeyboardEvent("keydown", {key, ...modifiers, bubbles: true, cancelable: true})))"""
        for key in ("S", "Z", "N", ".", " "):
            self.assertTrue(self.browser.value(f"{takes}('{key}', {{}})"), key)
        for key, modifiers in (("s", "altKey"), ("s", "ctrlKey"), ("n", "metaKey"), ("+", "ctrlKey"), ("z", "altKey")):
            self.assertFalse(self.browser.value(f"{takes}('{key}', {{{modifiers}: true}})"), key + modifiers)
        self.assertFalse(self.browser.value(f"{takes}('z', {{ctrlKey: true, shiftKey: true}})"))
        self.check_calm()

    def test_toggles_once_while_space_is_held_down(self):
        self.open()
        self.choose("Prime knots/10_165")
        self.slide("thickness", -2)  # which makes a long run
        self.browser.value("""[false, true].forEach((repeat) => scene.canvas.dispatchEvent(
          new KeyboardEvent("keydown", {key: " ", repeat, bubbles: true})))""")
        self.browser.wait("picture.isRunning")
        self.check_calm()

    def test_has_room_for_the_curve_on_every_screen(self):
        pictures = BUILD / "pictures"
        pictures.mkdir(exist_ok=True)
        for width, height in ((1400, 900), (400, 800), (667, 375), (799, 375)):
            for name, choice in (("knot", "Prime knots/8_18"), ("filling", "Domains to fill/Torus")):
                with self.subTest(f"{name}, {width} x {height}"):
                    self.open(width, height)
                    self.choose(choice)
                    self.browser.wait("!scene.isWaiting")
                    self.browser.save_picture(pictures / f"{name}_{width}x{height}.png")
                    size = self.browser.value("[scene.canvas.clientWidth, scene.canvas.clientHeight]")
                    self.assertGreater(min(size), 300)
                    self.assertLessEqual(self.browser.value("document.documentElement.scrollWidth"), width)
        self.check_calm()


if __name__ == "__main__":
    unittest.main()
