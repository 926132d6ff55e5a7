# SPDX-License-Identifier: Apache-2.0
"""Speeds in planetary gear trains: every mesh is a relation between the speeds of three bodies.

A mesh satisfies z_1 (w_1 - w_c) + z_2 (w_2 - w_c) = 0 with the absolute speeds w of both gears and of the
carrier of their line of centres (R. Willis, Principles of Mechanism, 1841). The spins of a file are relative
to the parent body. The given speeds determine the remaining freedom.
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
"""Rounding error per term of a sum, relative to the sum of absolute values: a smaller speed is zero."""

SAME = 1e-9
"""Relative singular value, and deviation of a direction cosine from one, that count as zero."""


def line_carrier(parts: Parts, one: str, two: str) -> str:
    """Carrier of the line of centres of two gears; ground if both are on ground.

    It is the base of the gear whose base has more moving joints to ground.
    """
    bases = [base_of(parts, parts.mechanism, body) for body in (one, two)]
    chains = [_movers(parts, base) for base in bases]
    return bases[0] if len(chains[0]) > len(chains[1]) else bases[1]


def carrying(parts: Parts, one: str, two: str) -> int | None:
    """Which of two meshing bevel gears is a planet on a carrier that rotates about the axis of the other.

    1 or 2; 0 if both bodies have the same base; None if neither applies and the tooth relation is unknown.
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
    """Whether a link connects bodies whose spins refer to different frames or equal those of other bodies."""
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
    """All spin speeds, and given speeds that contradict earlier ones, see `speed_ratios.start_speeds`.

    Bodies in `supported` are at rest if the given speeds permit it.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    rows = [row for link in links if (row := relation(parts, place, link)).any()]
    free = null_space(np.array(rows).reshape(-1, len(turning)), len(turning))
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
    # rounding error of columns of unit length
    found[np.abs(found) <= ROUNDING * len(turning) * np.linalg.norm(y)] = 0.0
    speeds = dict(zip(turning, found.tolist(), strict=True))
    return {n: speeds.get(n, 0.0) for n in parts.bodies}, wrong


def undetermined(parts: Parts, links: list[Link], known: Sequence[str]) -> list[str]:
    """Bodies in a train with the known ones whose spin speeds do not follow from these.

    `carried_speeds` gives them the least speeds that fit.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    rows = [row for link in links if (row := relation(parts, place, link)).any()]
    free = null_space(np.array(rows).reshape(-1, len(turning)), len(turning))
    taken = free[[place[name] for name in known if name in place]]
    if not free.shape[1] or not len(taken):
        return []
    _, sizes, basis = np.linalg.svd(taken)
    spanned, left = np.split(basis, [int(np.sum(sizes > SAME * sizes.max()))])
    moved = np.linalg.norm(free @ spanned.T, axis=1) > SAME  # by the known ones
    loose = np.linalg.norm(free @ left.T, axis=1) > SAME
    return [name for name, k in place.items() if moved[k] and loose[k]]


def speed_in_space(
    parts: Parts,
    spins: Mapping[str, float],
    body: str,
    about: str | None = None,
    against: str | None = None,
) -> float:
    """Absolute speed of a body about its own axis, or about that of another body [rad/s].

    Parameters
    ----------
    parts
        A model or the parts of one.
    spins
        Spin speeds of the bodies relative to their parents [rad/s].
    body
        Name of the body; the speed of ground is zero.
    about
        Body whose axis is used.
    against
        Reference body, such as a carrier; the speed is relative to it.
    """
    turning = [name for name, seat in parts.mechanism.seats.items() if "spin" in seat.coordinates]
    place = {name: k for k, name in enumerate(turning)}
    row = spin_row(parts, place, body, about)
    if against is not None:
        row = row - spin_row(parts, place, against, about or body)
    values = np.array([spins.get(name, 0.0) for name in turning])
    found, terms = float(row @ values), float(np.abs(row) @ np.abs(values))
    return 0.0 if abs(found) <= ROUNDING * values.size * terms else found


def _movers(parts: Parts, body: str) -> list[str]:
    """Bodies with moving joints on the path to ground."""
    found = []
    while body != GROUND and body in parts.mechanism.seats:
        seat = parts.mechanism.seats[body]
        if seat.coordinates:
            found.append(body)
        body = seat.parent
    return found


def spin_row(parts: Parts, place: Mapping[str, int], body: str, about: str | None = None) -> Array:
    """Factors of the absolute speed of a body over all spins, about its own axis or that of `about`.

    Rotation about a non-parallel axis does not rotate one gear relative to another: it moves both.

    Parameters
    ----------
    parts
        A model or the parts of one.
    place
        Number of every spin, by body.
    body, about
        The body, and the body whose axis is used.
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
    """1 if the axes of two bodies are parallel, -1 if they are opposite, else 0."""
    if not {one, two} <= parts.mechanism.seats.keys():
        return 1.0
    axes = [seat_frame(parts, parts.mechanism.seats[b])[1][:, 2] for b in (one, two)]
    along = float(axes[0] @ axes[1])
    return float(np.sign(along)) if abs(abs(along) - 1.0) < SAME else 0.0


def relation(parts: Parts, place: Mapping[str, int], link: Link) -> Array:
    """Factors over the spins whose sum is zero by a mesh, a coupling or a ratio.

    By virtual work the same factors times a torque are the torques of the link on all spins: the torque
    itself acts on the second body.

    Parameters
    ----------
    parts
        A model or the parts of one.
    place
        Number of every spin, by body.
    link
        The link.
    """
    where, one, two, ratio = link
    if where[0] == "ratios":  # relation between relative spins
        row = np.zeros(len(place))
        for body, factor in ((one, -ratio), (two, 1.0)):
            if body in place:
                row[place[body]] += factor
        return row
    w_1, w_2 = (spin_row(parts, place, body) for body in (one, two))
    base = np.zeros(len(place))
    if where[0] == "meshes":
        base = spin_row(parts, place, line_carrier(parts, one, two), about=one)
    if where[0] == "bevel_meshes":  # the gears rotate about different axes
        carrier = line_carrier(parts, one, two)
        w_1, w_2 = (w - spin_row(parts, place, carrier, about=b) for w, b in ((w_1, one), (w_2, two)))
    return np.asarray((w_2 - base) - ratio * (w_1 - base))


def null_space(rows: Array, n: int) -> Array:
    """Orthonormal speeds that satisfy all relations, shape (n, freedoms).

    Parameters
    ----------
    rows
        Relations between the speeds.
    n
        Number of speeds.
    """
    if not len(rows):
        return np.eye(n)
    _, sizes, basis = np.linalg.svd(rows / np.linalg.norm(rows, axis=1, keepdims=True))
    return np.asarray(basis[int(np.sum(sizes > SAME * sizes.max())) :].T)


def _rank(free: Array, names: list[str], place: Mapping[str, int]) -> int:
    if not free.shape[1]:
        return 0
    return int(np.linalg.matrix_rank(free[[place[n] for n in names]], tol=SAME))
