# SPDX-License-Identifier: Apache-2.0
"""Mesh forces that are only the rounding of positions and forces: the mesh has no load.

The travel u = r_b1 phi_1 + r_b2 phi_2 of a mesh is the small difference of two arcs of up to a turn, each
known to the relative spacing eps of floating-point numbers. A mesh of face width b is not stiffer than b E,
five to ten times the stiffness of steel teeth (ISO 6336-1: c_gamma = 20 N/(mm um) = 0.1 E). A force below

    F = eps 2 pi (r_1 + r_2) b E

is therefore no contact that the positions could resolve. Forces in equilibrium are known relative to the
largest ones: below 1e-10 of the largest mesh force a force is none, either.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

MODULUS = 2.1e11
"""Modulus of elasticity of steel [Pa]."""
RELATIVE = 1e-10
"""Mesh force over the largest mesh force of the machine up to which it is rounding."""


def rounding_force(radii: float, width: float) -> float:
    """Mesh force of the rounding of a turn [N].

    Parameters
    ----------
    radii
        Sum of the reference radii of both gears [m].
    width
        Face width [m].

    Examples
    --------
    >>> f"{rounding_force(0.12, 0.06):.3g}"
    '2.11e-06'
    """
    return float(np.finfo(float).eps) * 2.0 * math.pi * radii * width * MODULUS


def least_forces(model: Model, largest: float) -> dict[str, float]:
    """Force by mesh up to which there is no load [N].

    Parameters
    ----------
    model
        The model.
    largest
        Largest mesh force of the machine [N].
    """
    found = {}
    for name, mesh in model.every_mesh.items():
        sizes = [_size(model, gear) for gear in mesh.gears]
        limit = rounding_force(sum(r for r, _ in sizes), min(b for _, b in sizes))
        found[name] = max(limit, RELATIVE * largest) if math.isfinite(largest) else limit
    return found


def _size(model: Model, gear: str) -> tuple[float, float]:
    """Reference radius and face width of a gear [m]."""
    if gear in model.gears:
        own = model.gears[gear].geometry
        return 0.5 * abs(own.d), own.b
    cone = model.bevel_gears[gear]
    return cone.geometry.R_m, cone.face_width


def without_rounding(model: Model, channels: Mapping[str, Mapping[str, Any]]) -> dict[str, Mapping[str, Any]]:
    """Statistics of channels with zero mesh forces in place of rounding."""
    names = {f"mesh_force[{mesh}]" for mesh in unloaded_meshes(model, channels)}
    none = dict.fromkeys(("mean", "rms", "min", "max"), 0.0)
    return {name: {**row, **none} if name in names else row for name, row in channels.items()}


def unloaded_meshes(model: Model | None, channels: Mapping[str, Mapping[str, Any]]) -> frozenset[str]:
    """Meshes whose force is nothing but rounding, from statistics of channels.

    Parameters
    ----------
    model
        The model; without one, and for meshes of which the force is not known, nothing is found.
    channels
        Statistics by channel, with `min` and `max`.
    """
    if model is None:
        return frozenset()
    forces = {}
    for mesh in model.every_mesh:
        row = channels.get(f"mesh_force[{mesh}]")
        if row is not None and math.isfinite(row["min"]) and math.isfinite(row["max"]):
            forces[mesh] = max(abs(row["min"]), abs(row["max"]))
    limits = least_forces(model, max(forces.values(), default=0.0))
    return frozenset(mesh for mesh, force in forces.items() if force <= limits[mesh])
