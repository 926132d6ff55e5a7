# SPDX-License-Identifier: Apache-2.0
"""Whole numbers of Python, of NumPy, and floating-point numbers without a fraction."""

from __future__ import annotations

from numbers import Real
from typing import Any


def whole_number(value: Any) -> int | None:
    """The whole number; None for a fraction, infinity, NaN, a truth value, and what is no number.

    Parameters
    ----------
    value
        Any value.

    Examples
    --------
    >>> import numpy as np
    >>> [whole_number(value) for value in (24, np.int64(24), 24.0, 24.5, True)]
    [24, 24, 24, None, None]
    """
    if isinstance(value, bool) or not isinstance(value, Real) or value % 1 != 0:
        return None
    return int(value)
