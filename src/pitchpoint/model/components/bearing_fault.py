# SPDX-License-Identifier: Apache-2.0
"""Faults of bearings: spalls on races and elements, elements that are not spaced evenly, too much play."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar, TypeAlias

from pitchpoint.model.keys import integer, positive, quantity

SEVERITY = "share of the fault that is there: 0 is healthy"
LENGTH = "extent along the rolling direction; severity scales it"
DEPTH = "depth of the floor; severity scales it. An element that spans the spall drops in less deep"


@dataclass(frozen=True, kw_only=True)
class InnerRaceFault:
    """Spall over the whole width of the track of the inner race."""

    form: ClassVar[str] = "inner_race"
    angle: float = quantity(
        "angle", "its middle on the inner ring, from the x axis of the outer ring as assembled", 0.0
    )
    length: float = positive("length", LENGTH)
    depth: float = positive("length", DEPTH)
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class OuterRaceFault:
    """Spall over the whole width of the track of the outer race."""

    form: ClassVar[str] = "outer_race"
    angle: float = quantity("angle", "its middle, from the x axis of the outer ring", 0.0)
    length: float = positive("length", LENGTH)
    depth: float = positive("length", DEPTH)
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class ElementFault:
    """Spall on the track of one rolling element: it meets both races, each once per turn of the element."""

    form: ClassVar[str] = "rolling_element"
    element: int = integer("number of the element; 0 starts at the x axis of the outer ring", 0, minimum=0)
    angle: float = quantity("angle", "its middle, from outwards as assembled", 0.0)
    length: float = positive("length", LENGTH)
    depth: float = positive("length", DEPTH)
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class CageFault:
    """Worn cage that lets one gap between two elements grow; all others share what is left evenly."""

    form: ClassVar[str] = "cage"
    element: int = integer("number of the element behind which the gap widens", 0, minimum=0)
    widening: float = positive("angle", "how much wider the gap is; severity scales it")
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


@dataclass(frozen=True, kw_only=True)
class LooseBearing:
    """Radial clearance that should not be there: inside a rolling bearing, or of its ring in the seat."""

    form: ClassVar[str] = "loose"
    clearance: float = positive(
        "length",
        "in diameter: added to that of a rolling bearing; of the ring of a linear bearing in its seat; "
        "severity scales it",
    )
    severity: float = quantity("dimensionless", SEVERITY, 1.0, minimum=0.0, maximum=1.0)


SpallFault: TypeAlias = InnerRaceFault | OuterRaceFault | ElementFault
BearingFault: TypeAlias = SpallFault | CageFault | LooseBearing

BEARING_FAULTS: dict[str, type] = {
    c.form: c for c in (InnerRaceFault, OuterRaceFault, ElementFault, CageFault, LooseBearing)
}
SEAT_FAULTS: dict[str, type] = {LooseBearing.form: LooseBearing}


def play(faults: Iterable[BearingFault]) -> float:
    """Radial clearance that all faults together add, in diameter [m]."""
    return sum(fault.severity * fault.clearance for fault in faults if isinstance(fault, LooseBearing))
