# SPDX-License-Identifier: Apache-2.0
"""Parts of a synchronous average: regular, residual and difference signal, envelope of a mesh harmonic.

The average is one exact period, and every order is one line of its Fourier series. Orders are therefore
removed without window, leakage or filter transients.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, whole

MIN_TEETH = 4


@dataclass(frozen=True)
class GearSignals:
    """Parts of a synchronous average; average = mean + regular + residual.

    Attributes
    ----------
    regular
        Shape (n,). Mesh harmonics and lowest orders of the shaft, in the unit of the signal.
    residual
        Shape (n,). Average less mean and regular signal, sidebands included: for NA4.
    difference
        Shape (n,). Residual without the first-order sidebands of the mesh harmonics: for FM4, M6A, M8A.
    mesh_orders
        Shape (n_harmonic,). Orders of the mesh harmonics within the bandwidth [-].
    """

    regular: Array
    residual: Array
    difference: Array
    mesh_orders: NDArray[np.int64]


def gear_signals(average: ArrayLike, *, teeth: int | Sequence[int], shaft_orders: int = 2) -> GearSignals:
    """Regular, residual and difference signal from the synchronous average of a shaft.

    Parameters
    ----------
    average
        One revolution of the shaft, shape (n,), any unit, at equal steps of its angle.
    teeth
        Number of teeth of the gear, or of all gears on the shaft, whose mesh harmonics are regular [-].
    shaft_orders
        Number of lowest shaft orders that are regular (unbalance, misalignment) [-].

    Returns
    -------
    GearSignals
        Regular, residual and difference signal.

    Raises
    ------
    SignalError
        If the first mesh harmonic is above the bandwidth of the average, or no orders remain.

    Notes
    -----
    The Fourier lines k z (and 1 ... `shaft_orders`) are the regular signal and are removed from the residual;
    the lines k z ± 1 are also removed from the difference. The difference is that of FM4 [1]_ (called
    residual by some authors), the residual that of NA4, with the first-order sidebands [2]_. Exact, because
    the average is one period. Valid for shafts with fixed axes.

    References
    ----------
    .. [1] R. M. Stewart, Some useful data analysis techniques for gearbox diagnostics, Institute of Sound and
       Vibration Research, University of Southampton, 1977.
    .. [2] J. J. Zakrajsek, D. P. Townsend, H. J. Decker, An analysis of gear fault detection methods as
       applied to pitting fatigue failure data, NASA TM 105950, 1993.

    Examples
    --------
    Amplitude modulation once per revolution gives a pair of first-order sidebands:

    >>> angle = 2 * np.pi * np.arange(256) / 256
    >>> parts = gear_signals((1 + 0.2 * np.cos(angle)) * np.cos(20 * angle), teeth=20)
    >>> [round(float(np.sqrt(np.mean(p**2))), 6) for p in (parts.regular, parts.residual, parts.difference)]
    [0.707107, 0.1, 0.0]
    >>> parts.mesh_orders.tolist()
    [20, 40, 60, 80, 100, 120]
    """
    x = as_signal(average, "average", 2 * MIN_TEETH)
    lines = np.fft.rfft(x)
    order = np.arange(lines.size)
    mesh, sidebands = np.zeros(lines.size, dtype=bool), np.zeros(lines.size, dtype=bool)
    for z in tooth_counts(teeth, x.size):
        mesh |= (order % z == 0) & (order > 0)
        # includes the lower sideband of a harmonic just above the bandwidth of the average
        sidebands |= ((order % z == 1) | (order % z == z - 1)) & (order > 1)
    regular = mesh | ((order >= 1) & (order <= int(shaft_orders)))
    rest = ~regular & (order > 0)
    if not np.any(rest & ~sidebands):
        raise SignalError("teeth: every order is a mesh harmonic or next to one; check the tooth counts")
    parts = [np.fft.irfft(np.where(kept, lines, 0.0), x.size) for kept in (regular, rest, rest & ~sidebands)]
    return GearSignals(parts[0], parts[1], parts[2], np.flatnonzero(mesh).astype(np.int64))


def mesh_envelope(
    average: ArrayLike, *, teeth: int, harmonic: int = 1, half_width: int | None = None
) -> Array:
    """Envelope of a synchronous average around one mesh harmonic.

    Parameters
    ----------
    average
        One revolution of the shaft, shape (n,), any unit.
    teeth
        Number of teeth z of the gear [-].
    harmonic
        Number of the mesh harmonic [-]; preferably the strongest.
    half_width
        Number of orders on either side of it [-]; default (z - 1)/2, half-way to the adjacent harmonics.

    Returns
    -------
    NDArray
        Magnitude of the analytic signal, shape (n,), in the unit of the signal.

    Raises
    ------
    SignalError
        If the band is outside the bandwidth of the average.

    Notes
    -----
    |x_b + i H(x_b)| of the band-passed average x_b [1]_; exact, because the average is one period. Valid if
    the band has a single carrier.

    References
    ----------
    .. [1] P. D. McFadden, Detecting fatigue cracks in gears by amplitude and phase demodulation of the
       meshing vibration, Journal of Vibration, Acoustics, Stress, and Reliability in Design 108(2), 1986,
       165-170.

    Examples
    --------
    >>> angle = 2 * np.pi * np.arange(256) / 256
    >>> envelope = mesh_envelope((1 + 0.2 * np.cos(3 * angle)) * np.cos(20 * angle), teeth=20)
    >>> bool(np.allclose(envelope, 1 + 0.2 * np.cos(3 * angle)))
    True
    """
    x = as_signal(average, "average", 2 * MIN_TEETH)
    (z,) = tooth_counts(teeth, x.size)
    width = (z - 1) // 2 if half_width is None else int(half_width)
    center = int(harmonic) * z
    # the line at half the samples per revolution has no phase
    if not (int(harmonic) >= 1 and 0 <= width < center and 2 * (center + width) < x.size):
        raise SignalError(
            f"harmonic: orders {center - width} to {center + width} (limit 1 to below {x.size / 2:g}); "
            "choose a lower harmonic or more samples per revolution"
        )
    lines = np.zeros(x.size, dtype=np.complex128)
    band = slice(center - width, center + width + 1)
    lines[band] = 2.0 * np.fft.rfft(x)[band]
    return np.asarray(np.abs(np.fft.ifft(lines)), dtype=np.float64)


def tooth_counts(teeth: int | Sequence[int], samples: int) -> tuple[int, ...]:
    """Check numbers of teeth: whole, and the first mesh harmonic within the bandwidth of an average.

    Parameters
    ----------
    teeth
        One or several numbers of teeth [-].
    samples
        Samples per revolution [-].

    Raises
    ------
    SignalError
        If a number is not a whole number of at least 4, or not below half the samples per revolution.

    Examples
    --------
    >>> tooth_counts([20, 31], 256)
    (20, 31)
    """
    counts = [whole(z, "teeth", MIN_TEETH) for z in np.atleast_1d(np.asarray(teeth)).tolist()]
    for z in counts:
        if 2 * z >= samples:
            raise SignalError(
                f"teeth: {samples} samples per revolution are too few for {z} teeth (limit above {2 * z}); "
                "raise the sample rate or the samples per revolution"
            )
    return tuple(counts)
