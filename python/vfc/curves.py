# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Curves as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from typing import Any, Callable, Sequence, Union

import numpy as np

from . import _vfc


@dataclass(repr=False)
class Network:
    """Curves with junctions: points, and edges that join them.

    Attributes:
        points: array of shape (n, 3)
        edges: integer array of shape (m, 2), of indices of points
    """

    points: np.ndarray
    edges: np.ndarray

    def __repr__(self) -> str:
        return f"<Network: {len(self.points)} points, {len(self.edges)} edges>"


Curves = Union[np.ndarray, Sequence[Any], Network]
Closed = Union[bool, Sequence[bool]]


def _is_one(curves: Curves) -> bool:
    return not isinstance(curves, Network) and len(curves) > 0 and np.ndim(curves[0]) == 1


def _flags(closed: Closed, count: int) -> list[bool]:
    flags = [bool(closed)] * count if np.ndim(closed) == 0 else [bool(flag) for flag in closed]
    if len(flags) != count:
        raise ValueError(f"closed has {len(flags)} values, but there are {count} curves")
    return flags


def _rows(curve: Any, is_closed: bool) -> np.ndarray:
    """The points of a curve; a closed one may repeat its first point at the end."""
    rows = np.asarray(curve, dtype=float)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise ValueError(f"a curve has the shape {rows.shape}, but must have the shape (n, 3)")
    is_repeated = is_closed and len(rows) > 1 and np.array_equal(rows[0], rows[-1])
    return rows[:-1] if is_repeated else rows


def flat(curves: Curves, closed: Closed = True) -> tuple:
    """The points of all curves, and which are joined: edges, or where each begins and if it closes."""
    if isinstance(curves, Network):
        return np.asarray(curves.points, float), np.asarray(curves.edges)
    if isinstance(curves, (str, PathLike)):
        raise TypeError(f"the curve is the name '{curves}', but must be an array; read() reads a file")
    parts = [curves] if _is_one(curves) else list(curves)
    flags = _flags(closed, len(parts))
    rows = [_rows(part, flag) for part, flag in zip(parts, flags)]
    offsets = np.cumsum([0] + [len(part) for part in rows])
    points = rows[0] if len(rows) == 1 else np.concatenate(rows or [np.empty((0, 3))])
    return points, offsets.tolist(), flags


def to_core(curves: Curves, closed: Closed = True, pin: Any = None) -> _vfc.Curve:
    """The curves as an object of the compiled module."""
    core = _vfc.Curve(*flat(curves, closed))
    if isinstance(pin, str):
        if pin != "ends":
            raise ValueError(f"pin is '{pin}', but must be 'ends' or indices of points")
        core.pin_ends()
    elif pin is not None:
        core.pin([int(point) for point in pin])
    return core


def _split(array: np.ndarray, core: _vfc.Curve) -> list[np.ndarray]:
    return np.split(array, core.offsets()[1:-1])


def from_core(core: _vfc.Curve, like: Curves) -> Curves:
    """The curves of the compiled module in the form of others: an array, a list or a network."""
    if isinstance(like, Network):
        return Network(core.points(), core.edges())
    parts = _split(core.points(), core)
    return parts[0] if _is_one(like) else parts


def size(curves: Curves) -> str:
    """The numbers of curves and points, for a `repr`."""
    if isinstance(curves, Network):
        return repr(curves)[1:-1]
    parts = [curves] if _is_one(curves) else curves
    number = f"{len(parts)} curves, " if len(parts) != 1 else ""
    return f"{number}{sum(map(len, parts))} points"


def origins(core: _vfc.Curve, like: Curves) -> Any:
    """The input point that each point of the result was, or -1, in the form of the curves."""
    if isinstance(like, Network):
        return core.origins()
    parts = _split(core.origins(), core)
    return parts[0] if _is_one(like) else parts
