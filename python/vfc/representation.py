# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Volume_filling_curves authors
"""What results look like at the prompt: their members, long ones by their size only."""

from __future__ import annotations

from typing import Any

import numpy as np


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"<array {value.shape}>"
    if isinstance(value, list) and len(value) > 3:
        return f"<{len(value)} items>"
    return f"{value:.6g}" if isinstance(value, float) else repr(value)


class Short:
    """A dataclass whose `repr` fits a few lines."""

    def __repr__(self) -> str:
        members = (f"{name}={_short(value)}" for name, value in vars(self).items())
        return f"{type(self).__name__}({', '.join(members)})"
