# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Check and repair of triangle meshes that are to be filled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _vfc
from .arguments import integers, number, numbers
from .defects import MeshDefect
from .runs import Progress


@dataclass(repr=False, eq=False)
class RepairedMesh:
    """A mesh that bounds a domain.

    Attributes:
        vertices: array of shape (n, 3)
        faces: integer array of shape (m, 3), oriented outwards
        steps: what was repaired, in words; empty if nothing was
        distance_from_input: the greatest distance of the result from the input's surface, estimated
            from some 10,000 points, in the input's unit
        distance_to_result: that of the input's surface from the result, which may leave out parts
    """

    vertices: np.ndarray
    faces: np.ndarray
    steps: list[str]
    distance_from_input: float
    distance_to_result: float

    def __repr__(self) -> str:
        return (f"<RepairedMesh: {len(self.vertices)} vertices, {len(self.faces)} faces, "
                f"{len(self.steps)} steps>")


def check_mesh(vertices: Any, faces: Any, *, progress: Progress = None) -> list[MeshDefect]:
    """Lists the errors of a mesh as the boundary of a domain, and warnings; decided exactly.

    Args:
        vertices: array of shape (n, 3)
        faces: integer array of shape (m, 3), of indices of vertices
        progress: a function of a dictionary with the keys stage and seconds; if it returns `False`,
            `Interrupted` is raised

    Returns:
        a list of `MeshDefect`, at most 1000 of each kind; `fill()` takes the mesh if none is an error
    """
    found = _vfc.check_mesh(numbers(vertices, "vertices"), integers(faces, "faces"), progress)
    return [MeshDefect(**defect) for defect in found]


def repair(vertices: Any, faces: Any, *, alpha: float = 0,
           progress: Progress = None) -> RepairedMesh:
    """Repairs a mesh by the steps that change it least, so that `fill()` takes it.

    Equal vertices are merged, small sheets and flat faces are removed, holes are closed,
    self-intersections are cut out and shells are united. Only if that does not suffice, a new surface
    is wrapped around all faces.

    Args:
        vertices: array of shape (n, 3)
        faces: integer array of shape (m, 3), of indices of vertices
        alpha: the width of gaps that a wrapped surface does not enter, in the input's unit; 0 stands
            for a fiftieth of the diagonal
        progress: a function of a dictionary with the keys stage and seconds; if it returns `False`,
            `Interrupted` is raised

    Raises:
        ValueError: if the mesh cannot be repaired, for example if no face has an area
    """
    return RepairedMesh(**_vfc.repair(numbers(vertices, "vertices"), integers(faces, "faces"),
                                      number(alpha, "alpha"), progress))
