# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Curves in files: OBJ, and .polylines.txt."""

from __future__ import annotations

import os
from typing import Any

from . import _vfc
from .curves import Closed, Curves, Network, split, to_core


def read(file: Any, *, network: bool = False) -> tuple[list, list] | Network:
    """Reads curves without loss.

    Args:
        file: the path of an .obj or .polylines.txt file
        network: whether to accept junctions

    Returns:
        a list of arrays of shape (n, 3) and a list that says which are closed; a `Network` if
        `network` is true

    Raises:
        OSError: if the file cannot be opened
        ValueError: if it holds no valid curve, with the line
    """
    with open(file, "rb"):  # raises the OSError that fits
        core = _vfc.read(os.fspath(file), bool(network))
    if network:
        return Network(core.points(), core.edges())
    return split(core.points(), core), core.closedness()


def write(file: Any, curves: Curves, *, closed: Closed = True) -> None:
    """Writes curves without loss, with 17 significant digits; replaces the file when complete.

    Raises:
        OSError: if the file cannot be written
    """
    _vfc.write(os.fspath(file), to_core(curves, closed))
