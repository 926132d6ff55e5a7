# SPDX-License-Identifier: Apache-2.0
"""Fourier series of a curve over one mesh cycle: amplitudes and phases of the mesh orders."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError


@dataclass(frozen=True)
class MeshOrders:
    """Fourier series of curves over one base pitch.

    Attributes
    ----------
    order
        Multiples of the mesh frequency, 1, 2, … [-], shape (n_order,).
    amplitude
        Peak amplitudes, in the unit of the curve, shape (..., n_order).
    phase
        Phases [rad], shape (..., n_order): the series is mean + Σ amplitude cos(2π order ψ + phase).
    mean
        Means over the cycle, in the unit of the curve, shape (...).
    """

    order: Array
    amplitude: Array
    phase: Array
    mean: Array


def mesh_orders(values: ArrayLike, harmonics: int = 10) -> MeshOrders:
    """Fourier series of curves over one mesh cycle, exact for band-limited curves.

    Parameters
    ----------
    values
        Curves at equidistant mesh phases over one base pitch, from phase 0, without the repeated end point,
        shape (..., n_phase), any unit.
    harmonics
        Number of orders; reduced to those below half the number of phases.

    Returns
    -------
    MeshOrders
        The series.

    Raises
    ------
    SignalError
        If there are fewer than 4 phases.

    Examples
    --------
    >>> psi = np.arange(32) / 32
    >>> found = mesh_orders(5.0 + 2.0 * np.cos(2.0 * np.pi * psi + 0.5), harmonics=2)
    >>> float(found.mean), found.amplitude.round(9).tolist(), round(float(found.phase[0]), 9)
    (5.0, [2.0, 0.0], 0.5)
    """
    curves = np.asarray(values, dtype=np.float64)
    n = curves.shape[-1]
    if n < 4:
        raise SignalError(f"mesh cycle: {n} positions (limit at least 4); use more positions")
    series = np.fft.rfft(curves, axis=-1) / n
    last = min(harmonics, (n - 1) // 2)
    chosen = 2.0 * series[..., 1 : last + 1]
    return MeshOrders(
        order=np.arange(1.0, last + 1.0),
        amplitude=np.abs(chosen),
        phase=np.angle(chosen),
        mean=series[..., 0].real,
    )
