# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Untangles a knot, and has the record of the run verified."""

import vfc

knot = vfc.closed_braid([1, -2, 1, -2, 1, -2, 1, -2], points=400, random_seed=3)  # 8_18
result = vfc.untangle(knot, certificate=True, lower_ropelength=True)
print(f"{result.status} after {result.statistics.iterations} iterations, "
      f"{len(knot)} -> {len(result.curves)} points")
print(vfc.verify(result.certificate, knot, result.curves).is_valid)
for curve in (knot, result.curves):
    print(f"ropelength {vfc.measure(curve).ropelength:.2f}")
