# SPDX-License-Identifier: Apache-2.0
"""Airfoils of a windIO file: relative thickness, aerodynamic centre, polars by Reynolds number."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import GeometryError
from pitchpoint.core.nearest import LISTED, did_you_mean, hint
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.model.windio.ontology import Ontology

FloatArray = NDArray[np.float64]
_HALF_TURN = math.radians(0.2)
"""Angles this close to ±180° are ±180°; files have 3.14 for π."""
_NAMES = {1: ("c_l", "c_d", "c_m"), 2: ("cl", "cd", "cm")}


@dataclass(frozen=True)
class Airfoil:
    """Airfoil of a file: relative thickness, aerodynamic centre from the leading edge over the chord, and
    its polars by increasing Reynolds number, whose moments are about this centre."""

    thickness: float
    center: float
    reynolds: FloatArray
    polars: tuple[Polar, ...]

    def at(self, reynolds: float) -> Polar:
        """Polar of a Reynolds number: linear over its logarithm, the first or last one beyond the range."""
        if len(self.polars) == 1:
            return self.polars[0]
        x = np.log(np.clip(reynolds, self.reynolds[0], self.reynolds[-1]))
        k = int(np.clip(np.searchsorted(np.log(self.reynolds), x) - 1, 0, len(self.polars) - 2))
        low, high = np.log(self.reynolds[k : k + 2])
        share = float((x - low) / (high - low))
        one, two = self.polars[k : k + 2]
        if share in (0.0, 1.0):
            return two if share else one
        alpha = np.union1d(one.alpha, two.alpha)
        rows = np.array([(1.0 - share) * one.at(a) + share * two.at(a) for a in alpha])
        return Polar(name=one.name, alpha=alpha, lift=rows[:, 0], drag=rows[:, 1], moment=rows[:, 2])


def read_airfoils(
    file: Ontology, names: Sequence[str], configurations: Mapping[str, str]
) -> dict[str, Airfoil]:
    """Airfoils of a blade by name; problems and notes on what is not used remain in `file`.

    Parameters
    ----------
    file
        The file.
    names
        Airfoils of the blade.
    configurations
        Configuration of the polars by airfoil; default: the first one of the airfoil.
    """
    found = {}
    known = {
        str(entry.get("name")): k
        for k, entry in enumerate(file.entries("airfoils"))
        if isinstance(entry, dict)
    }
    for name in dict.fromkeys(names):
        if name not in known:
            if known:
                remedy = f"{did_you_mean(name, known)}there are {', '.join(list(known)[:LISTED])}"
                file.problem(("airfoils",), f"has no airfoil '{name}', which the blade names", remedy=remedy)
            continue
        before = len(file.problems)
        airfoil = _airfoil(file, ("airfoils", known[name]), name, configurations.get(name))
        if len(file.problems) == before and airfoil is not None:
            found[name] = airfoil
    return found


def _airfoil(file: Ontology, at: tuple[Any, ...], name: str, wanted: str | None) -> Airfoil | None:
    key = "rthick" if file.has(*at, "rthick") else "relative_thickness"
    thick = file.number(*at, key, positive=True)
    center = file.number(*at, "aerodynamic_center", default=0.25)
    for place, value in ((key, thick), ("aerodynamic_center", center)):
        if not -1e-6 <= value <= 1.0 + 1e-6 and value == value:
            remedy = "give a share of the chord, not per cent"
            file.problem((*at, place), "is out of range", f"{value:g}", "0 to 1", remedy)
    sets: list[tuple[Any, ...]] = []
    entries = file.entries(*at, "polars")
    given = list(dict.fromkeys(str(e.get("configuration")) for e in entries if isinstance(e, dict)))
    used = wanted if wanted in given else next(iter(given), None)
    if wanted is not None and wanted != used and given != ["None"]:  # without configurations: any
        text = f"has no polars of the configuration '{wanted}', which the blade names"
        file.problem((*at, "polars"), text, remedy=hint(wanted, given))
    if len(given) > 1:
        others = ", ".join(each for each in given if each != used)
        file.notes.append(f"airfoil {name}: polars of the configuration {used}, not of {others}")
    for k, entry in enumerate(entries):
        if not isinstance(entry, dict) or str(entry.get("configuration")) != used:
            continue
        if "re_sets" in entry:
            sets += [
                (*at, "polars", k, "re_sets", j)
                for j in range(len(file.entries(*at, "polars", k, "re_sets")))
            ]
        else:
            sets.append((*at, "polars", k))
    if not sets:
        file.problem((*at, "polars"), "has no polar")
        return None
    rows = [
        (file.number(*place, "re", default=1e6, positive=True), _polar(file, place, name)) for place in sets
    ]
    if any(polar is None for _, polar in rows):
        return None
    by_number = {number: polar for number, polar in rows if polar is not None}
    if len(by_number) < len(rows):
        file.notes.append(f"airfoil {name}: the last one of several polars with the same Reynolds number")
    numbers = np.array(sorted(by_number))
    return Airfoil(thick, center, numbers, tuple(by_number[n] for n in numbers))


def _polar(file: Ontology, at: tuple[Any, ...], name: str) -> Polar | None:
    """Polar of one Reynolds number; None with a problem."""
    before = len(file.problems)
    curves: list[tuple[FloatArray, FloatArray]] = []
    for key in _NAMES[2 if file.has(*at, _NAMES[2][0]) else 1]:
        if key.endswith("m") and not file.has(*at, key):
            curves.append((curves[0][0], np.zeros(curves[0][0].size)))
            continue
        grid, values = file.curve(*at, key, unit=False)
        grid = np.array(file.angle(grid), dtype=float)
        for k, sign in ((0, -1.0), (-1, 1.0)):
            if abs(grid[k] - sign * math.pi) < _HALF_TURN:
                grid[k] = sign * math.pi
        if grid[0] > -math.pi or grid[-1] < math.pi:
            ends = f"{math.degrees(grid[0]):g} to {math.degrees(grid[-1]):g} deg"
            text, remedy = f"is the range of the polar of {name}", "complete the polar"
            file.problem((*at, key), text, ends, "-180 to 180 deg", remedy)
        curves.append((grid, values))
    if len(file.problems) > before:
        return None
    alpha = np.unique(np.concatenate([grid for grid, _ in curves]))
    if alpha.size == 2:
        alpha = np.array([alpha[0], 0.5 * (alpha[0] + alpha[1]), alpha[1]])
    lift, drag, moment = (np.interp(alpha, grid, values) for grid, values in curves)
    try:
        return Polar(name=name, alpha=alpha, lift=lift, drag=drag, moment=moment)
    except GeometryError as error:
        p = error.problem
        remedy = f"windIO {file.version} has angles in {'degrees' if file.version == 2 else 'radians'}"
        file.problem(at, f"{p.text}: airfoil {name}", p.value, p.limit, remedy)
        return None
