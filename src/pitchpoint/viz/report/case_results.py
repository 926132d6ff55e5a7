# SPDX-License-Identifier: Apache-2.0
"""Results of independent cases by meaning: load sharing, forces, contact and bearings, for each component."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pitchpoint.core.extremes import greatest
from pitchpoint.core.load_sharing import FACTOR
from pitchpoint.viz.quantities import Array, Scale, channel_scale, scale
from pitchpoint.viz.report.bearing_forces import NOTHING

Row = Mapping[str, Any]
Case = Mapping[str, Any]
ROUND_OFF = 1e-9
"""Relative size up to which a value is round-off: of the alternating part to the largest value of a channel,
and of a case to the largest of all cases."""


@dataclass(frozen=True)
class CaseQuantity:
    """One result of all cases.

    Parameters
    ----------
    name
        Name of its picture.
    title
        Result in words.
    unit
        SI unit.
    owners
        Meshes, bearings or planetary stages; one without name for speed sweeps of earlier versions.
    values
        Values in SI, nan where they are not known, shape (n_case, n_owner).
    """

    name: str
    title: str
    unit: str
    owners: tuple[str, ...]
    values: Array

    @property
    def scale(self) -> Scale:
        """Display unit; shares of the time in per cent."""
        if self.name == "contact_loss_share":
            return Scale("%", 100.0)
        values = self.values[np.isfinite(self.values)]
        known = self.name in ("deflection", "transmission_error")
        return channel_scale(self.name, self.unit, values) if known else scale(self.unit, values)

    @property
    def largest(self) -> Array:
        """Value of the owner with the largest magnitude in each case, shape (n_case,)."""
        filled = np.where(np.isfinite(self.values), np.abs(self.values), -1.0)
        best = self.values[np.arange(len(filled)), filled.argmax(axis=1)]
        return np.asarray(best)


def case_quantities(cases: Sequence[Case]) -> list[CaseQuantity]:
    """Results of the cases that differ from zero in any of them.

    Parameters
    ----------
    cases
        Cases as of `io.case_store.read_cases`.
    """
    rolled = any(name.startswith("unloaded_transmission_error[") for c in cases for name in c["channels"])
    varying = (
        ("transmission_error", "transmission error, p–p", "transmission_error", _range)
        if rolled
        else ("deflection", "rms of the deflection", "deflection", _alternating)
    )
    listed: tuple[tuple[str, str, str, Callable[[Row], float]], ...] = (
        (FACTOR, "mesh load factor of the planets", FACTOR, lambda row: row["mean"]),
        varying,
        ("mesh_force", "maximum mesh force", "mesh_force", _magnitude),
        *((name, title, "contact_state", _number(name)) for name, title in CONTACT.items()),
    )
    found = [_quantity(cases, *entry) for entry in listed]
    found += _bearings(cases)
    return [one for one in found if one is not None and np.any(np.nan_to_num(one.values))]


CONTACT = {
    "contact_loss_share": "time without contact",
    "impact_rate": "impacts per time",
    "closing_speed_max": "maximum closing speed",
    "rattle_index": "rattle index",
    "load_reversal": "load reversal",
    "impact_energy_per_revolution": "energy of the impacts per revolution",
    "contact_frequency": "frequency of the contacts",
}
"""Numbers of the contact of a mesh in words."""
UNITS = {
    "impact_rate": "1/s",
    "closing_speed_max": "m/s",
    "contact_frequency": "Hz",
    "impact_energy_per_revolution": "J",
}
"""Their units, of those with one."""


def _number(name: str) -> Callable[[Row], float]:
    return lambda row: float(row.get(name, math.nan))


def _magnitude(row: Row) -> float:
    return abs(greatest(row))


def _range(row: Row) -> float:
    """Peak to peak value; round-off of a constant is zero, nan (a failed case) remains."""
    size = float(row["max"]) - float(row["min"])
    return 0.0 if size <= ROUND_OFF * _magnitude(row) else size


def _alternating(row: Row) -> float:
    """Rms of the alternating part; round-off of a constant is zero, nan (a failed case) remains."""
    return 0.0 if row["rms"] <= ROUND_OFF * _magnitude(row) else float(row["rms"])


def _rows(case: Case, quantity: str) -> Iterator[tuple[str, Row]]:
    """Owner and statistics of a quantity; points of a speed sweep of earlier versions have no owner."""
    for name, row in case["channels"].items():
        if name.startswith(f"{quantity}["):
            yield name[len(quantity) + 1 : -1], row
    for point in case.get("points", ()):
        for mesh, own in point.get("meshes", {"": point}).items():
            if quantity == "contact_state":
                yield mesh, own
            elif quantity in own:
                yield mesh, own[quantity]
        yield from (
            (name[len(quantity) + 1 : -1], {"mean": value})
            for name, value in point.items()
            if name.startswith(f"{quantity}[")
        )


def _quantity(
    cases: Sequence[Case], name: str, title: str, quantity: str, value: Callable[[Row], float]
) -> CaseQuantity | None:
    """One result of all cases; of the points of a sweep the largest. None if no case has it."""
    found: list[dict[str, float]] = []
    for case in cases:
        own: dict[str, float] = {}
        for owner, row in _rows(case, quantity):
            x = value(row)
            if math.isfinite(x) and abs(x) >= abs(own.get(owner, 0.0)):
                own[owner] = x
        found.append(own)
    owners = tuple(dict.fromkeys(owner for own in found for owner in own))
    if not owners:
        return None
    values = np.array([[own.get(owner, math.nan) for owner in owners] for own in found])
    values[np.abs(values) < ROUND_OFF * np.nanmax(np.abs(values))] = 0.0
    if name in CONTACT or name == FACTOR:
        unit = UNITS.get(name, "1")
    else:
        unit = next(str(row["unit"]) for case in cases for _, row in _rows(case, quantity) if "unit" in row)
    if name == "contact_frequency":  # an oscillation that does not occur has no frequency
        values[values == 0.0] = math.nan
    return CaseQuantity(name, title, unit, owners, values)


def _bearings(cases: Sequence[Case]) -> list[CaseQuantity]:
    """Largest radial and axial force of the bearings; axial forces that are round-off count as none."""
    found, size = [], 0.0
    for way, value in (("radial", _magnitude), ("axial", greatest)):
        ends = f".{way}"
        own = [
            {"channels": {n: r for n, r in case["channels"].items() if n.endswith(f"{ends}]")}}
            for case in cases
        ]
        part = _quantity(own, f"{way}_bearing_force", f"maximum {way} bearing force", "bearing_force", value)
        if part is None:
            continue
        size = max(size, float(np.nanmax(np.abs(part.values))))
        loaded = np.nanmax(np.abs(part.values), axis=0) > NOTHING * size
        if loaded.any():
            owners = [
                o.removesuffix(ends) for o, is_loaded in zip(part.owners, loaded, strict=True) if is_loaded
            ]
            found.append(
                CaseQuantity(part.name, part.title, part.unit, tuple(owners), part.values[:, loaded])
            )
    return found
