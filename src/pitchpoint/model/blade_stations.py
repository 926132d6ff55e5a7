# SPDX-License-Identifier: Apache-2.0
"""Blade from the lists of a model, with every problem at its key."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import GeometryError, Message, ModelError
from pitchpoint.core.nearest import nearest
from pitchpoint.geometry.rotor.blade import Blade
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.polar_range import extrapolate_polar, range_problem
from pitchpoint.model.components.blade import LISTS
from pitchpoint.model.files import read_once
from pitchpoint.model.openfast.airfoil import read_airfoil

if TYPE_CHECKING:
    from pitchpoint.model.components.blade import BladePolar, BladeStations

_SAME = 1e-9


def blade_of(part: BladeStations, hub_radius: float) -> Blade:
    """Blade of the stations of a model.

    Parameters
    ----------
    part
        The stations.
    hub_radius
        Distance of the root from the axis of the rotor [m].

    Raises
    ------
    ModelError
        With every problem; `where` is the key within the blade.
    """
    problems = _station_problems(part, hub_radius)
    polars: dict[str, Polar] = {}
    for name, table in part.polars.items():
        try:
            polars[name] = _polar(name, table)
        except ModelError as error:
            problems += [p.changed(where=f"polars.{name}.{p.where}".rstrip(".")) for p in error.problems]
    for k, name in enumerate(part.airfoils):
        if name not in part.polars:
            near = nearest(name, list(part.polars))
            remedy = f"did you mean {near[0]}?" if near else "add it to polars"
            limit = ", ".join(part.polars) or "polars has none"
            problems.append(
                Message(
                    f"airfoils.{k}", f"names the polar '{name}', which does not exist", None, limit, remedy
                )
            )
    if problems:
        raise ModelError(problems)
    names = list(polars)
    none = np.zeros(0)
    return Blade(
        span=np.maximum(np.array(part.radius) - hub_radius, 0.0),
        chord=np.array(part.chord),
        twist=np.array(part.twist),
        prebend=np.array(part.prebend) if part.prebend else none,
        sweep=np.array(part.sweep) if part.sweep else none,
        polars=list(polars.values()),
        polar_index=np.array([names.index(name) for name in part.airfoils]),
    )


def _station_problems(part: BladeStations, hub_radius: float) -> list[Message]:
    """Lengths of the lists, and radii that do not increase or begin within the hub."""
    found = []
    count = len(part.radius)
    for name in ("chord", "twist", "airfoils", "prebend", "sweep"):
        size = len(getattr(part, name))
        if size != count and (size or name in ("chord", "twist", "airfoils")):
            remedy = "give one value for each station"
            found.append(Message(name, "is the number of values", str(size), f"{count} as of radius", remedy))
    radius = np.array(part.radius)
    for name, most, unit, factor, limit in (
        ("chord", radius[-1], "m", 1.0, f"<= {radius[-1]:.6g} m, the radius of the rotor"),
        ("twist", 0.5 * math.pi, "deg", 180.0 / math.pi, "-90 to 90 deg"),
    ):
        values = np.array(getattr(part, name))
        for k in np.flatnonzero(np.abs(values) > most * (1.0 + _SAME))[:1]:
            shown, remedy = f"{values[k] * factor:.6g} {unit}", "correct the value and its unit"
            found.append(Message(f"{name}.{k}", "is out of range", shown, limit, remedy))
    for k in np.flatnonzero(np.diff(radius) <= 0.0)[:1]:
        limit, remedy = f"> {radius[k]:.6g} m", "sort the stations from root to tip"
        found.append(Message(f"radius.{k + 1}", "does not increase", f"{radius[k + 1]:.6g} m", limit, remedy))
    if radius[0] < hub_radius - _SAME:
        remedy = "give radii from the rotor axis, not from the root"
        limit = f">= {hub_radius:.6g} m, the hub radius"
        found.append(Message("radius.0", "is inside the hub", f"{radius[0]:.6g} m", limit, remedy))
    return found


def _polar(name: str, table: BladePolar) -> Polar:
    """Complete polar of a file or of lists."""
    given = table.lists
    if table.file is not None:
        if given:
            key = next(iter(given))
            raise ModelError([Message(key, "is given together with file", remedy="give one of them")])
        polar = _file(table.file)
    else:
        if missing := [key for key in LISTS[:3] if key not in given]:
            text = f"has no {', '.join(missing)}"
            raise ModelError([Message("", text, remedy="give angle, lift and drag, or file")])
        try:
            polar = Polar(
                name=name,
                alpha=np.array(table.angle),
                lift=np.array(table.lift),
                drag=np.array(table.drag),
                moment=np.array(table.moment),
            )
        except GeometryError as error:
            raise ModelError([error.problem.changed(where="")]) from None
    if table.aspect_ratio is not None:
        try:
            polar = extrapolate_polar(polar, table.aspect_ratio)
        except GeometryError as error:
            raise ModelError([error.problem.changed(where="")]) from None
    if not polar.complete:
        remedy = "complete the table, or give aspect_ratio to continue it as a stalled plate"
        found = range_problem(polar, remedy)
        name = "" if table.file is None else f"{Path(table.file).name}: "
        raise ModelError([found.changed(where="" if not name else "file", value=f"{name}{found.value}")])
    return polar


@read_once(64)
def _file(path: str) -> Polar:
    """Polar of a file."""
    try:
        return read_airfoil(path)
    except ModelError as error:
        problems = [p.changed(where="file", text=f"{p.where}: {p.text}".lstrip(": ")) for p in error.problems]
        raise ModelError(problems) from None
