# SPDX-License-Identifier: Apache-2.0
"""A linear bearing between a body and ground or a housing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pitchpoint.model.component import Component
from pitchpoint.model.components.bearing_fault import SEAT_FAULTS, LooseBearing
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.keys import component, derived, end, key, quantities, text


@dataclass(frozen=True, kw_only=True)
class Bearing(Component):
    """Linear spring and damper in six directions between a body and ground or a housing."""

    body: str = text("name of the body", names="bodies")
    position: tuple[float, float, float] = quantities(
        "length",
        "centre of the bearing relative to the origin of the body, on its axis: [0, 0, z]",
        (0.0, 0.0, 0.0),
        length=(3, 3),
    )
    stiffness: Stiffness6 = component(Stiffness6, "stiffness in six directions", Stiffness6())
    housing: str | None = end(
        "housing instead of ground: BODY, or BODY.MARKER at the bearing, such as a node of an elastic body; "
        "the spin remains free",
        None,
    )
    damping: Damping6 | None = component(Damping6, "damping in the same directions, or a damping ratio")
    faults: Mapping[str, LooseBearing] = key(
        "components", "faults by name", {}, isolated=True, of=SEAT_FAULTS
    )
    stage: str | None = derived()
    """Planetary stage that contains the bearing, if any."""
    given: Any = derived()
    """The bearing as given, if its housing is that of the model."""
