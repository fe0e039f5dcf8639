# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What the live page takes: its choices, files and drawings, and what is wrong with them."""

import math
import unittest

from cases import PAGE, On_page


def circle(x, y=450, radius=120, number_of_points=40):
    turns = [2 * math.pi * k / number_of_points for k in range(number_of_points)]
    return [(x + radius * math.cos(t), y + radius * math.sin(t)) for t in turns]


class Inputs(On_page):
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

    def test_takes_knots_that_are_drawn(self):
        turns = [2 * math.pi * k / 90 for k in range(90)]
        trefoil = [(500 + 100 * (math.sin(t) + 2 * math.sin(2 * t)),
                    430 - 100 * (math.cos(t) - 2 * math.cos(2 * t))) for t in turns]
        self.open(1400, 900)
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
            self.assertEqual(self.browser.value("element('knot').selectedOptions[0].text"), "Your curve")
        self.browser.click("draw")
        self.choose("Prime knots/3_1")
        self.assertFalse(self.browser.value("drawing.isOn"))
        self.assertGreater(self.browser.value("element('run').clientHeight"), 0)
        self.check_calm()

    def test_discards_a_drawing_by_escape_and_takes_links(self):
        self.open(1400, 900)
        shown = self.browser.value("picture.number")
        self.browser.click("draw")
        self.browser.drag(*circle(500))
        self.browser.press("Escape")
        self.assertFalse(self.browser.value("drawing.isOn"))
        self.assertEqual(self.browser.value("number"), shown)
        self.browser.click("draw")
        self.browser.drag(*circle(500))
        self.browser.drag(*circle(650))
        self.browser.wait("drawing.strokes.length === 2")
        self.browser.click("draw")
        self.browser.wait("picture.number === number && picture.strands.length === 2")
        self.browser.wait("element('crossings').textContent === '2'")  # which alternate
        self.check_calm()

    def test_takes_a_name_that_comes_before_the_first_picture(self):
        self.open()
        self.choose("Domains to fill/Torus")
        self.browser.value("showIdentity({number, name: '3_1', isProved: true})")
        self.assertEqual(self.text("name"), "3_1 (proved)")
        self.check_calm()

    def test_loads_every_choice(self):
        self.open()
        choices = self.browser.value("[...element('knot').options].map((option) => option.value)")
        others = [name for name in choices if name and not name.startswith("Prime knots/")]
        self.assertEqual(len(others), 13)
        self.assertGreater(len(choices), 250)
        for name in [*others, choices[-2]]:
            with self.subTest(name):
                self.choose(name)
                self.browser.wait("domain || element('name').textContent !== '…'")
                self.assertEqual(self.browser.value("element('knot').value"), name)
                self.assertFalse(self.browser.value("element('message').classList.contains('refused')"))
        self.check_calm()

    def test_opens_the_same_file_again(self):
        file = self.folder / "square.obj"
        self.open()
        for height in (1, 2):
            file.write_text(f"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 {height}\nl 1 2 3 4 1\n")
            length = self.number("length")
            self.browser.choose_file("open", file)
            self.browser.wait(f"Number(element('length').textContent) !== {length}")
            self.assertEqual(self.browser.value("element('file').value"), "")
            self.assertEqual(self.browser.value("element('knot').selectedOptions[0].text"), "Your curve")
        self.check_calm()

    def test_takes_files_that_are_dropped(self):
        drop = """((type) => {
          const event = new DragEvent(type, {dataTransfer: new DataTransfer(), bubbles: true, cancelable: true});
          event.dataTransfer.items.add(new File(["v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nl 1 2 3 1\\n"], "triangle.obj"));
          return document.body.dispatchEvent(event); })"""
        self.open()
        self.assertFalse(self.browser.value(f"{drop}('dragover')"))  # the browser would not drop it
        self.assertFalse(self.browser.value(f"{drop}('drop')"))  # the browser would leave the page
        self.browser.wait("picture.number === number && element('length').textContent === '3.4142'")
        self.check_calm()

    def test_names_what_is_shown_after_a_refusal(self):
        selected = "element('knot').selectedOptions[0].text"
        self.open()
        self.choose("Prime knots/4_1")
        self.browser.value("openFile(new File(['v 0 0 0\\nv 1 0 x\\n'], 'bad.obj'))")
        self.wait_for_message("line 2")
        self.assertEqual(self.browser.value(selected), "4_1")
        self.browser.value("openFile({name: 'folder', text: () => Promise.reject(new Error())})")
        self.wait_for_message("folder cannot be read.")
        self.assertEqual(self.browser.value(selected), "4_1")
        self.check_calm()

    def test_says_what_the_browser_lacks(self):
        self.open()
        self.browser.value("element('worker').prepend('delete self.DecompressionStream;'); startWorker(); loadChoice()")
        self.wait_for_message("The page does not work in this browser: DecompressionStream is not defined")
        self.check_calm()
        self.browser.ask("Page.addScriptToEvaluateOnNewDocument",
                         source="HTMLCanvasElement.prototype.getContext = () => null")
        self.browser.open(PAGE, 1400, 900)
        self.browser.wait("document.readyState === 'complete' && document.querySelector('main').hidden")
        self.wait_for_message("The page needs WebGL")


if __name__ == "__main__":
    unittest.main()
