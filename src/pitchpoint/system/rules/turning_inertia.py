# SPDX-License-Identifier: Apache-2.0
"""Moment of inertia that rotates with a gear: its body, the body it is fixed to, and all attached bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.model.frames import GROUND, body_frame
from pitchpoint.model.mechanism import seat_frame

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def turning_inertia(model: Model, body: str) -> float:
    """Moment of inertia about the spin axis of a body with a gear [kg m^2]; infinite if it cannot rotate.

    Bodies on joints are included with their joints locked at zero coordinates: the diagonal entry of the
    mass matrix for the spin. Attached elastic bodies are not included. A body that is fixed to a station of
    a beam rotates with the twist of the beam.

    Parameters
    ----------
    model
        The model.
    body
        Name of the body.
    """
    seats, gear = model.mechanism.seats, body
    while seats[body].kind == "fixed" and seats[body].beam is None:  # a beam twists
        if seats[body].parent == GROUND:
            return float("inf")
        body = seats[body].parent
    polar = model.body_inertia(body).polar
    hanging = model.mechanism.carried_by(body)
    if not hanging:
        return polar
    place, axes = body_frame(model, gear)
    if place is None:
        place = seat_frame(model, seats[gear])[0]
    axis = axes[:, 2]
    for name in hanging:
        if name in model.elastic_bodies:
            continue
        inertia = model.body_inertia(name)
        origin, own = body_frame(model, name)
        at = seat_frame(model, seats[name])[0] if origin is None else origin
        arm = at + own @ np.array(inertia.place) - place
        along = own.T @ axis
        beside = arm - (arm @ axis) * axis
        polar += float(along @ inertia.about_center() @ along + inertia.mass * beside @ beside)
    return polar
