# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The runs of a session: programs take turns on each case, and every run is a line of JSON in
runs.jsonl as soon as it has ended, so that a session can go on where it was interrupted."""

import datetime
import json
import os
import platform

from .programs import measure

LONG = 60  # CPU seconds; what takes longer is not repeated
GROWTH = 1.2  # exponent with which the next time in a series is foreseen


def machine():
    """The processor's name, if the system reports it."""
    try:
        with open("/proc/cpuinfo") as file:
            lines = file.read().splitlines()
    except OSError:
        lines = []
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return dict(machine=next(names, platform.machine()), processors=os.cpu_count(),
                system=platform.platform())


class Runs:
    """All runs in a folder: those that are there, and those that are added."""

    def __init__(self, folder):
        self.file = folder / "runs.jsonl"
        text = self.file.read_text() if self.file.exists() else ""
        self.lines = [json.loads(line) for line in text.splitlines()]

    def find(self, wanted):
        """The run that all of `wanted` is true of."""
        matching = (line for line in self.lines if all(line[key] == wanted[key] for key in wanted))
        return next(matching, None)

    def add(self, line):
        self.lines.append(line)
        with open(self.file, "a") as file:
            file.write(json.dumps(line) + "\n")


class Session:
    """Programs, of which the first is the one to be judged, on cases."""

    def __init__(self, runs, programs, settings, folder, report):
        self.runs, self.programs, self.settings = runs, programs, settings
        self.folder, self.report = folder, report
        self.surroundings = machine()
        self.last_of_series = {}

    def __call__(self, cases):
        for case in cases:
            programs = [program for program in self.takers(case) if not self.is_too_long(program, case)]
            for turn in range(self.settings.repeat):
                lines = [self.run(program, case, turn) for program in programs]
                if any(line["cpu_seconds"] > LONG for line in lines):
                    break

    def takers(self, case):
        """The programs that the case is for: no peers in series."""
        if not case.for_others:
            return self.programs[:1]
        return [program for program in self.programs if not (program.is_peer and case.series)]

    def is_too_long(self, program, case):
        size, seconds = self.last_of_series.get((program.name, case.suite, case.series), (0, 0))
        foreseen = seconds * (case.size / size) ** GROWTH if size else 0
        if foreseen <= self.settings.most_seconds:
            return False
        self.report(f"{case.suite}: {case.name}: {program.name}: left out, as it would take about "
                  f"{foreseen:.0f} CPU seconds")
        return True

    def run(self, program, case, turn):
        asked = self.asked(program, case, turn)
        line = self.runs.find(asked)
        if line is None:
            line = {**asked, **self.about(program), **measure(program, case, self.folder, self.settings,
                                                              self.programs[0])}
            self.runs.add(line)
        if case.series:
            self.last_of_series[program.name, case.suite, case.series] = case.size, line["cpu_seconds"]
        end = line.get("error") or line["report"].get("status") or "done"
        self.report(f"{case.suite}: {case.name}: {program.name}: {line['cpu_seconds']:.2f} s, {end}")
        return line

    def asked(self, program, case, turn):
        """The identity of a run."""
        return dict(suite=case.suite, case=case.name, program=program.name, digest=program.digest, turn=turn,
                    job=case.job, input=case.input.name, thickness=case.thickness,
                    options=[str(word) for word in case.options], series=case.series, size=case.size,
                    group=case.group, threads=case.threads or self.settings.threads)

    def about(self, program):
        """What figures depend on besides."""
        return dict(versions=program.versions, date=datetime.datetime.now().isoformat(timespec="seconds"),
                    load=round(os.getloadavg()[0], 2), **self.surroundings)
