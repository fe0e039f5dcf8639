# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Checks of curves: whether they meet themselves, and whether they keep inside a domain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

import numpy as np

from . import _vfc
from .arguments import number
from .curves import Closed, Curves, flat, to_core
from .defects import CurveDefect
from .domains import Domain, core_of, core_or_none
from .representation import Short
from .runs import Progress


@dataclass(repr=False, eq=False)
class WallDistance(Short):
    """The least distance of curves to the boundary of a domain.

    Attributes:
        distance: the distance, in the input's unit
        point: the point of the curves that comes nearest
        edge: the indices of the two points of its edge, among the points of all curves
    """

    distance: float
    point: np.ndarray
    edge: list[int]


def outside(curves: Curves, domain: Domain, *, closed: Closed = True,
            progress: Progress = None) -> tuple[list[int], list[list[int]]]:
    """The points, and the edges, that are not strictly inside the domain; decided exactly.

    Returns:
        the indices of points, among those of all curves, and a pair of such indices for each edge
    """
    return _vfc.outside(to_core(curves, closed), core_of(domain), progress)


def wall_distance(curves: Curves, domain: Domain, *, closed: Closed = True,
                  progress: Progress = None) -> WallDistance:
    """The least distance of curves to the boundary of the domain they are in, along whole edges.

    It is exact up to rounding in meshes and polygons. In others it may be too large by 0.1 %.

    Raises:
        ValueError: if the curves are not inside
    """
    return WallDistance(**_vfc.wall_distance(to_core(curves, closed), core_of(domain), progress))


def check_curves(curves: Curves, *, closed: Closed = True, domain: Optional[Domain] = None,
                 wall_distance: float = 0, progress: Progress = None) -> list[CurveDefect]:
    """Lists the errors of curves, and warnings. Contacts are decided exactly.

    Args:
        curves: the curves
        closed: whether they are closed, or a list with a value for each
        domain: the domain that has to contain the curves
        wall_distance: how far from its boundary they have to keep, in the input's unit; needs a
            domain
        progress: a function of a dictionary; if it returns `False`, `Interrupted` is raised

    Returns:
        a list of `CurveDefect`; functions take the curves if none is an error

    Raises:
        ValueError: if `wall_distance` is negative or not finite, or given without a domain
    """
    if not 0 <= number(wall_distance, "wall_distance") < np.inf:
        raise ValueError(f"wall_distance is {wall_distance}, but must be finite and not negative")
    if domain is None and wall_distance > 0:
        raise ValueError("wall_distance needs a domain")
    inside = core_or_none(domain)
    found = _vfc.check_curves(*flat(curves, closed), progress)
    defects = [CurveDefect(**defect) for defect in found]
    if inside is None or any(defect.is_error for defect in defects):
        return defects
    core = to_core(curves, closed)
    points, edges = _vfc.outside(core, inside, progress)
    defects += [_error("outside node", "a point is not strictly inside", [point]) for point in points]
    defects += [_error("outside segment", "an edge is not strictly inside", edge) for edge in edges]
    if edges or wall_distance == 0:
        return defects
    nearest = WallDistance(**_vfc.wall_distance(core, inside, progress))
    if nearest.distance < wall_distance:
        message = f"an edge comes as near to the boundary as {nearest.distance:.6g}"
        defects.append(_error("near wall", message, nearest.edge))
    return defects


def _error(kind: str, message: str, points: list[int]) -> CurveDefect:
    return CurveDefect(kind, True, message, np.array(points))
