# SPDX-License-Identifier: Apache-2.0
"""Torques on every body about its axis, by what they come from, at constant speed.

Bodies fixed to a shaft transmit torque through their joints: from the wind on a rotor through the main shaft
to the carrier of the planets. The torque of planets on their carrier is the remainder of the balance.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.model.torque_balance import TorqueBalance

Acting = list[tuple[list[str], float | None]]
"""Names of what acts, and torque [N m]; None if balance does not determine it."""


def acting_torques(
    model: Model, balance: TorqueBalance, outer: Sequence[Mapping[str, Any]]
) -> dict[str, Acting]:
    """Torques on every body about its axis.

    Parameters
    ----------
    model
        The model.
    balance
        Its torques.
    outer
        Torques from outside: `name`, `torque`, `body` and `reaction`.
    """
    found = {body: _own(balance, outer, body) for body in model.bodies}
    for body in model.bodies:
        _complete(model, found, body)
    return found


def _own(balance: TorqueBalance, outer: Sequence[Mapping[str, Any]], body: str) -> Acting:
    """External torques on a body, and those of its meshes and couplings."""
    found: Acting = []
    for each in outer:
        if body in (each["body"], each["reaction"]):
            way = 1.0 if each["body"] == body else -1.0
            found.append(([each["name"]], None if each["torque"] is None else way * each["torque"]))
    for link in balance.links.values():
        for end, torque in zip(link.bodies, link.torques, strict=True):
            if end == body:
                found.append(([str(link.place[1])], torque + 0.0 if math.isfinite(torque) else None))
    return found


def _complete(model: Model, found: dict[str, Acting], body: str) -> None:
    """Add torques of planets on carriers and those through fixed joints, for bodies that rotate as one."""
    seats = model.mechanism.seats
    fixed = _fixed_to(model, body)
    if body not in seats or not seats[body].coordinates:
        return
    fixed = [body, *fixed]
    riders = {name: _riders(model, name) for name in fixed}
    carriers = [name for name, those in riders.items() if those]
    known = [torque for name in fixed for _, torque in found[name] if torque is not None]
    if len(known) < sum(len(found[name]) for name in fixed) or len(carriers) > 1:
        return
    for name in carriers:
        found[name].append((riders[name], -math.fsum(known)))
    for name in reversed(fixed[1:]):  # bodies fixed to others come after them
        through = math.fsum(torque or 0.0 for _, torque in found[name])
        parent = seats[name].parent
        found[name].append(([parent], -through))
        found[parent].append(([name], through))


def _fixed_to(model: Model, body: str) -> list[str]:
    """Bodies that are fixed to a body, and those fixed to them, each after the one that carries it."""
    found = [body]
    for name, seat in model.mechanism.seats.items():
        if seat.parent in found and not seat.coordinates:
            found.append(name)
    return found[1:]


def _riders(model: Model, body: str) -> list[str]:
    """Bodies with gears on a body, such as the planets on their carrier."""
    return [
        name
        for name, seat in model.mechanism.seats.items()
        if seat.parent == body
        and seat.coordinates
        and any(
            model.bodies[one].gears or model.bodies[one].bevel_gears
            for one in (name, *model.mechanism.carried_by(name))
        )
    ]
