# SPDX-License-Identifier: Apache-2.0
"""Root stress of both gears from the loads of a contact analysis, by two methods.

Nominal bending stress with notch factor at the 30° tangent of the fillet, by the load of each tooth pair in
each contact plane; and stress of the fillet by finite elements, by the loads of all planes of a tooth and its
neighbours. Derivation: docs/theory/root_stress.md.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.root_section import (
    NOTCH_RANGE,
    RIM_RANGES,
    helix_factor,
    rim_factor,
    rim_ratio,
    root_section,
)
from pitchpoint.contact.tooth_fe.fillet_stress import stress_by_planes, stress_of_teeth
from pitchpoint.core.errors import GeometryError, join_notes, split_notes
from pitchpoint.core.nomenclature import attributes
from pitchpoint.solvers.contact_analysis.lubrication import OVER
from pitchpoint.system.rules.flexible_teeth import (
    blank_of,
    common_width,
    finite_elements_of,
    has_finite_elements,
)

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.components.gear import Gear
    from pitchpoint.solvers.contact_analysis.flank_states import FlankStates

Array = NDArray[np.float64]

FROM_TANGENT = {1: math.radians(30.0), -1: math.radians(40.0)}
"""Least tangent angle of points of the fillet by the sign of z: nearer to the flank, stress is that of the
load itself. Forces on the upper two thirds of the flank have their maximum beyond it."""
_PHASES = 256
"""Mesh phases whose stresses are in memory at the same time."""


def with_root_stress(data: xr.Dataset, flanks: FlankStates, method: str | None = None) -> xr.Dataset:
    """Add the root stress of both gears to a contact analysis.

    Parameters
    ----------
    data
        Dataset with the contact nodes.
    flanks
        The mesh.
    method
        "tangent" or "finite_elements"; None: finite elements if the teeth of the contact are.

    Returns
    -------
    xarray.Dataset
        With `root_stress` over the contact nodes and `gear` [Pa], NaN without load, and over `gear` the
        critical section and the factors. With finite elements also `root_stress_fe` at the point of the
        fillet with the largest stress of the torque, 0 for teeth without load and without loaded neighbours,
        and over torque and gear `root_tangent_fe`, the tangent angle of this point, and `root_stress_fe_min`,
        the minimum over the cycle where the maximum occurs. NaN, with a note, where a gear does not permit a
        method.
    """
    mesh = flanks.model.meshes[flanks.mesh]
    assert mesh.contact is not None
    whole = method or ("finite_elements" if has_finite_elements(mesh.contact) else "tangent")
    gears = [flanks.model.gears[name] for name in mesh.gears]
    found, notes = data.copy(), split_notes(str(data.attrs.get("notes", "")))
    size = tuple(data.sizes[name] for name in OVER)
    at_tangent = np.full((*size, 2), np.nan)
    sections: dict[str, list[float]] = {name: [math.nan] * 2 for name in SECTION}
    for k, gear in enumerate(gears):
        try:
            at_tangent[..., k], section = _at_tangent(data, flanks, k, gear)
        except GeometryError as error:
            notes.append(_without(flanks, k, "at the tangent of the fillet", error))
            continue
        for name, value in section.items():
            sections[name][k] = value
        notes += _remarks(flanks, k, gear, sections["root_chord"][k] / sections["root_fillet_radius"][k])
    found["root_stress"] = (*OVER, "gear"), at_tangent, attributes("root_stress")
    for name, values in sections.items():
        found[name] = ("gear",), values, attributes(name)
    internal = any(gear.geometry.is_internal for gear in gears)
    found.attrs["root_stress"] = f"30 deg tangent{', internal gear 60 deg' if internal else ''}"
    if whole == "finite_elements":
        found = _with_finite_elements(found, flanks, gears, notes)
    found.attrs["notes"] = join_notes(notes)
    return found


SECTION = ("root_chord", "root_fillet_radius", "helix_factor", "rim_factor")
"""Critical section and factors of a gear in the dataset."""


def _at_tangent(data: xr.Dataset, flanks: FlankStates, k: int, gear: Gear) -> tuple[Array, dict[str, float]]:
    """Stress at the tangent of the fillet of gear k (0, 1), and its section and factors."""
    pair = flanks.model.pairs[flanks.mesh]
    section = root_section(gear.geometry)
    Y_beta = helix_factor(gear.geometry.beta, pair.eps_beta)
    Y_B = rim_factor(gear.geometry, blank_of(gear))
    line_load = _values(data, "plane_force") / data["plane_width"].values
    stress = Y_beta * Y_B * section.stress(line_load, _values(data, f"roll_{k + 1}"))
    return stress, dict(zip(SECTION, (section.chord, section.fillet_radius, Y_beta, Y_B), strict=True))


def _remarks(flanks: FlankStates, k: int, gear: Gear, chord_over_radius: float) -> list[str]:
    """Notes on factors outside the ranges of the standard."""
    name = flanks.model.meshes[flanks.mesh].gears[k]
    found, low = [], RIM_RANGES[gear.geometry.sign][0]
    q_s = 0.5 * chord_over_radius
    if not NOTCH_RANGE[0] <= q_s < NOTCH_RANGE[1]:
        found.append(f"gear {name}: root stress with q_s = {q_s:.3g}, Y_S is stated for 1 to 8")
    if (ratio := rim_ratio(gear.geometry, blank_of(gear))) < low:
        size = "m_n" if gear.geometry.is_internal else "h_t"
        found.append(
            f"gear {name}: root stress with a rim of {ratio:.3g} {size}, Y_B is stated above {low:g}"
        )
    return found


def _without(flanks: FlankStates, k: int, method: str, error: GeometryError) -> str:
    """Note that a gear has no root stress by a method."""
    name = flanks.model.meshes[flanks.mesh].gears[k]
    return f"gear {name}: no root stress {method}, {error}"


def _with_finite_elements(
    data: xr.Dataset, flanks: FlankStates, gears: list[Gear], notes: list[str]
) -> xr.Dataset:
    """Dataset with the stress of the fillets by finite elements; adds notes."""
    size = tuple(data.sizes[name] for name in OVER)
    stress = np.full((*size, 2), np.nan)
    extremes = np.full((2, size[0], 2), np.nan)
    words = []
    for k, gear in enumerate(gears):
        try:
            stress[..., k], extremes[..., k], text = _by_elements(data, flanks, k, gear)
        except GeometryError as error:
            notes.append(_without(flanks, k, "by finite elements", error))
            continue
        words.append(text)
    found = data.copy()
    found["root_stress_fe"] = (*OVER, "gear"), stress, attributes("root_stress_fe")
    for name, values in zip(("root_stress_fe_min", "root_tangent_fe"), extremes, strict=True):
        found[name] = (OVER[0], "gear"), values, attributes(name)
    if words:
        found.attrs["root_stress"] += f" and finite elements ({' and '.join(dict.fromkeys(words))})"
    return found


def _by_elements(data: xr.Dataset, flanks: FlankStates, k: int, gear: Gear) -> tuple[Array, Array, str]:
    """Stress of gear k at the point of the fillet with the largest stress of the mesh cycle; per torque the
    minimum at the place of the maximum, and the tangent angle of the point; resolution in words.

    The stored teeth have forces on their left flanks. Half a turn about the centre line of a tooth makes its
    right flank the left one; it reverses the face width and the order of the teeth.
    """
    mesh = flanks.model.meshes[flanks.mesh]
    tooth = finite_elements_of(gear)
    is_right = (flanks.flank < 0) != gear.geometry.is_internal
    low, high = common_width((mesh.offset1, mesh.offset2)[k], flanks.model.pairs[flanks.mesh])
    turned = slice(None, None, -1 if is_right else 1)
    span = (-high, -low) if is_right else (low, high)
    kept = tooth.tangents > FROM_TANGENT[gear.geometry.sign] - 1e-6
    if not kept.any():
        raise GeometryError(
            "has no point with the tangent angle of the largest stress", where="root_fillet_radius"
        )
    n = data.sizes["plane"]
    edges = np.linspace(*span, n + 1)
    by_planes = stress_by_planes(tooth, n, 0.5 * (edges[1:] + edges[:-1]), span)[kept]
    # in the order of the stored teeth: the next pair has the next tooth of gear 1, the previous of gear 2
    order = slice(None, None, 1 if k == 0 else -1)
    force = np.nan_to_num(_values(data, "plane_force"))[:, :, order, turned]
    root, tip = tooth.roll
    height = (2.0 * np.nan_to_num(_values(data, f"roll_{k + 1}")) - root - tip)[:, :, order, turned] / (
        tip - root
    )
    # teeth before and after contact have loaded neighbours, too
    beside = ((0, 0), (0, 0), (1, 1), (0, 0))
    force, height = np.pad(force, beside), np.pad(height, beside)
    stress, extremes = np.empty(tuple(data.sizes[name] for name in OVER)), np.empty((2, len(force)))
    for t, loads in enumerate(zip(height, force, strict=True)):
        most = np.max([found.max(axis=(0, 1, 3)) for found in _by_phases(by_planes, *loads)], axis=0)
        point = int(np.argmax(most))
        there = np.concatenate(list(_by_phases(by_planes[point : point + 1], *loads)))[:, :, 0]
        place = int(np.argmax(there.max(axis=(0, 1))))
        extremes[:, t] = there[:, :, place].min(), tooth.tangents[kept][point]
        stress[t] = there[:, 1:-1]
    about = tooth.provenance
    words = f"order {about['section_order']}, {about['width_polynomials']} polynomials over the width"
    return stress[:, :, order, turned], extremes, words


def _by_phases(by_planes: Array, height: Array, force: Array) -> Iterator[Array]:
    """Stress of all teeth at parts of the mesh phases, shape (phases, teeth, F, planes)."""
    for first in range(0, len(force), _PHASES):
        part = slice(first, first + _PHASES)
        yield stress_of_teeth(by_planes, height[part], force[part])


def _values(data: xr.Dataset, name: str) -> Array:
    values: Any = data[name].transpose(*OVER).values
    return np.asarray(values, dtype=np.float64)
