# SPDX-License-Identifier: Apache-2.0
"""Deviations of single teeth - pitch, runout, measured flank maps - and the gap that they cause.

Teeth are numbered counter-clockwise seen from +z, tooth 0 on the +x axis of the gear. The left flank of a
tooth is the one on its counter-clockwise side (for internal gears too).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import GeometryError, Message
from pitchpoint.geometry.modifications import (
    FlankModifications,
    base_tangent,
    deviation,
    flank_range,
    size_problems,
)

if TYPE_CHECKING:
    from pitchpoint.geometry.cylindrical_gear import CylindricalGear

FloatArray = NDArray[np.float64]

FLANKS = ("left", "right")


@dataclass(frozen=True, kw_only=True)
class Runout:
    """Eccentricity of the teeth relative to the axis of rotation.

    Parameters
    ----------
    amount
        Runout, twice the eccentricity [m], ≥ 0.
    phase
        Direction in which the teeth are displaced, from the centre of tooth 0 [rad].
    """

    amount: float
    phase: float = 0.0


@dataclass(frozen=True, kw_only=True)
class FlankMap:
    """Measured deviation of one flank of one tooth on a regular grid.

    Parameters
    ----------
    tooth
        Number of the tooth, from 0.
    flank
        "left" or "right".
    values
        Shape (n_roll, n_z): rows from the root form circle to the tip form circle at equal roll lengths,
        columns from z = −b/2 to b/2 [m]. Measured along the transverse base tangent, as by gear measuring
        machines (ISO 1328-1); positive is more material.
    """

    tooth: int
    flank: str
    values: ArrayLike


@dataclass(frozen=True, kw_only=True)
class Deviations:
    """All deviations of the teeth of one gear.

    Parameters
    ----------
    pitch
        Single pitch deviations f_pt of both flanks [m], arcs on the reference circle: entry i is for the
        pitch from tooth i − 1 to tooth i, positive if it is too long. Empty = none.
    pitch_right
        The same for the right flanks if they differ; `pitch` then holds those of the left flanks.
    runout
        Eccentricity, or None.
    flank_maps
        Measured flanks; flanks without a map are ideal.
    """

    pitch: Sequence[float] = ()
    pitch_right: Sequence[float] | None = None
    runout: Runout | None = None
    flank_maps: Sequence[FlankMap] = field(default=())


def _refuse(where: str, message: str, value: object, limit: str) -> GeometryError:
    return GeometryError(message, where=where, value=f"{value}", limit=limit)


def deviation_problems(deviations: Deviations, gear: CylindricalGear) -> list[Message]:
    """Deviations that are too large to be possible for a gear.

    Parameters
    ----------
    deviations
        Deviations of single teeth.
    gear
        External or internal gear.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=20, m_n=3e-3, b=0.02)
    >>> print(deviation_problems(Deviations(runout=Runout(amount=30.0)), gear)[0])
    runout.amount: 30000 mm is larger than the module (limit 3 mm); give it with a unit, such as 20 um
    """
    right = deviations.pitch if deviations.pitch_right is None else deviations.pitch_right
    amounts = {"pitch": max(_largest(deviations.pitch), _largest(right))}
    if deviations.runout is not None:
        amounts["runout.amount"] = deviations.runout.amount
    for k, measured in enumerate(deviations.flank_maps):
        amounts[f"flank_maps[{k}].values"] = _largest(measured.values)
    return size_problems(amounts, gear)


def _largest(values: ArrayLike) -> float:
    return float(np.abs(np.asarray(values, dtype=float)).max(initial=0.0))


def index_deviations(pitch: ArrayLike) -> FloatArray:
    """Displacement of each tooth from its ideal position, from the single pitch deviations.

    Parameters
    ----------
    pitch
        Single pitch deviations [m], shape (z,).

    Returns
    -------
    ndarray, shape (z,)
        Displacement [m] in the direction of counting, zero mean. The mean of `pitch` is subtracted first,
        because the pitches of a gear add up to one revolution.

    Notes
    -----
    Cumulative sum of the single pitch deviations (ISO 1328-1, index deviation).

    Examples
    --------
    >>> (1e6 * index_deviations([2e-6, -1e-6, -1e-6, 0.0])).round(9)
    array([ 1.25,  0.25, -0.75, -0.75])
    """
    pitch = np.asarray(pitch, dtype=float)
    place = np.cumsum(pitch - pitch.mean())
    return place - place.mean()


def _pitch_gap(deviations: Deviations, gear: CylindricalGear, flank: str) -> FloatArray:
    """Gap due to the displacement of each tooth [m], shape (z,)."""
    z = abs(gear.z)
    pitch = deviations.pitch
    if flank == "right" and deviations.pitch_right is not None:
        pitch = deviations.pitch_right
    values = np.asarray(pitch, dtype=float)
    if values.size == 0:
        return np.zeros(z)
    if values.shape != (z,) or not np.isfinite(values).all():
        raise _refuse("deviations.pitch", "is not one finite number per tooth", values.shape, f"({z},)")
    # A left flank displaced counter-clockwise, outwards from its tooth, reduces the gap.
    outwards = 1.0 if flank == "left" else -1.0
    return -outwards * index_deviations(values) * math.cos(gear.alpha_t)


def _runout_gap(
    runout: Runout, gear: CylindricalGear, flank: str, z: FloatArray, roll: FloatArray
) -> FloatArray:
    """Gap due to an eccentricity [m], shape (z, n_z, n_roll).

    The flank normal at the roll angle ξ = L/r_b is the direction of the base tangent there; the gap is minus
    the displacement along it. Helical teeth rotate with z, so that all points of a contact line have the same
    normal.
    """
    if not (0.0 <= runout.amount < math.inf and math.isfinite(runout.phase)):
        raise _refuse("deviations.runout", "is not possible", runout, "finite, amount >= 0")
    side = 1.0 if flank == "left" else -1.0
    tooth = 2.0 * math.pi / abs(gear.z) * np.arange(abs(gear.z))
    xi = roll / abs(gear.r_b)
    # For internal gears |ψ_b| is the half angle to the start of the same involute, hence the sign of the gear
    # in both terms.
    turned = 2.0 * math.tan(gear.beta) / abs(gear.d) * z
    tangent = tooth[:, None, None] + turned[:, None] + side * gear.sign * (gear.psi_b - xi)
    normal = tangent + side * 0.5 * math.pi
    return -0.5 * runout.amount * np.cos(normal - runout.phase)


def _resample(values: ArrayLike, z: FloatArray, roll: FloatArray, gear: CylindricalGear) -> FloatArray:
    """Bilinear interpolation of a flank map, constant beyond its edges; shape (n_z, n_roll)."""
    grid = np.asarray(values, dtype=float)
    if grid.ndim != 2 or grid.size == 0 or not np.isfinite(grid).all():
        raise _refuse("flank_maps.values", "is not a grid of finite numbers", grid.shape, "(n_roll, n_z)")
    root, tip = flank_range(gear)

    def weights(share: FloatArray, n: int) -> FloatArray:
        """Hat functions of n stations at relative positions `share`, shape (m, n) [-]."""
        place = np.clip(share, 0.0, 1.0) * (n - 1)
        return np.maximum(0.0, 1.0 - np.abs(place[:, None] - np.arange(n)[None, :]))

    along = weights((roll - root) / (tip - root), grid.shape[0])
    across = weights(z / gear.b + 0.5, grid.shape[1])
    return across @ grid.T @ along.T


def separation(
    gear: CylindricalGear,
    flank: str,
    z: ArrayLike,
    roll: ArrayLike,
    *,
    modifications: FlankModifications | None = None,
    deviations: Deviations | None = None,
) -> FloatArray:
    """Gap between the real and the ideal flanks of a gear, along the transverse base tangent.

    Parameters
    ----------
    gear
        External or internal gear.
    flank
        "left" or "right".
    z
        Positions along the face width [m], shape (n_z,), −b/2 to b/2.
    roll
        Roll lengths [m], shape (n_roll,).
    modifications
        Micro-geometry common to all flanks of this side.
    deviations
        Deviations of single teeth.

    Returns
    -------
    ndarray, shape (|z|, n_z, n_roll)
        Sum of modifications, deviations and the gap of the gear's `outline` [m]; positive = gap, negative =
        excess material.

    Raises
    ------
    GeometryError
        If the data do not fit the gear.

    Notes
    -----
    First order in the deviations. Pitch: f cos α_t, because a rotation of the tooth by f/r moves its flank
    along the base tangent by r_b f/r. Runout: component of the eccentricity along the flank normal.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> gear = CylindricalGear(z=50, m_n=3e-3, b=0.02)
    >>> late = Deviations(pitch=[0.0] * 10 + [5e-6, -5e-6] + [0.0] * 38)
    >>> gap = separation(gear, "left", [0.0], [0.025], deviations=late)
    >>> gap.shape, round(1e6 * float(gap[10, 0, 0] - gap[9, 0, 0]), 6)
    ((50, 1, 1), -4.698463)
    """
    if flank not in FLANKS:
        raise _refuse("flank", "is unknown", repr(flank), " or ".join(FLANKS))
    z = np.atleast_1d(np.asarray(z, dtype=float))
    roll = np.atleast_1d(np.asarray(roll, dtype=float))
    sep = np.zeros((abs(gear.z), z.size, roll.size))
    if gear.outline is not None:
        sep += gear.outline.gap(gear, flank, roll)
    if modifications is not None:
        sep += base_tangent(deviation(modifications, gear, roll[None, :], z[:, None]), gear)
    if deviations is None:
        return sep
    sep += _pitch_gap(deviations, gear, flank)[:, None, None]
    if deviations.runout is not None:
        sep += _runout_gap(deviations.runout, gear, flank, z, roll)
    for measured in deviations.flank_maps:
        if measured.flank not in FLANKS:
            raise _refuse("flank_maps.flank", "is unknown", repr(measured.flank), " or ".join(FLANKS))
        if not 0 <= measured.tooth < abs(gear.z):
            raise _refuse("flank_maps.tooth", "does not exist", measured.tooth, f"0 to {abs(gear.z) - 1}")
        if measured.flank == flank:
            sep[measured.tooth] -= _resample(measured.values, z, roll, gear)
    return sep
