# SPDX-License-Identifier: Apache-2.0
"""Box of turbulence from a seed: Fourier coefficients with spectrum and coherence, then time series.

Source: P. S. Veers, Three-dimensional wind simulation, Sandia report SAND88-0152, 1988; spectra and coherence
of IEC 61400-1:2005, annex B.2.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.wind.box import WindBox
from pitchpoint.model.wind.turbulence import KaimalTurbulence
from pitchpoint.solvers.turbulence.coherent_phases import coherent_coefficients, independent_coefficients
from pitchpoint.solvers.turbulence.kaimal import DEVIATIONS, band_variance, coherence_decay

Array = NDArray[np.float64]

_BLOCK = 1 << 22
"""Samples that are transformed to time together: 32 MB."""


def frequencies(turbulence: KaimalTurbulence) -> Array:
    """Frequencies of a box [Hz], shape (n_f,): multiples of 1/duration below half the sampling rate."""
    n = turbulence.samples
    return np.arange(1, (n - 1) // 2 + 1) / (n * turbulence.time_step)


def line_variances(turbulence: KaimalTurbulence, component: int) -> Array:
    """Variance of each frequency [m²/s²], shape (n_f,).

    The Kaimal spectrum is integrated over the band around each frequency, and all bands are multiplied by
    one factor so that their sum is the variance σ² of the component.

    Parameters
    ----------
    turbulence
        Description.
    component
        0 longitudinal, 1 lateral, 2 vertical.
    """
    f = frequencies(turbulence)
    half = 0.5 * f[0]
    share = band_variance(f - half, f + half, component, turbulence.mean_speed, turbulence.hub_height)
    return share * ((DEVIATIONS[component] * turbulence.deviation) ** 2 / share.sum())


def make_turbulence(turbulence: KaimalTurbulence, seed: int) -> WindBox:
    """Box of turbulence; the same seed gives the same numbers.

    The memory needed is that of the box and, in single precision, of one component once more.

    Parameters
    ----------
    turbulence
        Description.
    seed
        Integer from 0.

    Returns
    -------
    WindBox
        Fluctuations with zero mean at every point, periodic in time.

    Raises
    ------
    ModelError
        If the seed is not an integer from 0.

    Examples
    --------
    >>> wind = KaimalTurbulence(mean_speed=12.0, deviation=1.8, hub_height=90.0, size=(60.0, 60.0),
    ...                         points=(3, 3), duration=60.0, time_step=0.1)
    >>> box = make_turbulence(wind, seed=1)
    >>> box.velocity.shape
    (600, 3, 3, 3)
    """
    if isinstance(seed, bool) or not isinstance(seed, int) or seed < 0:
        text = "is not an integer from 0"
        raise ModelError([Message("turbulence.seed", text, repr(seed), ">= 0", "write a whole number")])
    n, (n_y, n_z) = turbulence.samples, turbulence.points
    spacing = _spacing(turbulence)
    velocity = np.empty((n, n_z, n_y, 3), np.float32)
    for component in range(3):
        lines = _lines(turbulence, component, spacing, np.random.default_rng([seed, component]))
        _to_time(lines, velocity, component)
    return WindBox(
        velocity=velocity,
        time_step=turbulence.duration / n,
        spacing=spacing,
        bottom=max(turbulence.hub_height - 0.5 * turbulence.size[1], 0.0),
        hub_height=turbulence.hub_height,
        mean_speed=turbulence.mean_speed,
    )


def _spacing(turbulence: KaimalTurbulence) -> tuple[float, float]:
    """Distances of the grid along y and z [m]; 1 m along an axis with one point."""
    y, z = (
        length / (number - 1) if number > 1 else 1.0
        for length, number in zip(turbulence.size, turbulence.points, strict=True)
    )
    return y, z


def _lines(
    turbulence: KaimalTurbulence,
    component: int,
    spacing: tuple[float, float],
    rng: np.random.Generator,
) -> NDArray[np.complex64]:
    """Fourier coefficients of a component, shape (n/2 + 1, n_z, n_y); a wave of amplitude a has a/2."""
    f = frequencies(turbulence)
    n_y, n_z = turbulence.points
    found = np.zeros((turbulence.samples // 2 + 1, n_z, n_y), np.complex64)
    amplitude = np.sqrt(0.5 * line_variances(turbulence, component))[:, None, None]
    coherent = component == 0 or turbulence.coherent == "uvw"
    decay = coherence_decay(f, component, turbulence.mean_speed, turbulence.hub_height)
    step = max(1, _BLOCK // (n_y * n_z))
    for k in range(0, f.size, step):
        part = slice(k, min(k + step, f.size))
        if coherent and n_y * n_z > 1:
            unit = coherent_coefficients(decay[part], turbulence.points, spacing, rng)
        else:
            unit = independent_coefficients(part.stop - part.start, turbulence.points, rng)
        found[1 + part.start : 1 + part.stop] = amplitude[part] * unit
    return found


def _to_time(lines: NDArray[np.complex64], velocity: NDArray[np.float32], component: int) -> None:
    """Transform coefficients to time series, some rows of the grid together."""
    n, n_z, n_y = velocity.shape[:3]
    step = max(1, _BLOCK // (n * n_y))
    for k in range(0, n_z, step):
        velocity[:, k : k + step, :, component] = n * np.fft.irfft(
            lines[:, k : k + step].astype(np.complex128), n, axis=0
        )
