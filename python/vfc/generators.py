# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Closed curves to try things with. The same arguments give the same points on every machine."""

from __future__ import annotations

from typing import Sequence, Union

import numpy as np

from . import _vfc
from .arguments import INT_MAX, integer
from .curves import split

Result = Union[np.ndarray, list]


def _curves(core: _vfc.Curve) -> Result:
    parts = split(core.points(), core)
    return parts[0] if len(parts) == 1 else parts


def torus_knot(p: int, q: int, points: int = 300, *, random_seed: int = 0) -> Result:
    """The torus knot T(p, q); a link, as a list of arrays, if p and q have a common divisor."""
    windings = (integer(p, "p", -INT_MAX, INT_MAX), integer(q, "q", -INT_MAX, INT_MAX))
    return _curves(_vfc.torus_knot(*windings, integer(points, "points"),
                                   integer(random_seed, "random_seed")))


def closed_braid(word: Sequence[int], points: int = 300, *, random_seed: int = 0) -> Result:
    """The closure of a braid: the letter i exchanges the strands i and i + 1, and -i the other way.

    The word [1, 1, 1] is the right-handed trefoil, [1, -2, 1, -2] the figure-eight knot.
    """
    letters = [integer(letter, "a letter of the word", -INT_MAX, INT_MAX) for letter in word]
    return _curves(_vfc.closed_braid(letters, integer(points, "points"),
                                     integer(random_seed, "random_seed")))


def hard_unknot(points: int = 100, moves: int = 2000, *, random_seed: int = 0) -> np.ndarray:
    """A circle after random certified moves: an unknot that does not look like one."""
    return _curves(_vfc.hard_unknot(integer(points, "points"), integer(moves, "moves"),
                                    integer(random_seed, "random_seed")))


def random_polygon(points: int, *, random_seed: int = 0) -> np.ndarray:
    """A random closed polygon with edges of length 1."""
    return _curves(_vfc.random_polygon(integer(points, "points"),
                                       integer(random_seed, "random_seed")))
