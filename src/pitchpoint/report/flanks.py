# SPDX-License-Identifier: Apache-2.0
"""Flank modifications, deviations and faults of the gears of a model, as table rows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from pitchpoint.core.units import format_quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.gear_faults import SeatFault
    from pitchpoint.model.components.modifications import Deviations
    from pitchpoint.model.components.tooth_faults import BevelFault, ToothFault
    from pitchpoint.model.model import Model

HEIGHTS = ("profile_crowning", "lead_crowning", "profile_slope", "helix_slope")

Line = tuple[str, str, str, str, str]
"""Gear, flanks, kind, amount, extent."""


def flank_lines(model: Model) -> list[Line]:
    """Modifications, deviations and faults of the flanks of all gears, amounts in micrometres.

    Faults of severity 0 are omitted, see `inactive_faults`.
    """
    found = [(name, *line) for name, gear in model.gears.items() for line in _lines(gear)]
    for name, cone in model.bevel_gears.items():
        found += [
            (name, *_fault(label, fault)) for label, fault in cone.faults.items() if fault.severity != 0.0
        ]
    return found


def inactive_faults(model: Model) -> int:
    """Number of tooth and seat faults with severity 0, which have no effect until a study raises it."""
    return sum(fault.severity == 0.0 for gear in model.toothed.values() for fault in gear.faults.values())


def _lines(gear: Gear) -> list[tuple[str, str, str, str]]:
    found = []
    made = gear.modifications
    if made is not None:
        left, right = made.side("left"), made.side("right")
        sides = [("left and right", left)] if left == right else [("left", left), ("right", right)]
        found += [
            (side, *line) for side, flank in sides if flank is not None for line in _modifications(flank)
        ]
    if gear.deviations is not None:
        found += _deviations(gear.deviations)
    found += [_fault(label, fault) for label, fault in gear.faults.items() if fault.severity != 0.0]
    if gear.tooth_profile is not None:
        parts = ", ".join(gear.tooth_profile.given)
        found.append((parts.replace("both", "left and right"), "profile given as points", "–", ""))
    return found


def _modifications(flank: Any) -> list[tuple[str, str, str]]:
    """Modifications of the left or right flanks: kind, amount, extent."""
    found = []
    for name in ("tip_relief", "root_relief", "end_relief"):
        relief = getattr(flank, name)
        if relief is None or relief.amount == 0.0:
            continue
        start = getattr(relief, "start_diameter", None)
        words = [relief.shape]
        words += [f"from diameter {format_quantity(start, 'length')}"] if start is not None else []
        words += [f"over {format_quantity(relief.length, 'length')}"] if relief.length is not None else []
        found.append((name.replace("_", " "), _micrometres(relief.amount), ", ".join(words)))
    for name in HEIGHTS:
        amount = getattr(flank, name)
        if amount != 0.0:
            found.append((name.replace("_", " "), _micrometres(amount), ""))
    return found


def _deviations(real: Deviations) -> list[tuple[str, str, str, str]]:
    """Deviations of single teeth: flanks, kind, maximum, extent."""
    found = []
    left, right = real.pitch_of("left"), real.pitch_of("right")
    sides = [("left and right", left)] if left == right else [("left", left), ("right", right)]
    for side, pitch in sides:
        if any(pitch):
            found.append((side, "single pitch deviations", _span(pitch), f"{len(pitch)} teeth"))
    if real.runout is not None and real.runout.amount:
        turned = f"towards {format_quantity(real.runout.phase, 'angle')}" if real.runout.phase else ""
        found.append(("left and right", "runout", _micrometres(real.runout.amount), turned))
    for one in real.flank_maps:
        values = [value for row in one.values for value in row]
        found.append((one.flank, "measured flank", _span(values), f"tooth {one.tooth}"))
    return found


def _fault(label: str, fault: ToothFault | BevelFault | SeatFault) -> tuple[str, str, str, str]:
    """Fault of the teeth or of the seat: flanks, kind, severity, tooth."""
    tooth = getattr(fault, "tooth", None)
    flanks = getattr(fault, "flank", "both").replace("both", "left and right")
    where = "all teeth" if tooth is None else f"tooth {tooth}"
    return flanks, f"{label}: {fault.form.replace('_', ' ')}", f"severity {fault.severity:g}", where


def _span(values: Sequence[float]) -> str:
    return f"{_number(min(values))} to {_micrometres(max(values))}"


def _micrometres(value: float) -> str:
    return f"{_number(value)} µm"


def _number(value: float) -> str:
    return f"{1e6 * value:.4g}".replace("-", "−")
