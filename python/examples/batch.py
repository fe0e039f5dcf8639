# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Untangles many knots in threads: the interpreter's lock is free while the library works."""

from concurrent.futures import ThreadPoolExecutor

import vfc

knots = [vfc.hard_unknot(80, random_seed=seed) for seed in range(20)]
with ThreadPoolExecutor() as pool:
    results = list(pool.map(vfc.untangle, knots))
print(sum(result.status == "unknotted" for result in results), "of", len(knots), "unknotted")
