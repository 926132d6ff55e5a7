# SPDX-License-Identifier: Apache-2.0
"""Notes on a contact analysis: contact below the root form circle, beyond tip edges, and in few planes."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, note
from pitchpoint.elements.mesh.surface.nodes import ON_PATH, TIP_2
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates, under_load

FINE = 1e-3
"""Length of roll below the root form circle that is not reported, in base pitches."""
NEAR = 0.9
"""Share of the range of tip edges beyond which contacts are reported."""
ALIGNED = 1e-9
"""Misalignment that is rounding [rad]."""
FEW = 3
"""Loaded planes below which the load distribution over the face width is not resolved."""


def contact_notes(
    flanks: FlankStates, found: list[tuple[NDArray[np.void], NDArray[np.void]]]
) -> tuple[Message, ...]:
    """Notes on solved states.

    Parameters
    ----------
    flanks
        The mesh.
    found
        States, shape (m,), and nodes, shape (m, max_nodes), for each torque.
    """
    loaded = [nodes[under_load(states, nodes)] for states, nodes in found]
    if not any(nodes.size for nodes in loaded):
        return ()
    node = np.concatenate(loaded)
    return (
        *_interference(flanks, node),
        *_far_edges(flanks, node),
        *_few_planes(flanks, found, loaded),
        *_one_plane(flanks, found),
    )


def _interference(flanks: FlankStates, node: NDArray[np.void]) -> list[Message]:
    """Contacts between the root form circle and the root, where the flank is not an involute."""
    pair = flanks.model.pairs[flanks.mesh]
    found = []
    for k, name in enumerate(flanks.model.meshes[flanks.mesh].gears):
        form = pair.T1A_form if k == 0 else pair.T1T2 - pair.T1E_form  # signed, as the lengths of roll
        below = form - node["roll"][:, k]
        if below.max() <= FINE * pair.p_et:
            continue
        shape = flanks.model.gears[name].geometry
        r_b = 0.5 * abs(shape.d_b)
        deepest = float(node["roll"][int(below.argmax()), k])
        inside = deepest * (1.0 if shape.z > 0 else -1.0) < 0.0
        place = (
            "inside its base circle" if inside else f"at the diameter {2e3 * math.hypot(r_b, deepest):.6g} mm"
        )
        found.append(
            note(
                f"mesh {flanks.mesh}: interference, {name} touches {place}, beyond its root form circle of "
                f"{1e3 * abs(shape.d_Ff):.6g} mm, and calculated as if its involute continued there"
            )
        )
    return found


def _far_edges(flanks: FlankStates, node: NDArray[np.void]) -> list[Message]:
    """Contacts of tip edges near the end of the range in which they are followed."""
    pair, reach = flanks.model.pairs[flanks.mesh], float(flanks.record["reach"])
    start, end = pair.T1A - pair.T1C, pair.T1E - pair.T1C
    away = np.where(node["place"] == TIP_2, start - node["xi"], node["xi"] - end)
    away[node["place"] == ON_PATH] = 0.0
    if away.max() < NEAR * reach:
        return []
    share = f"{float(away.max()) / pair.p_et:.2f}"
    return [
        note(
            f"mesh {flanks.mesh}: tip edges touch up to {share} base pitches beyond the path of contact, and "
            f"only contacts within {reach / pair.p_et:.2g} are calculated: the deflection is too large for "
            "these teeth"
        )
    ]


def _few_planes(
    flanks: FlankStates,
    found: list[tuple[NDArray[np.void], NDArray[np.void]]],
    loaded: list[NDArray[np.void]],
) -> list[Message]:
    """Torque with the fewest planes under load over the mesh cycle; of two planes both may be."""
    planes = int(flanks.record["slices"])
    least, at = min((np.unique(nodes["plane"]).size, k) for k, nodes in enumerate(loaded) if nodes.size)
    if least >= min(FEW, planes):
        return []
    torque = float(found[at][0]["force"].mean()) * float(flanks.record["r_b1"])
    return [
        note(
            f"mesh {flanks.mesh}: load in only {least} of {planes} planes at {torque:.4g} N m, so that K_Hβ "
            f"is only rough, extrapolated from them up to {1.5 * planes:g} (1.5 × planes): give more planes"
        )
    ]


def _one_plane(flanks: FlankStates, found: list[tuple[NDArray[np.void], NDArray[np.void]]]) -> list[Message]:
    """Misalignment of flanks with a single contact plane."""
    tilt = max(float(np.abs(states["kappa"]).max()) for states, _ in found)
    if int(flanks.record["slices"]) > 1 or tilt < ALIGNED:
        return []
    return [
        note(
            f"mesh {flanks.mesh}: misalignment has no effect with one contact plane: give planes, such as 11"
        )
    ]
