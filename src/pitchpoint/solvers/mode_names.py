# SPDX-License-Identifier: Apache-2.0
"""What a mode does, in words: from the shares of bodies and elements in its energies.

The share of a coordinate in a name is M_kk phi_k^2 over the sum of this over all coordinates: the kinetic
energy that the coordinate would have alone. Between 0 and 1 it is, and it is the share in the kinetic energy
where the mass matrix is diagonal. A coordinate of a joint also moves what hangs on the body, and what
moves the other way takes energy away: phi_k (M phi)_k, the share in the energy itself, then is negative for
one of them and above 1 for another. Elements that push away from rest, such as gravity on an upright
pendulum, have negative strain energy; the share of an element is that in the sum of the magnitudes.
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
"""Words for the coordinates of a body."""

TORSIONAL = 0.7
"""Share of the spins from which a mode counts as torsional."""
ENOUGH = 0.8
"""Share that the named motions make up."""
MOST = 3
"""Most motions that are named."""


def mode_names(
    layout: Layout, parts: Parts, omega: Array, shapes: Array, potential: Array
) -> tuple[str, ...]:
    """Names of all modes.

    Parameters
    ----------
    layout
        Names of bodies and coordinates.
    parts
        Names of the elements and their bodies, and the mass matrix.
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
    """The motions that have the largest shares, largest first."""
    named, total = [], 0.0
    for k in np.argsort(-kinetic, kind="stable")[:MOST]:
        body, _, motion = layout.coordinates[k].rpartition(".")
        named.append(f"{body} {MOTION.get(motion, motion)} {100.0 * kinetic[k]:.0f} %")
        total += float(kinetic[k])
        if total >= ENOUGH:
            break
    return ", ".join(named)


def _spin_share(layout: Layout, kinetic: Array) -> float:
    return float(sum(s for c, s in zip(layout.coordinates, kinetic, strict=True) if c.endswith(".spin")))


def _bodies(layout: Layout, kinetic: Sequence[float] | Array) -> list[tuple[str, float]]:
    """Share of every body, largest first."""
    shares: dict[str, float] = {}
    for coordinate, share in zip(layout.coordinates, kinetic, strict=True):
        body = coordinate.rpartition(".")[0]
        shares[body] = shares.get(body, 0.0) + float(share)
    return sorted(shares.items(), key=lambda item: -item[1])
