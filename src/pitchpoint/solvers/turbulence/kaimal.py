# SPDX-License-Identifier: Apache-2.0
"""Spectra and coherence of the Kaimal model of IEC 61400-1.

Source: IEC 61400-1:2005, annex B.2.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.model.wind.iec import turbulence_scale

Array = NDArray[np.float64]

SCALES = (8.1, 2.7, 0.66)
"""Integral scales of u, v and w over Λ_1."""
DEVIATIONS = (1.0, 0.8, 0.5)
"""Standard deviations of u, v and w over σ_1."""
DECAY = 12.0
"""Decay of the coherence with the reduced frequency."""
OFFSET = 0.12
"""Coherence of slow changes: the factor of distance over coherence length."""


def spectral_density(f: ArrayLike, component: int, deviation: float, mean: float, hub: float) -> Array:
    """One-sided spectral density S(f) = 4 σ² (L/V) / (1 + 6 f L/V)^(5/3) [m²/s], shape of f.

    Parameters
    ----------
    f
        Frequencies [Hz].
    component
        0 longitudinal, 1 lateral, 2 vertical.
    deviation
        Standard deviation of the component [m/s].
    mean
        Mean speed at hub height [m/s].
    hub
        Hub height [m].

    Examples
    --------
    >>> float(spectral_density(0.1, 0, 1.8, 12.0, 90.0).round(4))
    2.9692
    """
    length = SCALES[component] * turbulence_scale(hub) / mean
    return 4.0 * deviation**2 * length / (1.0 + 6.0 * np.asarray(f, float) * length) ** (5.0 / 3.0)


def band_variance(low: ArrayLike, high: ArrayLike, component: int, mean: float, hub: float) -> Array:
    """Share of the variance between two frequencies: (1 + 6 f L/V)^(-2/3) at `low` less that at `high`.

    Parameters
    ----------
    low, high
        Ends of the bands [Hz], of one shape, which is that of the result.
    component, mean, hub
        As for `spectral_density`.

    Examples
    --------
    >>> float(band_variance(0.0, 0.1, 0, 12.0, 90.0).round(4))
    0.8545
    """
    length = 6.0 * SCALES[component] * turbulence_scale(hub) / mean
    first, last = (1.0 + length * np.asarray(f, float) for f in (low, high))
    return np.asarray(first ** (-2.0 / 3.0) - last ** (-2.0 / 3.0))


def coherence_decay(f: ArrayLike, component: int, mean: float, hub: float) -> Array:
    """Decay c of the coherence exp(-c r) with the distance r [1/m], shape of f.

    c = 12 sqrt((f/V)² + (0.12/L_c)²) with L_c = 8.1 Λ_1. The standard defines it for the longitudinal
    component; for the others L_c is their integral scale.

    Parameters
    ----------
    f
        Frequencies [Hz].
    component, mean, hub
        As for `spectral_density`.

    Examples
    --------
    >>> float(np.exp(-10.0 * coherence_decay(0.1, 0, 12.0, 90.0)).round(4))
    0.3676
    """
    length = SCALES[component] * turbulence_scale(hub)
    return np.asarray(DECAY * np.hypot(np.asarray(f, float) / mean, OFFSET / length))
