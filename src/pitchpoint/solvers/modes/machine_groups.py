# SPDX-License-Identifier: Apache-2.0
"""Parts of a machine for energies and names of modes: stations of a shaft belong to their shaft."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from pitchpoint.elements import registry
from pitchpoint.elements.kind import FREE, MESH
from pitchpoint.solvers.gear_trains import turning_spins
from pitchpoint.solvers.modes.structures import Structures, structures_of
from pitchpoint.solvers.resistance import resisted_spins
from pitchpoint.solvers.stiffness_parts import ROTATION, Parts
from pitchpoint.system.elastic import modal_bodies
from pitchpoint.system.meshes import mesh_records

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def part_of(name: str, known: Sequence[str]) -> str:
    """Shaft or elastic body to which a station or modal coordinate belongs; other names are unchanged.

    Examples
    --------
    >>> part_of("rotor.12", ("rotor", "rotor.12")), part_of("pump.a", ("pump.a",))
    ('rotor', 'pump.a')
    """
    base, dot, number = name.rpartition(".")
    return base if dot and number.isdigit() and base in known else name


@dataclass(frozen=True)
class Groups:
    """Parts of a machine, and its elements by component.

    Parameters
    ----------
    parts
        Names of the parts (bodies, shafts with all stations), without ground.
    part
        Part of each body, shape (nb,); -1 for ground.
    carried
        Part that moves each body: bodies fixed to another one move with it, shape (nb,); -1 for ground.
    moves
        Part that carries each part: itself, or the one to which it is fixed.
    rotates
        Whether each part is free to rotate about its axis, or has gears.
    hidden
        Bodies with modal coordinates, and floating frames.
    deflects
        Part whose deflection or floating frame each coordinate moves, shape (nd,); -1 for others.
    components
        Names of the components with strain energy: `mesh stage`, `bearing front`, `shaft rotor`.
    component
        Component of each element.
    kinds
        Kind of each component: `mesh`, or the first word of its name.
    springs
        Whether each component is a spring, unlike weight and other loads.
    ends
        Parts connected by each component, without ground.
    bodies
        Bodies connected by the elements of each component, without ground.
    """

    parts: tuple[str, ...]
    part: tuple[int, ...]
    carried: tuple[int, ...]
    moves: tuple[int, ...]
    rotates: tuple[bool, ...]
    hidden: frozenset[int]
    deflects: tuple[int, ...]
    components: tuple[str, ...]
    component: tuple[int, ...]
    kinds: tuple[str, ...]
    springs: tuple[bool, ...]
    ends: tuple[tuple[int, ...], ...]
    bodies: tuple[frozenset[int], ...]


SHAFT = "shaft"
"""First word of a component that is made of the beams of one shaft."""


def groups_of(system: System, parts: Parts) -> Groups:
    """Parts and components of a system; `parts` is its linearisation by element."""
    body, names = system.program["body"], system.layout.bodies
    structures = structures_of(system)
    owner = [structures.bodies.get(name) or part_of(name, names) for name in names]
    listed = tuple(dict.fromkeys(owner[1:]))
    number = {name: k for k, name in enumerate(listed)}
    part = (-1, *(number[name] for name in owner[1:]))
    carried = [-1]
    for b in range(1, len(names)):
        parent = int(body[b]["spinner"]) or int(body[b]["parent"])
        follows = body[b]["n"] == 0 and parent and not body[b]["shares"]
        carried.append(carried[parent] if follows else part[b])
    still = _mounted(system)
    spins = {
        part[b]
        for b in range(1, len(names))
        if (body[b]["spin"] >= 0 and (body[b]["n"] == 1 or b not in still)) or body[b]["spinner"]
    }
    hidden = frozenset(modal_bodies(system))
    labels, kinds, ends = _components(parts, part, listed, hidden, structures)
    listed_components = tuple(dict.fromkeys(labels))
    place = {label: k for k, label in enumerate(listed_components)}
    first = {label: e for e, label in reversed(list(enumerate(labels)))}
    touched: dict[str, set[int]] = {label: set() for label in listed_components}
    for label, pair in zip(labels, parts.bodies, strict=True):
        touched[label] |= {int(b) for b in pair if b}
    return Groups(
        parts=listed,
        part=part,
        carried=tuple(carried),
        moves=tuple(carried[part.index(k)] for k in range(len(listed))),
        rotates=tuple(k in spins for k in range(len(listed))),
        hidden=hidden,
        deflects=_deflects(system, part, hidden),
        components=listed_components,
        component=tuple(place[label] for label in labels),
        kinds=tuple(kinds[first[label]] for label in listed_components),
        springs=tuple(
            parts.kinds[k] != ROTATION and registry.find(parts.kinds[k]).names_modes
            for k in (first[label] for label in listed_components)
        ),
        ends=tuple(ends[first[label]] for label in listed_components),
        bodies=tuple(frozenset(touched[label]) for label in listed_components),
    )


def _deflects(system: System, part: Sequence[int], hidden: frozenset[int]) -> tuple[int, ...]:
    """Part of each coordinate of an elastic body, -1 for others."""
    body = system.program["body"]
    found = [-1] * len(system.layout.coordinates)
    for b in hidden:
        for d in range(int(body[b]["dof"]), int(body[b]["dof"] + body[b]["n"])):
            found[d] = part[b]
    return tuple(found)


def _mounted(system: System) -> set[int]:
    """Bodies that do not rotate: on mounts, or held in rotation and with bearings of other bodies."""
    body = system.program["body"]
    meshed = {int(r[end]) for r in mesh_records(system) for end in "ij"}
    held, free = set(resisted_spins(system)), turning_spins(system)
    carries: set[int] = set()
    for kind, records in system.records.items():
        described = registry.find(kind)
        if "j" in (records.dtype.names or ()):
            carries |= {int(r["j"]) for r in records if described.spins_of(r) == FREE}
    return {
        b
        for b in range(1, len(body))
        if b not in meshed and ((spin := int(body[b]["spin"])) in held or (spin not in free and b in carries))
    }


def _components(
    parts: Parts,
    part: Sequence[int],
    names: Sequence[str],
    hidden: frozenset[int],
    structures: Structures,
) -> tuple[list[str], list[str], list[tuple[int, ...]]]:
    """Label, kind and connected parts of the component of each element."""
    labels, kinds, ends = [], [], []
    for label, kind, pair in zip(parts.elements, parts.kinds, parts.bodies, strict=True):
        own = tuple(dict.fromkeys(part[b] for b in pair if b))
        if kind != ROTATION:
            label = structures.component(kind, label)
        word = label.partition(" ")[0]
        within = pair.all() and pair[0] != pair[1] and len(own) == 1
        if within and hidden.isdisjoint(pair.tolist()) and names[own[0]] not in structures.bodies.values():
            label, word = f"{SHAFT} {names[own[0]]}", SHAFT
        elif kind != ROTATION and registry.find(kind).role == MESH:
            word = MESH
        labels.append(label)
        kinds.append(word)
        ends.append(own)
    return labels, kinds, ends
