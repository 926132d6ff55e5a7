# SPDX-License-Identifier: Apache-2.0
"""Characteristic frequencies of planetary gear sets: mesh, faults, planet pass; mesh phases.

Speeds are signed, in rad/s, counter-clockwise positive; frequencies are nonnegative, in Hz.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, finite, whole


@dataclass(frozen=True)
class PlanetaryFrequencies:
    """Characteristic frequencies of a planetary gear set.

    Attributes
    ----------
    speed_sun, speed_carrier, speed_ring
        Absolute speeds [rad/s].
    speed_planet
        Speed of a planet relative to the carrier [rad/s].
    mesh
        Mesh frequency, equal at sun and ring [Hz].
    sun_fault, ring_fault
        Rate at which one damaged tooth of sun or ring meshes with any planet [Hz].
    planet_fault
        Rate at which one damaged flank of a planet is in mesh [Hz]; one flank of a tooth is in contact with
        the sun, the other with the ring.
    planet_fault_both
        Rate at which a broken planet tooth, or one damaged on both flanks, meshes with sun or ring [Hz].
    planet_pass
        Planet pass frequency at a fixed location [Hz].
    hunting_sun, hunting_ring
        Hunting tooth frequencies of sun and planet, and of planet and ring [Hz].
    """

    speed_sun: float
    speed_carrier: float
    speed_ring: float
    speed_planet: float
    mesh: float
    sun_fault: float
    ring_fault: float
    planet_fault: float
    planet_fault_both: float
    planet_pass: float
    hunting_sun: float
    hunting_ring: float


def planetary_frequencies(
    *,
    z_sun: int,
    z_planet: int,
    z_ring: int,
    planets: int,
    speed_sun: float | None = None,
    speed_carrier: float | None = None,
    speed_ring: float | None = None,
) -> PlanetaryFrequencies:
    """Mesh, fault and planet pass frequencies of a planetary gear set with any fixed member.

    Parameters
    ----------
    z_sun, z_planet, z_ring
        Numbers of teeth, all positive [-].
    planets
        Number of planets N [-].
    speed_sun, speed_carrier, speed_ring
        Two of the absolute speeds [rad/s], 0 for a fixed member. The third is computed.

    Returns
    -------
    PlanetaryFrequencies
        Frequencies [Hz], speeds [rad/s].

    Raises
    ------
    SignalError
        If not exactly two speeds are given, or a number is not a whole number above zero.

    Notes
    -----
    Willis: z_s (w_s - w_c) + z_r (w_r - w_c) = 0. With f_m = z_r |w_r - w_c|/2π: sun N f_m/z_s, planet
    f_m/z_p and twice that for both flanks, ring N f_m/z_r, planet pass N |w_c|/2π [1]_. Valid for simple
    planets.

    References
    ----------
    .. [1] P. D. McFadden, J. D. Smith, An explanation for the asymmetry of the modulation sidebands about the
       tooth meshing frequency in epicyclic gear vibration, Proc. IMechE C 199(1), 1985, 65-70.

    Examples
    --------
    First stage of a 5 MW wind turbine gearbox, fixed ring, carrier at 12.1 rpm:

    >>> f = planetary_frequencies(
    ...     z_sun=19, z_planet=17, z_ring=56, planets=3, speed_carrier=12.1 * math.pi / 30, speed_ring=0.0)
    >>> [round(x, 5) for x in (f.mesh, f.sun_fault, f.planet_fault, f.ring_fault)]
    [11.29333, 1.78316, 0.66431, 0.605]
    >>> round(f.speed_sun * 30 / math.pi, 4)
    47.7632
    """
    z_s, z_p = whole(z_sun, "z_sun"), whole(z_planet, "z_planet")
    z_r, n = whole(abs(z_ring), "z_ring"), whole(planets, "planets")
    given = {"sun": speed_sun, "carrier": speed_carrier, "ring": speed_ring}
    known = {name: finite(w, f"speed_{name}") for name, w in given.items() if w is not None}
    if len(known) != 2:
        raise SignalError(
            f"speed_sun, speed_carrier, speed_ring: {len(known)} given (limit 2); the third follows"
        )
    if "carrier" not in known:
        w_s, w_r = known["sun"], known["ring"]
        w_c = (z_s * w_s + z_r * w_r) / (z_s + z_r)
    else:
        w_c = known["carrier"]
        w_s = known["sun"] if "sun" in known else w_c - (known["ring"] - w_c) * z_r / z_s
        w_r = known["ring"] if "ring" in known else w_c - (w_s - w_c) * z_s / z_r
    # of two equivalent expressions, use the one with the given speed
    mesh = (z_s * abs(w_s - w_c) if "sun" in known else z_r * abs(w_r - w_c)) / math.tau
    return PlanetaryFrequencies(
        speed_sun=w_s,
        speed_carrier=w_c,
        speed_ring=w_r,
        speed_planet=-(w_s - w_c) * z_s / z_p,
        mesh=mesh,
        sun_fault=n * mesh / z_s,
        ring_fault=n * mesh / z_r,
        planet_fault=mesh / z_p,
        planet_fault_both=2.0 * mesh / z_p,
        planet_pass=n * abs(w_c) / math.tau,
        hunting_sun=mesh / math.lcm(z_s, z_p),
        hunting_ring=mesh / math.lcm(z_p, z_r),
    )


def planet_phases(z: int, angles: ArrayLike) -> Array:
    """Mesh phases of the planets with a central gear, relative to a planet at the angle zero.

    Parameters
    ----------
    z
        Number of teeth of the central gear, negative for a ring [-].
    angles
        Angles of the planets on the carrier [rad], shape (N,), counter-clockwise.

    Returns
    -------
    NDArray
        Phases [fractions of a mesh cycle, 0 to 1], shape (N,).

    Raises
    ------
    SignalError
        If the number of teeth is not a whole number, or an angle is not finite.

    Notes
    -----
    frac(z ψ/2π), z negative for a ring [1]_. Valid for equal planets.

    References
    ----------
    .. [1] R. G. Parker, J. Lin, Mesh phasing relationships in planetary and epicyclic gears, Journal of
       Mechanical Design 126(2), 2004, 365-370.

    Examples
    --------
    Sequential phases of four planets between 51 and 85 teeth, at the sun and at the ring:

    >>> planet_phases(51, np.arange(4) * np.pi / 2).tolist()
    [0.0, 0.75, 0.5, 0.25]
    >>> planet_phases(-85, np.arange(4) * np.pi / 2).tolist()
    [0.0, 0.75, 0.5, 0.25]
    """
    whole(abs(z), "z")
    turned = z * as_signal(angles, "angles", 1) / math.tau
    # angles have round-off; a phase just below one is zero
    return np.asarray(np.round(turned - np.floor(turned), 12) % 1.0 + 0.0)


def excited_motion(z_sun: int, planets: int, harmonics: int = 3) -> tuple[str, ...]:
    """Type of motion excited by harmonics of the mesh frequency in a set with equally spaced planets.

    Parameters
    ----------
    z_sun
        Number of teeth of the sun [-].
    planets
        Number of planets N, at least 3 [-].
    harmonics
        Number of harmonics, from the first [-].

    Returns
    -------
    tuple of str
        `rotational` (rotation of the central members), `translational` (their translation) or `planet`
        (motion of the planets only) for each harmonic.

    Raises
    ------
    SignalError
        If a number is not a whole number, or there are fewer than three planets.

    Notes
    -----
    k = l z_s mod N for harmonic l: 0 rotational, 1 or N - 1 translational, else planet [1]_. Valid for
    equal, equally spaced planets.

    References
    ----------
    .. [1] R. G. Parker, A physical explanation for the effectiveness of planet phasing to suppress planetary
       gear vibration, Journal of Sound and Vibration 236(4), 2000, 561-573.

    Examples
    --------
    >>> excited_motion(19, 3)
    ('translational', 'translational', 'rotational')
    >>> excited_motion(54, 4, 2)
    ('planet', 'rotational')
    """
    z_s, n = whole(z_sun, "z_sun"), whole(planets, "planets", 3)
    found = []
    for harmonic in range(1, whole(harmonics, "harmonics") + 1):
        k = harmonic * z_s % n
        found.append("rotational" if k == 0 else "translational" if k in (1, n - 1) else "planet")
    return tuple(found)
