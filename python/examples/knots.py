# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Names a knot, untangles it, has the record of the run verified, and draws it, if matplotlib is
there. Editors and Jupyter run the cells one by one."""

# %% A knot is an array of points.
import numpy as np

import vfc

knot = vfc.closed_braid([1, -2, 1, -2, 1, -2, 1, -2], points=400, random_seed=3)
print(knot.shape)
assert knot.shape == (400, 3)

# %% Its name
found = vfc.identify(knot)
print(found.name, "proved" if found.is_proved else "", found.chirality, found.jones_polynomial)
assert (found.name, found.is_proved) == ("8_18", True)

# %% Its shortest shape
result = vfc.untangle(knot, certificate=True, lower_ropelength=True)
ropelengths = [vfc.measure(curve).ropelength for curve in (knot, result.curves)]
print(f"{result.status} after {result.statistics.iterations} iterations, "
      f"{len(knot)} -> {len(result.curves)} points, "
      f"ropelength {ropelengths[0]:.1f} -> {ropelengths[1]:.1f}")
assert ropelengths[1] < ropelengths[0] / 2

# %% It is the same knot: no strand has passed another one.
verdict = vfc.verify(result.certificate, knot, result.curves)
print("the record is valid:", verdict.is_valid)
assert verdict
assert vfc.identify(result.curves).name == found.name

# %% A picture
try:
    import matplotlib
except ImportError:
    print("no picture: matplotlib is absent")
else:
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(8, 4))
    for place, curve in enumerate((knot, result.curves), start=1):
        axes = figure.add_subplot(1, 2, place, projection="3d")
        axes.plot(*np.vstack([curve, curve[:1]]).T)
        axes.set_aspect("equal")
    figure.savefig("knots.png")
