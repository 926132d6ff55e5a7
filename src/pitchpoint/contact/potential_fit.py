# SPDX-License-Identifier: Apache-2.0
"""Table of the elastic potential from its values and derivatives at the points of a grid.

The spline interpolates V = sqrt(2 U), which crosses zero with a slope where contact begins; U itself would
oscillate below that place. Below contact V continues along the approach by the tangent at the lowest point in
contact. Slopes of V by phase, misalignment and centre distance double the resolution of these axes; not that
of the approach, where V has its kink at the beginning of contact.

Derivation: docs/theory/stiffness.md, "Pre-computed flank contact".
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.potential_axes import TableAxis
from pitchpoint.contact.potential_table import (
    APPROACH,
    AXES,
    HEAD,
    MAX_QUANTITIES,
    PHASE,
    QUANTITIES,
    RATIOS,
    VALUES,
)
from pitchpoint.contact.stiffness.description import refuse
from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import NOT_FINITE, REFUSED

FloatArray = NDArray[np.float64]

U, U_S, U_X, U_KAPPA, U_A, FURTHER = 0, 1, 2, 3, 4, 5
"""Columns of the values at a point: potential, its derivatives, then further quantities."""

PAIR_FORCE = "pair_force_"
"""Beginning of the names of quantities that belong to tooth pairs, in the order of their numbers: a mesh
cycle later each pair has taken the place of the next one."""

NO_CONTACT = 1e-14
"""Share of the largest potential below which a point counts as without contact."""
FLATTEST = 0.02
"""Smallest slope below contact, as share of the largest slope of V by the approach."""
FALLING = 1e-6
"""Share of the largest force by which a computed force may be negative."""


@dataclass(frozen=True, eq=False)
class PotentialTable:
    """Table of the elastic potential of one flank.

    Parameters
    ----------
    axes
        Mesh phase, approach [m], misalignment [rad], centre distance [m].
    coefficients
        B-spline coefficients of V [J^0.5], shape (n_s, n_x, n_kappa, n_a), without the repeated ones of the
        phase.
    ratios
        Ratios of further quantities to the force at the tabulated points, shape (n, *points).
    quantities
        Unit of every further quantity, by name.
    errors
        Measured errors by name: rms, maximum and rms of the quantity itself, in nominal values.

    Examples
    --------
    >>> table = PotentialTable.of_spring(2.0e8, 1.0e-5, 5.0e-5)
    >>> table.coefficients.shape, sorted(table.quantities)
    ((8, 6, 1, 1), [])
    """

    axes: tuple[TableAxis, TableAxis, TableAxis, TableAxis]
    coefficients: FloatArray
    ratios: FloatArray
    quantities: Mapping[str, str] = field(default_factory=dict)
    errors: Mapping[str, tuple[float, float, float]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Check shapes and numbers."""
        check_quantities(self.quantities)
        shape = coefficients_shape(self.axes)
        points = (len(self.quantities), *(axis.count for axis in self.axes))
        for name, array, wanted in (
            ("coefficients", self.coefficients, shape),
            ("ratios", self.ratios, points),
        ):
            if array.shape != wanted:
                raise refuse(
                    f"table.{name}", "is not the shape", array.shape, str(wanted), "rebuild the table"
                )
            if not np.all(np.isfinite(array)):
                raise refuse(f"table.{name}", "is not finite", "NaN or inf", "numbers", "rebuild the table")
        if not np.all(np.isfinite([size for sizes in self.errors.values() for size in sizes])):
            raise refuse("table.errors", "are not finite", "NaN or inf", "numbers", "rebuild the table")
        if np.max(lowest_values(self.axes, self.coefficients)) >= 0.0:
            raise refuse("table.coefficients", "begin in contact", "V >= 0", "V < 0", "rebuild the table")

    @cached_property
    def packed(self) -> FloatArray:
        """The array for the kernels of `contact.potential_table`, shape (n,)."""
        blocks = [axis.block for axis in self.axes]
        head = np.zeros(HEAD)
        head[QUANTITIES] = len(self.quantities)
        head[AXES : AXES + 4] = HEAD + np.cumsum([0, *(len(b) for b in blocks[:-1])])
        head[VALUES] = HEAD + sum(len(b) for b in blocks)
        head[RATIOS] = head[VALUES] + self.coefficients[:1].size * self.axes[PHASE].n_coefficients
        wrapped = np.concatenate([self.coefficients, self.coefficients[:3]])
        end = self.ratios[:, :1].copy()
        of_pairs = np.array([name.startswith(PAIR_FORCE) for name in self.quantities], dtype=bool)
        end[of_pairs] = np.roll(end[of_pairs], 1, axis=0)
        ratios = np.concatenate([self.ratios, end], axis=1)
        packed = np.concatenate(
            [
                head,
                *blocks,
                np.transpose(wrapped, (0, 2, 3, 1)).ravel(),
                ratios.transpose(1, 3, 4, 2, 0).ravel(),
            ]
        )
        packed.setflags(write=False)
        return packed

    @classmethod
    def of_spring(cls, k: float, first: float, last: float, lever: float | None = None) -> PotentialTable:
        """Table of one linear spring without any other dependence, for examples and tests.

        Parameters
        ----------
        k
            Stiffness [N/m].
        first, last
            Approach at first contact and highest approach [m].
        lever
            Constant ratio of one further quantity to the force [m].
        """
        x = np.linspace(first - 0.25 * (last - first), last, 6)
        axes = (
            TableAxis("phase", np.arange(8) / 8.0, period=1.0),
            TableAxis("approach", x),
            TableAxis("misalignment", np.zeros(1)),
            TableAxis("centre_distance", np.zeros(1)),
        )
        force = k * np.maximum(x - first, 0.0)
        values = np.zeros((8, 6, 1, 1, FURTHER + (lever is not None)))
        values[..., U] = (0.5 * force * np.maximum(x - first, 0.0))[:, None, None]
        values[..., U_X] = force[:, None, None]
        if lever is not None:
            values[..., FURTHER] = lever * values[..., U_X]
        return fit_potential(axes, values, {} if lever is None else {"lever": "m"})


