# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Chromium without a display or a network, as a user has it: pages, sizes, mouse, keys, pictures. It is
spoken to in its DevTools protocol, through pipes."""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import time


class Browser:
    def __init__(self, *switches):
        self.profile = tempfile.TemporaryDirectory()
        commands, self.commands = os.pipe()
        self.answers, answers = os.pipe()
        self.process = subprocess.Popen(
            ["bash", "-c", f'exec "$@" 3<&{commands} 4>&{answers}', "bash",
             shutil.which("chromium"), "--headless", "--no-sandbox", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--remote-debugging-pipe", "--hide-scrollbars",
             f"--user-data-dir={self.profile.name}", "--host-resolver-rules=MAP * ~NOTFOUND",
             *switches],
            pass_fds=(commands, answers), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(commands)
        os.close(answers)
        self.number, self.rest, self.session = 0, b"", None

    # It ends by itself, and its children with it: they write to its profile until then.
    def close(self):
        self.session = None
        self.ask("Browser.close")
        self.process.wait(timeout=60)
        os.close(self.commands)
        os.close(self.answers)
        self.profile.cleanup()

    def open_tab(self, folder):
        """Opens a tab, to which all that follows applies, and which saves files to this folder."""
        self.complaints = []
        self.file_input = None  # for which the page has opened a file dialog
        self.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
        self.tab = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=self.tab, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")

    def close_tab(self):
        self.session = None
        self.ask("Target.closeTarget", targetId=self.tab)

    def ask(self, method, **parameters):
        """The answer to a command; what the page complains about, or requests, is kept."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.next_message()
            if answer.get("id") == self.number:
                assert "error" not in answer, f"{method}: {answer['error']}"
                return answer["result"]
            self.listen(answer)

    def next_message(self):
        while b"\0" not in self.rest:
            piece = os.read(self.answers, 1 << 16)
            assert piece, "the browser has ended"
            self.rest += piece
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def listen(self, event):
        if event.get("sessionId") != self.session:
            return  # of a closed tab, or of the browser
        method, parameters = event["method"], event.get("params", {})
        if method in ("Runtime.exceptionThrown", "Runtime.consoleAPICalled", "Log.entryAdded"):
            self.complaints.append(json.dumps(parameters))
        if method == "Page.fileChooserOpened":
            self.file_input = parameters["backendNodeId"]
        if method == "Network.requestWillBeSent":
            url = parameters["request"]["url"]
            if not url.startswith(("file:", "blob:", "data:")):
                self.complaints.append(f"a request of {url}")

    def open(self, file, width, height):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height,
                 deviceScaleFactor=1, mobile=width < 800)
        self.ask("Page.navigate", url=file.as_uri())

    def value(self, expression, **options):
        result = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, **options)
        assert "exceptionDetails" not in result, f"{expression}: {result['exceptionDetails']}"
        return result["result"].get("value")

    def wait(self, condition, seconds=300):
        """Waits until an expression is true, and returns its value. A browser on a busy machine can
        take a minute to start."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            value = self.value(condition)
            if value:
                return value
            time.sleep(0.05)
        raise AssertionError(f"{condition} does not become true")

    def click(self, name):
        self.value(f"element('{name}').click()")

    def choose_file(self, button, file):
        """Presses a button that opens a file dialog, and chooses a file there."""
        self.ask("Page.setInterceptFileChooserDialog", enabled=True)
        self.file_input = None
        self.ask("Runtime.evaluate", expression=f"element('{button}').click()", userGesture=True)
        end = time.monotonic() + 60
        while self.file_input is None:
            assert time.monotonic() < end, "no dialog is opened"
            self.value("0")  # takes in what the browser reports
        self.ask("DOM.setFileInputFiles", files=[str(file)], backendNodeId=self.file_input)

    def mouse(self, kind, x, y):
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1,
                 buttons=0 if kind == "mouseReleased" else 1)

    def drag(self, *points):
        self.mouse("mousePressed", *points[0])
        for point in points[1:]:
            self.mouse("mouseMoved", *point)
        self.mouse("mouseReleased", *points[-1])

    def wheel(self, x, y, down):
        self.ask("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=down)

    def touch(self, kind, *points):
        self.ask("Input.dispatchTouchEvent", type=kind, touchPoints=[
            {"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)])

    def press(self, key, modifier=None):
        keys = {"key": key, "modifiers": {None: 0, "Alt": 1, "Ctrl": 2, "Meta": 4, "Shift": 8}[modifier]}
        text = key if len(key) == 1 and modifier is None else ""
        self.ask("Input.dispatchKeyEvent", type="keyDown", text=text, **keys)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **keys)

    def save_picture(self, file):
        data = self.ask("Page.captureScreenshot", format="png")["data"]
        file.write_bytes(base64.b64decode(data))
