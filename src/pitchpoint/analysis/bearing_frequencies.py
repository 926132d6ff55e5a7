# SPDX-License-Identifier: Apache-2.0
"""Characteristic frequencies of rolling bearings from geometry and ring speeds."""

from __future__ import annotations

import math
from dataclasses import dataclass

from pitchpoint.analysis.sampled import SignalError, finite, positive, whole


@dataclass(frozen=True)
class BearingFrequencies:
    """Characteristic frequencies of a rolling bearing, by their usual abbreviations.

    Attributes
    ----------
    cage_speed
        Speed of the cage [rad/s].
    ftf
        Rotation frequency of the cage (fundamental train frequency) [Hz].
    bpfo, bpfi
        Ball pass frequencies of the outer and the inner ring [Hz].
    bsf
        Ball spin frequency, relative to the cage: rate at which a spot on an element touches one ring [Hz].
    bsf_double
        Twice the ball spin frequency: rate at which a spot on an element touches either ring [Hz].
    """

    cage_speed: float
    ftf: float
    bpfo: float
    bpfi: float
    bsf: float
    bsf_double: float


def bearing_frequencies(
    *,
    elements: int,
    element_diameter: float,
    pitch_diameter: float,
    speed_inner: float,
    speed_outer: float = 0.0,
    contact_angle: float = 0.0,
) -> BearingFrequencies:
    """Kinematic frequencies of a rolling bearing.

    Parameters
    ----------
    elements
        Number Z of rolling elements of one row [-].
    element_diameter, pitch_diameter
        Diameter d of a rolling element and pitch diameter D [m].
    speed_inner, speed_outer
        Speeds of the rings [rad/s] in a frame in which the load direction is fixed; for a planet bearing
        relative to the carrier.
    contact_angle
        Contact angle α [rad].

    Returns
    -------
    BearingFrequencies
        Frequencies [Hz].

    Raises
    ------
    SignalError
        If the element diameter is not below the pitch diameter, or a number is unsuitable.

    Notes
    -----
    With γ = d cos α/D and the relative speed n = |n_i - n_o|: cage n_i (1 - γ)/2 + n_o (1 + γ)/2,
    BPFO = Z n (1 - γ)/2, BPFI = Z n (1 + γ)/2, BSF = n (1 - γ²) D/(2 d) [1]_. Valid without slip; real
    bearings slip by 1 to 2 %.

    References
    ----------
    .. [1] R. B. Randall, J. Antoni, Rolling element bearing diagnostics - a tutorial, Mechanical Systems and
       Signal Processing 25(2), 2011, 485-520.

    Examples
    --------
    Eight balls of 0.3125 inch, pitch diameter 1.319 inch, one revolution per second:

    >>> f = bearing_frequencies(
    ...     elements=8, element_diameter=0.3125, pitch_diameter=1.319, speed_inner=2 * math.pi)
    >>> [round(x, 4) for x in (f.bpfo, f.bpfi, f.bsf, f.ftf)]
    [3.0523, 4.9477, 1.9919, 0.3815]
    """
    number = whole(elements, "elements", 2)
    d, pitch = positive(element_diameter, "element_diameter"), positive(pitch_diameter, "pitch_diameter")
    if d >= pitch:
        raise SignalError(
            f"element_diameter: {d:g} (limit < pitch_diameter {pitch:g}); give both in the same unit"
        )
    inner, outer = finite(speed_inner, "speed_inner"), finite(speed_outer, "speed_outer")
    gamma = d / pitch * math.cos(finite(contact_angle, "contact_angle"))
    cage = 0.5 * ((1.0 - gamma) * inner + (1.0 + gamma) * outer)
    turns = abs(inner - outer) / math.tau
    bsf = 0.5 * pitch / d * (1.0 - gamma**2) * turns
    return BearingFrequencies(
        cage_speed=cage,
        ftf=abs(cage) / math.tau,
        bpfo=0.5 * number * (1.0 - gamma) * turns,
        bpfi=0.5 * number * (1.0 + gamma) * turns,
        bsf=bsf,
        bsf_double=2.0 * bsf,
    )
