# SPDX-License-Identifier: Apache-2.0
"""Flexible rims of internal gears: modes, hidden bodies of their coordinates, shapes and supports."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements.flexible_body import GROUP, LOADS, flexible_row, modal_bodies
from pitchpoint.elements.kind import RIM
from pitchpoint.elements.mesh.rim_room import rim_room
from pitchpoint.model.inertia import gear_by_geometry
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.ring_modes import (
    RingMode,
    RingSection,
    coordinate_names,
    ring_invariants,
    ring_mode,
    ring_terms,
    support_shapes,
    support_stiffness,
)

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

SPIN = 5
"""Load with geometric stiffness: square of the spin about the z axis."""


@dataclass(frozen=True)
class RimParts:
    """Bodies and records of one flexible rim.

    Parameters
    ----------
    name
        Name of the element.
    bodies
        Hidden bodies of the modal coordinates.
    flexible, guides
        Records of the kinds flexible_body and guide.
    """

    name: str
    bodies: tuple[Body, ...]
    flexible: NDArray[np.void]
    guides: NDArray[np.void]


# --- ring of a gear -----------------------------------------------------------------------------------------
def ring_section(gear: Gear) -> RingSection:
    """Rim of an internal gear from the root circle outwards; the teeth add mass only.

    The outer radius is half the outside diameter `bore_diameter`, or follows from `rim_thickness`.
    """
    root = 0.5 * abs(gear.geometry.d_f)
    outer = 0.5 * gear.bore_diameter or root + (gear.rim_thickness or 0.0)
    data = gear.material_data
    bare = RingSection(
        inner=root,
        outer=outer,
        width=gear.face_width,
        youngs_modulus=data.youngs_modulus,
        poisson_ratio=data.poisson_ratio,
        density=data.density,
    )
    whole, polar, _ = gear_by_geometry(gear)
    mass = whole - bare.mass
    radius = math.sqrt((polar - 0.5 * bare.mass * (root**2 + outer**2)) / mass)
    return bare.with_teeth(mass, radius)


def rim_modes(gear: Gear) -> tuple[RingMode, ...]:
    """Modes of the flexible rim of a gear, free of supports; empty for a rigid rim."""
    if gear.flexible_rim is None:
        return ()
    return _modes(ring_section(gear), gear.flexible_rim.waves)


@lru_cache(maxsize=32)
def _modes(section: RingSection, waves: int) -> tuple[RingMode, ...]:
    return tuple(ring_mode(section, n) for n in range(2, waves + 1))


def supported_stiffness(gear: Gear) -> Array:
    """Stiffness matrix of the coordinates with the supports, on a housing that does not move [N/m]."""
    modes, part = rim_modes(gear), gear.flexible_rim
    K = np.diag(np.repeat([m.stiffness for m in modes], 2))
    if part is None or part.supports is None:
        return K
    given = part.supports
    section = ring_section(gear)
    terms = ring_terms(modes, section.radius, section.outer)
    return K + support_stiffness(support_shapes(terms, given.places), given.radial, given.tangential)


def rim_facts(model: Model) -> dict[str, dict[str, Any]]:
    """Natural frequencies of all flexible rims without planets, their bodies and housings at rest [Hz].

    Returns
    -------
    dict
        By gear: `waves`, `free` frequencies, and `supported` pairs of frequencies, empty without supports. A
        supported pair has the coordinates of its number of waves as its largest share.
    """
    found = {}
    for body in model.bodies:
        for name in rims_of(model, body):
            gear = model.gears[name]
            modes = rim_modes(gear)
            held = gear.flexible_rim is not None and gear.flexible_rim.supports is not None
            found[name] = {
                "waves": [m.waves for m in modes],
                "free": [m.frequency for m in modes],
                "supported": _supported(gear, modes) if held else [],
            }
    return found


def _supported(gear: Gear, modes: Sequence[RingMode]) -> list[list[float]]:
    """Frequencies of a rim on its supports by the number of waves [Hz]."""
    from scipy.linalg import eigh

    mass = np.repeat([m.mass for m in modes], 2)
    values, shapes = eigh(supported_stiffness(gear), np.diag(mass))
    share = (shapes**2 * mass[:, None]).reshape(len(modes), 2, -1).sum(axis=1)
    of = np.argmax(share, axis=0)
    frequency = np.sqrt(np.maximum(values, 0.0)) / math.tau
    return [frequency[of == k].tolist() for k in range(len(modes))]


# --- records ------------------------------------------------------------------------------------------------
def rims_of(model: Model, body: str) -> list[str]:
    """Gears with flexible rims on a body."""
    if body in model.shafts or body in model.elastic_bodies:
        return []
    return [gear for gear in model.bodies[body].gears if model.gears[gear].flexible_rim is not None]


def rim_count(model: Model, body: str) -> int:
    """Number of hidden bodies of the flexible rims of a body; they follow it in the records."""
    return sum(_groups(model, gear) for gear in rims_of(model, body))


def _groups(model: Model, gear: str) -> int:
    return -(-2 * len(rim_modes(model.gears[gear])) // GROUP)


def _hidden(model: Model, body: str, gear: str, number: int) -> tuple[int, ...]:
    """Numbers of the hidden bodies of a rim; `number` is that of its body."""
    rims = rims_of(model, body)
    first = number + 1 + sum(_groups(model, other) for other in rims[: rims.index(gear)])
    return tuple(range(first, first + _groups(model, gear)))


def coordinates_of_rim(model: Model, gear: str) -> list[str]:
    """Names of the coordinates of a flexible rim in results: BODY.1.cos2 and so on."""
    body = str(model.body_of(gear))
    groups = _hidden(model, body, gear, 0)
    words = coordinate_names(rim_modes(model.gears[gear]))
    return [f"{body}.{groups[k // GROUP]}.{word}" for k, word in enumerate(words)]


def rim_parts(model: Model, body: str, number: int) -> list[RimParts]:
    """Bodies and records of all flexible rims of a body with this number."""
    return [_parts(model, body, gear, number) for gear in rims_of(model, body)]


def _parts(model: Model, body: str, name: str, frame: int) -> RimParts:
    gear, hidden = model.gears[name], _hidden(model, body, name, frame)
    modes = rim_modes(gear)
    words = coordinate_names(modes)
    bodies, guides = modal_bodies(body, len(words), hidden[0], words)
    named = [replace(b, name=f"{body}.{k - frame}") for k, b in zip(hidden, bodies, strict=True)]
    mass = np.repeat([m.mass for m in modes], 2)
    ratio = gear.flexible_rim.damping_ratio if gear.flexible_rim is not None else 0.0
    stiffening = np.zeros((LOADS, mass.size, mass.size))
    stiffening[SPIN] = np.diag(np.repeat([m.stretch for m in modes], 2))
    row = flexible_row(
        ring_invariants(modes),
        np.repeat([m.stiffness for m in modes], 2),
        frame=frame,
        hidden=hidden,
        damping=2.0 * ratio * np.sqrt(np.diag(supported_stiffness(gear)) * mass),
        stiffening=stiffening,
    )
    return RimParts(f"{name}.rim", tuple(named), row, guides)


def rims(model: Model, numbers: Mapping[str, int]) -> list[RimParts]:
    """All flexible rims of a model."""
    return [part for body in model.mechanism.seats for part in rim_parts(model, body, numbers[body])]


def set_rim(row: Any, model: Model, name: str, keep: Callable[[Array], int]) -> None:
    """Set the fields of the flexible rim of gear 2 of a mesh record; unchanged for a rigid rim."""
    gear = model.meshes[name].gears[1]
    part = model.gears[gear]
    if part.flexible_rim is None:
        return
    terms = ring_terms(rim_modes(part), ring_section(part).radius, 0.0)
    row["rim"] = keep(rim_room(terms))
    set_hidden(row, model, str(model.body_of(gear)), gear, int(row["j"]))


def set_hidden(row: Any, model: Model, body: str, gear: str, number: int) -> None:
    """Set the number of coordinates of a rim and their hidden bodies; `number` is that of its body."""
    row["n_rim"] = 2 * len(rim_modes(model.gears[gear]))
    for field, hidden in zip(RIM[2:], _hidden(model, body, gear, number), strict=False):
        row[field] = hidden
