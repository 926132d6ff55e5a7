# SPDX-License-Identifier: Apache-2.0
"""Speeds in gear trains with carriers: every mesh is a relation between the spins of three bodies.

A mesh holds z_1 (w_1 - w_c) + z_2 (w_2 - w_c) = 0 with the speeds w in space of both gears and of the body
that carries the line between them round (R. Willis, Principles of Mechanism, 1841). The spins of a file count
against what a body hangs on. What all relations leave free is fixed by the given speeds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pitchpoint.model.frames import GROUND
from pitchpoint.model.mechanism import base_of, same_base, seat_frame, spinner_of

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts
    from pitchpoint.model.speed_ratios import Link

Array = NDArray[np.float64]

ROUNDING = 8 * np.finfo(float).eps
"""Rounding of a sum over its terms without signs, for each of them: a speed below that is zero."""

SAME = 1e-9
"""Singular value over the largest, and part of a row over one, that count as zero."""


def line_carrier(parts: Parts, one: str, two: str) -> str:
    """The body that carries the line between two gears round; ground where both are on ground.

    It is what the gear hangs on whose base moves with more joints.
    """
    bases = [base_of(parts, parts.mechanism, body) for body in (one, two)]
    chains = [_movers(parts, base) for base in bases]
    return bases[0] if len(chains[0]) > len(chains[1]) else bases[1]


def carrying(parts: Parts, one: str, two: str) -> int | None:
    """Which of two bodies with bevel gears in mesh rides on a carrier that turns about the axis of the other.

    1 or 2; 0 if both hang on one body; None if neither is so, and the relation of their teeth is unknown.
    """
    mechanism = parts.mechanism
    bases = [base_of(parts, mechanism, body) for body in (one, two)]
    if bases[0] == bases[1]:
        return 0
    for k, (rider, other) in enumerate(((one, two), (two, one)), start=1):
        carrier = base_of(parts, mechanism, rider)
        around = base_of(parts, mechanism, carrier) == base_of(parts, mechanism, other)
        if around and carrier not in (GROUND, other) and _sense(parts, carrier, other) != 0.0:
            return k
    return None


def has_carriers(parts: Parts, links: list[Link]) -> bool:
    """Whether some link joins bodies whose spins count from different frames or are those of others."""
    return any(
        place[0] != "ratios"
        and (
            not same_base(parts, one, two)
            or any(spinner_of(parts, parts.mechanism, body) is not None for body in (one, two))
        )
        for place, one, two, _ in links
    )


def carried_speeds(
    parts: Parts, links: list[Link], given: Mapping[str, float], supported: Sequence[str], tolerance: float
) -> tuple[dict[str, float], list[tuple[str, float]]]:
    """Speeds of all spins and given ones that contradict earlier ones, see `speed_ratios.start_speeds`.

    Bodies that are `supported` are at rest where the given speeds allow it.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    rows = [row for link in links if (row := _relation(parts, place, link)).any()]
    free = _null_space(np.array(rows).reshape(-1, len(turning)), len(turning))
    taken: list[str] = []
    wrong = []
    y = np.zeros(free.shape[1])
    wanted = dict(given) | {name: 0.0 for name in supported if name not in given}
    for name, value in wanted.items():
        if name not in place:
            continue
        fits = float(free[place[name]] @ y)
        if _rank(free, [*taken, name], place) > len(taken):
            taken.append(name)
            chosen = free[[place[n] for n in taken]]
            y = np.linalg.lstsq(chosen, np.array([wanted[n] for n in taken]), rcond=None)[0]
        elif name in given and abs(fits - value) > tolerance * max(abs(value), abs(fits)):
            wrong.append((name, fits))
    found = free @ y
    # columns of length one are rounded as one is
    found[np.abs(found) <= ROUNDING * len(turning) * np.linalg.norm(y)] = 0.0
    speeds = dict(zip(turning, found.tolist(), strict=True))
    return {n: speeds.get(n, 0.0) for n in parts.bodies}, wrong