def check_quantities(quantities: Mapping[str, str]) -> None:
    """Refuse more further quantities than a table may have.

    Parameters
    ----------
    quantities
        Unit of every further quantity, by name.

    Raises
    ------
    ModelError
        If there are more than `MAX_QUANTITIES`.

    Examples
    --------
    >>> check_quantities({"pair_force_0": "1"})
    """
    if len(quantities) > MAX_QUANTITIES:
        words = "is too large a number of further quantities"
        remedy = "use flexible contact, or fewer tooth pairs in contact: each is a quantity"
        raise refuse("table.quantities", words, len(quantities), f"<= {MAX_QUANTITIES}", remedy)


def coefficients_shape(axes: tuple[TableAxis, ...]) -> tuple[int, ...]:
    """Shape of the coefficients of a table with given axes.

    Parameters
    ----------
    axes
        The four axes.

    Examples
    --------
    >>> coefficients_shape(PotentialTable.of_spring(1.0, 0.0, 1.0).axes)
    (8, 6, 1, 1)
    """
    return tuple(axis.size for axis in axes)


def lowest_values(axes: tuple[TableAxis, ...], coefficients: FloatArray) -> FloatArray:
    """Coefficients of the largest V at the lowest approach within the tolerances of axes with one point.

    Parameters
    ----------
    axes
        The four axes.
    coefficients
        Coefficients of V, shape (n_s, n_x, n_kappa, n_a).

    Returns
    -------
    FloatArray
        Shape (n_s, n_kappa, n_a), with one value for an axis with one point. A spline is below its largest
        coefficient.

    Examples
    --------
    >>> spring = PotentialTable.of_spring(2.0e8, 0.0, 4.0e-5)
    >>> bool(np.all(lowest_values(spring.axes, spring.coefficients) < 0.0))
    True
    """
    bound = coefficients[:, 0]
    for number, axis in ((1, axes[2]), (2, axes[3])):
        if axis.count == 1:
            value, *slopes = np.split(bound, axis.size, axis=number)
            bound = value + axis.tolerance * sum(np.abs(slope) for slope in slopes)
    return bound


def fit_potential(
    axes: tuple[TableAxis, TableAxis, TableAxis, TableAxis],
    values: FloatArray,
    quantities: Mapping[str, str] | None = None,
) -> PotentialTable:
    """Table through values of the potential and its derivatives at all points of the axes.

    Parameters
    ----------
    axes
        Mesh phase, approach, misalignment, centre distance.
    values
        Potential [J], its derivatives by the four coordinates, and further quantities that vanish without
        contact, shape (n_s, n_x, n_kappa, n_a, 5 + n).
    quantities
        Unit of every further quantity, by name.

    Returns
    -------
    PotentialTable
        Without measured errors.

    Raises
    ------
    SolverError
        If the values are not those of an elastic potential that grows with the approach.
    ModelError
        If contact begins below the first approach.

    Examples
    --------
    >>> spring = PotentialTable.of_spring(2.0e8, 0.0, 4.0e-5)
    >>> float(np.round(spring.coefficients.max() ** 2 / 2.0, 6))  # 2e8 N/m * (40 um)^2/2
    0.16
    """
    quantities = dict(quantities or {})
    shape = tuple(axis.count for axis in axes)
    if values.shape != (*shape, FURTHER + len(quantities)):
        raise SolverError(
            f"the values of the potential have the shape {values.shape}, not that of the axes", REFUSED
        )
    _check(axes, values)
    V = _roots(axes[APPROACH].points, values)
    for axis, number in zip(axes, range(4), strict=True):
        by_value, by_slope = axis.slopes_operators
        smooth = axis.values_operator
        slope = V.pop(U_S + number)
        V = {k: _along(number, by_value if k == U else smooth, v) for k, v in V.items()}
        V[U] += _along(number, by_slope, slope)
    coefficients = np.ascontiguousarray(V[U][: len(axes[PHASE].refined)])
    # no teeth touch at the lowest approach: the spline must not overshoot there
    excess = np.maximum(lowest_values(axes, coefficients) + 1e-9 * np.max(np.abs(V[U])), 0.0)
    inside = tuple(slice(0, 1) if axis.count == 1 else slice(None) for axis in axes[2:])
    coefficients[:, 0, *inside] -= excess
    return PotentialTable(axes, coefficients, _ratios(values), quantities)


