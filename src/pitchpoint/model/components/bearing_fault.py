# SPDX-License-Identifier: Apache-2.0
"""Bearing faults: spalls on races and rolling elements, uneven element spacing, excessive clearance."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar, TypeAlias

from pitchpoint.model.component import Component
from pitchpoint.model.keys import integer, positive, quantity


def _severity() -> Any:
    return quantity("dimensionless", "severity: 0 healthy, 1 the given size", 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class Spall(Component):
    """Base class of spalls over the whole width of a track."""

    angle: float = quantity(
        "angle",
        "angle of its centre; on a race from the x axis of the outer ring as assembled, on an element from "
        "the outward direction",
        0.0,
    )
    length: float = positive("length", "length in the rolling direction; scaled by severity")
    depth: float = positive(
        "length",
        "depth of the floor; scaled by severity. An element that bridges the spall drops in less",
    )
    severity: float = _severity()


@dataclass(frozen=True, kw_only=True)
class InnerRaceFault(Spall):
    """Spall over the whole width of the inner race; its angle rotates with the inner ring."""

    form: ClassVar[str] = "inner_race"


@dataclass(frozen=True, kw_only=True)
class OuterRaceFault(Spall):
    """Spall over the whole width of the outer race."""

    form: ClassVar[str] = "outer_race"


@dataclass(frozen=True, kw_only=True)
class ElementFault(Spall):
    """Spall on one rolling element: it strikes each race once per revolution of the element."""

    form: ClassVar[str] = "rolling_element"
    element: int = integer(
        "number of the element; 0 is at the x axis of the outer ring at the start", 0, minimum=0
    )


@dataclass(frozen=True, kw_only=True)
class CageFault(Component):
    """Worn cage: the spacing of two adjacent elements is wider, all other spacings are equally reduced."""

    form: ClassVar[str] = "cage"
    element: int = integer("number of the element behind which the spacing is wider", 0, minimum=0)
    widening: float = positive("angle", "increase of the spacing; scaled by severity")
    severity: float = _severity()


@dataclass(frozen=True, kw_only=True)
class LooseBearing(Component):
    """Excessive radial clearance, inside a rolling bearing or of a ring in its seat."""

    form: ClassVar[str] = "loose"
    clearance: float = positive(
        "length",
        "diametral clearance: added to that of a rolling bearing, or of the ring of a linear bearing in its "
        "seat; scaled by severity",
    )
    severity: float = _severity()


SpallFault: TypeAlias = InnerRaceFault | OuterRaceFault | ElementFault
BearingFault: TypeAlias = SpallFault | CageFault | LooseBearing

BEARING_FAULTS: dict[str, type] = {
    c.form: c for c in (InnerRaceFault, OuterRaceFault, ElementFault, CageFault, LooseBearing)
}
SEAT_FAULTS: dict[str, type] = {LooseBearing.form: LooseBearing}


def play(faults: Iterable[BearingFault]) -> float:
    """Diametral clearance [m] added by all faults."""
    return sum(fault.severity * fault.clearance for fault in faults if isinstance(fault, LooseBearing))
