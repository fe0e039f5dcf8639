# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Curves as arrays."""

from __future__ import annotations

import reprlib
from dataclasses import dataclass
from os import PathLike
from typing import Any, Sequence, Union

import numpy as np

from . import _vfc
from .arguments import integers, is_one, numbers


@dataclass(repr=False, eq=False)
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
    return not isinstance(curves, Network) and is_one(curves)


def _flags(closed: Closed, count: int) -> list[bool]:
    flags = np.asarray(closed)
    if flags.dtype.kind not in "biu" and flags.size > 0:
        raise TypeError(f"closed is {closed!r}, but must be True, False, or a list of such values")
    if flags.ndim == 0:
        return [bool(flags)] * count
    if flags.ndim > 1:
        raise ValueError(f"closed has the shape {flags.shape}, but must be a list")
    if len(flags) != count:
        raise ValueError(f"closed has {len(flags)} values, but there are {count} curves")
    return flags.astype(bool).tolist()


def _rows(curve: Any) -> np.ndarray:
    rows = numbers(curve, "a curve")
    if rows.ndim != 2 or rows.shape[1] != 3:
        hint = "; read() returns curves, and which are closed" if rows.ndim == 3 else ""
        raise ValueError(f"a curve has the shape {rows.shape}, but must have the shape (n, 3){hint}")
    return rows


def flat(curves: Curves, closed: Closed = True) -> tuple:
    """The points of all curves, and which are joined: edges, or where each begins and if it closes."""
    if isinstance(curves, Network):
        return numbers(curves.points, "points"), integers(curves.edges, "edges")
    if isinstance(curves, (str, PathLike)):
        raise TypeError(f"the curve is the name '{curves}', but must be an array; read() reads a file")
    is_scalar = isinstance(curves, np.ndarray) and curves.ndim == 0
    if not hasattr(curves, "__getitem__") or isinstance(curves, (dict, memoryview)) or is_scalar:
        hint = "; pass its member curves" if hasattr(curves, "curves") else ""
        raise TypeError(f"the curves are {reprlib.repr(curves)}, but must be an array of points, a list of such "
                        f"arrays, or a Network{hint}")
    parts = [curves] if _is_one(curves) else list(curves)
    flags = _flags(closed, len(parts))
    rows = [_rows(part) for part in parts]
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
        core.pin(_indices(pin))
    return core


def _indices(pin: Any) -> list[int]:
    points = integers(pin, "pin")
    if points.ndim != 1:
        raise ValueError(f"pin has the shape {points.shape}, but must be a list of indices")
    if np.any(points < 0):
        raise ValueError(f"pin: there is no point {points.min()}")
    return points.tolist()


def kept(curves: Curves) -> Curves:
    """The curves, whatever becomes of the list that holds them while a run lasts."""
    return list(curves) if isinstance(curves, list) else curves


def split(array: np.ndarray, core: _vfc.Curve) -> list[np.ndarray]:
    """The rows of each curve; none if there is no curve, where np.split() would return one array."""
    offsets = core.offsets().tolist()
    return [array[first:end] for first, end in zip(offsets, offsets[1:])]


def from_core(core: _vfc.Curve, like: Curves) -> Curves:
    """The curves of the compiled module in the form of the input: an array, a list or a network."""
    if isinstance(like, Network):
        return Network(core.points(), core.edges())
    parts = split(core.points(), core)
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
    parts = split(core.origins(), core)
    return parts[0] if _is_one(like) else parts
