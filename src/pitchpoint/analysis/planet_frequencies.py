# SPDX-License-Identifier: Apache-2.0
"""Frequencies of planet sets: meshes, faults, passing planets, phases of the meshes.

Speeds are signed, in rad/s and counter-clockwise; frequencies are never negative, in Hz.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.analysis.sampled import Array, SignalError, as_signal, finite, whole


@dataclass(frozen=True)
class PlanetaryFrequencies:
    """Frequencies of a planet set.

    Attributes
    ----------
    speed_sun, speed_carrier, speed_ring
        Speeds in space [rad/s].
    speed_planet
        Speed of a planet against the carrier [rad/s].
    mesh
        Mesh frequency, the same at sun and ring [Hz].
    sun_fault, ring_fault
        How often one bad tooth of sun or ring meets any planet [Hz].
    planet_fault
        How often one bad flank of a planet meets its mate: a planet drives with one flank and is driven at
        the other [Hz].
    planet_fault_both
        How often a tooth of a planet that is bad on both flanks, or broken, meets sun or ring [Hz].
    planet_pass
        How often any planet passes a place in space [Hz].
    hunting_sun, hunting_ring
        How often the same two teeth of sun and planet, planet and ring meet [Hz].
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
    """Mesh, fault and passing frequencies of a planet set, whichever member is at rest.

    Parameters
    ----------
    z_sun, z_planet, z_ring
        Numbers of teeth, all counted positive [-].
    planets
        Number of planets N [-].
    speed_sun, speed_carrier, speed_ring
        Speeds in space [rad/s]: two of them, 0 for a member that is held. The third follows.

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
    f_m/z_p and twice that for both flanks, ring N f_m/z_r, passing planets N |w_c|/2π [1]_. Valid for simple
    planets.

    References
    ----------
    .. [1] P. D. McFadden, J. D. Smith, An explanation for the asymmetry of the modulation sidebands about the
       tooth meshing frequency in epicyclic gear vibration, Proc. IMechE C 199(1), 1985, 65-70.

    Examples
    --------
    First stage of a 5 MW wind turbine gearbox, ring held, carrier at 12.1 rpm:

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
    # of two equivalent members, the one that was given
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
    """Phases of the meshes of planets with a central gear against that of a planet at the angle zero.

    Parameters
    ----------
    z
        Number of teeth of the central gear, negative for a ring [-].
    angles
        Angles of the planets on the carrier [rad], shape (N,), counter-clockwise.

    Returns
    -------
    NDArray
        Phases [parts of a mesh cycle, 0 to 1], shape (N,).

    Raises
    ------
    SignalError
        If the number of teeth is not a whole number, or an angle is not finite.

    Notes
    -----
    frac(z ψ/2π), z negative for a ring [1]_. Valid for planets that are alike.

    References
    ----------
    .. [1] R. G. Parker, J. Lin, Mesh phasing relationships in planetary and epicyclic gears, Journal of
       Mechanical Design 126(2), 2004, 365-370.

    Examples
    --------
    Four planets between 51 and 85 teeth follow each other, at the sun and at the ring:

    >>> planet_phases(51, np.arange(4) * np.pi / 2).tolist()
    [0.0, 0.75, 0.5, 0.25]
    >>> planet_phases(-85, np.arange(4) * np.pi / 2).tolist()
    [0.0, 0.75, 0.5, 0.25]
    """
    whole(abs(z), "z")
    turned = z * as_signal(angles, "angles", 1) / math.tau
    # angles carry round-off, and just below one is zero
    return np.asarray(np.round(turned - np.floor(turned), 12) % 1.0 + 0.0)


def excited_motion(z_sun: int, planets: int, harmonics: int = 3) -> tuple[str, ...]:
    """Kind of motion that harmonics of the mesh frequency excite in a set with planets at equal angles.

    Parameters
    ----------
    z_sun
        Teeth of the sun [-].
    planets
        Number of planets N, at least 3 [-].
    harmonics
        How many harmonics, from the first on [-].

    Returns
    -------
    tuple of str
        `rotational` (all central members turn), `translational` (they move sideways) or `planet` (planets
        alone) for each harmonic.

    Raises
    ------
    SignalError
        If a number is not a whole number, or there are fewer than three planets.

    Notes
    -----
    k = l z_s mod N for harmonic l: 0 rotational, 1 or N - 1 translational, else planet [1]_. Valid for
    planets that are alike and at equal angles.

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
