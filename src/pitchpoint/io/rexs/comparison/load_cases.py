# SPDX-License-Identifier: Apache-2.0
"""Load cases of two gear units that belong together."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TypeAlias

import numpy as np

from pitchpoint.io.rexs.comparison.equality import distance
from pitchpoint.io.rexs.document import RexsAttribute, RexsLoadCase, RexsModel

Values: TypeAlias = Mapping[int, Mapping[str, RexsAttribute]]
"""Values of the components of a load case."""
ID = 1e-3
"""Cost of another id or place, which decides only between load cases that are otherwise equal."""


def paired_cases(
    a: RexsModel, b: RexsModel, pairs: Mapping[int, int]
) -> Iterator[tuple[str, Values | None, Values | None]]:
    """Load cases, and values accumulated over load spectra, of both gear units.

    Load cases are paired by their values, so that other ids and another order do not count.

    Parameters
    ----------
    a, b
        The gear units.
    pairs
        Components of `b` by those of `a`.

    Yields
    ------
    tuple
        Load case in words, its values in `a` and in `b`; None if it is only in the other one.
    """
    from scipy.optimize import linear_sum_assignment

    for k in range(max(len(a.load_spectra), len(b.load_spectra))):
        one, two = (m.load_spectra[k] if k < len(m.load_spectra) else None for m in (a, b))
        of_a = one.cases if one is not None else ()
        of_b = two.cases if two is not None else ()
        cost = np.array([[_cost(x, y, pairs) for y in of_b] for x in of_a]).reshape(len(of_a), len(of_b))
        chosen = dict(zip(*(side.tolist() for side in linear_sum_assignment(cost)), strict=True))
        many = f" of load spectrum {k + 1}" if max(len(a.load_spectra), len(b.load_spectra)) > 1 else ""
        for x, case in enumerate(of_a):
            other = of_b[chosen[x]].components if x in chosen else None
            yield f"{case.id}{many}", case.components, other
        for y, case in enumerate(of_b):
            if y not in chosen.values():
                yield f"{case.id}{many}", None, case.components
        total_a, total_b = ({} if s is None else s.accumulation for s in (one, two))
        if total_a or total_b:
            yield f"total{many}", total_a, total_b


def _cost(x: RexsLoadCase, y: RexsLoadCase, pairs: Mapping[int, int]) -> float:
    """Mean difference of the values of two load cases."""
    total, count = 0.0, 0
    back = {j: i for i, j in pairs.items()}
    there = {back[j]: values for j, values in y.components.items() if j in back}
    for i in x.components.keys() | there.keys():
        mine, other = x.components.get(i, {}), there.get(i, {})
        for name in mine.keys() | other.keys():
            total += distance(mine.get(name), other.get(name))
            count += 1
    return (total / count if count else 0.0) + ID * (x.id != y.id)
