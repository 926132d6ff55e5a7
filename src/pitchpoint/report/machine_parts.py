# SPDX-License-Identifier: Apache-2.0
"""Rotating parts of a model for the analysis of its signals: orders of shafts, meshes, rolling bearings."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from pitchpoint.analysis.turning_parts import Bearing, Mesh, Shaft, TurningParts
from pitchpoint.core.errors import Message, ModelError

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

LARGEST = 10_000_000
"""Largest denominator of a ratio, above the product of the tooth counts of three stages."""
EXACT = 1e-12
BEARING_PARTS = {"outer ring": "bpfo", "inner ring": "bpfi", "rolling element": "bsf_double", "cage": "ftf"}


def parts_of(
    model: Model, spins: Mapping[str, float], reference: str
) -> tuple[TurningParts, dict[str, str], list[str]]:
    """Shafts, meshes and bearings by their orders.

    Parameters
    ----------
    model
        The model.
    spins
        Speeds of all bodies [rad/s], from `report.frequencies.turning_speeds`.
    reference
        Body that defines order 1.

    Returns
    -------
    TurningParts
        Shafts of equal speed are merged.
    dict
        Name of the merged shaft by body.
    list of str
        Remarks on omitted parts.

    Raises
    ------
    ModelError
        If the reference does not rotate, or all meshes are those of planets.
    """
    from pitchpoint.model.rings import ring_bodies
    from pitchpoint.report.frequencies import frequencies_of

    rows = frequencies_of(model, spins)
    base = abs(rows["shafts"].get(reference, {}).get("speed", 0.0))
    if not base:
        raise ModelError([Message(f"bodies.{reference}", "does not rotate, so it cannot define orders")])
    remarks, orders = [], {}
    carried_by = {body for bearing in model.rolling_bearings.values() for body in ring_bodies(bearing)}
    for body, row in rows["shafts"].items():
        if not row["speed"] or not (row["gears"] or body in carried_by or body == reference):
            continue
        order = Fraction(abs(row["speed"]) / base).limit_denominator(LARGEST)
        if abs(float(order) * base / abs(row["speed"]) - 1.0) > EXACT:
            remarks.append(f"{body} is not geared to {reference}; omitted")
            continue
        orders[body] = order
    carried = [name for name, row in rows["meshes"].items() if row["carrier"] is not None]
    if carried and len(carried) == len(rows["meshes"]):
        raise ModelError(
            [
                Message(
                    "meshes",
                    "all are on a rotating carrier: the planets pass a sensor in turn, and no test here "
                    "covers the resulting lines",
                    remedy="`pitchpoint frequencies` lists the fault frequencies of sun, planets and ring",
                )
            ]
        )
    if carried:
        remarks.append(f"meshes on carriers are not supported: {', '.join(carried)} omitted")
    groups: dict[Fraction, list[str]] = {}
    for body, order in orders.items():
        groups.setdefault(order, []).append(body)
    names = {body: " or ".join(bodies) for bodies in groups.values() for body in bodies}
    shafts = tuple(Shaft(" or ".join(bodies), order) for order, bodies in groups.items())
    parts = TurningParts(shafts, _meshes(model, rows["meshes"], names), _bearings(model, rows, base, names))
    return parts, names, remarks


def meshes_at_bodies(model: Model) -> dict[str, tuple[str, ...]]:
    """Names of the meshes of the gears on each body.

    Parameters
    ----------
    model
        The model.
    """
    found: dict[str, tuple[str, ...]] = {}
    for name, mesh in model.every_mesh.items():
        for gear in mesh.gears:
            body = str(model.body_of(gear))
            found[body] = (*found.get(body, ()), name)
    return found


def _meshes(
    model: Model, rows: Mapping[str, Mapping[str, object]], names: Mapping[str, str]
) -> tuple[Mesh, ...]:
    """Meshes with fixed axes; those of equal tooth counts on equal shafts are merged."""
    found: dict[tuple[object, ...], tuple[list[str], list[str], list[str]]] = {}
    for name, row in rows.items():
        one, two = model.every_mesh[name].gears
        bodies = [str(model.body_of(gear)) for gear in (one, two)]
        if row["carrier"] is not None or any(body not in names for body in bodies):
            continue
        teeth = tuple(model.toothed[gear].number_of_teeth for gear in (one, two))
        key = (teeth, names[bodies[0]], names[bodies[1]])
        entry = found.setdefault(key, ([], [], []))
        for listed, new in zip(entry, (name, one, two), strict=True):
            if new not in listed:
                listed.append(new)
    return tuple(
        Mesh(" or ".join(meshes), (" or ".join(ones), " or ".join(twos)), key[0], (key[1], key[2]))  # type: ignore[arg-type]
        for key, (meshes, ones, twos) in found.items()
    )


def _bearings(
    model: Model, rows: Mapping[str, Mapping[str, object]], base: float, names: Mapping[str, str]
) -> tuple[Bearing, ...]:
    """Rolling bearings with the orders of their parts and the shaft that rotates in them."""
    import math

    from pitchpoint.model.rings import ring_bodies

    found = []
    for name, row in rows["rolling_bearings"].items():
        rates = {part: row[key] * math.tau / base for part, key in BEARING_PARTS.items()}  # type: ignore[index]
        orders = {part: float(rate) for part, rate in rates.items() if rate > 0.0}
        if orders:
            bodies = ring_bodies(model.rolling_bearings[name])
            shaft = next((names[body] for body in bodies if body in names), "")
            found.append(Bearing(name, orders, shaft))
    return tuple(found)
