#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""make_page.py CORE.js PAGE: writes the live page, one file that needs no other, with the core, which
is in CORE.js and CORE.wasm, with three.js, and with the knots and domains to choose from."""

import base64
import gzip
import json
import os
import pathlib
import re
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
PACKAGE = FOLDER.parent


def three_js():
    """The text of three.js, from where the film has it, see demo/Volume_filling_curves/film."""
    folders = (os.environ.get("XDG_DATA_DIRS") or "/usr/local/share:/usr/share").split(":")
    for folder in folders:
        file = pathlib.Path(folder, "javascript/three/three.min.js")
        if file.is_file():
            return file.read_text()
    sys.exit("three.js is missing; install Debian's package libjs-three")


def knots():
    words = (PACKAGE / "data/prime_knots.txt").read_text()
    return {"primeKnots": dict(re.findall(r"^(\w+): (.+)$", words, re.MULTILINE)),
            "hardUnknot": (PACKAGE / "data/hard_unknot.obj").read_text(),
            "torus": (PACKAGE / "data/torus.off").read_text()}


def in_script(text):
    """Without sequences that would end the element, or begin a comment: they only occur in texts."""
    return text.replace("</script", "<\\/script").replace("<!--", "<\\!--")


def compressed(file):
    """As the worker decompresses it; as it is, the core takes three times as much."""
    return base64.b64encode(gzip.compress(file.read_bytes(), mtime=0)).decode()


def page(core):
    film = PACKAGE / "demo/Volume_filling_curves/film"
    scripts = {"core.js": core.read_text(),
               "scene.js": (film / "scene.js").read_text().replace("/* three.js */", three_js())}
    for name in ("worker.js", "filling_worker.js", "drawing.js", "view.js", "hand.js", "knot.js", "filling.js",
                 "choices.js", "page.js"):
        scripts[name] = (FOLDER / name).read_text()
    parts = {name: in_script(text) for name, text in scripts.items()}
    parts["core.wasm"] = compressed(core.with_suffix(".wasm"))
    parts["page.css"] = (FOLDER / "page.css").read_text()
    parts["knots"] = json.dumps(knots()).replace("<", "\\u003c")
    return re.sub(r"/\* ([\w.]+) \*/", lambda mark: parts[mark[1]], (FOLDER / "page.html").read_text())


def main():
    core, file = map(pathlib.Path, sys.argv[1:])
    file.parent.mkdir(exist_ok=True)
    unfinished = file.with_suffix(".unfinished")
    unfinished.write_text(page(core))
    unfinished.replace(file)


main()
