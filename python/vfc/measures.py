# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Measures of curves, and of how they fill a domain."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from . import _results, _vfc
from .arguments import field, integer, number
from .curves import Closed, Curves, to_core
from .domains import Domain, core_of, core_or_none
from .runs import Progress


def length(curves: Curves, *, closed: Closed = True) -> float:
    """The length of all curves together, in the input's unit."""
    return _vfc.length(to_core(curves, closed))


def measure(curves: Curves, *, closed: Closed = True, thickness: float = 0,
            progress: Progress = None) -> _results.CurveMeasures:
    """Lengths, curvature, thickness, crossings and linking numbers.

    Args:
        curves: the curves
        closed: whether they are closed
        thickness: edges that are closer than pi times this along a curve are neighbors, which do not
            count for `min_clearance`; with 0, those with a common point
        progress: a function of a dictionary; if it returns `False`, `Interrupted` is raised
    """
    r = number(thickness, "thickness")
    if not r >= 0:
        raise ValueError(f"thickness is {r}, but must not be negative")
    return _results.CurveMeasures(**_vfc.measure(to_core(curves, closed), r, progress))


def coverage(curves: Curves, domain: Domain, thickness: Any, *, closed: Closed = True,
             samples: int = 20000, random_seed: int = 0,
             progress: Progress = None) -> _results.Coverage:
    """Statistics of the distances of uniform samples of the domain to the curves, in thicknesses.

    Args:
        curves: the curves
        domain: the domain
        thickness: r, in the input's unit: a number, a function of a point, or an array with a value
            per vertex of a mesh
        closed: whether the curves are closed, or a list with a value for each
        samples: the number of samples
        random_seed: the seed of the samples
        progress: a function of a dictionary; if it returns `False`, `Interrupted` is raised
    """
    core = to_core(curves, closed)
    return _results.Coverage(
        **_vfc.coverage(core, core_of(domain), field(thickness, "thickness"), integer(samples, "samples"),
                        integer(random_seed, "random_seed"), progress))


def arc_spline(curves: Curves, domain: Optional[Domain] = None, *, closed: Closed = True,
               progress: Progress = None) -> _results.ArcSpline:
    """The smooth curves of arcs and segments that round the corners of curves, for CAD and machines.

    Args:
        curves: the curves
        domain: the domain that the arcs must not leave
        closed: whether the curves are closed
        progress: a function of a dictionary; if it returns `False`, `Interrupted` is raised

    Returns:
        an `ArcSpline`, which says whether it is certified to be ambient isotopic to the curves
    """
    result = _vfc.arc_spline(to_core(curves, closed), core_or_none(domain), progress)
    return _results.made("ArcSpline", result)


def tube(curves: Curves, radius: float, *, closed: Closed = True,
         sides: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """The surface of the tube around curves: vertices (n, 3) and faces (m, 3), oriented outwards.

    At each point, a regular polygon of so many sides, at most 1024, has its corners at the distance
    `radius`, in the plane that bisects the bend. The tube lies within `radius` of the curve; so its
    volume is some per cent less than pi radius^2 length. It does not meet itself if the radius is
    less than the `polygonal_thickness` of `measure()`.
    """
    return _vfc.tube(to_core(curves, closed), number(radius, "radius"), integer(sides, "sides", 3, 1024))