def speed_in_space(
    parts: Parts,
    spins: Mapping[str, float],
    body: str,
    about: str | None = None,
    against: str | None = None,
) -> float:
    """Speed of a body about its own axis in space [rad/s], or about that of another body.

    Parameters
    ----------
    parts
        A model or the parts of one.
    spins
        Speeds of bodies as a file counts them, against what they hang on [rad/s].
    body
        Name of the body; ground does not move.
    about
        Body whose axis counts.
    against
        Body against whose speed about the same axis it counts, such as a carrier.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    row = _in_space(parts, place, body, about)
    if against is not None:
        row = row - _in_space(parts, place, against, about or body)
    values = np.array([spins.get(name, 0.0) for name in turning])
    found, terms = float(row @ values), float(np.abs(row) @ np.abs(values))
    return 0.0 if abs(found) <= ROUNDING * values.size * terms else found


def _movers(parts: Parts, body: str) -> list[str]:
    """Bodies on the way from ground whose joints move."""
    found = []
    while body != GROUND and body in parts.mechanism.seats:
        seat = parts.mechanism.seats[body]
        if seat.coordinates:
            found.append(body)
        body = seat.parent
    return found


def _in_space(parts: Parts, place: Mapping[str, int], body: str, about: str | None = None) -> Array:
    """Speed of a body about the axis of its gears, or of those of another body, per speed of every spin.

    What turns about an axis that is not parallel turns no gear against another: it takes both along.
    """
    found = np.zeros(len(place))
    sense = 1.0 if about is None else _sense(parts, body, about)
    while sense != 0.0 and body != GROUND and body in parts.mechanism.seats:
        seat = parts.mechanism.seats[body]
        if body in place:
            found[place[body]] += sense
        if seat.parent != GROUND and seat.parent in parts.mechanism.seats:
            sense *= _sense(parts, body, seat.parent)
        body = seat.parent
    return found


def _sense(parts: Parts, one: str, two: str) -> float:
    """1 where the axes of two bodies are parallel, -1 where they are opposite, else 0."""
    if not {one, two} <= parts.mechanism.seats.keys():
        return 1.0
    axes = [seat_frame(parts, parts.mechanism.seats[b])[1][:, 2] for b in (one, two)]
    along = float(axes[0] @ axes[1])
    return float(np.sign(along)) if abs(abs(along) - 1.0) < SAME else 0.0


def _relation(parts: Parts, place: Mapping[str, int], link: Link) -> Array:
    """Row over the spins that a mesh, a coupling or a ratio holds at zero."""
    where, one, two, ratio = link
    if where[0] == "ratios":  # of the spins as given in the file
        row = np.zeros(len(place))
        for body, factor in ((one, -ratio), (two, 1.0)):
            if body in place:
                row[place[body]] += factor
        return row
    w_1, w_2 = (_in_space(parts, place, body) for body in (one, two))
    base = np.zeros(len(place))
    if where[0] == "meshes":
        base = _in_space(parts, place, line_carrier(parts, one, two), about=one)
    if where[0] == "bevel_meshes":  # each gear turns about an axis of its own
        carrier = line_carrier(parts, one, two)
        w_1, w_2 = (w - _in_space(parts, place, carrier, about=b) for w, b in ((w_1, one), (w_2, two)))
    return np.asarray((w_2 - base) - ratio * (w_1 - base))


def _null_space(rows: Array, n: int) -> Array:
    if not len(rows):
        return np.eye(n)
    _, sizes, basis = np.linalg.svd(rows / np.linalg.norm(rows, axis=1, keepdims=True))
    return np.asarray(basis[int(np.sum(sizes > SAME * sizes.max())) :].T)


def _rank(free: Array, names: list[str], place: Mapping[str, int]) -> int:
    if not free.shape[1]:
        return 0
    return int(np.linalg.matrix_rank(free[[place[n] for n in names]], tol=SAME))
