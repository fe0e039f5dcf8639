# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Untangles many knots in threads: the interpreter's lock is free while the library works."""

import os
import threading
from concurrent.futures import ThreadPoolExecutor

import vfc


# %% Ctrl-C, or the stop button of Jupyter, reaches the main thread only, which tells the others.
def untangled(knots):
    """The results of all knots, in their order."""
    stop = threading.Event()

    def untangle(knot):
        return vfc.untangle(knot, progress=lambda p: not stop.is_set())
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        try:
            return list(pool.map(untangle, knots))
        except KeyboardInterrupt:
            stop.set()
            raise


# %% A table
if __name__ == "__main__":
    results = untangled([vfc.hard_unknot(80, random_seed=seed) for seed in range(20)])
    print("seed  status     iterations  points  length")
    for seed, result in enumerate(results):
        print(f"{seed:4}  {result.status:9}  {result.statistics.iterations:10}  "
              f"{len(result.curves):6}  {vfc.length(result.curves):6.2f}")
    assert all(result.status == "unknotted" for result in results)
