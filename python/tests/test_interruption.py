# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Tests of Ctrl-C, which ends every call that can last, and of the interpreter's lock."""

import importlib.util
import inspect
import operator
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
from support import CUBE_FACES, CUBE_VERTICES, SQUARE, circle

import vfc

# What takes no longer than half a second for a million points.
INSTANT = {"length", "write", "Ball", "Box", "Implicit"}
SECONDS_TO_THE_SIGNAL = 0.05
SECONDS_TO_THE_END = 0.5 * (os.cpu_count() or 1)  # of all processors


class Interrupted_call:
    """A call during which Ctrl-C is pressed, while a function of the compiled module is at work.

    Only an exception that comes out of that function shows that it ended its work: Python itself
    raises one as soon as a function that heeds no signal has returned."""

    def __init__(self, call):
        self.sent = self.came_from = None
        self._timer = threading.Timer(SECONDS_TO_THE_SIGNAL, self._press)
        sys.setprofile(self._watch)
        try:
            call()
            self.has_ended_before = self.sent is None
        except KeyboardInterrupt:
            self.has_ended_before = False
        finally:
            sys.setprofile(None)
            self._timer.cancel()
        self.seconds = time.process_time() - self.sent if self.sent else 0

    def _press(self):
        self.sent = time.process_time()
        os.kill(os.getpid(), signal.SIGINT)

    def _watch(self, frame, event, function):
        if getattr(function, "__module__", None) != "vfc._vfc":
            return
        if event == "c_call" and not self._timer.is_alive():
            self._timer.start()
        elif event == "c_exception":
            self.came_from = function.__name__


class Interruption(unittest.TestCase):
    def setUp(self):
        signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in a background job
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "chain.obj"

    def long_calls(self):
        """Calls that last longer than the signal takes, by the name of the function."""
        polygon = vfc.random_polygon(20000)
        tangle = vfc.random_polygon(4000)
        start = vfc.random_polygon(100000)  # the record of a smaller one is replayed too fast
        record = vfc.simplify(start, certificate=True)
        chain = np.cumsum(np.random.default_rng(0).normal(size=(400000, 3)), axis=0)
        tube = vfc.tube(chain[:40000], 1e-9, closed=False)
        cube = vfc.Mesh(CUBE_VERTICES, CUBE_FACES)
        # The function is none of Python: _watch() would be called for each of its lines.
        half_space = vfc.Implicit(operator.itemgetter(0), (-1, -1, -1), (1, 1, 1))
        inside = circle(400000, at=(-0.5, 0, 0), radius=0.3)
        around = vfc.Ball((0, 0, 0), 1000)
        vfc.write(self.file, chain, closed=False)
        yield from [
            ("untangle", lambda: vfc.untangle(tangle)),
            ("untangle", lambda: vfc.untangle(tangle, strategy="flow")),
            ("untangle", lambda: vfc.untangle(tangle, domain=around)),
            ("simplify", lambda: vfc.simplify(chain, closed=False)),
            ("verify", lambda: vfc.verify(record.certificate, start, record.curves)),
            ("verify", lambda: vfc.verify(record.certificate, start, record.curves, domain=around)),
            ("fill", lambda: vfc.fill(cube, thickness=0.01)),
            ("fill", lambda: vfc.fill(half_space, thickness=0.02)),
            ("fill", lambda: vfc.fill(vfc.Polygons(SQUARE), thickness=1e-3)),
            ("measure", lambda: vfc.measure(polygon)),
            ("identify", lambda: vfc.identify(polygon)),
            ("identify_chain", lambda: vfc.identify_chain(chain[:2000], find_core=True)),
            ("coverage", lambda: vfc.coverage(circle(), around, 0.1, samples=10**8)),
            ("coverage", lambda: vfc.coverage(polygon, cube, 0.1, samples=10**7)),
            ("outside", lambda: vfc.outside(inside, half_space)),
            ("wall_distance", lambda: vfc.wall_distance(inside, half_space)),
            ("check_curves", lambda: vfc.check_curves(chain, closed=False)),
            ("check_curves", lambda: vfc.check_curves(inside, domain=half_space)),
            ("hard_unknot", lambda: vfc.hard_unknot(1000, 10**8)),
            ("random_polygon", lambda: vfc.random_polygon(2 * 10**6)),
            ("torus_knot", lambda: vfc.torus_knot(2, 3, 10**7)),
            ("closed_braid", lambda: vfc.closed_braid([1, -2] * 99, 10**7)),
            ("arc_spline", lambda: vfc.arc_spline(chain, closed=False)),
            ("tube", lambda: vfc.tube(chain, 0.1, closed=False)),
            ("Mesh", lambda: vfc.Mesh(*tube)),
            ("Polygons", lambda: vfc.Polygons(circle(10**6)[:, :2])),
            ("check_mesh", lambda: vfc.check_mesh(*tube)),
            ("repair", lambda: vfc.repair(tube[0], tube[1][1:])),
            ("read", lambda: vfc.read(self.file))]

    def test_ctrl_c_ends_every_long_call(self):
        interrupted = set()
        for name, call in self.long_calls():
            with self.subTest(inspect.getsource(call).strip()):
                ended = Interrupted_call(call)
                self.assertFalse(ended.has_ended_before, "the call ended before the signal")
                self.assertIsNotNone(ended.came_from, "the work went on to its end")
                self.assertLess(ended.seconds, SECONDS_TO_THE_END)
            interrupted.add(name)
        self.assertEqual(interrupted | INSTANT, callables())

    def test_ctrl_c_ends_the_threads_of_the_example(self):
        file = pathlib.Path(__file__).parents[1] / "examples/batch.py"
        specification = importlib.util.spec_from_file_location("batch", file)
        batch = importlib.util.module_from_spec(specification)
        specification.loader.exec_module(batch)
        tangle = vfc.random_polygon(4000)
        timer = threading.Timer(0.5, os.kill, [os.getpid(), signal.SIGINT])
        start = time.process_time()
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            batch.untangled([tangle] * 8)
        self.assertLess(time.process_time() - start, 5 * (os.cpu_count() or 1))  # 8 runs take minutes

    def test_other_threads_go_on(self):
        polygon = vfc.random_polygon(20000)
        counted, is_over = [0], threading.Event()

        def count():
            while not is_over.wait(1e-3):
                counted[0] += 1
        thread = threading.Thread(target=count)
        thread.start()
        try:
            before, start = counted[0], time.monotonic()
            vfc.measure(polygon[:4000], closed=False)
            waits = (time.monotonic() - start) / 1e-3
            self.assertGreater(counted[0] - before, waits / 20)  # a busy machine wakes threads late
        finally:
            is_over.set()
            thread.join()


    def test_the_interpreter_ends_while_daemon_threads_work(self):
        for call in ("vfc.measure(knot)", "vfc.fill(ball, thickness=lambda p: 0.05)",
                     "vfc.fill(ball, thickness=0.02, progress=lambda p: 0)"):
            script = (f"import threading, time, vfc\nknot, ball = vfc.torus_knot(2, 3), vfc.Ball((0, 0, 0), 1)\n"
                      f"def work():\n    while True: {call}\n"
                      f"threading.Thread(target=work, daemon=True).start()\ntime.sleep(0.1)\n")
            ended = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
            self.assertEqual((ended.returncode, ended.stderr), (0, ""), call)


def callables():
    """The functions and the domains of the package."""
    return {name for name, value in vars(vfc).items()
            if inspect.isfunction(value) or inspect.isclass(value) and issubclass(value, vfc.Domain)
            } - {"Domain"}


if __name__ == "__main__":
    unittest.main()
