# SPDX-License-Identifier: Apache-2.0
"""Shafts and beams made from numbers: nodes as bodies, pieces between them, bearings to ground."""

from __future__ import annotations

import numpy as np

from pitchpoint.elements.beam import beam_row
from pitchpoint.elements.shaft_beam import shaft_row
from pitchpoint.multibody.bodies import FREE, Body
from tests.support.engine import bearings

LIGHT = 1e-9
"""Mass [kg] and inertia [kg m^2] of a node that is nothing but a node."""


def nodes(places, discs=None, origin=(0.0, 0.0, 0.0), name="n", motion=FREE):
    """Bodies at places along z; discs maps a node to (mass, transverse, polar)."""
    found = []
    for k, z in enumerate(places):
        m, it, ip = (discs or {}).get(k, (LIGHT, LIGHT, LIGHT))
        place = np.add(origin, (0.0, 0.0, z))
        found.append(
            Body(
                motion=motion,
                position=place,
                mass=m,
                transverse_inertia=it,
                polar_inertia=ip,
                name=f"{name}{k}",
            )
        )
    return found


def shaft(beams, first=1, **more):
    """Records of pieces in a row, from body `first` on."""
    return np.concatenate(
        [shaft_row(b, bodies=(first + k, first + k + 1), **more) for k, b in enumerate(beams)]
    )


def fixed_beams(beams, first=1, **more):
    """The same, fixed to their bodies; first 0 clamps the first end to ground."""
    return np.concatenate(
        [beam_row(b, bodies=(first + k, first + k + 1), **more) for k, b in enumerate(beams)]
    )


def supports(bodies, rows):
    """Bearings to ground from rows (body, K, D) with the markers at the bodies."""
    records = bearings([(i, 0, K, D) for i, K, D in rows])
    for record, (i, _, _) in zip(records, rows, strict=True):
        record["d0"] = bodies[i - 1].position
    return records


def damped_frequencies(M, D, K):
    """Imaginary parts of the eigenvalues [Hz] above zero, ascending, with their real parts [1/s]."""
    n = M.shape[0]
    top = np.hstack([np.zeros((n, n)), np.eye(n)])
    low = np.hstack([-np.linalg.solve(M, K), -np.linalg.solve(M, D)])
    values = np.linalg.eigvals(np.vstack([top, low]))
    values = values[values.imag > 1e-3]
    values = values[np.argsort(values.imag)]
    return values.imag / (2.0 * np.pi), values.real
