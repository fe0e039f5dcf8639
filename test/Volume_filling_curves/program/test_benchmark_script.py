#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Runs scripts/benchmark on small cases, with the program against itself and as a peer of itself:
both get the same, all is recorded, reported and drawn, and a session goes on. No figure of time is
tested, since it depends on the machine."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

sys.dont_write_bytecode = True
PACKAGE = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(PACKAGE / "benchmark" / "Volume_filling_curves"))
from side_by_side.ratios import growth, growth_of_large, ratio  # noqa: E402

VFC = os.environ["VFC_PROGRAM"]
TWICE = 2  # runs of a case


def benchmark(*arguments):
    command = [PACKAGE / "scripts" / "benchmark", *arguments]
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def session(out, *arguments):
    return benchmark("--build", f"here={VFC}", "--data", out / "nothing", "--quick", "--repeat", TWICE,
                     "--out", out, *arguments)


class Quick(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.temporary.name) / "out"
        cls.peer = f"peer={VFC} {{job}} {{input}} -o {{output}} --thickness 0.2 --threads 1"
        cls.arguments = ("--against", f"there={VFC}", "--peer", cls.peer)
        cls.done = session(cls.out, *cls.arguments)
        cls.lines = [json.loads(line) for line in (cls.out / "runs.jsonl").read_text().splitlines()]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def of(self, suite, program):
        return [line for line in self.lines if (line["suite"], line["program"]) == (suite, program)]

    def test_all_suites_run(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        suites = {"fillings", "found-meshes", "unknots", "knots", "filling-scaling", "untangling-scaling",
                  "coverage", "threads"}
        self.assertEqual({line["suite"] for line in self.lines}, suites)
        self.assertFalse([line["error"] for line in self.lines if "error" in line])
        for line in self.lines:
            self.assertGreater(line["cpu_seconds"], 0)
            self.assertGreater(line["peak_memory_bytes"], 1e6)
            self.assertTrue(line["machine"] and line["versions"] and line["digest"] and line["date"])

    def test_programs_take_turns(self):
        order = [(line["program"], line["turn"]) for line in self.lines if line["suite"] == "fillings"]
        self.assertEqual(order, [(p, turn) for turn in range(TWICE) for p in ("here", "there", "peer")])

    def test_the_same_program_gets_the_same(self):
        here, there = self.of("fillings", "here"), self.of("fillings", "there")
        self.assertEqual({line["curve"] for line in here}, {line["curve"] for line in there})
        times = [{line["turn"]: line["cpu_seconds"] for line in lines} for lines in (here, there)]
        self.assertIn(ratio(*times).text(), (self.out / "tables.md").read_text())

    def test_a_peer_is_measured_by_what_it_wrote(self):
        here, peer = (self.of("fillings", program)[0]["report"] for program in ("here", "peer"))
        self.assertEqual(peer["nodes_end"], here["nodes_end"])
        self.assertEqual(peer["coverage"], here["coverage"])

    def test_tables_and_plots_are_written(self):
        tables = (self.out / "tables.md").read_text()
        self.assertIn("| here / there | CPU time |", tables)
        self.assertIn("| torus, bundled, peer |", tables)
        self.assertNotIn("OTHER", tables)  # bits of the curve by another number of threads
        names = {"filling_time", "filling_memory", "filling_stages", "untangling_time",
                 "coverage_by_iterations", "filling_ratios", "unknot_ratios"}
        self.assertEqual({file.stem for file in self.out.glob("*.svg")}, names)
        for file in self.out.glob("*.svg"):
            circles = ElementTree.parse(file).iter("{http://www.w3.org/2000/svg}circle")
            self.assertGreaterEqual(len(list(circles)), 1, file.name)

    def test_places_of_a_page_get_tables(self):
        page, end = self.out / "page.md", "<!-- end of benchmark -->"
        page.write_text(f"# A page\n<!-- benchmark own unknots -->\nold\n{end}\n"
                        f"<!-- benchmark nonsense -->\nkept\n{end}\n")
        done = benchmark("--show", self.out, "--into", page)
        self.assertIn("nothing was measured for the table nonsense", done.stderr)
        self.assertRegex(page.read_text(), r"^# A page\n<!-- .* -->\n\n\| curve .*\n\| --- .*\n\| hard_unknot \| "
                         rf"unknotted .*\n\n{end}\n<!-- benchmark nonsense -->\nkept\n{end}\n$")

    def test_a_session_goes_on(self):
        self.assertEqual(session(self.out, *self.arguments, "--suite", "knots").returncode, 0)
        again = (self.out / "runs.jsonl").read_text().splitlines()
        self.assertEqual(len(again), len(self.lines))


class Errors(unittest.TestCase):
    def test_what_takes_too_long_is_ended_and_said(self):
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name)
            endless = "endless=sh -c 'while :; do :; done' {input}"
            done = session(out, "--suite", "unknots", "--repeat", 1, "--most-seconds", 1, "--peer", endless)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("| hard_unknot, endless | ended after 1 CPU seconds |", done.stdout)
            self.assertFalse(list(out.glob("*.svg")), "nothing to compare with")

    def test_the_signal_of_the_limit_decides_and_not_the_seconds(self):
        with tempfile.TemporaryDirectory() as name:
            for sent, said in (("XCPU", "ended after 1000 CPU seconds"), ("KILL", "exit status 137")):
                ended = f"ended=sh -c 'kill -{sent} $$' {{input}}"
                done = session(pathlib.Path(name) / sent, "--suite", "unknots", "--repeat", 1,
                               "--most-seconds", 1000, "--peer", ended)
                self.assertIn(f"| hard_unknot, ended | {said}", done.stdout)

    def test_missing_programs_and_data_are_named(self):
        with tempfile.TemporaryDirectory() as name:
            out = pathlib.Path(name)
            self.assertIn("there is no program", benchmark("--build", out, "--out", out).stderr)
            self.assertIn("a peer is NAME=COMMAND", session(out, "--peer", "something").stderr)
            self.assertIn("no runs in", benchmark("--show", out).stderr)
            done = benchmark("--build", VFC, "--data", out, "--out", out, "--suite", "unknots", "--repeat", 1)
            self.assertIn("has not: paper/freedman_he_wang.obj", done.stderr)


class Arithmetic(unittest.TestCase):
    def test_ratios_are_of_the_same_turn(self):
        spread = ratio({0: 2.0, 1: 9.0, 2: 4.0}, {0: 1.0, 1: 3.0, 2: 1.0, 3: 100.0})
        self.assertEqual((spread.low, spread.median, spread.high), (2, 3, 4))
        self.assertIsNone(ratio({0: 1.0}, {1: 1.0}))

    def test_growth_of_a_power_is_its_exponent(self):
        grown = growth([(n, 3 * n**1.5) for n in (100, 10, 1000)])
        self.assertAlmostEqual(grown.exponent, 1.5)
        self.assertAlmostEqual(grown.at(4), 24)
        turning = [(n, max(n, 1000)) for n in (10, 100, 1000, 2000, 10_000)]
        self.assertAlmostEqual(growth_of_large(turning).exponent, 1)
        self.assertLess(growth(turning).exponent, 0.5)
        self.assertIsNone(growth([(10, 1.0), (20, 0.01)], 0.05))


if __name__ == "__main__":
    unittest.main()
