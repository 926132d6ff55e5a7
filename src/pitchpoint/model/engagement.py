# SPDX-License-Identifier: Apache-2.0
"""Clutches and brakes that a scenario engages: a row of the shift table of a gearbox.

An engaged clutch keeps its capacity, and its bodies start with the same speed; an engaged brake keeps
its body at rest. The others are open. A scenario without the key `engaged` leaves all clutches to their
capacities.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pitchpoint.model.frames import GROUND, bodies_of

if TYPE_CHECKING:
    from pitchpoint.model.components.clutch import Clutch
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.speed_ratios import Link

Engaged = Sequence[str] | None
"""Names of the engaged clutches; None if a scenario does not give them."""


def is_open(name: str, clutch: Clutch, engaged: Engaged) -> bool:
    """Whether a scenario opens a clutch; not the friction between the halves of a scissor gear.

    Examples
    --------
    >>> from pitchpoint import Clutch
    >>> one = Clutch(bodies=("sun",), capacity="3 kN m")
    >>> is_open("A", one, ("B",)), is_open("A", one, ("A", "B")), is_open("A", one, None)
    (True, False, False)
    """
    return engaged is not None and clutch.stage is None and name not in engaged


def braked_body(parts: Parts, clutch: Clutch) -> str | None:
    """The body that a brake keeps at rest; None for a clutch between two moving bodies."""
    return held_body(parts, [*bodies_of(clutch.bodies), GROUND][:2])


def held_body(parts: Parts, ends: Sequence[str]) -> str | None:
    """The moving one of two bodies, if the other is ground or fixed."""
    moving = [e for e in ends if e != GROUND and not (e in parts.bodies and parts.bodies[e].moves == "fixed")]
    return moving[0] if len(moving) == 1 and moving[0] in parts.mechanism.seats else None


def engaged_links(parts: Parts, engaged: Engaged) -> list[Link]:
    """Engaged clutches between two moving bodies, as links of equal speeds."""
    return [
        (("clutches", name), *bodies_of(clutch.bodies), 1.0)  # type: ignore[misc]
        for name, clutch in _engaged(parts, engaged).items()
        if len(set(bodies_of(clutch.bodies)) & set(parts.bodies)) == 2 and braked_body(parts, clutch) is None
    ]


def engaged_brakes(parts: Parts, engaged: Engaged) -> dict[str, str]:
    """Bodies that engaged brakes keep at rest, with the brake."""
    found = {}
    for name, clutch in _engaged(parts, engaged).items():
        body = braked_body(parts, clutch)
        if body is not None:
            found[body] = name
    return found


def _engaged(parts: Parts, engaged: Engaged) -> dict[str, Clutch]:
    return {name: parts.clutches[name] for name in engaged or () if name in parts.clutches}
