# SPDX-License-Identifier: Apache-2.0
"""Mode shapes of a machine at the nodes of its elastic bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.system.rules.elastic_body import file_nodes

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.solvers.modal import Modes

Array = NDArray[np.float64]


def node_shapes(model: Model, modes: Modes) -> dict[str, tuple[Array, NDArray[np.complex128]]]:
    """Positions of all nodes of elastic bodies and their displacements in the damped modes.

    Parameters
    ----------
    model, modes
        The model and its modes from `find_modes`.

    Returns
    -------
    dict
        By body: positions at rest (k, 3) [m], and displacements (n, k, 3) per unit of the shapes, world axes.
    """
    return {name: _of_body(name, *file_nodes(model, name), modes) for name in model.elastic_bodies}


def _of_body(name: str, places: Array, phi: Array, modes: Modes) -> tuple[Array, Any]:
    """Node positions and displacements in world axes, from the floating frame and the modal coordinates."""
    k = modes.bodies.index(name)
    own = [modes.coordinates.index(f"{name}.{m // 3 + 1}.eta{m + 1}") for m in range(phi.shape[2])]
    turned = modes.axes[k] @ _about_z(modes.state.q[modes.coordinates.index(f"{name}.spin")])
    arms = (places + phi @ modes.state.q[own]) @ turned.T
    frame = modes.damped_body_shape[:, k]
    swing = np.einsum("ab,kbm,nm->nka", turned, phi, modes.damped_shape[:, own])
    return modes.place[k] + arms, frame[:, None, :3] + np.cross(frame[:, None, 3:], arms[None]) + swing


def _about_z(angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
