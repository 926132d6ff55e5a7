# SPDX-License-Identifier: Apache-2.0
"""Profile shifts that are missing or placeholders: the centre distances determine them."""

from __future__ import annotations

import math
from typing import Any

from pitchpoint.core.units import parse_quantity
from pitchpoint.geometry.involute import transverse_pressure_angle, working_pressure_angle
from pitchpoint.io.rexs.conversion.state import Conversion, Meshing

KEY, ATTRIBUTE = "profile_shift_coefficient", "addendum_modification_coefficient"
ROUNDING = 1e-3
"""Difference of centre distances that rounded profile shifts can cause, in modules."""


def settle_shifts(conversion: Conversion) -> None:
    """Leave profile shifts to the centre distances where they are missing or placeholders.

    The centre distance wins over a profile shift of exactly 0 that contradicts it. A mesh determines one
    shift: meshes with one open gear come first. If both gears of the remaining meshes are open, gear 1 has no
    shift, because only the sum is determined.
    """
    follows: set[int] = set()
    """Gears whose profile shift follows from a mesh, by the identity of their data."""
    for meshing in () if conversion.own else conversion.meshings:
        _check_given(conversion, meshing, follows)
    left = list(conversion.meshings)
    while left:
        counts = [len(_open(meshing, follows)) for meshing in left]
        k = next((i for i, n in enumerate(counts) if n < 2), 0)
        meshing = left.pop(k)
        if counts[k] == 2:
            meshing.entries[0][KEY] = 0.0
            reason = "the centre distance determines the sum of both only"
            conversion.default(meshing.gears[0], ATTRIBUTE, "0", _target(conversion, meshing, 0), reason)
        for index in _open(meshing, follows):
            follows.add(id(meshing.entries[index]))
            reason = f"from the centre distance {_mm(meshing.distance)} of {_mesh(conversion, meshing)}"
            target = _target(conversion, meshing, index)
            conversion.default(meshing.gears[index], ATTRIBUTE, "zero backlash", target, reason)


def _open(meshing: Meshing, follows: set[int]) -> list[int]:
    """Gears of a mesh without profile shift that no mesh determines yet."""
    return [k for k, data in enumerate(meshing.entries) if KEY not in data and id(data) not in follows]


def _check_given(conversion: Conversion, meshing: Meshing, follows: set[int]) -> None:
    """Compare the profile shifts of both gears, if given, with the centre distance."""
    shifts = [data.get(KEY) for data in meshing.entries]
    if None in shifts:
        return
    off = distance_without_backlash(meshing.entries) - meshing.distance
    internal = any(data.get("type") == "internal" for data in meshing.entries)
    overlap = -off if internal else off
    if abs(off) <= ROUNDING * parse_quantity(meshing.entries[0]["normal_module"], "length"):
        if overlap > 0.0:
            text = f"rounded in the file, {1e6 * overlap:.3g} um of overlap"
            _leave(conversion, meshing, 1, text, follows)
        return
    zeros = [k for k in (0, 1) if shifts[k] == 0.0]
    if zeros:
        text = f"0 is a placeholder: it gives {_mm(meshing.distance + off)}, "
        text += f"and the centre distance is {_mm(meshing.distance)}"
        _leave(conversion, meshing, zeros[-1], text, follows)
    # else backlash by the centre distance, or an error that the model reports


def _leave(conversion: Conversion, meshing: Meshing, k: int, reason: str, follows: set[int]) -> None:
    """Leave the profile shift of a gear to the centre distance."""
    del meshing.entries[k][KEY]
    follows.add(id(meshing.entries[k]))
    target, why = _target(conversion, meshing, k), f"{_mesh(conversion, meshing)}: {reason}"
    conversion.changed(meshing.gears[k], ATTRIBUTE, "zero backlash", target, why)


def _target(conversion: Conversion, meshing: Meshing, k: int) -> str:
    return f"gears.{conversion.name(meshing.gears[k])}.{KEY}"


def _mesh(conversion: Conversion, meshing: Meshing) -> str:
    """Stage of a mesh in the file, and its gears by their names in the model."""
    return f"{meshing.stage}, {' / '.join(map(conversion.name, meshing.gears))}"


def _mm(value: float) -> str:
    return f"{1e3 * value:.6g} mm"


def distance_without_backlash(data: list[dict[str, Any]]) -> float:
    """Centre distance at which two gears with the given profile shifts have no backlash [m].

    Parameters
    ----------
    data
        Data of both gears for the model file.

    Examples
    --------
    27/51 teeth of an industrial gearbox; its centre distance is 190 mm.

    >>> gear = {"normal_module": "4.5 mm", "helix_angle": "21 deg", "profile_shift_coefficient": 0.231415}
    >>> pair = [{"number_of_teeth": 27, **gear}, {"number_of_teeth": 51, **gear}]
    >>> round(1e3 * distance_without_backlash(pair), 4)
    190.0
    """
    signs = [-1.0 if one.get("type") == "internal" else 1.0 for one in data]
    z = sum(sign * one["number_of_teeth"] for sign, one in zip(signs, data, strict=True))
    m_n = parse_quantity(data[0]["normal_module"], "length")
    alpha_n = parse_quantity(data[0].get("normal_pressure_angle", "20 deg"), "angle")
    beta = parse_quantity(data[0].get("helix_angle", "0 deg"), "angle")
    alpha_t = transverse_pressure_angle(alpha_n, beta)
    x_sum = sum(one[KEY] for one in data)
    alpha_wt = working_pressure_angle(z_sum=int(z), alpha_n=alpha_n, beta=beta, x_sum=x_sum)
    return abs(z) * m_n / (2.0 * math.cos(beta)) * math.cos(alpha_t) / math.cos(alpha_wt)
