# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Curves in files."""

from __future__ import annotations

import os
from typing import Any, Optional

from . import _vfc
from .curves import Closed, Curves, Network, split, to_core


def read(file: Any, *, network: bool = False,
         closed: Optional[bool] = None) -> tuple[list, list] | Network:
    """Reads curves without loss.

    Args:
        file: the path of an .obj, .polylines.txt, .ply, .vtp, .vect, .xyz, .txt, .dat, .pdb, .ent or
            .cif file, the last three of proteins and nucleic acids, whose backbones are read
        network: whether to accept junctions
        closed: whether the curves are closed, whatever the file says; lists of points need it if
            their ends nearly meet

    Returns:
        a list of arrays of shape (n, 3) and a list that says which are closed; a `Network` if
        `network` is true

    Raises:
        OSError: if the file cannot be opened
        ValueError: if it holds no valid curve, with the line
    """
    if closed not in (None, True, False):
        raise TypeError(f"closed is {closed!r}, but must be True, False or None")
    with open(file, "rb"):  # raises the OSError that fits
        core = _vfc.read(os.fsencode(file), bool(network), None if closed is None else bool(closed))
    if network:
        return Network(core.points(), core.edges())
    return split(core.points(), core), core.closedness()


def write(file: Any, curves: Curves, *, closed: Closed = True) -> None:
    """Writes curves without loss, with 17 significant digits; replaces the file when complete.

    The formats are .obj, .polylines.txt, .ply, .vtp, .vect, .xyz, .txt and .dat.

    Raises:
        OSError: if the file cannot be written
        ValueError: if the name has no extension of these, or there is no curve
    """
    if b"\0" in os.fsencode(file):
        raise ValueError("the name of the file has a null character")
    _vfc.write(os.fsencode(file), to_core(curves, closed))
