# SPDX-License-Identifier: Apache-2.0
"""Bearings and couplings of a model as records of the six-component spring."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import bearing as element
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.bearing_fault import play
from pitchpoint.model.components.coupling import Coupling
from pitchpoint.model.frames import GROUND, body_frame, place_of, split
from pitchpoint.model.mechanism import seat_frame
from pitchpoint.multibody.bodies import FIXED, Body
from pitchpoint.system.rules.bank import Bank, pack
from pitchpoint.system.rules.bodies import count_of, frame_at, seat_at
from pitchpoint.system.rules.places import Places

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def bearing_bank(places: Places) -> Bank:
    """All bearings without fit clearance (body to ground or housing) and all couplings (body to body).

    The markers are on the spin axes (x = y = 0), so that the springs do not rotate with the gears. The
    springs act along the axes of the (first) body.
    """
    model = places.model
    rows, names = [], []
    seats = housing_numbers(model)
    parts: list[tuple[str, Bearing | Coupling, tuple[str, ...]]] = [
        *((n, b, (b.body,)) for n, b in model.bearings.items() if play(b.faults.values()) == 0.0),
        *((n, c, c.bodies) for n, c in model.couplings.items()),
    ]
    for name, part, ends in parts:
        row = np.zeros(1, element.RECORD)[0]
        origin = [np.array(model.bodies[b].origin or (0.0, 0.0, 0.0)) for b in ends]
        axes = body_frame(model, ends[0])[1]
        marker = origin[0] + axes @ [0.0, 0.0, part.position[2]]
        row["i"], row["zi"] = seat_at(model, ends[0], part.position[2])
        row["K"] = part.stiffness.matrix6()
        row["D"] = damping_matrix(model, part, ends)
        row["B"] = axes
        if len(ends) == 2:
            way = body_frame(model, ends[1])[1][:, 2]
            along = float((marker - origin[1]) @ way)
            row["j"], row["zj"] = seat_at(model, ends[1], along)
            row["d0"] = axes.T @ (marker - origin[1] - along * way)
            row["B"] = seat_frame(model, model.mechanism.seats[ends[1]])[1].T @ axes
        else:
            row["d0"] = axes.T @ marker
        if name in seats and isinstance(part, Bearing):
            row["j"], row["housed"] = seats[name], 1
            row["d0"] = 0.0
            row["B"] = np.eye(3)
        rows.append(row)
        names.append(name)
    return pack("bearing", element.RECORD, rows, names)


def housed(model: Model) -> list[str]:
    """Names of the bearings with a housing."""
    return [n for n, b in model.bearings.items() if b.housing not in (None, GROUND)]


def housing_numbers(model: Model) -> dict[str, int]:
    """Number of the housing seat of each bearing with a housing; numbered after all other bodies."""
    first = 1 + sum(count_of(model, name) for name in model.mechanism.seats)
    first += sum(len(beam.stations) for beam in model.beams.values())
    return {name: first + k for k, name in enumerate(housed(model))}


def housing_seats(model: Model) -> list[Body]:
    """Massless bodies fixed to the housings at the bearings, with the axes of the supported bodies."""
    found = []
    for name in housed(model):
        part = model.bearings[name]
        origin = np.array(model.bodies[part.body].origin or (0.0, 0.0, 0.0))
        axes = body_frame(model, part.body)[1]
        place = origin + axes @ [0.0, 0.0, part.position[2]]
        body, marker = split(str(part.housing))
        parent = frame_at(model, body, place_of(model, str(part.housing)) if marker else place)[0]
        found.append(Body(motion=FIXED, parent=parent, position=place, axes=axes, name=f"{name}.housing"))
    return found


def damping_matrix(model: Model, part: Bearing | Coupling, ends: tuple[str, ...]) -> NDArray[np.float64]:
    """Damping matrix; a ratio refers to critical damping of the (reduced) inertia on the spring."""
    if part.damping is None:
        return np.zeros((6, 6))
    if part.damping.ratio is None:
        return np.array(part.damping.matrix6())
    inverse = np.zeros(6)
    for end in ends:
        part_of = model.body_inertia(end)
        masses = (*3 * (part_of.mass,), *2 * (part_of.transverse,), part_of.polar)
        inverse += np.array([1.0 / v if v > 0.0 else 0.0 for v in masses])
    K = np.array(part.stiffness.matrix6())
    # damping along the principal directions: matrix square root of M^(-1/2) K M^(-1/2), scaled back
    scale = np.where(inverse > 0.0, np.sqrt(inverse), 0.0)
    values, vectors = np.linalg.eigh(scale[:, None] * K * scale[None, :])
    root = vectors * np.sqrt(np.maximum(values, 0.0)) @ vectors.T
    back = np.where(scale > 0.0, 1.0 / np.where(scale > 0.0, scale, 1.0), 0.0)
    return 2.0 * part.damping.ratio * back[:, None] * root * back[None, :]
