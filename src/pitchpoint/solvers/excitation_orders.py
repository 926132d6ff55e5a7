# SPDX-License-Identifier: Apache-2.0
"""Excitation orders of a machine per revolution of one body: shafts, meshes, their sidebands, others."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import SolverError
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.solvers.gear_trains import mesh_orders
from pitchpoint.solvers.load_orders import LoadOrder, load_orders, rigid_sum
from pitchpoint.solvers.modes.energies import Motions
from pitchpoint.system.meshes import mesh_names, mesh_records

if TYPE_CHECKING:
    from pitchpoint.system.system import System

Array = NDArray[np.float64]

USUAL = ("1x", "2x", "mesh", "2mesh", "sidebands", "loads", "blades")
"""Default orders: once and twice per revolution of every shaft, mesh frequencies with one pair of sidebands
per gear, twice the mesh frequencies, the harmonics of torques and drives, and the passing of blades."""
Orders = Sequence[str | float] | str
"""Orders: words and numbers, or one text with commas between them."""
SHAFT, MESH, SIDEBAND, OTHER = "shaft", "mesh", "sideband", "other"
LOAD, RIPPLE = "load", "ripple"
BLADES = "blades"
"""Word and kind of the orders of a wind rotor: multiples of its number of blades."""
PASSINGS = 3
"""Multiples of the number of blades: 3P, 6P and 9P of three blades."""
EQUAL = 1e-9
"""Relative distance of orders that are one line."""
LOADS = "loads"
"""Word for the harmonics of torques and drives."""
CANCELLED = 1e-3
"""Vector sum over the sum of the amplitudes up to which torques on one body cancel: tables are rounded."""
FEW = 2
"""Maximum number of names in the name of an order."""


@dataclass(frozen=True)
class Order:
    """One excitation order.

    Parameters
    ----------
    name
        Its name: `1× rotor`, `mesh stage`, `mesh stage + 1× rotor`.
    value
        Periods per revolution of the reference body.
    kind
        `shaft`, `mesh`, `sideband`, `load` (a torque), `ripple` (of a drive), `blades` or `other`.
    harmonic
        Number of the harmonic of the shaft or mesh.
    parts, meshes
        Parts that rotate with the shaft, and meshes with a gear on them; the meshes of a mesh order; the
        parts on which a torque or drive acts.
    torques
        Harmonics of the torques of this order.
    """

    name: str
    value: float
    kind: str
    harmonic: int = 1
    parts: tuple[int, ...] = ()
    meshes: tuple[str, ...] = ()
    torques: tuple[LoadOrder, ...] = ()


def excitation_orders(
    system: System,
    motions: Motions,
    rates: Array,
    chosen: Orders = USUAL,
    others: Mapping[str, float] | None = None,
) -> tuple[Order, ...]:
    """Orders in ascending order; equal ones of one kind are one.

    Parameters
    ----------
    system, motions
        The system and the motions of its bodies.
    rates
        Rates of all coordinates with the reference body at 1 rad/s.
    chosen
        `3x` for the third order of every shaft, `mesh` and `2mesh` for mesh harmonics, `sidebands` and
        `2sidebands` for one and two pairs of sidebands per gear at every chosen mesh harmonic, `loads` for
        the harmonics of torques that repeat with the angle of a body, and of the ripples of drives, `blades`
        for the multiples of the number of blades of wind rotors, numbers; a sequence, or a text such as
        `mesh,2`. The shaft of a wind rotor has its first order only, 1P: the others are those of the blades.
    others
        Further orders by name, such as those of bearing faults.

    Raises
    ------
    SolverError
        If a word is unknown.
    """
    words = order_words(chosen)
    shafts, meshes, bands, more = read_orders([word for word in words if word not in (LOADS, BLADES)])
    turning = _shafts(system, motions, rates)
    rotors = _rotors(system, motions, rates)
    teeth = _grouped([(name, value, (name,)) for name, value in mesh_orders(system, rates).items()])
    found = []
    for n in shafts:
        for name, value, parts in turning:
            bladed = [rotor for rotor in rotors if rotor.part in parts]
            if not bladed or n == 1:
                label = f"1P{bladed[0].mark}" if bladed else f"{n}× {name}"
                found.append(Order(label, n * value, SHAFT, n, tuple(parts), _on(system, motions, parts)))
    if BLADES in words:
        found += [
            Order(f"{n * r.blades}P{r.mark}", n * r.blades * r.speed, BLADES, n, r.parts)
            for r in rotors
            for n in range(1, PASSINGS + 1)
        ]
    for n in meshes:
        for name, value, own in teeth:
            label = f"mesh {name}" if n == 1 else f"{n}× mesh {name}"
            found.append(Order(label, n * value, MESH, n, (), own))
            for j in range(1, bands + 1):
                for shaft, rotation in _gears(system, motions, rates, own[0]):
                    for sign, side in ((-1.0, "−"), (1.0, "+")):
                        band = f"{label} {side} {j}× {shaft}"
                        found.append(Order(band, abs(n * value + sign * j * rotation), SIDEBAND, n, (), own))
    found += _of_loads(system, motions, rates) if LOADS in words else []
    found += [Order(f"{value:g}×", value, OTHER) for value in more]
    found += [Order(name, abs(value), OTHER) for name, value in (others or {}).items()]
    return tuple(sorted((o for o in found if o.value > 0.0), key=lambda o: o.value))


def _of_loads(system: System, motions: Motions, rates: Array) -> list[Order]:
    """Harmonics of torques and ripples of drives; torques on bodies of one speed are one order.

    Torques on one body whose vector sum is zero, such as those of equal cylinders on a rigid crankshaft, do
    not excite and are omitted.
    """
    groups = motions.groups
    alike: dict[tuple[tuple[int, ...], float, float], list[LoadOrder]] = {}
    for one in load_orders(system, motions.state, rates):
        parts = tuple(dict.fromkeys(groups.moves[groups.part[b]] for b in one.bodies))
        key = parts if one.ripple else ()
        alike.setdefault((key, round(one.order, 9), round(one.speed, 9)), []).append(one)
    found = []
    for (_, order, _), own in alike.items():
        ripple = own[0].ripple
        if len({one.bodies for one in own}) == 1 < len(own) and not ripple and rigid_sum(own) < CANCELLED:
            continue
        parts = tuple(dict.fromkeys(groups.moves[groups.part[b]] for one in own for b in one.bodies))
        names = ", ".join(one.name for one in own)
        if len(own) > FEW:
            names = f"{own[0].name} and {len(own) - 1} more"
        source = "ripple of the drive" if ripple else f"torque {names}"
        name = f"{order:.6g}× {groups.parts[parts[0]]} ({source})"
        found.append(
            Order(name, own[0].order * own[0].speed, RIPPLE if ripple else LOAD, 1, parts, (), tuple(own))
        )
    return found


@dataclass(frozen=True)
class _Rotor:
    """Turning wind rotor: part of its hub, parts of hub and blades, number of blades, speed, its name in
    orders if there are several."""

    part: int
    parts: tuple[int, ...]
    blades: int
    speed: float
    mark: str


def _rotors(system: System, motions: Motions, rates: Array) -> list[_Rotor]:
    """Wind rotors that turn."""
    if system.model is None:
        return []
    groups, speed, names = motions.groups, _speeds(motions, rates), system.layout.bodies
    table = system.program["body"]
    found = []
    for name, rotor in system.model.wind_rotors.items():
        hub = names.index(rotor.hub.partition(".")[0])
        if not speed[hub] > 0.0:
            continue
        carried = [hub]
        for b in range(hub + 1, len(table)):
            if int(table[b]["parent"]) in carried and not table[b]["state"]:
                carried.append(b)
        mark = f" {name}" if len(system.model.wind_rotors) > 1 else ""
        parts = tuple(dict.fromkeys(groups.part[b] for b in carried))
        found.append(_Rotor(groups.carried[hub], parts, rotor.blades, float(speed[hub]), mark))
    return found


def order_words(chosen: Orders) -> list[str]:
    """Single orders of a sequence or of a text.

    Examples
    --------
    >>> order_words("1x, mesh,2"), order_words(["mesh", 2])
    (['1x', 'mesh', '2'], ['mesh', '2'])
    """
    return [str(word).strip() for word in (chosen.split(",") if isinstance(chosen, str) else chosen)]


def read_orders(chosen: Orders) -> tuple[list[int], list[int], int, list[float]]:
    """Shaft orders, mesh harmonics, pairs of sidebands, numbers.

    Raises
    ------
    SolverError
        If a word is unknown.

    Examples
    --------
    >>> read_orders("1x,2x,mesh,0.5")
    ([1, 2], [1], 0, [0.5])
    """
    shafts, meshes, more, bands = [], [], [], 0
    for word in order_words(chosen):
        found = re.fullmatch(r"(\d*)(x|mesh|sidebands?)", word)
        number = int(found[1] or 1) if found else 0
        try:
            value = 0.0 if found else float(word)
        except ValueError:
            value = 0.0
        if found and number:
            if found[2] == "x":
                shafts.append(number)
            elif found[2] == "mesh":
                meshes.append(number)
            else:
                bands = max(bands, number)
        elif value > 0.0:
            more.append(value)
        else:
            raise SolverError(
                f"orders: {word!r} is not an order; use 1x, 2x (shafts), mesh, 2mesh, sidebands, 2sidebands, "
                "loads, blades, a number; fault frequencies: more_orders in Python, bearings in the command",
                INCONSISTENT,
            )
    return sorted(set(shafts)), sorted(set(meshes)), bands, more


def _grouped(rows: Sequence[tuple[str, float, tuple[Any, ...]]]) -> list[tuple[str, float, tuple[Any, ...]]]:
    """Rows of equal value as one, with a common name; values of zero are omitted."""
    groups: list[list[tuple[str, float, tuple[Any, ...]]]] = []
    for row in rows:
        if row[1] <= EQUAL:
            continue
        for group in groups:
            if abs(row[1] - group[0][1]) <= EQUAL * row[1]:
                group.append(row)
                break
        else:
            groups.append([row])
    return [
        (
            ", ".join(r[0] for r in g) if len(g) <= FEW else f"{g[0][0]} and {len(g) - 1} more",
            g[0][1],
            tuple(x for r in g for x in r[2]),
        )
        for g in groups
    ]


def _speeds(motions: Motions, rates: Array) -> Array:
    """Speed of every body about its axis in space with the reference body at 1 rad/s, shape (nb,)."""
    return np.abs(motions.of(rates[None].astype(np.complex128))[0][0, :, 5].real)


def _shafts(system: System, motions: Motions, rates: Array) -> list[tuple[str, float, tuple[int, ...]]]:
    """Shafts by speed: name, order and parts."""
    groups, speed = motions.groups, _speeds(motions, rates)
    rows = []
    body = system.program["body"]
    for part in dict.fromkeys(groups.carried):
        bodies = [b for b, p in enumerate(groups.carried) if p == part]
        if part >= 0 and groups.rotates[part] and any(_spins(body[b], rates) for b in bodies):
            rows.append((groups.parts[part], max(float(speed[b]) for b in bodies), (part,)))
    return _grouped(rows)


def _spins(body: np.void, rates: Array) -> bool:
    """Whether a body turns in its own bearings; a blade on a pitch bearing is only carried by its hub."""
    spin = int(body["spin"])
    return spin >= 0 and abs(float(rates[spin])) > EQUAL * float(np.abs(rates).max())


def _on(system: System, motions: Motions, parts: Sequence[int]) -> tuple[str, ...]:
    """Meshes with a gear on one of some parts."""
    carried = motions.groups.carried
    return tuple(
        name
        for name, record in zip(mesh_names(system), mesh_records(system), strict=True)
        if {carried[int(record["i"])], carried[int(record["j"])]} & set(parts)
    )


def _gears(system: System, motions: Motions, rates: Array, mesh: str) -> list[tuple[str, float]]:
    """Shafts of both gears of a mesh, and their rotation relative to the line of centres."""
    at = mesh_names(system).index(mesh)
    record, groups = mesh_records(system)[at], motions.groups
    order = mesh_orders(system, rates)[mesh]
    return [
        (groups.parts[groups.carried[int(record[end])]], order / abs(float(record[teeth])))
        for end, teeth in (("i", "z1"), ("j", "z2"))
        if record[end]
    ]
