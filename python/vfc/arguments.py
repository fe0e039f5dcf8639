# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""Arguments as the compiled module takes them; an error names the one that is wrong."""

from __future__ import annotations

import operator
import reprlib
from typing import Any

import numpy as np

INT_MAX = 2**31 - 1  # of int in C++
SIZE_MAX = 2**63 - 1  # the largest index in NumPy; std::size_t holds more


def integer(value: Any, name: str, least: int = 0, most: int = SIZE_MAX) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {reprlib.repr(value)}, but must be an integer") from None
    if number < least:
        limit = f"be at least {least}" if least else "not be negative"
        raise ValueError(f"{name} is {number}, but must {limit}")
    if number > most:
        raise ValueError(f"{name} is {number}, but must be at most {most}")
    return number


def number(value: Any, name: str) -> float:
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except OverflowError:
        raise ValueError(f"{name} is {reprlib.repr(value)}, which is too large") from None
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {reprlib.repr(value)}, but must be a number") from None


def numbers(value: Any, name: str) -> np.ndarray:
    """An array of floats."""
    array = _array(value, name)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name} must hold numbers, but has the dtype {array.dtype}")
    return array.astype(float, order="C", copy=False)  # a MemoryError of NumPy says how much is missing


def integers(value: Any, name: str) -> np.ndarray:
    """An array of indices. NumPy itself would cut off the decimals of floats."""
    array = _array(value, name)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise TypeError(f"{name} must hold integers, but has the dtype {array.dtype}")
    if array.dtype.kind == "u" and array.size > 0:
        integer(array.max(), name)  # NumPy itself would turn it into a negative index
    return array.astype(np.int64, order="C", copy=False)


def is_one(value: Any) -> bool:
    """Whether these are rows of coordinates, not a list of such arrays. Rows of np.matrix have two dimensions."""
    return len(value) > 0 and (value.ndim == 2 if isinstance(value, np.ndarray) else np.ndim(value[0]) == 1)


def vector(value: Any, name: str) -> np.ndarray:
    coordinates = numbers(value, name)
    if coordinates.shape != (3,):
        raise ValueError(f"{name} has the shape {coordinates.shape}, but must have three coordinates")
    if not np.isfinite(coordinates).all():
        raise ValueError(f"{name} has a coordinate that is not finite")
    return coordinates


def field(value: Any, name: str) -> Any:
    """An array of floats in place of any array; numbers and functions stay what they are."""
    is_array = not callable(value) and (isinstance(value, (list, tuple)) or np.ndim(value) > 0)
    return numbers(value, name) if is_array else unmasked(value, name)


def unmasked(value: Any, name: str) -> Any:
    """The value; the compiled module does not see the mask of an array."""
    if np.ma.is_masked(value):
        raise ValueError(f"{name} has masked values")
    return value


def _array(value: Any, name: str) -> np.ndarray:
    value = unmasked(value, name)
    try:
        return np.asarray(value)
    except ValueError:  # of lists of different lengths
        raise ValueError(f"{name} has rows of different lengths") from None
