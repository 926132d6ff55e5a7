# SPDX-License-Identifier: Apache-2.0
"""Names of modes, from the energy shares of bodies and elements.

The share of a coordinate is M_kk phi_k^2 over its sum over all coordinates: the kinetic energy of that
coordinate alone. It is between 0 and 1, and it is the share of the kinetic energy if the mass matrix is
diagonal. The exact share, phi_k (M phi)_k, is not used: a joint coordinate also moves the bodies that follow
in the tree, so the share of one coordinate may be negative and that of another above 1. Elements with
negative stiffness, such as gravity on an upright pendulum, have negative strain energy; the share of an
element refers to the sum of the magnitudes.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pitchpoint.elements import registry
from pitchpoint.solvers.stiffness_parts import ROTATION, Array, Parts
from pitchpoint.system.layout import Layout

MOTION = {
    "x": "translation x",
    "y": "translation y",
    "z": "translation z",
    "alpha": "tilt rx",
    "beta": "tilt ry",
    "spin": "rotation",
}
"""Names of the motions of a body, by coordinate."""

TORSIONAL = 0.7
"""Kinetic energy share of the spins from which a mode counts as torsional."""
ENERGY_SHARE = 0.8
"""Energy share that the listed motions must cover."""
MAX_MOTIONS = 3
"""Maximum number of motions listed."""


def mode_names(
    layout: Layout, parts: Parts, omega: Array, shapes: Array, potential: Array
) -> tuple[str, ...]:
    """Names of all modes.

    Parameters
    ----------
    layout
        Names of bodies and coordinates.
    parts
        Elements and their bodies, and the mass matrix.
    omega, shapes
        Undamped circular frequencies (n,), zero for rigid modes, and shapes (n, nd).
    potential
        Shares of elements (n, ne) in the strain energy.
    """
    kinetic = shapes**2 * parts.M.diagonal()
    kinetic = kinetic / np.maximum(kinetic.sum(axis=1, keepdims=True), 1e-300)
    potential = potential / np.maximum(np.abs(potential).sum(axis=1, keepdims=True), 1e-300)
    several = int(np.sum(omega == 0.0)) > 1
    return tuple(
        _rigid(layout, kinetic[j], several)
        if omega[j] == 0.0
        else _elastic(layout, parts, kinetic[j], potential[j])
        for j in range(len(omega))
    )


def _rigid(layout: Layout, kinetic: Array, several: bool) -> str:
    spins = _spin_share(layout, kinetic)
    if spins < TORSIONAL:
        return f"rigid motion: {_motions(layout, kinetic)}"
    if not several:
        return "rigid rotation"
    bodies = [b for b, share in _bodies(layout, kinetic) if share > 0.01]
    return f"rigid rotation of {', '.join(bodies)}"


def _elastic(layout: Layout, parts: Parts, kinetic: Array, potential: Array) -> str:
    if _spin_share(layout, kinetic) < TORSIONAL or not potential.size:
        return _motions(layout, kinetic)
    e = int(np.argmax(potential))
    if parts.kinds[e] == ROTATION or not registry.find(parts.kinds[e]).names_modes:
        return _motions(layout, kinetic)
    one, two = (layout.bodies[b] for b in parts.bodies[e])
    share = "" if potential[e] > 0.995 else f" {100.0 * potential[e]:.0f} %"
    if parts.bodies[e][1] == 0:
        return f"{parts.elements[e]}: {one} against ground (torsion){share}"
    return f"{parts.elements[e]}: {one} against {two} (torsion){share}"


def _motions(layout: Layout, kinetic: Array) -> str:
    """Motions with the largest shares, in descending order."""
    named, total = [], 0.0
    for k in np.argsort(-kinetic, kind="stable")[:MAX_MOTIONS]:
        body, _, motion = layout.coordinates[k].rpartition(".")
        named.append(f"{body} {MOTION.get(motion, motion)} {100.0 * kinetic[k]:.0f} %")
        total += float(kinetic[k])
        if total >= ENERGY_SHARE:
            break
    return ", ".join(named)


def _spin_share(layout: Layout, kinetic: Array) -> float:
    return float(sum(s for c, s in zip(layout.coordinates, kinetic, strict=True) if c.endswith(".spin")))


def _bodies(layout: Layout, kinetic: Sequence[float] | Array) -> list[tuple[str, float]]:
    """Share of every body, in descending order."""
    shares: dict[str, float] = {}
    for coordinate, share in zip(layout.coordinates, kinetic, strict=True):
        body = coordinate.rpartition(".")[0]
        shares[body] = shares.get(body, 0.0) + float(share)
    return sorted(shares.items(), key=lambda item: -item[1])
