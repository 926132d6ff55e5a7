# SPDX-License-Identifier: Apache-2.0
"""Gear body under the roots of adjacent teeth: compliance of one root, coupling to the next, common part.

The elastic ring gives the coupling, and the compliance of the root itself for the body "ring"; the other
bodies replace the latter and take over the coupling in proportion.

Derivation: docs/theory/flank_compliance.md, "The gear body".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.contact.compliance.blank import BlankRadii
from pitchpoint.contact.compliance.clamped_tooth import ClampedTooth
from pitchpoint.contact.compliance.elastic_ring import ElasticRing
from pitchpoint.contact.compliance.root_body import half_plane, sainsot, weber_banaschek
from pitchpoint.contact.compliance.toothed_ring import ToothedRing
from pitchpoint.core.errors import GeometryError, Message, ModelError
from pitchpoint.geometry.materials import Material

Array = NDArray[np.float64]

BODIES = ("weber_banaschek", "half_plane", "ring", "sainsot", "rigid")

_LIMIT = 0.4995
"""Numerical radius of the coupling up to which any number of teeth is positive definite; exactly 1/2."""
_STEP = 0.025
"""Step of the reduction of the coupling by normal forces."""
_SHARE = 0.9
"""Largest share of the compliance of a root that may be common to all teeth."""
_HEIGHTS = 9
_ANGLES = np.exp(1j * np.linspace(0.0, 2.0 * math.pi, 73)[:-1])


@dataclass(frozen=True)
class Foundation:
    """Compliance of the root strips per unit length of the tooth trace, for waves along it.

    Loads are moment, shear and normal force of `ClampedTooth.root_loads`.

    Parameters
    ----------
    own
        Rotation and displacements of a root per load on it, shape (k, 3, 3).
    next
        The same per load on the next root, counter-clockwise, shape (k, 3, 3).
    common
        Displacement along the base tangent shared by all teeth in contact, apart from torsion, per unit face
        width [m²/N].
    torsion
        Displacement along the base tangent due to torsion of the blank, per unit face width [m²/N].
    coupling
        Factors of the coupling by normal forces and of the whole coupling [-]; below 1 where it was reduced
        to keep the compliance of any number of teeth positive.
    """

    own: Array
    next: Array
    common: float
    torsion: float
    coupling: tuple[float, float]


def foundation(
    tooth: ClampedTooth, radii: BlankRadii, material: Material, body: str, wave_numbers: Array
) -> Foundation:
    """Gear body under adjacent teeth.

    Parameters
    ----------
    tooth
        The clamped tooth.
    radii
        Radii of the blank.
    material
        Material of the gear.
    body
        "weber_banaschek": as published, independent of the blank; "half_plane": half plane with the depth of
        the blank as reference; "ring": elastic ring clamped at the bore, with its web; "sainsot": fit to a
        ring, inside its range; "rigid".
    wave_numbers
        Wave numbers along the tooth trace, the first one 0 [1/m], shape (k,).

    Raises
    ------
    ModelError
        If the body is not known.
    GeometryError
        If a body is outside its range.

    Notes
    -----
    A constant displacement of all teeth, c_τ along the base tangent, has the root compliance c_τ τ τᵀ with
    root loads · τ = 1: τ = (±1, x_c, 0) cos β/r_b. This removes the mean coupling of the second neighbours
    from the root compliances of a uniform load; `common` returns it to all teeth. The remaining coupling of
    the second neighbours is neglected. With N = own^{-1/2} next own^{-1/2}, a chain of teeth is positive
    semidefinite if the numerical radius of N is at most 1/2.

    Examples
    --------
    Root of a 43-tooth gear on a ring, compliance for shear times E; same root and next root:

    >>> from pitchpoint.contact.compliance.blank import Blank, blank_radii
    >>> from pitchpoint.contact.compliance.clamped_tooth import clamped_tooth
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.materials import material
    >>> gear = CylindricalGear(z=43, m_n=1e-3)
    >>> found = foundation(
    ...     clamped_tooth(gear), blank_radii(gear, Blank()), material("steel"), "ring", np.zeros(1)
    ... )
    >>> [round(206e9 * float(a[0, 1, 1]), 3) for a in (found.own, found.next)]
    [1.463, 0.458]
    """
    if body not in BODIES:
        known = ", ".join(BODIES)
        raise ModelError(
            [Message("compliance.body", "is not a model of the gear body", body, known, "choose")]
        )
    count = wave_numbers.size
    if body == "rigid":
        zero = np.zeros((count, 3, 3))
        return Foundation(zero, zero, 0.0, 0.0, (1.0, 1.0))
    E, nu = material.youngs_modulus, material.poisson_ratio
    form, cos_beta = tooth.form, tooth.cos_beta
    chord = tooth.chord / cos_beta
    ring = ElasticRing(math.hypot(tooth.distance, 0.5 * chord), radii, form.sign, E, nu)
    normal = np.array([1.0 / cos_beta, 1.0, 1.0])
    teeth = ToothedRing(ring, round(form.z), chord, tooth.distance).response(wave_numbers)
    own, following, second = teeth * normal[:, None] * normal
    tau = np.array([form.sign, tooth.distance, 0.0]) * cos_beta / form.r_b
    shift = np.outer(tau, tau) / cos_beta
    loads = tooth.root_loads(np.linspace(*tooth.roll, _HEIGHTS))
    far = cos_beta * float(np.einsum("hi,ij,hj->h", loads, second[0], loads).mean())
    common = min(max(far, 0.0), _SHARE * cos_beta / float(tau @ np.linalg.solve(own[0], tau)))
    own[0] -= common * shift
    following[0] -= common * shift
    torsion = radii.torsion(form.r_b, material.shear_modulus)
    if body != "ring":
        target = _root(tooth, radii, material, body)
        if body != "weber_banaschek":
            target = target - (common + (torsion if body == "sainsot" else 0.0)) * shift
        if np.linalg.eigvalsh(target)[0] <= 0.0:
            raise GeometryError(
                "is stiffer than the blank as a whole",
                where="compliance.body",
                value=body,
                remedy="use body: ring or weber_banaschek",
            )
        turn = np.linalg.cholesky(target) @ np.linalg.inv(np.linalg.cholesky(own[0]))
        own, following = (turn @ a @ turn.T for a in (own, following))
    following, coupling = _bounded(own, following)
    return Foundation(0.5 * (own + own.transpose(0, 2, 1)), following, common, torsion, coupling)


def _root(tooth: ClampedTooth, radii: BlankRadii, material: Material, body: str) -> Array:
    """Compliance of one root for the published bodies, shape (3, 3)."""
    E, nu = material.youngs_modulus, material.poisson_ratio
    if body == "weber_banaschek":
        return weber_banaschek(nu).matrix(tooth.chord, E)
    if body == "half_plane":
        return half_plane(tooth.chord, radii.depth, nu).matrix(tooth.chord, E)
    form = tooth.form
    if form.is_internal:
        raise GeometryError(
            "does not apply to internal gears",
            where="compliance.body",
            value=body,
            remedy="use body: ring or weber_banaschek",
        )
    theta = form.root_half_angle
    fit = sainsot(theta, radii.root / radii.clamp).matrix(2.0 * form.r_f * theta * tooth.cos_beta, E)
    shift = np.eye(3)
    shift[0, 1] = tooth.distance - form.r_f  # their height counts from the root circle
    return np.asarray(shift.T @ fit @ shift)


def _bounded(own: Array, following: Array) -> tuple[Array, tuple[float, float]]:
    """Coupling reduced until a chain of teeth is positive, first that by normal forces, and the factors."""
    values, vectors = np.linalg.eigh(own)
    root = vectors / np.sqrt(values)[:, None, :]

    def radius(normal: float, waves: NDArray[np.intp]) -> Array:
        """Numerical radius of the coupling of some waves with a factor on normal forces, shape of waves."""
        N = root[waves].transpose(0, 2, 1) @ _reduced(following[waves], normal) @ root[waves]
        turned = _ANGLES[:, None, None, None] * N
        hermitian = turned + turned.conj().transpose(0, 1, 3, 2)
        return np.asarray(0.5 * np.linalg.eigvalsh(hermitian)[..., -1].max(axis=0))

    all_waves = np.arange(own.shape[0], dtype=np.intp)
    critical = all_waves[radius(1.0, all_waves) > _LIMIT]
    normal = 1.0
    while critical.size and normal > 0.0:
        normal = max(0.0, normal - _STEP)
        critical = critical[radius(normal, critical) > _LIMIT]
    whole = _LIMIT / float(radius(normal, critical).max()) if critical.size else 1.0
    return whole * _reduced(following, normal), (normal, whole)


def _reduced(following: Array, normal: float) -> Array:
    """Coupling with a factor on normal forces at both ends, shape (k, 3, 3)."""
    factor = np.array([1.0, 1.0, normal])
    return np.asarray(following * factor[:, None] * factor)