def _along(axis: int, operator: FloatArray, values: FloatArray) -> FloatArray:
    """Apply an operator along one axis of an array."""
    return np.moveaxis(np.tensordot(operator, values, axes=(1, axis)), 0, axis)


def _check(axes: tuple[TableAxis, ...], values: FloatArray) -> None:
    """Refuse values that no elastic potential has, with the state where it is worst."""
    names = ("phase", "approach", "misalignment", "centre distance")
    energy, force = values[..., U], values[..., U_X]
    largest = float(np.max(energy, initial=0.0, where=np.isfinite(energy)))
    wrong = (
        (~np.all(np.isfinite(values), axis=-1), NOT_FINITE, "is not finite"),
        (energy < -NO_CONTACT * largest, REFUSED, "is negative"),
        (force < -FALLING * np.max(np.abs(force)), REFUSED, "decreases with the approach"),
        (np.broadcast_to(largest <= 0.0, energy.shape), REFUSED, "is zero everywhere: raise the approach"),
    )
    for faults, status, words in wrong:
        if np.any(faults):
            at = np.unravel_index(int(np.argmax(faults)), faults.shape)
            place = ", ".join(
                f"{name} {axis.points[i]:.6g}" for name, axis, i in zip(names, axes, at, strict=True)
            )
            raise SolverError(f"the elastic potential {words} ({place})", status)
    begun = np.argwhere(energy[:, 0] > NO_CONTACT * largest)
    if len(begun):
        lowest, phase = axes[APPROACH].points[0], axes[PHASE].points[begun[0, 0]]
        words = f"is the lowest approach, but teeth are in contact there (phase {phase:.6g})"
        raise refuse("axis.approach", words, f"{lowest:.6g} m", "below first contact", "start lower")
    apart = ~np.any(energy > NO_CONTACT * largest, axis=APPROACH)
    if np.any(apart):
        k = np.argwhere(apart)[0]
        raise SolverError(
            f"no contact up to the highest approach (phase {axes[PHASE].points[k[0]]:.6g}, misalignment "
            f"{axes[2].points[k[1]]:.6g}, centre distance {axes[3].points[k[2]]:.6g}); raise the approach",
            REFUSED,
        )


def _roots(x: FloatArray, values: FloatArray) -> dict[int, FloatArray]:
    """V and its four slopes by column; below contact along the tangent at the lowest point in contact."""
    energy = values[..., U]
    touching = energy > NO_CONTACT * np.max(energy)
    touching = np.flip(np.logical_and.accumulate(np.flip(touching, APPROACH), axis=APPROACH), APPROACH)
    V = np.sqrt(2.0 * np.where(touching, energy, 0.0))
    safe = np.where(touching, V, 1.0)
    found = {U: V} | {k: np.where(touching, values[..., k] / safe, 0.0) for k in range(U_S, FURTHER)}
    first = np.argmax(touching, axis=APPROACH)[:, None]
    lowest = {k: np.take_along_axis(v, first, axis=APPROACH) for k, v in found.items()}
    lowest[U_X] = np.maximum(lowest[U_X], FLATTEST * np.max(found[U_X]))
    tangent = lowest[U] + lowest[U_X] * (x[None, :, None, None] - x[first])
    lowest[U] = np.minimum(tangent, 0.0)
    return {k: np.where(touching, found[k], lowest[k]) for k in found}


def _ratios(values: FloatArray) -> FloatArray:
    """Ratios of further quantities to the force; below contact those of the lowest point in contact."""
    force = values[..., U_X]
    loaded = force > FALLING * np.max(force)
    found = np.moveaxis(values[..., FURTHER:], -1, 0) / np.where(loaded, force, 1.0)
    first = np.argmax(loaded, axis=APPROACH)[:, None]
    lowest = np.take_along_axis(found, first[None], axis=1 + APPROACH)
    return np.ascontiguousarray(np.where(loaded, found, lowest))
