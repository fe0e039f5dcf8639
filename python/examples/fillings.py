# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Fills a cube with a curve that is thinner at the bottom, and draws it, if matplotlib is there."""

# %% A mesh: vertices, and faces as indices of vertices
import numpy as np

import vfc

vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
faces = np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
assert vfc.check_mesh(vertices, faces) == []

# %% A thickness at each vertex
result = vfc.fill(vertices, faces, thickness=0.08 + 0.04 * vertices[:, 2])
share = result.coverage.fraction_within_r
print(f"{result.status}: {100 * share:.0f} % of the volume within r, length {vfc.length(result.curves):.1f}")
assert result.status == "converged" and share > 0.7

# %% A tube around the curve, for pyvista, polyscope or trimesh
tube_vertices, tube_faces = vfc.tube(result.curves, 0.02, closed=result.closed)
print(f"a tube of {len(tube_faces)} triangles")
assert vfc.check_mesh(tube_vertices, tube_faces) == []

# %% A picture
try:
    import matplotlib
except ImportError:
    print("no picture: matplotlib is absent")
else:
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    axes = plt.figure().add_subplot(projection="3d")
    for curve in result.curves:
        axes.plot(*np.vstack([curve, curve[:1]]).T, linewidth=0.8)
    axes.set_aspect("equal")
    plt.savefig("filling.png")

# %% A picture with light and shadow
try:
    import pyvista
except ImportError:
    print("no second picture: pyvista is absent")
else:
    plotter = pyvista.Plotter(off_screen=True)
    plotter.add_mesh(pyvista.PolyData(tube_vertices, np.insert(tube_faces, 0, 3, axis=1)), smooth_shading=True)
    plotter.screenshot("tube.png")
