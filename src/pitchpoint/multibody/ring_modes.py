# SPDX-License-Identifier: Apache-2.0
"""In-plane modes of a circular ring in closed form: a thick curved beam with shear and rotary inertia.

With n waves around the circumference, points at the distance z outside the line of centroids of radius R
move by

    u = eta cos(n theta) outwards,  v + z psi = eta (V + z Psi) sin(n theta) along theta

and n theta shifted by a quarter of a wave for the second coordinate. Strain (v' + u + z psi')/(R + z) and
shear psi - (v - u')/R give, per coordinate and with A_k = integral of z^k/(R + z) over the section,

    k = pi (E (A_0 (1 + n V)^2 + 2 A_1 (1 + n V) n Psi + A_2 n^2 Psi^2) + kappa G A R (Psi - (V + n)/R)^2)
    m = pi (rho (R A (1 + V^2) + 2 I V Psi + R I Psi^2) + mu (1 + (V + z_t Psi)^2))

where the teeth add a mass mu per radian at z_t. V and Psi are those of the lowest of the three frequencies,
bending. For a thin ring V = -1/n, Psi = (V + n)/R and omega^2 = (E I/(rho A R^4)) n^2 (n^2 - 1)^2/(n^2 + 1).

In a ring that spins at omega about its axis, the two coordinates of n waves are coupled by Coriolis forces
2 omega g eta' with g = -2 pi rho A R V for a thin ring, and centrifugal forces stretch the ring: the hoop
force rho A R^2 omega^2 adds pi rho A R omega^2 (V + n)^2 to k.

Sources: S. Timoshenko, Vibration Problems in Engineering, 3rd ed., article 69 (thin ring); E. Winkler (curved
beam); G. R. Cowper, J. Appl. Mech. 33 (1966) 335-340 (kappa); G. F. Carrier, Quart. Appl. Math. 3 (1945)
235-245 (spinning ring).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pitchpoint.multibody.mass_invariants import MassInvariants

Array = NDArray[np.float64]

WORDS = ("cos", "sin")
"""Beginning of the names of both coordinates of a mode."""


@dataclass(frozen=True, kw_only=True)
class RingSection:
    """A ring of rectangular section, with teeth that add mass only.

    Parameters
    ----------
    inner, outer
        Radii of the rim [m].
    width
        Along the axis [m].
    youngs_modulus, poisson_ratio, density
        Of the material [Pa, -, kg/m^3].
    tooth_mass
        Mass of all teeth [kg].
    tooth_radius
        Radius at which it acts [m].
    """

    inner: float
    outer: float
    width: float
    youngs_modulus: float
    poisson_ratio: float
    density: float
    tooth_mass: float = 0.0
    tooth_radius: float = 0.0

    @property
    def radius(self) -> float:
        """Radius R of the line of centroids [m]."""
        return 0.5 * (self.inner + self.outer)

    @property
    def height(self) -> float:
        """Radial thickness of the rim [m]."""
        return self.outer - self.inner

    @property
    def mass(self) -> float:
        """Mass of rim and teeth [kg]."""
        return math.tau * self.radius * self.height * self.width * self.density + self.tooth_mass

    def with_teeth(self, mass: float, radius: float) -> RingSection:
        """The same ring with teeth of this mass [kg] at this radius [m]."""
        return replace(self, tooth_mass=mass, tooth_radius=radius)


@dataclass(frozen=True, kw_only=True)
class RingMode:
    """Bending mode of a ring with n waves, per unit of its radial amplitude.

    Parameters
    ----------
    waves
        Number of waves n around the circumference.
    tangential
        Amplitude V of the tangential displacement on the line of centroids [-].
    rotation
        Amplitude Psi of the rotation of the section [1/m].
    stiffness, mass
        Modal stiffness [N/m] and mass [kg].
    stretch
        Stiffness by the hoop force of a spinning ring, per (rad/s)^2 [kg].
    coriolis
        Integral of u_k v_l - v_k u_l over the mass for the two coordinates k (cosine) and l (sine) [kg].
    """

    waves: int
    tangential: float
    rotation: float
    stiffness: float
    mass: float
    stretch: float
    coriolis: float

    @property
    def frequency(self) -> float:
        """Natural frequency of the free ring at rest [Hz]."""
        return math.sqrt(self.stiffness / self.mass) / math.tau


def ring_mode(ring: RingSection, waves: int) -> RingMode:
    """Bending mode of a free ring.

    Parameters
    ----------
    ring
        Section and material.
    waves
        Number of waves n >= 2 around the circumference.

    Returns
    -------
    RingMode

    Examples
    --------
    A thin steel ring of 200 mm radius and 2 x 10 mm: n (n^2 - 1)/sqrt(n^2 + 1) sqrt(E I/(rho A R^4))/(2 pi)
    = 31.617 Hz with two waves.

    >>> thin = RingSection(inner=0.199, outer=0.201, width=0.01, youngs_modulus=206e9, poisson_ratio=0.3,
    ...                    density=7830.0)
    >>> round(ring_mode(thin, 2).frequency, 2)
    31.62
    """
    from scipy.linalg import eigh

    R, h, b, n = ring.radius, ring.height, ring.width, float(waves)
    A, inertia = b * h, b * h**3 / 12.0
    log = math.log(ring.outer / ring.inner)
    A_0, A_1, A_2 = b * log, b * (h - R * log), b * (R * R * log - R * h)  # integrals of z^k/(R + z)
    nu = ring.poisson_ratio
    G, kappa = ring.youngs_modulus / (2.0 * (1.0 + nu)), 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu)
    # strain and shear of (u, v, psi)
    strain, turned, shear = (
        np.array([1.0, n, 0.0]),
        np.array([0.0, 0.0, n]),
        np.array([-n / R, -1.0 / R, 1.0]),
    )
    K = A_0 * np.outer(strain, strain) + A_2 * np.outer(turned, turned)
    K += A_1 * (np.outer(strain, turned) + np.outer(turned, strain))
    K = math.pi * (ring.youngs_modulus * K + kappa * G * A * R * np.outer(shear, shear))
    z = ring.tooth_radius - R
    teeth = ring.tooth_mass / math.tau
    M = ring.density * np.array([[R * A, 0.0, 0.0], [0.0, R * A, inertia], [0.0, inertia, R * inertia]])
    M += teeth * np.array([[1.0, 0.0, 0.0], [0.0, 1.0, z], [0.0, z, z * z]])
    M *= math.pi
    shape = eigh(K, M)[1][:, 0]
    shape = shape / shape[0]
    V, Psi = float(shape[1]), float(shape[2])
    around = ring.mass / math.tau
    return RingMode(
        waves=waves,
        tangential=V,
        rotation=Psi,
        stiffness=float(shape @ K @ shape),
        mass=float(shape @ M @ shape),
        stretch=math.pi * around * (V + n) ** 2,
        coriolis=-2.0 * math.pi * (V * around + (ring.density * inertia + teeth * z) * Psi),
    )


def ring_invariants(modes: Sequence[RingMode]) -> MassInvariants:
    """Mass invariants of ring modes, two coordinates each: cosine, then sine.

    Without those of the rigid ring, and for rotation about its axis only: the inertia of the deflected ring
    about a diameter is that of the undeformed one.

    Parameters
    ----------
    modes
        Modes with different numbers of waves n >= 2, so that they have no momentum.
    """
    n = 2 * len(modes)
    angular_1, inertia_2 = np.zeros((n, 3, n)), np.zeros((n, n, 3, 3))
    mass = np.repeat([m.mass for m in modes], 2)
    for k, mode in enumerate(modes):
        angular_1[2 * k, 2, 2 * k + 1] = mode.coriolis
        angular_1[2 * k + 1, 2, 2 * k] = -mode.coriolis
    inertia_2[range(n), range(n), 2, 2] = mass
    return MassInvariants(
        mass=0.0,
        first=np.zeros(3),
        inertia=np.zeros((3, 3)),
        momentum=np.zeros((3, n)),
        angular=np.zeros((3, n)),
        angular_1=angular_1,
        inertia_1=np.zeros((n, 3, 3)),
        inertia_2=inertia_2,
        modal=np.diag(mass),
    )


def coordinate_names(modes: Sequence[RingMode]) -> list[str]:
    """Names of the coordinates of ring modes: cosine and sine with their numbers of waves.

    Examples
    --------
    >>> ring = RingSection(inner=0.19, outer=0.21, width=0.01, youngs_modulus=206e9, poisson_ratio=0.3,
    ...                    density=7830.0)
    >>> coordinate_names([ring_mode(ring, 2)])
    ['cos2', 'sin2']
    """
    return [f"{word}{mode.waves}" for mode in modes for word in WORDS]


def waves_of(coordinate: str) -> int:
    """Number of waves of a coordinate with a name of `coordinate_names`; 0 for others.

    Examples
    --------
    >>> waves_of("ring.2.sin4"), waves_of("ring.x"), waves_of("rod.1.eta3")
    (4, 0, 0)
    """
    word = coordinate.rpartition(".")[2]
    number = word[len(WORDS[0]) :]
    return int(number) if word.startswith(WORDS) and number.isdigit() else 0


def ring_terms(modes: Sequence[RingMode], centroid: float, radius: float) -> Array:
    """Displacement of a point that is rigidly attached to the section of the ring at the angle theta.

    At the distance z = radius - centroid it moves by v + z psi along the tangent: a point of the rim, or with
    the radius 0 the frame of a gear whose teeth are attached to the section.

    Parameters
    ----------
    modes
        Modes, two coordinates each: cosine, then sine.
    centroid
        Radius R of the line of centroids [m].
    radius
        Radius of the point [m].

    Returns
    -------
    ndarray
        Rows of coordinate, number of waves, component (displacement along radius, tangent and axis, then the
        rotations about them), and factors of cosine and sine.
    """
    rows = []
    for k, m in enumerate(modes):
        along = m.tangential + (radius - centroid) * m.rotation
        for c, of_cosine, of_sine in ((0, 1.0, 0.0), (1, 0.0, along), (5, 0.0, m.rotation)):
            rows.append((2 * k, m.waves, c, of_cosine, of_sine))
            rows.append((2 * k + 1, m.waves, c, -of_sine, of_cosine))
    return np.array(rows)


def support_shapes(terms: Array, angles: Sequence[float]) -> Array:
    """Radial and tangential displacement at some angles, per coordinate.

    Parameters
    ----------
    terms
        Rows of `ring_terms`.
    angles
        Angles [rad].

    Returns
    -------
    ndarray
        Shape (number of angles, 2, number of coordinates).
    """
    found = np.zeros((len(angles), 2, int(terms[:, 0].max()) + 1))
    for k, n, component, of_cosine, of_sine in terms:
        if component < 2:
            turned = n * np.asarray(angles)
            found[:, int(component), int(k)] += of_cosine * np.cos(turned) + of_sine * np.sin(turned)
    return found


def support_stiffness(shapes: Array, radial: float, tangential: float) -> Array:
    """Stiffness matrix of the coordinates by equal springs at the angles of `support_shapes` [N/m].

    Parameters
    ----------
    shapes
        Displacements at the supports.
    radial, tangential
        Stiffness of one support [N/m].
    """
    return radial * shapes[:, 0].T @ shapes[:, 0] + tangential * shapes[:, 1].T @ shapes[:, 1]
