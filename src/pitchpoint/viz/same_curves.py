# SPDX-License-Identifier: Apache-2.0
"""Equal curves drawn once, with the names of all."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeVar

Curve = TypeVar("Curve")


def grouped(
    curves: Mapping[str, Curve], same: Callable[[Curve, Curve], bool]
) -> list[tuple[list[str], Curve]]:
    """First of each set of equal curves, with the names of all.

    Parameters
    ----------
    curves
        Curves by name.
    same
        Whether two curves are equal.

    Examples
    --------
    >>> grouped({"a": 1.0, "b": 2.0, "c": 1.0}, lambda x, y: x == y)
    [(['a', 'c'], 1.0), (['b'], 2.0)]
    """
    found: list[tuple[list[str], Curve]] = []
    for name, curve in curves.items():
        names = next((names for names, other in found if same(other, curve)), None)
        if names is None:
            found.append(([name], curve))
        else:
            names.append(name)
    return found
