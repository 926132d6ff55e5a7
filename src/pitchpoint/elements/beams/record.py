# SPDX-License-Identifier: Apache-2.0
"""Record of one beam for the kernels: parameters from section and material, and scratch fields."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.multibody.beam_coupling import Coupling
from pitchpoint.multibody.beam_section import Beam

_RULE = np.polynomial.legendre.leggauss(4)
"""Gauss points and weights of the mass matrix, exact."""

#: The vectors that describe a beam: positions of both nodes, direction of the chord, normals of both end
#: sections, their first and, for coupled sections, their second axes.
XI, XJ, E, TI, TJ, PI, PJ, QI, QJ = range(9)

RECORD = np.dtype(
    [(n, "i8") for n in ("i", "j", "ii", "ij", "ji", "jj")]
    + [
        ("length", "f8"),  # unloaded length [m]
        ("k_u", "f8"),  # axial stiffness [N/m]
        ("k_t", "f8"),  # torsional stiffness [N m/rad]
        ("k_d", "f8"),  # bending moment per angle between the ends [N m/rad]
        ("k_s", "f8"),  # moment of either end per sum of both slopes against the chord [N m/rad]
        ("c_a", "f8"),  # excess bending stiffness towards axis 1: moment per slope of the same end [N m/rad]
        ("c_b", "f8"),  # and per slope of the other end
        ("n_s", "f8"),  # length times square of the sum of both slopes over the elongation by it [1]
        ("eta", "f8"),  # damping over stiffness [s]
        ("coupled", "i8"),  # 1: the next two matrices are not zero
        ("Q", "f8", (6, 6)),  # further stiffness of the deformations y [N/m, N, N m]
        ("R", "f8", (6, 6)),  # further damping of their rates [N s/m, N s, N m s]
        ("twist", "f8"),  # angle of end j relative to end i without torque [rad]
        ("mass", "f8"),  # [kg]; 0: the beam has no inertia
        ("M", "f8", (5, 5)),  # mass matrix of XI..TJ, energy 1/2 sum M_kl w_k' . w_l' [kg, kg m, kg m^2]
        ("gyro", "f8", (3, 3)),  # polar inertia of the vectors E, TI, TJ [kg m^2]
        ("polar", "f8", (2, 2)),  # polar inertia of both spins [kg m^2]
        ("gravity", "f8", 3),  # [m/s^2], world axes
        ("p_i", "f8", 3),  # node i in the frame of body i [m]
        ("p_j", "f8", 3),
        ("B_i", "f8", (3, 3)),  # section axes 1, 2 and beam axis in the frame of body i, columns
        ("B_j", "f8", (3, 3)),
    ]
    # scratch: written and read within one call
    + [
        ("w", "f8", (9, 3)),  # the vectors, their first and second time derivatives
        ("w1", "f8", (9, 3)),
        ("w2", "f8", (9, 3)),
        ("dw", "f8", (9, 3)),  # their directional derivatives for one motion
        ("dw1", "f8", (9, 3)),
        ("dw2", "f8", (9, 3)),
        ("y", "f8", (4, 6)),  # deformations of coupled sections, their rates, and the changes of both
        ("inert", "f8", (5, 3)),  # inertia force of each vector
        ("d_inert", "f8", (5, 3)),
        ("arm", "f8", (2, 3)),  # nodes from the origins of their bodies
        ("omega", "f8", (2, 3)),
        ("alpha", "f8", (2, 3)),
        ("d_arm", "f8", (2, 3)),
        ("d_theta", "f8", (2, 3)),
        ("d_omega", "f8", (2, 3)),
        ("d_alpha", "f8", (2, 3)),
        ("D", "f8", (3, 3)),  # difference of the normals; its rate in world axes and in axes of the chord
        ("S", "f8", (3, 3)),  # sum of the slopes against the chord, likewise
        ("f_d", "f8", 3),  # their forces [N m]
        ("f_s", "f8", 3),
        ("arc", "f8"),  # angle between the ends over its sine, and its derivative by the cosine
        ("arc1", "f8"),
        ("cos", "f8"),  # sum of the cosines of both slopes and its rate
        ("cos1", "f8"),
        ("h", "f8", 2),  # end moments of the excess stiffness for bending towards axis 1 [N m]
        ("g", "f8", (2, 6)),  # forces of the deformations y by Q and R, and their changes
        ("m", "f8", 3),  # gradient of the twist with respect to a rotation of the second end
        ("c", "f8", 3),  # moment of the dampers; its component along the chord acts on the ends
        ("G", "f8", 3),  # generalised force of the chord direction [N m]
        ("V", "f8", 3),  # force of the beam on node i [N]
        ("mu", "f8", (2, 3)),  # moments of the ends on the beam [N m]
        ("F", "f8", (2, 3)),  # forces on both nodes, inertia included [N]
        ("axial", "f8"),  # tension [N]
        ("torque", "f8"),
        ("ell", "f8"),  # length of the chord and its rate
        ("ell1", "f8"),
        ("s", "f8"),  # mean spin about the chord [rad/s]
        ("out", "i8"),
    ],
    align=True,
)

_PLACES = (
    ("fx", "N", "shear force along axis 1"),
    ("fy", "N", "shear force along axis 2"),
    ("fz", "N", "axial force, tension positive"),
    ("mx", "N m", "bending moment about axis 1"),
    ("my", "N m", "bending moment about axis 2"),
    ("mz", "N m", "torque"),
)

#: Section forces at both ends: load of the part beyond the section on the part before it, in the axes of the
#: end, which do not spin with a shaft.
OUTPUTS = tuple(
    (f"beam_force[{{}}.{end}.{word}]", unit, f"{text}, {which} end")
    for end, which in (("i", "first"), ("j", "second"))
    for word, unit, text in _PLACES
)


def beam_row(
    beam: Beam,
    *,
    bodies: tuple[int, int],
    nodes: tuple[ArrayLike, ArrayLike] = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)),
    axes: tuple[ArrayLike, ArrayLike] | None = None,
    eta: float = 0.0,
    twist: float = 0.0,
    gravity: ArrayLike = (0.0, 0.0, 0.0),
) -> NDArray[np.void]:
    """Record of one beam, shape (1,).

    Parameters
    ----------
    beam
        Section, length and material; without density the beam has no mass.
    bodies
        Numbers of the bodies at both ends; 0 = ground.
    nodes
        Ends of the beam in the body frames [m].
    axes
        Section axes 1, 2 and beam axis as columns (3, 3) in the frames of the bodies, at either end; the beam
        axis points from the first body to the second. Default: the beam is along the third axes.
    eta
        Damping over stiffness, in axes that spin with the beam [s].
    twist
        Angle of the second end relative to the first without torque [rad].
    gravity
        Gravitational acceleration of the mass of the beam, world axes [m/s^2].
    """
    row = np.zeros(1, RECORD)
    r, s, h = row[0], beam.section, beam.length
    r["i"], r["j"] = bodies
    r["p_i"], r["p_j"] = nodes
    r["B_i"], r["B_j"] = axes if axes is not None else (np.eye(3), np.eye(3))
    r["length"], r["eta"], r["twist"], r["gravity"] = h, eta, twist, gravity
    r["k_u"], r["k_t"] = beam.E * s.A / h, beam.G * s.J / h
    r["n_s"] = 40.0
    own, other = _bending(beam, 2)
    r["k_d"], r["k_s"] = 0.5 * (own - other), 0.5 * (own + other)
    if not s.round:
        one = _bending(beam, 1)
        r["c_a"], r["c_b"] = one[0] - own, one[1] - other
    if beam.coupling is not None:
        _couple(r, beam.coupling)
    r["mass"] = beam.mass
    if beam.mass > 0.0:
        r["M"], r["gyro"], r["polar"] = _inertia(beam)
    return row


def _couple(r: np.void, part: Coupling) -> None:
    """Set the stiffness of an element with coupled sections: that of a round section, with the bending
    stiffness of the softer direction, and the rest.

    With the share b = 1/(1 + phi) of bending in the sum s of both slopes, the integral of the elongation
    theta w' - theta^2/2 by the rotation theta of the sections and the slope w' of the axis is
    (-1 + 2 b - 0.8 b^2)/8 L s^2; without shear deflection L s^2/40.
    """
    K, soft = part.stiffness, np.linalg.inv(part.stiffness)
    k = max((2, 4), key=lambda k: soft[k, k])
    base = np.array([K[0, 0], K[1, 1], *(2 * (K[k, k], K[k + 1, k + 1]))])
    r["coupled"], r["k_u"], r["k_t"], r["k_d"], r["k_s"] = 1, *base[:4]
    r["c_a"] = r["c_b"] = 0.0
    b = 1.0 / (1.0 + part.phi(k // 2))
    elongation = -0.125 + 0.25 * b - 0.1 * b * b
    r["n_s"] = 1.0 / elongation if elongation != 0.0 else np.inf
    r["Q"] = K - np.diag(base)
    r["R"] = part.damping + r["eta"] * r["Q"]


def _bending(beam: Beam, plane: int) -> tuple[float, float]:
    """End moment per slope of the same and of the other end against the chord [N m/rad]."""
    second = beam.section.I_1 if plane == 1 else beam.section.I_2
    p = beam.phi(plane)
    stiffness = beam.E * second / (beam.length * (1.0 + p))
    return (4.0 + p) * stiffness, (2.0 - p) * stiffness


def _inertia(beam: Beam) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Consistent mass matrices of the vectors of a beam; Gauss quadrature with four points is exact.

    A point of the axis is x = sum N_k w_k and the normal of its section n = sum nu_k w_k, with the static
    shape functions of a shear-flexible beam; rotary inertia is that of the mean of both planes.
    """
    s, h = beam.section, beam.length
    p = 0.5 * (beam.phi(1) + beam.phi(2))
    points, weights = _RULE
    M, gyro, polar = np.zeros((5, 5)), np.zeros((3, 3)), np.zeros((2, 2))
    for xi, weight in zip(0.5 * (1.0 + points), 0.5 * h * weights, strict=True):
        shear = 0.5 * p * (xi - xi**2)
        h_i = (xi - 2.0 * xi**2 + xi**3 + shear) / (1.0 + p)
        h_j = (xi**3 - xi**2 - shear) / (1.0 + p)
        b = (1.0 - 4.0 * xi + 3.0 * xi**2 + p * (1.0 - xi)) / (1.0 + p)
        c = (3.0 * xi**2 - 2.0 * xi + p * xi) / (1.0 + p)
        N = np.array([1.0 - xi, xi, -h * (h_i + h_j), h * h_i, h * h_j])
        nu = np.array([0.0, 0.0, 1.0 - b - c, b, c])
        M += weight * beam.rho * (s.A * np.outer(N, N) + 0.5 * (s.I_1 + s.I_2) * np.outer(nu, nu))
        both = weight * beam.rho * (s.I_1 + s.I_2)
        gyro += both * np.outer(nu[2:], nu[2:])
        polar += both * np.outer([1.0 - xi, xi], [1.0 - xi, xi])
    return M, gyro, polar
