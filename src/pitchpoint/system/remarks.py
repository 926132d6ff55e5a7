# SPDX-License-Identifier: Apache-2.0
"""Notes on results outside the validity of the model."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from pitchpoint.contact.damping import linear_ramp, ramp
from pitchpoint.core.errors import Message
from pitchpoint.core.kernel import plain
from pitchpoint.core.units import format_quantity
from pitchpoint.model.components.gear import Gear
from pitchpoint.system.flank_remarks import flank_remarks
from pitchpoint.system.meshes import mesh_names, mesh_records

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

DEEPEST = 0.1
"""Maximum penetration in normal modules for teeth as springs on the undeformed line of action."""
FULL_DAMPING = 0.9
"""Fraction of the contact damping above which it is considered complete."""


def run_remarks(system: System, statistics: Mapping[str, Mapping[str, Any]]) -> tuple[Message | str, ...]:
    """All notes of this module and of `flank_remarks` after a time response.

    Parameters
    ----------
    system
        The computed system.
    statistics
        Table of channels with `mean`, `min` and `max`.
    """
    deep = deep_contacts(system.model, [statistics])
    return (*deep, *weak_damping(system, statistics), *flank_remarks(system))


def deep_contacts(
    model: Model | None, statistics: Iterable[Mapping[str, Mapping[str, Any]]]
) -> tuple[Message, ...]:
    """Notes on meshes whose flank penetration exceeds the possible deflection of teeth.

    The penetration is that beyond the backlash at the actual centre distance, on either flank. Above a
    tenth of a module neither the tooth stiffness nor the undeformed path of contact is valid; usually a
    load, a stiffness or a prescribed motion has a wrong unit or sign.

    Parameters
    ----------
    model
        The computed model; None: no notes.
    statistics
        One or more tables of channels with `min` and `max` from runs, slow rolls or sweep points; NaN
        without samples.
    """
    if model is None:
        return ()
    tables = list(statistics)
    found = []
    for name, mesh in model.every_mesh.items():
        rows = [t[f"penetration[{name}]"]["max"] for t in tables if f"penetration[{name}]" in t]
        if not (reach := [depth for depth in rows if math.isfinite(depth)]):
            continue
        deepest = max(reach)
        gear, at = model.toothed[mesh.gears[0]], f"{model.section_of(name)}.{name}"
        limit = DEEPEST * (gear.normal_module if isinstance(gear, Gear) else gear.geometry.m_mn)
        if deepest > limit:
            found.append(
                Message(
                    at,
                    f"the flank penetration reaches {format_quantity(deepest, 'length', 3)}, more than teeth "
                    "can deflect",
                    limit=f"about 0.1 m_n = {format_quantity(limit, 'length', 3)}",
                    remedy="check loads, stiffness, prescribed motions, a given time step, and damping: "
                    "with low damping the varying stiffness can cause parametric instability",
                    kind="note",
                )
            )
    return tuple(found)


def weak_damping(system: System, statistics: Mapping[str, Mapping[str, Any]]) -> tuple[str, ...]:
    """Notes on meshes that stay in contact but have a mean penetration too small for full contact damping.

    Contact damping increases from zero at first contact to its full value at the penetration s_0. If the mean
    penetration is smaller, a damping ratio of 5 % may have only a tenth of its effect.

    Parameters
    ----------
    system
        The computed system.
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
