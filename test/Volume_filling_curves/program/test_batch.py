#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Kills batches of the program vfc at random moments, has several processes share one, and sees
to it that each curve is done once, as it is by a run of its own."""

import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from batch_test_support import VFC, check_results, make_knots, reports, skip, vfc

NUMBER = 120
INVALID_INPUT, INTERRUPTED = 4, 5  # exit statuses


def start(folder, *arguments):
    return subprocess.Popen([VFC, "untangle", "--batch", "knots.txt", *arguments, "--threads", "1"],
                            cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def number_of_lines(results):
    return results.read_bytes().count(b"\n") if results.exists() else 0


def end_at(process, results, lines, sent):
    """Sends a signal at a random moment after so many lines. Returns the exit status."""
    while number_of_lines(results) < lines and process.poll() is None:
        time.sleep(0.001)
    time.sleep(random.uniform(0, 0.01))
    process.send_signal(sent)
    return process.wait()


def check_killed(folder, names):
    results = folder / "killed" / "results.jsonl"
    for lines in sorted(random.sample(range(1, NUMBER // 2), 2)):  # far from the end, on a busy machine too
        status = end_at(start(folder, "-o", "killed"), results, lines, signal.SIGKILL)
        assert status == -signal.SIGKILL, "the batch came to its end before"
        print(f"killed after {number_of_lines(results)} of {NUMBER} curves")
    assert number_of_lines(results) < NUMBER
    last = vfc(folder, "untangle", "--batch", "knots.txt", "-o", "killed")
    assert last.returncode == 0, last.stderr
    assert f"runs {NUMBER}, " in last.stdout and "left" not in last.stdout, last.stdout
    check_results(folder, results.parent, names)


def check_finished(folder):
    """Another start does nothing, and ends alike."""
    results = folder / "killed" / "results.jsonl"
    before = results.read_bytes()
    again = vfc(folder, "untangle", "--batch", "knots.txt", "-o", "killed")
    assert (again.returncode, again.stderr) == (0, ""), again.stderr
    assert results.read_bytes() == before


def check_leavings(folder, names):
    """What a process leaves that is killed between the parts of its work."""
    results = folder / "killed" / "results.jsonl"
    lines = results.read_bytes().splitlines(keepends=True)
    results.write_bytes(b"".join(lines[:-3]) + lines[-1][:100])
    (folder / "killed" / f"{names[-1]}.obj").write_text("written, but not reported")
    (folder / "killed" / f"{names[-2]}.obj.tmp0").write_text("half wr")
    (folder / "killed" / f"{names[-2]}.obj.tmp1").write_text("half wr")
    last = vfc(folder, "untangle", "--batch", "knots.txt", "-o", "killed")
    assert last.returncode == 0, last.stderr
    check_results(folder, folder / "killed", names)


def check_interrupted(folder, names):
    results = folder / "interrupted" / "results.jsonl"
    for sent in (signal.SIGTERM, signal.SIGINT):
        status = end_at(start(folder, "-o", "interrupted"), results, number_of_lines(results) + 5, sent)
        assert status == INTERRUPTED, status
    assert start(folder, "-o", "interrupted").wait() == 0
    check_results(folder, results.parent, names)


def check_processes(folder, names):
    """Several processes at a time, one of which is killed."""
    shards, output = [["--shard", f"{k}/3"] for k in (1, 2, 3)], "shards"
    processes = [start(folder, "-o", output, *shard) for shard in shards]
    status = end_at(processes.pop(), folder / output / "results.jsonl", 10, signal.SIGKILL)
    assert status == -signal.SIGKILL
    assert [process.wait() for process in processes] == [0] * len(processes)
    assert start(folder, "-o", output).wait() == 0
    check_results(folder, folder / output, names)


def check_crashed(folder):
    """An input that crashes the program is reported, and the next start goes on behind it."""
    (folder / "crash.txt").write_text("knot_000.obj\nknot_001.obj\n")
    arguments = ["untangle", "--batch", "crash.txt", "-o", "crashed", "--strategy", "flow"]
    endless = ["--tolerance", "1e-300", "--thickness", "1e-3", "--frames", "film"]
    process = subprocess.Popen([VFC, *arguments, *endless], cwd=folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    while not (folder / "crashed" / "knot_000.film").exists() and process.poll() is None:
        time.sleep(0.001)
    process.send_signal(signal.SIGSEGV)
    assert process.wait() == -signal.SIGSEGV
    for _ in range(2):
        ended = vfc(folder, *arguments)
        assert ended.returncode == 1, ended.stderr
        found = reports(folder / "crashed" / "results.jsonl")
        assert list(found) == ["knot_000.obj", "knot_001.obj"], found
        crashed = found["knot_000.obj"]
        assert (crashed["status"], crashed["exit_status"]) == ("error", 1), crashed
        assert crashed["error"]["message"] == "the program crashed", crashed
        assert found["knot_001.obj"]["status"] != "error", found


def check_bad_input(folder):
    (folder / "bad.obj").write_text("v 0 0 0\nv 1 0 0\nl 1 3\n")
    (folder / "list.txt").write_text("knot_000.obj\nbad.obj\r\n\nmissing.obj\nknot_001.obj\n")
    for _ in range(2):
        ended = vfc(folder, "untangle", "--batch", "list.txt", "-o", "some")
        assert ended.returncode == INVALID_INPUT, ended.stderr
        found = reports(folder / "some" / "results.jsonl")
        statuses = {name: report["exit_status"] for name, report in found.items()}
        assert statuses == {"knot_000.obj": 0, "bad.obj": 4, "missing.obj": 4, "knot_001.obj": 0}
        error = found["bad.obj"]["error"]
        assert (error["file"], error["line"]) == ("bad.obj", 3) and error["message"], error
    files = {file.name for file in (folder / "some").iterdir()}
    assert files == {"knot_000.obj", "knot_001.obj", "results.jsonl"}, files


def main():
    if not os.path.exists(VFC):
        skip("there is no program vfc")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "knots"
        names = make_knots(folder, NUMBER)
        check_killed(folder, names)
        check_finished(folder)
        check_leavings(folder, names)
        check_interrupted(folder, names)
        check_processes(folder, names)
        check_bad_input(folder)
        check_crashed(folder)


main()
