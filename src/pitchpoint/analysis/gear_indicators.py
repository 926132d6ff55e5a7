# SPDX-License-Identifier: Apache-2.0
"""Condition indicators of gears: FM0, FM4, M6A, M8A, energy operator, sidebands; NA4, NA4*, NB4 over records.

They are computed from the synchronous average of the shaft (`synchronous_average`) and its parts
(`gear_signals`). FM4, M6A and M8A respond to one or a few damaged teeth and decrease again when the damage
spreads; NA4, NA4* and NB4 are relative to earlier records and continue to rise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.gear_signals import gear_signals, mesh_envelope, tooth_counts
from pitchpoint.analysis.indicators import ROUND_OFF, alternating_part, standardised_moment
from pitchpoint.analysis.sampled import Array, SignalError, as_signal


@dataclass(frozen=True)
class GearIndicators:
    """Condition indicators from the synchronous average of a gear, dimensionless.

    Attributes
    ----------
    fm0
        Peak-to-peak value over the sum of the mesh harmonic amplitudes: rises with damage of all teeth.
    fm4, m6a, m8a
        Standardised moments of order 4, 6, 8 of the difference signal: 3, 15, 105 for Gaussian noise.
    energy_operator
        Kurtosis of the Teager-Kaiser energy of the residual signal.
    sideband_level_factor
        Sum of the first-order sidebands of the first mesh harmonic over the standard deviation.
    """

    fm0: float
    fm4: float
    m6a: float
    m8a: float
    energy_operator: float
    sideband_level_factor: float


@dataclass(frozen=True)
class RunningKurtosis:
    """Fourth moment of each record over the squared reference variance of earlier records.

    Attributes
    ----------
    value
        Shape (n_record,). The indicator after each record [-].
    variance
        Shape (n_record,). Variance of each record, in the square of its unit.
    reference
        Shape (n_record,). Reference variance of each record, in the square of its unit.
    """

    value: Array
    variance: Array
    reference: Array


def gear_indicators(average: ArrayLike, *, teeth: int, other_teeth: Sequence[int] = ()) -> GearIndicators:
    """Condition indicators of one gear from the synchronous average of its shaft.

    Parameters
    ----------
    average
        Synchronous average, shape (n,), any unit.
    teeth
        Number of teeth z of the gear [-].
    other_teeth
        Numbers of teeth of other gears on the same shaft, whose harmonics are regular [-].

    Returns
    -------
    GearIndicators
        Six indicators.

    Raises
    ------
    SignalError
        If the first mesh harmonic is above the bandwidth of the average, or the residual or difference signal
        is zero (an average without any noise).

    Notes
    -----
    FM0 = peak-to-peak/Σ A(k z) over all harmonics within the bandwidth, FM4 [1]_; M6A, M8A [2]_; energy
    operator: kurtosis of r_i² - r_(i-1) r_(i+1), periodic [3]_; sideband level factor (A(z - 1) +
    A(z + 1))/σ [4]_. Amplitudes A are peak values. Valid for shafts with fixed axes; see the review [5]_.

    References
    ----------
    .. [1] R. M. Stewart, Some useful data analysis techniques for gearbox diagnostics, Institute of Sound and
       Vibration Research, University of Southampton, 1977; as in J. J. Zakrajsek, An investigation of gear
       mesh failure prediction techniques, NASA TM 102340, 1989.
    .. [2] H. R. Martin, Statistical moment analysis as a means of surface damage detection, Proceedings of
       the 7th International Modal Analysis Conference, 1989, 1016-1021.
    .. [3] J. Ma, Energy operator and other demodulation approaches to gear defect detection, Proceedings of
       the 49th Meeting of the Society for Machinery Failure Prevention Technology, 1995, 127-140.
    .. [4] P. Večeř, M. Kreidl, R. Šmíd, Condition indicators for gearbox condition monitoring systems, Acta
       Polytechnica 45(6), 2005, 35-43.
    .. [5] P. D. Samuel, D. J. Pines, A review of vibration-based techniques for helicopter transmission
       diagnostics, Journal of Sound and Vibration 282, 2005, 475-508.

    Examples
    --------
    Mesh and sidebands with amplitudes of 1 and 0.1, and a sinusoidal difference signal:

    >>> angle = 2 * np.pi * np.arange(400) / 400
    >>> x = (1 + 0.2 * np.cos(angle)) * np.cos(20 * angle) + 0.01 * np.cos(7 * angle)
    >>> found = gear_indicators(x, teeth=20)
    >>> [round(v, 3) for v in (found.fm0, found.fm4, found.m6a, found.m8a, found.sideband_level_factor)]
    [2.403, 1.5, 2.5, 4.375, 0.28]
    """
    x = alternating_part(average, "average")
    (z,) = tooth_counts(teeth, x.size)
    parts = gear_signals(x, teeth=[z, *other_teeth])
    lines = 2.0 / x.size * np.abs(np.fft.rfft(x))
    if x.size % 2 == 0:
        lines[-1] *= 0.5
    mesh = float(lines[z::z].sum())
    largest = float(np.abs(x).max())
    if mesh <= ROUND_OFF * largest:
        raise SignalError(f"average: has no harmonic of {z} teeth; check number of teeth and shaft")
    _not_empty(parts.residual, largest, "residual")
    _not_empty(parts.difference, largest, "difference")
    return GearIndicators(
        fm0=float(np.ptp(x)) / mesh,
        fm4=standardised_moment(parts.difference, 4),
        m6a=standardised_moment(parts.difference, 6),
        m8a=standardised_moment(parts.difference, 8),
        energy_operator=standardised_moment(teager_kaiser_energy(parts.residual), 4),
        sideband_level_factor=float(lines[z - 1] + lines[z + 1]) / float(x.std()),
    )


def teager_kaiser_energy(values: ArrayLike) -> Array:
    """Teager-Kaiser energy of a periodic signal.

    Parameters
    ----------
    values
        One period, shape (n,), any unit.

    Returns
    -------
    NDArray
        x_i² - x_(i-1) x_(i+1), shape (n,), in the square of the unit.

    Notes
    -----
    A² sin²(Ω) for a sine of amplitude A and Ω radians per sample [1]_. Valid for one carrier, Ω below π/4.

    References
    ----------
    .. [1] J. F. Kaiser, On a simple algorithm to calculate the energy of a signal, International Conference
       on Acoustics, Speech, and Signal Processing, 1990, 381-384.

    Examples
    --------
    >>> energy = teager_kaiser_energy(3.0 * np.sin(2 * np.pi * np.arange(12) / 12))
    >>> bool(np.allclose(energy, 9.0 * np.sin(np.pi / 6) ** 2))
    True
    """
    x = as_signal(values, minimum=3)
    return np.asarray(x * x - np.roll(x, 1) * np.roll(x, -1), dtype=np.float64)


def running_kurtosis(records: Sequence[ArrayLike], *, good_records: int | None = None) -> RunningKurtosis:
    """Kurtosis of successive records of a gear, relative to a reference variance of earlier records.

    Parameters
    ----------
    records
        Residual signals (for NA4) or envelopes (for NB4) in chronological order, shape (n,) each, one unit.
    good_records
        Number of first records of the gear in good condition [-]: their mean variance is the reference of all
        records (NA4*). Default: the reference is the mean variance up to and including each record (NA4).

    Returns
    -------
    RunningKurtosis
        One value per record.

    Raises
    ------
    SignalError
        If there is no record, a record is constant, or `good_records` is out of range.

    Notes
    -----
    NA4_M = mean((r_M - r̄_M)⁴)/((1/M) Σ_j mean((r_j - r̄_j)²))² [1]_; NA4* uses the variance of the gear in
    good condition instead of the running mean [2]_, so that the reference does not follow the damage. Valid
    for records at constant load and speed, which also affect the variance. The first value is the kurtosis.

    References
    ----------
    .. [1] J. J. Zakrajsek, D. P. Townsend, H. J. Decker, An analysis of gear fault detection methods as
       applied to pitting fatigue failure data, NASA TM 105950, 1993.
    .. [2] H. J. Decker, R. F. Handschuh, J. J. Zakrajsek, An enhancement to the NA4 gear vibration diagnostic
       parameter, NASA TM 106553, 1994.

    Examples
    --------
    Three equal sines and one of twice the amplitude: 1.5 · 2⁴/((3 + 2²)/4)² = 7.837, and 1.5 · 2⁴ relative to
    the first three:

    >>> sine = np.sin(2 * np.pi * np.arange(64) / 64)
    >>> records = [sine, sine, sine, 2 * sine]
    >>> running_kurtosis(records).value.round(3), running_kurtosis(records, good_records=3).value.round(3)
    (array([1.5  , 1.5  , 1.5  , 7.837]), array([ 1.5,  1.5,  1.5, 24. ]))
    """
    parts = [alternating_part(record, f"record {k}") for k, record in enumerate(records)]
    if not parts:
        raise SignalError("records: none (limit 1); pass the records in the order of time")
    variance = np.array([np.mean(p**2) for p in parts])
    if good_records is None:
        reference = np.cumsum(variance) / np.arange(1, variance.size + 1)
    elif 1 <= good_records <= variance.size:
        reference = np.full(variance.size, variance[: int(good_records)].mean())
    else:
        raise SignalError(f"good_records: {good_records} (limit 1 to {variance.size}, the number of records)")
    fourth = np.array([np.mean(p**4) for p in parts])
    return RunningKurtosis(fourth / reference**2, variance, reference)


def na4(
    averages: Sequence[ArrayLike], *, teeth: int | Sequence[int], good_records: int | None = None
) -> RunningKurtosis:
    """NA4 of a gear for each of its records, or NA4* relative to records in good condition.

    Parameters
    ----------
    averages
        Synchronous averages of the shaft in chronological order, shape (n,) each, one unit.
    teeth
        Numbers of teeth of the gears on the shaft [-].
    good_records
        See `running_kurtosis`.

    Returns
    -------
    RunningKurtosis
        NA4 or NA4* [-].

    Raises
    ------
    SignalError
        As `gear_signals` and `running_kurtosis`.

    Notes
    -----
    `running_kurtosis` of the residual signals, which include the first-order sidebands [1]_.

    References
    ----------
    .. [1] J. J. Zakrajsek, D. P. Townsend, H. J. Decker, An analysis of gear fault detection methods as
       applied to pitting fatigue failure data, NASA TM 105950, 1993.

    Examples
    --------
    >>> angle = 2 * np.pi * np.arange(256) / 256
    >>> records = [np.cos(20 * angle) + a * np.cos(7 * angle) for a in (0.1, 0.1, 0.1, 0.2)]
    >>> na4(records, teeth=20).value.round(3)
    array([1.5  , 1.5  , 1.5  , 7.837])
    """
    residuals = []
    for average in averages:
        residuals.append(gear_signals(average, teeth=teeth).residual)
        _not_empty(residuals[-1], float(np.abs(average).max()), "residual")
    return running_kurtosis(residuals, good_records=good_records)


def nb4(averages: Sequence[ArrayLike], *, teeth: int, harmonic: int = 1) -> RunningKurtosis:
    """NB4 of a gear for each of its records: NA4 of the envelope around a mesh harmonic.

    Parameters
    ----------
    averages
        Synchronous averages of the shaft in chronological order, shape (n,) each, one unit.
    teeth
        Number of teeth of the gear [-].
    harmonic
        Number of the mesh harmonic [-]; preferably the strongest.

    Returns
    -------
    RunningKurtosis
        NB4 [-].

    Raises
    ------
    SignalError
        As `mesh_envelope` and `running_kurtosis`.

    Notes
    -----
    `running_kurtosis` of |x_b + i H(x_b)|, where x_b is the average in the band around the mesh harmonic, up
    to half-way to the adjacent harmonics [1]_.

    References
    ----------
    .. [1] J. J. Zakrajsek, R. F. Handschuh, H. J. Decker, Application of fault detection techniques to spiral
       bevel gear fatigue data, NASA TM 106467, 1994.

    Examples
    --------
    >>> angle = 2 * np.pi * np.arange(256) / 256
    >>> records = [(1 + a * np.cos(3 * angle)) * np.cos(20 * angle) for a in (0.1, 0.1, 0.1, 0.2)]
    >>> nb4(records, teeth=20).value.round(3)
    array([1.5  , 1.5  , 1.5  , 7.837])
    """
    return running_kurtosis([mesh_envelope(a, teeth=teeth, harmonic=harmonic) for a in averages])


def _not_empty(signal: Array, largest: float, name: str) -> None:
    """Raise if a part of an average is only round-off."""
    if float(np.abs(signal).max()) <= ROUND_OFF * largest:
        raise SignalError(f"average: its {name} signal is only round-off, so that its shape is undefined")
