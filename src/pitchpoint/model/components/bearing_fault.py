# SPDX-License-Identifier: Apache-2.0
"""Faults of bearings: spalls on races and elements, elements that are not spaced evenly, too much play."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar, TypeAlias

from pitchpoint.model.keys import integer, positive, quantity


def _severity() -> Any:
    return quantity(
        "dimensionless", "share of the fault that is there: 0 is healthy", 1.0, minimum=0.0, maximum=1.0
    )


@dataclass(frozen=True, kw_only=True)
class Spall:
    """Spall over the whole width of a track: what races and elements have in common."""

    angle: float = quantity(
        "angle",
        "its middle: on a race from the x axis of the outer ring as assembled, on an element from outwards",
        0.0,
    )
    length: float = positive("length", "extent along the rolling direction; severity scales it")
    depth: float = positive(
        "length",
        "depth of the floor; severity scales it. An element that spans the spall drops in less deep",
    )
    severity: float = _severity()


@dataclass(frozen=True, kw_only=True)
class InnerRaceFault(Spall):
    """Spall over the whole width of the track of the inner race; its angle turns with the inner ring."""

    form: ClassVar[str] = "inner_race"


@dataclass(frozen=True, kw_only=True)
class OuterRaceFault(Spall):
    """Spall over the whole width of the track of the outer race."""

    form: ClassVar[str] = "outer_race"


@dataclass(frozen=True, kw_only=True)
class ElementFault(Spall):
    """Spall on the track of one rolling element: it meets both races, each once per turn of the element."""

    form: ClassVar[str] = "rolling_element"
    element: int = integer("number of the element; 0 starts at the x axis of the outer ring", 0, minimum=0)


@dataclass(frozen=True, kw_only=True)
class CageFault:
    """Worn cage that lets one gap between two elements grow; all others share what is left evenly."""

    form: ClassVar[str] = "cage"
    element: int = integer("number of the element behind which the gap widens", 0, minimum=0)
    widening: float = positive("angle", "how much wider the gap is; severity scales it")
    severity: float = _severity()


@dataclass(frozen=True, kw_only=True)
class LooseBearing:
    """Radial clearance that should not be there: inside a rolling bearing, or of its ring in the seat."""

    form: ClassVar[str] = "loose"
    clearance: float = positive(
        "length",
        "in diameter: added to that of a rolling bearing; of the ring of a linear bearing in its seat; "
        "severity scales it",
    )
    severity: float = _severity()


SpallFault: TypeAlias = InnerRaceFault | OuterRaceFault | ElementFault
BearingFault: TypeAlias = SpallFault | CageFault | LooseBearing

BEARING_FAULTS: dict[str, type] = {
    c.form: c for c in (InnerRaceFault, OuterRaceFault, ElementFault, CageFault, LooseBearing)
}
SEAT_FAULTS: dict[str, type] = {LooseBearing.form: LooseBearing}


def play(faults: Iterable[BearingFault]) -> float:
    """Radial clearance that all faults together add, in diameter [m]."""
    return sum(fault.severity * fault.clearance for fault in faults if isinstance(fault, LooseBearing))
