# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Domains, which curves fill or must not leave."""

from __future__ import annotations

from typing import Any, Callable, Optional, Sequence

import numpy as np

from . import _vfc
from .arguments import integers, is_one, number, numbers, vector


class Domain:
    """A domain: a `Mesh`, `Polygons`, a `Box`, a `Ball` or an `Implicit` one."""

    def __init__(self, core: _vfc.Domain, description: str):
        self._core = core
        self._description = description

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._description})"


def core_of(domain: Any) -> _vfc.Domain:
    """The domain as an object of the compiled module."""
    if not isinstance(domain, Domain):
        raise TypeError(f"the domain is a {type(domain).__name__}, but must be a Domain, such as "
                        "Mesh(vertices, faces)")
    return domain._core


def core_or_none(domain: Any) -> Optional[_vfc.Domain]:
    return None if domain is None else core_of(domain)


class Mesh(Domain):
    """The inside of a closed triangle mesh.

    Args:
        vertices: array of shape (n, 3)
        faces: integer array of shape (m, 3), of indices of vertices

    Raises:
        ValueError: if the mesh is not closed or intersects itself
    """

    def __init__(self, vertices: Any, faces: Any):
        core = _vfc.inside_of_mesh(numbers(vertices, "vertices"), integers(faces, "faces"))
        super().__init__(core, f"{len(vertices)} vertices, {len(faces)} faces")


class Polygons(Domain):
    """The inside of polygons in the plane z = 0, which a curve fills without leaving the plane.

    Args:
        polygons: each is its corners, an array of shape (n, 2), or a list of such arrays: first the
            outer boundary, then the holes

    Raises:
        ValueError: if boundaries touch themselves or one another, or holes are outside
    """

    def __init__(self, *polygons: Any):
        for polygon in polygons:
            if not hasattr(polygon, "__getitem__") or len(polygon) == 0:
                raise TypeError(f"a polygon is {polygon!r}, but must be an array of corners, or a list of such arrays")
        rings = [[polygon] if is_one(polygon) else list(polygon) for polygon in polygons]
        super().__init__(
            _vfc.inside_of_polygons([[numbers(ring, "corners") for ring in part] for part in rings]),
            f"{len(rings)} polygons, {sum(len(part) - 1 for part in rings)} holes")


class Box(Domain):
    """A box with sides parallel to the axes, between two opposite corners."""

    def __init__(self, low: Sequence[float], high: Sequence[float]):
        core = _vfc.inside_of_box(vector(low, "low"), vector(high, "high"))
        super().__init__(core, f"{list(low)}, {list(high)}")


class Ball(Domain):
    """A ball."""

    def __init__(self, center: Sequence[float], radius: float):
        core = _vfc.inside_of_ball(vector(center, "center"), number(radius, "radius"))
        super().__init__(core, f"{list(center)}, {radius}")


class Implicit(Domain):
    """Where a function of a point is negative, for example a signed distance.

    The function takes an array of shape (3,) and returns a number. It is called often, which takes
    the interpreter's lock each time: filling a mesh is about a hundred times faster.

    Args:
        function: the function
        low, high: opposite corners of a box, outside of which the function is nowhere negative
        lipschitz_bound: by how much the function changes at most per unit of length; with a smaller
            number than that a curve could leave the domain
    """

    def __init__(self, function: Callable[[np.ndarray], float], low: Sequence[float],
                 high: Sequence[float], *, lipschitz_bound: float = 1):
        if not callable(function):
            raise TypeError(f"function is {function!r}, but must be a function of a point")
        core = _vfc.where_negative(function, vector(low, "low"), vector(high, "high"),
                                   number(lipschitz_bound, "lipschitz_bound"))
        super().__init__(core, f"{function!r}, {list(low)}, {list(high)}")
