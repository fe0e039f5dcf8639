# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Curves and meshes that tests share."""

import numpy as np

CUBE_VERTICES = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
SQUARE = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
CUBE_FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5],
                       [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])


def circle(points=16, at=(0, 0, 0), radius=1.0):
    angle = np.linspace(0, 2 * np.pi, points, endpoint=False)
    return radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle]) + at
