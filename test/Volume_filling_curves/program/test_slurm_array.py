#!/usr/bin/env python3
# Copyright (c) 2026 The Volume_filling_curves authors.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Runs the manual's job array in a Slurm of its own, on this machine alone: controller and node
daemon start in a temporary folder, without authentication, and end with the test."""

import contextlib
import os
import pathlib
import pwd
import shutil
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from batch_test_support import EXAMPLES, VFC, check_results, make_knots, skip

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
MailProg=/bin/true
MpiDefault=none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
ReturnToService=2
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=10 State=UP
"""


def free_ports(number):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(number)]
        for item in sockets:
            item.bind(("127.0.0.1", 0))
        return [item.getsockname()[1] for item in sockets]


def configure(folder):
    file = folder / "slurm.conf"
    file.write_text(CONFIGURATION.format(
        host=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.getuid()).pw_name,
        ports=free_ports(2), folder=folder, cpus=os.cpu_count()))
    return {**os.environ, "SLURM_CONF": str(file),
            "PATH": os.pathsep.join([str(pathlib.Path(VFC).parent), os.environ["PATH"]])}


@contextlib.contextmanager
def daemon(folder, environment, *command):
    """A process whose messages go to a file, as long as the context lasts."""
    with open(folder / f"{command[0]}.log", "w") as log:
        process = subprocess.Popen(command, env=environment, cwd=folder, stdout=log, stderr=log)
        try:
            yield process
        finally:
            process.terminate()
            process.wait(timeout=60)


def wait_for_node(folder, environment):
    for _ in range(60):
        states = subprocess.run(["sinfo", "--noheader", "--format=%T"], env=environment,
                                capture_output=True, text=True)
        if states.stdout.strip() == "idle":
            return
        time.sleep(0.5)
    print((folder / "slurmctld.log").read_text(), (folder / "slurmd.log").read_text())
    skip("Slurm does not start here")


def run_array(folder, environment):
    command = ["sbatch", "--wait", str(EXAMPLES / "untangle_in_slurm_array.sh")]
    job = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True,
                         timeout=300)
    outputs = sorted(folder.glob("slurm-*.out"))
    assert job.returncode == 0, job.stderr + "".join(file.read_text() for file in outputs)
    return len(outputs)


def main():
    if not os.path.exists(VFC):
        skip("there is no program vfc")
    for program in ("slurmctld", "slurmd", "sbatch"):
        if not shutil.which(program):
            skip(f"there is no {program} (Debian: slurm-wlm)")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        knots = folder / "knots"
        names = make_knots(knots, 20)
        environment = configure(folder)
        for place in ("state", "spool"):
            (folder / place).mkdir()
        with daemon(folder, environment, "slurmctld", "-D", "-i"), \
             daemon(folder, environment, "slurmd", "-D"):
            wait_for_node(folder, environment)
            assert run_array(knots, environment) == 4, "tasks"
            check_results(knots, knots / "untangled", names)
            print("an array of 4 tasks untangled", len(names), "curves, each once")


main()
