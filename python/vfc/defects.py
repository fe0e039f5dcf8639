# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Defects of curves and of meshes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(eq=False)
class Defect:
    kind: str
    is_error: bool
    message: str

    def __str__(self) -> str:
        return f"{'error' if self.is_error else 'warning'}: {self.kind}: {self.message}"


@dataclass(eq=False)
class CurveDefect(Defect):
    """A defect of curves, or an oddity that does no harm.

    Attributes:
        kind: for example "self-contact", "coincident nodes" or "outside segment"
        is_error: whether functions refuse the curves because of it
        message: what it is
        points: the indices of the points concerned, among the points of all curves
    """

    points: np.ndarray


@dataclass(eq=False)
class MeshDefect(Defect):
    """A defect of a mesh, or an oddity that does no harm.

    Attributes:
        kind: for example "open boundary" or "self-intersection"
        is_error: whether the mesh bounds no domain because of it
        message: what it is, and where
        vertices: the indices of the vertices concerned
        faces: the indices of the faces concerned
    """

    vertices: np.ndarray
    faces: np.ndarray
