# SPDX-License-Identifier: Apache-2.0
"""Stiffness sources: each one small file with one function from a gear pair to a description.

`REGISTRY` lists them by the name that a model file uses. Importing this package imports none of them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any


@dataclass(frozen=True)
class Source:
    """One way to get at a mesh stiffness.

    Parameters
    ----------
    name
        Name in model files, of the module in this package, and of the function in it.
    returns
        Name of the description it returns: "PairShape" or "PhaseStiffness".
    summary
        What it is, in a few words for users.
    """

    name: str
    returns: str
    summary: str

    @property
    def function(self) -> Callable[..., Any]:
        """The source itself, ``function(pair, **options)``; imported on first use.

        >>> REGISTRY["constant"].function(None, mean=1.0e5).mean
        100000.0
        """
        found: Callable[..., Any] = getattr(import_module(f"{__name__}.{self.name}"), self.name)
        return found


#: All stiffness sources by name.
REGISTRY: dict[str, Source] = {
    source.name: source
    for source in (
        Source("din3990", "PairShape", "single stiffness c' by DIN 3990 / ISO 6336-1 with parabola"),
        Source("energy", "PairShape", "teeth as cantilevers, Hertz contact, gear bodies"),
        Source("hertz", "PairShape", "pair as two rounded bodies, force ~ penetration^1.5"),
        Source("constant", "PhaseStiffness", "one value"),
        Source("rectangular", "PhaseStiffness", "two values in turn"),
        Source("fourier", "PhaseStiffness", "Fourier series over the mesh phase"),
        Source("table", "PhaseStiffness", "table over the mesh phase"),
        Source("user", "PhaseStiffness", "own Python function of the mesh phase"),
    )
}
