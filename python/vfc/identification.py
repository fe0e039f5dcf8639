# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The names of knots, of closed curves and of open chains."""

from __future__ import annotations

from typing import Any

from . import _vfc
from ._results import ChainIdentity, LinkIdentity, made
from .curves import Curves, to_core
from .runs import PROGRESS, Progress, describe


def identify(curves: Curves, *, progress: Progress = None) -> LinkIdentity:
    """Names the knot of closed curves, with polynomials and a diagram; proved up to 10 crossings.

    Args:
        curves: the curves
        progress: a function of a dictionary; if it returns `False`, `Interrupted` is raised
    """
    return made("LinkIdentity", _vfc.identify(to_core(curves), progress))


def identify_chain(chain: Any, *, progress: Progress = None, **options: Any) -> ChainIdentity:
    result = _vfc.identify_chain(to_core([chain], closed=False), options, progress)
    return made("ChainIdentity", result)


describe(identify_chain, """Names the knots that an open chain, such as a protein, forms when it is closed.

    An open chain has no knot type, but each closure has. Both ends are extended to infinity along
    one direction, for many directions; the knots come with their shares of these closures.

    Parameters
    ----------
    chain : array of shape (n, 3)
        The points along the chain.""", PROGRESS)
