# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What is measured: builds of the program vfc, and peers, which a command runs.

CPU time is counted by the system, for all programs alike: that of the program and of the kernel
together, since the sum is exact and its parts, for short runs, are not. The peak of the memory is what
vfc reports; that of a peer is at least that of this script. How good a peer's result is vfc measures.
"""

import dataclasses
import hashlib
import json
import os
import pathlib
import shlex
import signal
import subprocess
import time

FINISHED = (0, 2, 3)  # exit statuses of vfc with which there is a result

# A shell of its own limits the CPU seconds, and keeps the memory of this script out of what a program
# counts as its peak. The soft limit comes with SIGXCPU, which the exit status shows; the hard one kills
# a program that ignores it. More than one command, so that the shell does not become the program.
FROM_SHELL = ("sh", "-c", 'ulimit -S -t "$0"; ulimit -H -t $(($0 + 5)); "$@"; exit $?')
AFTER_LIMIT = 128 + signal.SIGXCPU  # the shell's exit status

# Of a report, what is kept.
KEYS = ("status", "iterations", "seconds", "seconds_by_stage", "nodes_start", "nodes_end", "length_end",
        "thickness", "min_clearance", "min_bend_radius", "min_strand_distance", "min_wall_distance",
        "crowded_fraction", "fitting_thickness", "average_crossing_number", "coverage", "empty_regions",
        "unfilled_fraction", "outside_nodes", "outside_segments", "shortened_steps")


@dataclasses.dataclass(frozen=True)
class Program:
    """A build of vfc, or a peer: a command with {job}, {input}, {output} and {thickness} in it."""
    name: str
    words: tuple
    is_peer: bool
    versions: str  # as the program prints them
    digest: str  # of the program's file

    def command(self, case, output, report, threads):
        if not self.is_peer:
            return [*self.words, *case.words(), "-o", output, "--report", report, "--threads",
                    case.threads or threads, "--quiet", "--force"]
        values = dict(job=case.job, input=case.input, output=output, thickness=case.thickness or "")
        return [word.format(**values) for word in self.words]


def first_bytes_of_sha256(data):
    return hashlib.sha256(data).hexdigest()[:16]


def build(definition, name):
    """The program vfc from the place of its build folder or of itself, or NAME=PLACE."""
    first, equals, last = str(definition).partition("=")
    name, place = (first, pathlib.Path(last)) if equals else (name, pathlib.Path(first))
    file = place if place.is_file() else place / "bin" / "vfc"
    if not file.is_file():
        raise SystemExit(f"there is no program {file}: build it (scripts/build), or give another folder")
    file = file.resolve()
    said = subprocess.run([file, "--version"], capture_output=True, text=True, check=True).stdout
    versions = ", ".join(said.split("\n")).strip(", ")
    return Program(name, (str(file),), False, versions, first_bytes_of_sha256(file.read_bytes()))


def peer(definition):
    """A peer from NAME=COMMAND."""
    name, equals, command = definition.partition("=")
    if not (name and equals and "{input}" in command):
        raise SystemExit(f"a peer is NAME=COMMAND, with {{input}} in the command, not {definition}")
    words = tuple(shlex.split(command))
    return Program(name, words, True, "unknown", first_bytes_of_sha256(command.encode()))


def measure(program, case, folder, settings, judge):
    """Runs a program on a case in a folder, and returns the figures. `judge` is the build of vfc that
    measures what a peer has written; a run is ended when it has taken settings.most_seconds."""
    output, report, log = folder / "end.obj", folder / "report.json", folder / "log.txt"
    for file in (output, report):
        file.unlink(missing_ok=True)
    command = [str(word) for word in program.command(case, output, report, settings.threads)]
    with open(log, "wb") as said:
        start = time.perf_counter()
        process = subprocess.Popen([*FROM_SHELL, str(settings.most_seconds), *command], cwd=folder,
                                   stdin=subprocess.DEVNULL, stdout=said, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    figures = dict(exit=process.returncode, cpu_seconds=usage.ru_utime + usage.ru_stime,
                   user_seconds=usage.ru_utime, wall_seconds=wall,
                   peak_memory_bytes=1024 * usage.ru_maxrss, report={})
    if process.returncode not in ((0,) if program.is_peer else FINISHED):
        figures["error"] = reason(process.returncode, figures["cpu_seconds"], settings, log)
    elif program.is_peer:
        figures["report"] = judged(judge, case, output)
    else:
        report = json.loads(report.read_text())
        figures["report"], figures["peak_memory_bytes"] = kept(report), report["peak_memory_bytes"]
    if output.exists():
        figures["curve"] = first_bytes_of_sha256(output.read_bytes())
    return figures


def reason(exit_code, cpu_seconds, settings, log):
    """Why a run has no result. The seconds decide only for what survived SIGXCPU: the system may count
    less than the limit when it ends a program."""
    if exit_code == AFTER_LIMIT or cpu_seconds >= settings.most_seconds:
        return f"ended after {settings.most_seconds} CPU seconds"
    lines = log.read_text(errors="replace").split("\n")
    last = next((line.strip() for line in reversed(lines) if line.strip()), "no reason given")
    return f"exit status {exit_code}: {last[:200]}"


def judged(judge, case, curve):
    """The figures of a curve that a peer has written, none if vfc refuses it."""
    mesh = [case.input, "--thickness", case.thickness] if case.job == "fill" else []
    command = [*judge.words, "measure", curve, *mesh, "--report", "-", "--threads", 1]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    return kept(json.loads(done.stdout)) if done.returncode == 0 else {}


def kept(report):
    figures = {key: report.get(key) for key in KEYS}
    figures["empty_regions"] = len(report.get("empty_regions") or [])
    return figures
