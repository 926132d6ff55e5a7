# SPDX-License-Identifier: Apache-2.0
"""Numbers of Python and of NumPy, without truth values."""

from __future__ import annotations

from numbers import Real
from typing import Any


def whole_number(value: Any) -> int | None:
    """The whole number; None for a fraction, infinity, NaN, a truth value, and what is not a number.

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
    number = real_number(value)
    return None if number is None or number % 1.0 != 0.0 else int(number)


def real_number(value: Any) -> float | None:
    """The number; None for a truth value and for what is not a number.

    Parameters
    ----------
    value
        Any value.

    Examples
    --------
    >>> import numpy as np
    >>> [real_number(value) for value in (0.5, np.float32(0.5), 1, True, "0.5")]
    [0.5, 0.5, 1.0, None, None]
    """
    return float(value) if isinstance(value, Real) and not isinstance(value, bool) else None
