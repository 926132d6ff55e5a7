# SPDX-License-Identifier: Apache-2.0
"""What a user should know about numbers that were computed without a fault: limits of the model passed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.gear import Gear

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

DEEPEST = 0.1
"""Penetration in normal modules up to which teeth count as springs on their undeformed line of action."""


def deep_contacts(
    model: Model | None, statistics: Iterable[Mapping[str, Mapping[str, Any]]]
) -> tuple[str, ...]:
    """Sentences about meshes whose flanks went deeper into each other than teeth can bend.

    Penetration is counted from the backlash at the centre distance of the model, on either flank. Beyond a
    tenth of a module neither a stiffness per tooth nor the undeformed path of contact means anything: the
    loads, the stiffness or a prescribed motion are wrong by a unit or a sign.

    Parameters
    ----------
    model
        The model that was computed; there is nothing to say without one.
    statistics
        One or several tables of channels with `min` and `max`, as runs, rolls and points of sweeps give them;
        NaN where there was no sample.
    """
    if model is None:
        return ()
    tables = list(statistics)
    found = []
    for name, mesh in model.every_mesh.items():
        rows = [t[f"deflection[{name}]"] for t in tables if f"deflection[{name}]" in t]
        reach = [abs(v) for row in rows for v in (row["min"], row["max"]) if math.isfinite(v)]
        if not reach:
            continue
        deepest = max(reach) - 0.5 * model.backlash(name)
        gear, at = model.toothed[mesh.gears[0]], f"{model.section_of(name)}.{name}"
        limit = DEEPEST * (gear.normal_module if isinstance(gear, Gear) else gear.geometry.m_mn)
        if deepest > limit:
            found.append(
                f"{at}: the flanks go {format_quantity(deepest, 'length', 3)} into each other "
                f"(limit about 0.1 m_n = {format_quantity(limit, 'length', 3)}), more than teeth can bend; "
                "check the loads, the stiffness, prescribed motions, a given time step, and the damping: "
                "with too little of it a varying stiffness can build up vibrations without bound"
            )
    return tuple(found)
