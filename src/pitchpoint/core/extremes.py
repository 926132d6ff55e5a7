# SPDX-License-Identifier: Apache-2.0
"""Extreme value of a channel from its statistics."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


def greatest(row: Mapping[str, Any]) -> float:
    """Extreme value of a channel with the largest magnitude: forces on the back flank are negative.

    Parameters
    ----------
    row
        Statistics of the channel, with `min` and `max`.

    Examples
    --------
    >>> greatest({"min": -3.0, "max": 1.0})
    -3.0
    """
    return max(float(row["min"]), float(row["max"]), key=abs)
