# SPDX-License-Identifier: Apache-2.0
"""Shafts and bodies with axial loads whose bearings do not hold them along their axis."""

from __future__ import annotations

import dataclasses
from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from pitchpoint.model.components.bearing_geometry import FLOATING, NEGATIVE, POSITIVE
from pitchpoint.model.components.law import Constant
from pitchpoint.model.frames import GROUND, body_frame, split
from pitchpoint.model.rings import ring_bodies, rings_of

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

AXIAL = 1e-9
"""Axial share of a force or of gravity up to which it is round-off of the axes."""
NOT_HOLDING = (
    *("bearings", "rolling_bearings", "plain_bearings", "couplings", "meshes", "bevel_meshes"),
    *("gears", "bevel_gears", "bodies", "shafts", "planetary_stages", "loads", "unbalances", "sensors"),
    *("blocks", "controllers", "scenarios", "parameters", "torsion_springs", "torsion_maxwells", "clutches"),
    *("joints", "materials", "load_cases"),
)
"""Sections that hold no body along its axis, or are considered by themselves."""


class AxialSupport(NamedTuple):
    """Bearings of a body that do not hold it along its axis.

    Attributes
    ----------
    body
        Name of the body or shaft.
    bearings
        Names of all its bearings.
    side
        Direction along z of the body in which they support axial forces: 1 or -1; 0: in none.
    """

    body: str
    bearings: tuple[str, ...]
    side: int


def without_axial_support(model: Model) -> Iterator[AxialSupport]:
    """Bodies on bearings, with axial loads, that are held along their axis in one direction or not at all.

    Bodies with springs, contacts, axially stiff couplings or joints are assumed to be held by them; a joint
    that leaves all six directions to the bearings, as that of planets with `motion: free`, does not hold.
    Axial loads are those of helical and bevel gears, of spur gears on shafts that bend, of gravity and of
    forces. Gears of different helix angle that mesh with the same body, such as double helical gears, hold
    their body themselves.
    """
    if model.others:
        return
    on_pins = on_bearings_only(model)
    held = held_otherwise(model, on_pins)
    bearings = _bearings(model, on_pins)
    for name, body in model.bodies.items():
        free = body.moves == "free" or name in on_pins
        if not free or name in held or not bearings.get(name) or not _is_loaded(model, name):
            continue
        sides = {side for found in bearings[name].values() for side in found}
        if len(sides) < 2:
            yield AxialSupport(name, tuple(bearings[name]), *(sides or {0}))


def _bearings(model: Model, on_pins: Collection[str]) -> dict[str, dict[str, tuple[int, ...]]]:
    """Bearings of every body, with the directions of the axial forces on it that they support.

    A bearing between a pin and a planet of `on_pins` is that of the planet, which may contain its outer ring.
    """
    found: dict[str, dict[str, tuple[int, ...]]] = {}
    for name, linear in model.bearings.items():
        stiff = any(value != 0.0 for value in linear.stiffness.matrix6()[2])
        found.setdefault(linear.body, {})[name] = (1, -1) if stiff else ()
    for name, plain in model.plain_bearings.items():
        one, two = ring_bodies(plain)
        found.setdefault(two if two in on_pins else one, {})[name] = ()
    for name, rolling in model.rolling_bearings.items():
        inner, outer = rings_of(model, rolling)
        own, sense = (outer.body, -1.0) if outer.body in on_pins else (inner.body, 1.0)
        along = int(np.sign(sense * outer.axes[:, 2] @ body_frame(model, own)[1][:, 2]))
        absorbs = rolling.geometry.absorbs
        ways = {FLOATING: (), POSITIVE: (along,), NEGATIVE: (-along,)}.get(absorbs, (1, -1))
        found.setdefault(own, {})[name] = ways
    return found


def on_bearings_only(model: Model) -> set[str]:
    """Bodies whose joints leave all directions to their bearings, such as planets with `motion: free`."""
    return {
        name
        for name, body in model.bodies.items()
        if body.joint is not None and model.joints[body.joint].type == "shaft"
    }


def held_otherwise(model: Model, on_pins: Collection[str]) -> set[str]:
    """Bodies that other elements than their bearings may hold along their axis, housings included.

    `on_pins`: bodies that their joints do not hold.
    """
    found = {
        b for j in model.joints.values() for b in (split(end)[0] for end in j.bodies) if b not in on_pins
    }
    for group in dataclasses.fields(model):
        parts = getattr(model, group.name, None)
        if group.name not in NOT_HOLDING and isinstance(parts, Mapping):
            for part in parts.values():
                found |= {split(text)[0] for text in _texts(part)}
    for coupling in model.couplings.values():
        if any(value != 0.0 for value in coupling.stiffness.matrix6()[2]):
            found |= set(coupling.bodies)
    for bearing in model.bearings.values():
        found.add(split(bearing.housing or GROUND)[0])
    outer = {ring_bodies(rolling)[1] for rolling in model.rolling_bearings.values()}
    outer |= {ring_bodies(plain)[1] for plain in model.plain_bearings.values()}
    found |= outer - set(on_pins)
    return found


def _texts(part: Any) -> Iterator[str]:
    """All texts in a component, its lists and nested components."""
    if isinstance(part, str):
        yield part
    elif isinstance(part, tuple):
        for entry in part:
            yield from _texts(entry)
    elif dataclasses.is_dataclass(part):
        for each in dataclasses.fields(part):
            yield from _texts(getattr(part, each.name))


def _is_loaded(model: Model, name: str) -> bool:
    """Whether gears, gravity or forces load a body along its axis."""
    z = body_frame(model, name)[1][:, 2]
    if model.gravity is not None and abs(z @ np.array(model.gravity)) > AXIAL * np.linalg.norm(model.gravity):
        return True
    for load in model.loads.values():
        if load.body == name and load.force is not None and _pushes(load, z):
            return True
    return bool(model.bodies[name].bevel_gears) or is_pushed_by_teeth(model, name)


def _pushes(load: Any, z: Any) -> bool:
    """Whether a force may have a component along an axis in the world."""
    if not all(isinstance(part, Constant) for part in load.force):
        return True
    force = np.array([part.value for part in load.force])
    along = force @ z if load.along == "world" else force[2]
    return bool(abs(along) > AXIAL * np.linalg.norm(force))


def is_pushed_by_teeth(model: Model, name: str) -> bool:
    """Whether cylindrical gears push a body along its axis, and do not hold it at the same time.

    Spur gears push a shaft as it bends: the normal of tilted flanks has an axial component.
    """
    slopes: dict[str | None, set[float]] = {}
    for mesh in model.meshes.values():
        one, two = mesh.gears
        for own, other in ((one, two), (two, one)):
            if own in model.bodies[name].gears:
                slopes.setdefault(model.body_of(other), set()).add(round(model.gears[own].geometry.beta, 9))
    if any(len(found) > 1 for found in slopes.values()):
        return False
    return any(name in model.shafts or beta != 0.0 for found in slopes.values() for beta in found)
