# SPDX-License-Identifier: Apache-2.0
"""Sidebands of mesh lines at multiples of a shaft or carrier frequency."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.harmonics import kept_harmonics, read_tones, require_resolved
from pitchpoint.analysis.sampled import Array, SignalError, as_signal, positive, whole

_ABOVE = 3.0
"""Minimum ratio of a significant line to its background."""
_FLOOR = 1e-8
"""Minimum sideband amplitude over the largest sample, above window leakage and round-off."""


@dataclass(frozen=True)
class SidebandTable:
    """Lines at k f_mesh + j f_shaft.

    Attributes
    ----------
    harmonic
        Shape (n_harmonic,). Numbers k of the mesh harmonics [-].
    order
        Shape (2 J + 1,). Numbers j of the sidebands, from -J to J; 0 is the mesh line [-].
    frequency
        Shape (n_harmonic, 2 J + 1). Frequencies found [Hz].
    amplitude
        Shape (n_harmonic, 2 J + 1). Peak amplitudes, in the unit of the signal.
    level
        Shape (n_harmonic, 2 J + 1). Amplitude over that of the mesh line [dB].
    background
        Shape (n_harmonic, 2 J + 1). Median amplitude of the surrounding lines, in the unit of the signal.
    ratio
        Shape (n_harmonic,). Sum of all sidebands over the mesh line [-].
    index
        Shape (n_harmonic,). Mean of the two sidebands j = -1, 1, in the unit of the signal.
    asymmetry
        Shape (n_harmonic, J). (upper - lower)/(upper + lower) by |j| [-]: 1 if there is only the upper
        sideband; NaN if neither is significant.
    lost
        Number of requested mesh harmonics with sidebands above half the sample rate [-].
    """

    harmonic: Array
    order: Array
    frequency: Array
    amplitude: Array
    level: Array
    background: Array
    ratio: Array
    index: Array
    asymmetry: Array
    lost: int


def sideband_table(
    values: ArrayLike,
    sample_rate: float,
    mesh: float,
    spacing: float,
    *,
    harmonics: int = 3,
    sidebands: int = 3,
    tolerance: float = 0.01,
) -> SidebandTable:
    """Amplitudes and levels of mesh harmonics and their sidebands at multiples of a shaft frequency.

    Parameters
    ----------
    values
        Samples, shape (n_sample,), any unit.
    sample_rate
        Sample rate f_s [Hz].
    mesh
        Approximate mesh frequency f_m [Hz].
    spacing
        Sideband spacing: rotation frequency of the shaft or carrier [Hz].
    harmonics
        Number of mesh harmonics [-].
    sidebands
        Number of sidebands J on either side [-].
    tolerance
        Relative tolerance of mesh frequency and spacing [-].

    Returns
    -------
    SidebandTable
        One row per mesh harmonic with all sidebands below half the sample rate.

    Raises
    ------
    SignalError
        If the record is too short to separate the sidebands, the lowest sideband is below zero, or the
        sidebands of the first harmonic are not below half the sample rate.

    Notes
    -----
    Lines by `harmonics.read_tones`; if the mesh line is a peak, sideband frequencies are relative to it. Sum
    over mesh line as in [1]_; the asymmetry is due to combined amplitude and phase modulation, and to planets
    that pass the sensor [2]_. Valid for constant speed. A sideband is significant for the asymmetry if it
    exceeds three times its background and 1e-8 of the largest sample, that is, window leakage and round-off.

    References
    ----------
    .. [1] J. Hanna, C. Hatch, M. Kalb, A. Weiss, H. Luo, Detection of wind turbine gear tooth defects using
       sideband energy ratio, China Wind Power, 2011.
    .. [2] P. D. McFadden, J. D. Smith, An explanation for the asymmetry of the modulation sidebands about the
       tooth meshing frequency in epicyclic gear vibration, Proc. IMechE C 199(1), 1985, 65-70.

    Examples
    --------
    A mesh of 200 Hz with 40 % amplitude modulation by a shaft of 7.5 Hz: sidebands of 20 %.

    >>> t = np.arange(4000) / 2000.0
    >>> x = (1 + 0.4 * np.cos(2 * np.pi * 7.5 * t)) * np.cos(2 * np.pi * 200.0 * t)
    >>> table = sideband_table(x, 2000.0, 200.0, 7.5, harmonics=1, sidebands=1)
    >>> table.amplitude.round(4).tolist(), round(float(table.ratio[0]), 4)
    ([[0.2, 1.0, 0.2]], 0.4)
    """
    x = as_signal(values, minimum=4)
    rate, f_m = positive(sample_rate, "sample_rate"), positive(mesh, "mesh")
    gap, slack = positive(spacing, "spacing"), positive(tolerance, "tolerance")
    most = whole(sidebands, "sidebands")
    resolution = rate / x.size
    require_resolved(gap, resolution, "spacing")
    if most * gap >= f_m:
        raise SignalError(
            f"sidebands: {most} of {gap:g} Hz reach below zero from {f_m:g} Hz (limit "
            f"{int(np.ceil(f_m / gap)) - 1}); request fewer"
        )
    number, lost = kept_harmonics(f_m, rate - 2.0 * most * gap, harmonics)
    carrier = read_tones(x, rate, number * f_m, reach=np.minimum(slack * number * f_m, 0.5 * gap))
    seen = carrier.is_peak & (carrier.amplitude > _ABOVE * carrier.background)
    middle = np.where(seen, carrier.frequency, number * f_m)
    order = np.arange(-most, most + 1.0)
    wanted = middle[:, None] + order[None, :] * gap
    reach = np.minimum(np.maximum(slack * np.abs(order) * gap, resolution), 0.5 * gap)
    found = read_tones(x, rate, wanted.ravel(), reach=np.tile(reach, number.size))
    shape = (number.size, order.size)
    amplitude = found.amplitude.reshape(shape)
    line = amplitude[:, most]
    left, right = amplitude[:, most - 1 :: -1], amplitude[:, most + 1 :]
    floor = np.maximum(_ABOVE * found.background, _FLOOR * np.abs(x).max())
    stands = (found.amplitude > floor).reshape(shape)
    either = stands[:, most - 1 :: -1] | stands[:, most + 1 :]
    with np.errstate(divide="ignore", invalid="ignore"):
        level = 20.0 * np.log10(amplitude / line[:, None])
        ratio = (left.sum(axis=1) + right.sum(axis=1)) / line
        asymmetry = np.where(either, (right - left) / (right + left), np.nan)
    return SidebandTable(
        harmonic=number,
        order=order,
        frequency=found.frequency.reshape(shape),
        amplitude=amplitude,
        level=level,
        background=found.background.reshape(shape),
        ratio=ratio,
        index=0.5 * (left[:, 0] + right[:, 0]),
        asymmetry=asymmetry,
        lost=lost,
    )
