# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""The runs: untangle, fill, simplify, and the verification of their records."""

from __future__ import annotations

import inspect
import reprlib
from dataclasses import dataclass
from math import isnan
from typing import Any, Callable, Optional

import numpy as np

from . import _options, _results, _vfc
from .arguments import field
from .curves import Closed, Curves, from_core, kept, origins, size, to_core
from .domains import Domain, Mesh, core_of, core_or_none

Progress = Optional[Callable[[dict], Any]]


@dataclass(repr=False, eq=False)
class Untangled(_results.UntanglingResult):
    __doc__ = _results.UntanglingResult.__doc__ + """
        curves: the result, in the form of the input
        origin: for each point of the result the index, among the points of all curves of the input,
            of the point that it came from, or -1 if it was inserted
        certificate: the record of the run, if it was asked for
    """

    curves: Curves
    origin: Any
    certificate: Optional[bytes]

    def __repr__(self) -> str:
        return f"<Untangled: {self.status}, {self.statistics.iterations} iterations, {size(self.curves)}>"


@dataclass(repr=False, eq=False)
class Filled(_results.FillingResult):
    __doc__ = _results.FillingResult.__doc__ + """
        curves: a list of curves, or the result in the form of the curves that were given
        closed: whether each of them is closed
        certificate: the record of the run, if it was asked for
    """

    curves: Curves
    closed: list
    certificate: Optional[bytes]

    def __repr__(self) -> str:
        within = 100 * self.coverage.fraction_within_r
        share = "" if isnan(within) else f"{within:.0f} % within r = {self.thickness:.4g}, "
        return f"<Filled: {self.status}, {share}{size(self.curves)}>"


@dataclass(repr=False, eq=False)
class Simplified:
    """The result of `simplify()`.

    Attributes:
        removed_nodes: how many points were removed
        curves: the result, in the form of the input
        origin: for each point of the result the index, among the points of all curves of the input,
            of the point that it came from
        certificate: the record of the run, if it was asked for
    """

    removed_nodes: int
    curves: Curves
    origin: Any
    certificate: Optional[bytes]

    def __repr__(self) -> str:
        return f"<Simplified: {self.removed_nodes} points removed, {size(self.curves)}>"


def _record(is_wanted: bool) -> Optional[_vfc.Certificate]:
    return _vfc.Certificate() if is_wanted else None


def _bytes(record: Optional[_vfc.Certificate]) -> Optional[bytes]:
    return record.bytes() if record else None


def untangle(curves: Curves, *, domain: Optional[Domain] = None, closed: Closed = True,
             pin: Any = None, certificate: bool = False, progress: Progress = None,
             **options: Any) -> Untangled:
    curves = kept(curves)
    core = to_core(curves, closed, pin)
    record = _record(certificate)
    result = _vfc.untangle(core, core_or_none(domain), options, record, progress)
    return Untangled(**_results.with_classes("UntanglingResult", result),
                     curves=from_core(core, curves), origin=origins(core, curves),
                     certificate=_bytes(record))


def fill(domain: Any, faces: Any = None, *, curves: Optional[Curves] = None, closed: Closed = True,
         pin: Any = None, certificate: bool = False, progress: Progress = None,
         **options: Any) -> Filled:
    if faces is not None:
        domain = Mesh(domain, faces)
    if not isinstance(domain, Domain):
        raise TypeError("fill() takes vertices and faces, or a Domain")
    if curves is None and (pin is not None or closed is not True):
        raise TypeError("closed and pin are about curves, but no curves are given")
    for name in ("thickness", "direction_field"):
        options[name] = field(options.get(name), name)
    if isinstance(options["direction_field"], np.ndarray):
        options["direction_field"] = np.atleast_1d(options["direction_field"])
    given = [] if curves is None else kept(curves)
    core = to_core(given, closed, pin)
    record = _record(certificate)
    result = _vfc.fill(core, core_of(domain), options, record, progress)
    return Filled(**_results.with_classes("FillingResult", result),
                  curves=from_core(core, given), closed=core.closedness(),
                  certificate=_bytes(record))


