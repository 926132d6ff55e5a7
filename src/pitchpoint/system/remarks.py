# SPDX-License-Identifier: Apache-2.0
"""What a user should know about numbers that were computed without a fault: limits of the model passed."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.contact.damping import linear_ramp, ramp
from pitchpoint.core.errors import Message
from pitchpoint.core.kernel import plain
from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.gear import Gear
from pitchpoint.system.meshes import mesh_names, mesh_records

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

DEEPEST = 0.1
"""Penetration in normal modules up to which teeth count as springs on their undeformed line of action."""
FULL_DAMPING = 0.9
"""Share of the contact damping that counts as all of it."""


def deep_contacts(
    model: Model | None, statistics: Iterable[Mapping[str, Mapping[str, Any]]]
) -> tuple[Message, ...]:
    """Notes on meshes whose flanks went deeper into each other than teeth can bend.

    Penetration is counted from the backlash at the centre distance of the model, on either flank. Beyond a
    tenth of a module neither a stiffness per tooth nor the undeformed path of contact means anything: the
    loads, the stiffness or a prescribed motion are wrong by a unit or a sign.

    Parameters
    ----------
    model
        The model that was computed; without one there are no remarks.
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
                Message(
                    at,
                    f"the flanks go {format_quantity(deepest, 'length', 3)} into each other, more than teeth "
                    "can bend",
                    limit=f"about 0.1 m_n = {format_quantity(limit, 'length', 3)}",
                    remedy="check the loads, the stiffness, prescribed motions, a given time step, and "
                    "the damping: with too little of it a varying stiffness can build up unbounded vibration",
                    kind="note",
                )
            )
    return tuple(found)


def weak_damping(system: System, statistics: Mapping[str, Mapping[str, Any]]) -> tuple[str, ...]:
    """Sentences about meshes whose flanks stay in contact, but less deep than the contact damping requires.

    Contact damping grows from nothing at first contact to its full value at the penetration s_0. Where the
    mean penetration is smaller, a ratio of 5 % may act with a tenth of that.

    Parameters
    ----------
    system
        The system that was computed.
    statistics
        Channels with `mean`, and `share_zero` of the contact states.
    """
    found = []
    for name, record in zip(mesh_names(system), mesh_records(system), strict=True):
        law = record["contact"]
        row, state = (statistics.get(f"{word}[{name}]") for word in ("penetration", "contact_state"))
        if row is None or state is None or max(law["d_in"], law["d_out"]) <= 0.0:
            continue
        depth = float(row["mean"]) * float(law["normal"])
        if not 0.0 < depth < law["s_0"] or state["share_zero"] != 0.0:
            continue
        share, _ = plain(ramp if law["smooth"] else linear_ramp)(depth, float(law["s_0"]))
        if share < FULL_DAMPING:
            reached, full = (format_quantity(x, "length", 3) for x in (depth, float(law["s_0"])))
            mesh = system.model.every_mesh.get(name) if system.model is not None else None
            ratio = None if mesh is None or mesh.damping is None else mesh.damping.ratio
            acts = "" if ratio is None else f" (ratio {ratio:g} acts as {share * ratio:.2g})"
            found.append(
                f"mesh {name}: the mean penetration of the flanks is {reached}, less than s_0 = {full}, "
                f"so contact damping reaches {100.0 * share:.3g} % of its value{acts}; set damping.s_0 below "
                f"{reached}, or use damper, which acts independently of the penetration"
            )
    return tuple(found)
