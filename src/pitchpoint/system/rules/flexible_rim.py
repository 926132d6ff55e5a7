# SPDX-License-Identifier: Apache-2.0
"""Flexible rims of internal gears: modes, hidden bodies of their coordinates, shapes and supports."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import CompileError, Message, ModelError, PitchpointError
from pitchpoint.elements.flexible_body import GROUP, LOADS, flexible_row, modal_bodies
from pitchpoint.elements.kind import RIM
from pitchpoint.elements.mesh.rim_workspace import rim_workspace
from pitchpoint.model.frames import body_frame
from pitchpoint.model.inertia import gear_by_geometry
from pitchpoint.model.mechanism import axial_offset, seat_frame
from pitchpoint.multibody.bodies import Body
from pitchpoint.multibody.rim import Rim, element_rim, moved_integrals, ring_rim, terms_at, turned_terms
from pitchpoint.multibody.ring_modes import (
    RingMode,
    RingSection,
    ring_mode,
    support_shapes,
    support_stiffness,
    waves_of,
)
from pitchpoint.system.rules.structure_files import node_near, read_structure

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


def rim_of(gear: Gear) -> Rim:
    """Flexible rim of a gear, free of supports.

    Raises
    ------
    PitchpointError, OSError
        If its finite elements are not valid.
    """
    part = gear.flexible_rim
    assert part is not None
    if part.finite_elements is None:
        return _ring(ring_section(gear), part.waves)
    given, shape = part.finite_elements, gear.geometry
    near = 0.5 * abs(shape.d_a), 0.5 * abs(shape.d_f) + given.depth * shape.m_n, 0.5 * gear.face_width
    held = tuple((name, marker.position) for name, marker in given.held_nodes.items())
    alpha, beta = shape.alpha_t, shape.beta_b
    weights = (math.sin(alpha) ** 2, math.cos(alpha) ** 2, math.tan(beta) ** 2)
    stamp = Path(given.file).stat().st_mtime_ns
    return _elements(given.file, stamp, held, given.modes, weights, part.waves, near)


def _rim_in(model: Model, name: str) -> Rim:
    """Flexible rim of a gear of a model, with problems of its files at the keys of the model."""
    try:
        return rim_of(model.gears[name])
    except (PitchpointError, OSError, MemoryError, np.linalg.LinAlgError, RuntimeError) as fault:
        at = f"gears.{name}.flexible_rim.finite_elements"
        head, _, rest = str(fault).partition(": ")
        if isinstance(fault, CompileError) and head.startswith("held_nodes."):
            raise ModelError([Message(f"{at}.{head}", rest)], model.file) from None
        raise ModelError([Message(at, f"cannot be used: {fault}")], model.file) from None


def ring_modes(gear: Gear) -> tuple[RingMode, ...]:
    """Modes of the rim of a gear in closed form, free of supports."""
    part, section = gear.flexible_rim, ring_section(gear)
    return tuple(ring_mode(section, n) for n in range(2, (part.waves if part is not None else 1) + 1))


@lru_cache(maxsize=32)
def _ring(section: RingSection, waves: int) -> Rim:
    return ring_rim([ring_mode(section, n) for n in range(2, waves + 1)], section.radius)


@lru_cache(maxsize=8)
def _elements(
    file: str,
    stamp: int,
    held: tuple[tuple[str, tuple[float, float, float]], ...],
    modes: int,
    weights: tuple[float, float, float],
    waves: int,
    near: tuple[float, float, float],
) -> Rim:
    """Rim from a file; `stamp` is its modification time and part of the cache key."""
    structure = read_structure((file,))
    nodes = [node_near(structure, f"held_nodes.{word}", np.array(place)) for word, place in held]
    return element_rim(structure, nodes, modes, weights, waves=waves, near=near)


def supported_stiffness(gear: Gear) -> Array:
    """Stiffness matrix of the coordinates with the supports, on a housing that does not move [N/m]."""
    rim, part = rim_of(gear), gear.flexible_rim
    K = np.diag(rim.stiffness)
    if part is None or part.supports is None:
        return K
    given = part.supports
    shapes = support_shapes(terms_at(rim.terms, ring_section(gear).outer), given.places)
    return K + support_stiffness(shapes, given.radial, given.tangential)


def rim_facts(model: Model) -> dict[str, dict[str, Any]]:
    """Natural frequencies of all flexible rims without planets, their bodies and housings at rest [Hz].

    Returns
    -------
    dict
        By gear: `waves` of each frequency, 0 for finite elements, frequencies `free` of supports, and
        `supported`: lists of frequencies, empty without supports. A supported mode has the coordinates of its
        number of waves as its largest share.
    """
    found = {}
    for body in model.bodies:
        for name in rims_of(model, body):
            gear = model.gears[name]
            rim = _rim_in(model, name)
            waves = [waves_of(word) for word in rim.words]
            single = [k for k, n in enumerate(waves) if n == 0 or n not in waves[:k]]
            held = gear.flexible_rim is not None and gear.flexible_rim.supports is not None
            found[name] = {
                "waves": [waves[k] for k in single],
                "free": [float(rim.frequency[k]) for k in single],
                "supported": _supported(gear, waves) if held else [],
            }
    return found


def _supported(gear: Gear, waves: Sequence[int]) -> list[list[float]]:
    """Frequencies of a rim on its supports by the number of waves [Hz]."""
    from scipy.linalg import eigh

    mass = np.diag(rim_of(gear).integrals.modal)
    values, shapes = eigh(supported_stiffness(gear), np.diag(mass))
    numbers = np.array(waves)
    each = list(dict.fromkeys(waves))
    share = np.array([(shapes**2 * mass[:, None])[numbers == n].sum(axis=0) for n in each])
    of = np.argmax(share, axis=0)
    frequency = np.sqrt(np.maximum(values, 0.0)) / math.tau
    return [frequency[of == k].tolist() for k in range(len(each))]


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
    return -(-len(_rim_in(model, gear).words) // GROUP)


def _hidden(model: Model, body: str, gear: str, number: int) -> tuple[int, ...]:
    """Numbers of the hidden bodies of a rim; `number` is that of its body."""
    rims = rims_of(model, body)
    first = number + 1 + sum(_groups(model, other) for other in rims[: rims.index(gear)])
    return tuple(range(first, first + _groups(model, gear)))


def coordinates_of_rim(model: Model, gear: str) -> list[str]:
    """Names of the coordinates of a flexible rim in results: BODY.1.cos2 and so on."""
    body = str(model.body_of(gear))
    groups = _hidden(model, body, gear, 0)
    words = rim_of(model.gears[gear]).words
    return [f"{body}.{groups[k // GROUP]}.{word}" for k, word in enumerate(words)]


def axes_of_body(model: Model, body: str) -> Array:
    """Axes of a body in those of its frame, columns (3, 3)."""
    return np.asarray(seat_frame(model, model.mechanism.seats[body])[1].T @ body_frame(model, body)[1])


def _middle(model: Model, body: str, gear: str) -> float:
    """Position of the middle of a gear along the z axis of the frame of its body [m]."""
    return model.bodies[body].gears[gear] + (axial_offset(model, model.mechanism.seats[body]) or 0.0)


def terms_of_rim(model: Model, body: str, gear: str) -> Array:
    """Motion of the sections of a rim in the axes of the frame of its body; see `multibody.rim`."""
    turned = axes_of_body(model, body)
    return turned_terms(rim_of(model.gears[gear]).terms, math.atan2(turned[1, 0], turned[0, 0]))


def rim_parts(model: Model, body: str, number: int) -> list[RimParts]:
    """Bodies and records of all flexible rims of a body with this number."""
    return [_parts(model, body, gear, number) for gear in rims_of(model, body)]


def _parts(model: Model, body: str, name: str, frame: int) -> RimParts:
    gear, hidden = model.gears[name], _hidden(model, body, name, frame)
    rim, n = rim_of(gear), len(rim_of(gear).words)
    bodies, guides = modal_bodies(body, n, hidden[0], rim.words)
    named = [replace(b, name=f"{body}.{k - frame}") for k, b in zip(hidden, bodies, strict=True)]
    ratio = gear.flexible_rim.damping_ratio if gear.flexible_rim is not None else 0.0
    stiffening = np.zeros((LOADS, n, n))
    stiffening[SPIN] = np.diag(rim.stretch)
    row = flexible_row(
        moved_integrals(rim.integrals.turned(axes_of_body(model, body).T), _middle(model, body, name)),
        rim.stiffness,
        frame=frame,
        hidden=hidden,
        damping=2.0 * ratio * np.sqrt(np.diag(supported_stiffness(gear)) * np.diag(rim.integrals.modal)),
        stiffening=stiffening,
        gravity=model.gravity or (0.0, 0.0, 0.0),
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
    body = str(model.body_of(gear))
    row["rim"] = keep(rim_workspace(terms_of_rim(model, body, gear)))
    set_hidden(row, model, body, gear, int(row["j"]))


def set_hidden(row: Any, model: Model, body: str, gear: str, number: int) -> None:
    """Set the number of coordinates of a rim and their hidden bodies; `number` is that of its body."""
    row["n_rim"] = len(rim_of(model.gears[gear]).words)
    for field, hidden in zip(RIM[2:], _hidden(model, body, gear, number), strict=False):
        row[field] = hidden