def simplify(curves: Curves, *, closed: Closed = True, pin: Any = None, certificate: bool = False,
             progress: Progress = None, **options: Any) -> Simplified:
    curves = kept(curves)
    core = to_core(curves, closed, pin)
    record = _record(certificate)
    removed = _vfc.simplify(core, options, record, progress)
    return Simplified(removed, from_core(core, curves), origins(core, curves), _bytes(record))


def verify(certificate: bytes, start: Curves, end: Curves, *, domain: Optional[Domain] = None,
           closed: Closed = True, progress: Progress = None) -> _results.Verdict:
    """Replays the record of a run with exact arithmetic, by code that shares nothing with the run.

    Args:
        certificate: the record, from `untangle()`, `fill()` or `simplify()`
        start: the input of the run; of a filling without curves, `Filled.start`
        end: the result of the run
        domain: the domain that the curves must not have left
        closed: whether the curves are closed, or a list with a value for each
        progress: a function of a dictionary; if it returns `False`, `Interrupted` is raised

    Returns:
        a `Verdict`, which is true if the record proves that the curves are ambient isotopic
    """
    if not isinstance(certificate, (bytes, bytearray)):
        raise TypeError(f"certificate is {reprlib.repr(certificate)}, but must be the bytes that a "
                        "run returns with certificate=True")
    core = _vfc.Certificate(bytes(certificate))
    result = _vfc.verify(core, to_core(start, closed), to_core(end, closed), core_or_none(domain),
                         progress)
    return _results.Verdict(**result)


_COMMON = """
    closed : bool or list of bool, default True
        Whether the curves are closed. The last point of a closed curve may repeat the first.
    pin : 'ends' or indices of points, default None
        The points that stay where they are; indices count over the points of all curves. The ends
        of open curves are free by default, and a strand may slip off a free end.
    certificate : bool, default False
        Whether to record the run, for `verify()`.
    progress : function of a dict, default None
        Is called some twenty times a second. If it returns `False`, the run ends, and the result is
        the current curve; with any other value it goes on. Keys: stage, fraction,
        iterations, nodes, length, gradient_norm, seconds, thickness, expected_length,
        expected_nodes, expected_seconds. The stages are:""" + _options.STAGES

PROGRESS = """
    progress : function of a dict, default None
        Is called some twenty times a second. If it returns `False`, `Interrupted` is raised.
"""

_RAISES = """
    Raises
    ------
    ValueError
        if the input is not embedded or a value is out of its range; the message names the culprit
    TypeError
        if a keyword is unknown or a value has a wrong type
    KeyboardInterrupt
        on Ctrl-C
"""


def describe(function: Callable, text: str, common: str = _COMMON) -> None:
    """Documents a function, with the options that it passes on to the library."""
    function.__doc__ = text + common + _options.TEXTS[function.__name__] + _RAISES
    own = inspect.signature(function)
    named = [given for given in own.parameters.values() if given.kind != given.VAR_KEYWORD]
    options = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default)
               for name, default in _options.DEFAULTS[function.__name__].items()]
    function.__signature__ = own.replace(parameters=named + options)


describe(untangle, """Moves curves to a short and simple shape, without ever passing through themselves.

    Every change is certified with exact predicates: the result is ambient isotopic to the input.

    Parameters
    ----------
    curves : array of shape (n, 3), list of such arrays, or Network
        The curves, in any unit of length.
    domain : Domain, default None
        The domain in which the curves stay, such as a `Mesh`, whose cavities are obstacles.""")
describe(fill, """Fills a domain evenly with curves, which never leave it and never touch one another.

    Parameters
    ----------
    domain, faces : array of shape (n, 3), integer array of shape (m, 3)
        Vertices and faces of a closed triangle mesh; or a `Domain` alone. The options `thickness`
        and `direction_field` also take a function of a point or, in a mesh, an array with a row per
        vertex; a direction can be one vector.
    curves : curves inside the domain, default None
        The start. By default each connected part of the inside gets a curve.""")
describe(simplify, """Removes every point that can be removed without changing the knot type.

    Parameters
    ----------
    curves : array of shape (n, 3), list of such arrays, or Network
        The curves, in any unit of length.""")
