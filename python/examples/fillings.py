# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Fills a cube with a curve that is thinner at the bottom, and draws it, if matplotlib is there."""

import numpy as np
import vfc

vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
faces = np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
result = vfc.fill(vertices, faces, thickness=0.08 + 0.04 * vertices[:, 2])
print(f"{result.status}: {100 * result.coverage.fraction_within_r:.0f} % of the volume within r")
tube_vertices, tube_faces = vfc.tube(result.curves, 0.02)  # for pyvista, polyscope, trimesh
print(f"a tube of {len(tube_faces)} triangles")

try:
    import matplotlib
except ImportError:
    pass
else:
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    axes = plt.figure().add_subplot(projection="3d")
    for curve in result.curves:
        axes.plot(*np.vstack([curve, curve[:1]]).T, linewidth=0.8)
    plt.savefig("filling.png")
