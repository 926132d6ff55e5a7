# SPDX-License-Identifier: Apache-2.0
"""Unbalance as point masses that are part of the mass properties of a body."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.multibody.bodies import Body


def with_point_mass(body: Body, mass: float, place: ArrayLike) -> Body:
    """Copy of a body with an additional point mass.

    A round body is no longer round: its inertia depends on the spin angle.

    Parameters
    ----------
    body
        The body; its mass properties are included unchanged.
    mass
        Point mass [kg], > 0.
    place
        Position of the point mass from the origin in body axes, shape (3,) [m]; an unbalance U at the angle
        beta is mass times r = U at (r cos(beta), r sin(beta), z).

    Notes
    -----
    Parallel axis theorem: with T the inertia about the origin, T' = T + mass (p.p - p p^T); the new centre
    of mass is the mass-weighted mean.

    Examples
    --------
    >>> rotor = Body(mass=3.0, polar_inertia=0.02, transverse_inertia=0.01)
    >>> heavy = with_point_mass(rotor, 1.0, (0.1, 0.0, 0.0))
    >>> heavy.mass, heavy.com, round(float(heavy.tensor()[2, 2]), 12)
    (4.0, (0.025, 0.0, 0.0), 0.03)
    """
    p = np.asarray(place, float)
    total = body.mass + mass
    com = (body.mass * body.center_of_mass() + mass * p) / total
    about_origin = body.tensor() + mass * (p @ p * np.eye(3) - np.outer(p, p))
    about_com = about_origin - total * (com @ com * np.eye(3) - np.outer(com, com))
    return replace(
        body, mass=total, com=tuple(float(x) for x in com), inertia=0.5 * (about_com + about_com.T)
    )
