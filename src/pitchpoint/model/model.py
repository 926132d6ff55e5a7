# SPDX-License-Identifier: Apache-2.0
"""The model: what stands in drawings and data sheets, frozen and valid by construction."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

from pitchpoint.core.errors import ModelError, Problem
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.coupling import Coupling
from pitchpoint.model.components.damping import Damping
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.load import Load
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.keys import component, derived, key, text
from pitchpoint.model.scenario import Scenario

if TYPE_CHECKING:
    from pitchpoint.geometry.gear import CylindricalGear
    from pitchpoint.geometry.pair import GearPair
    from pitchpoint.model.inertia import BodyInertia
    from pitchpoint.model.phasing import Phasing

V = TypeVar("V")


class Frozen(dict[str, V]):
    """A dictionary that refuses to be changed."""

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("a model is frozen; use model.replace(path, value)")

    __setitem__ = __delitem__ = update = pop = popitem = clear = setdefault = _refuse  # type: ignore[assignment]
    __ior__ = _refuse  # type: ignore[assignment]

    def __reduce__(self) -> tuple[type, tuple[dict[str, V]]]:
        return type(self), (dict(self),)


@dataclass(frozen=True, kw_only=True)
class Model:
    """Gears, bodies, meshes, supports, loads and scenarios of one machine.

    Making a `Model` checks it; every problem is reported in one `ModelError`. All values are SI and radians.
    """

    title: str = text("what the file describes", "")
    gears: Mapping[str, Gear] = key("components", "the gears by name", {}, of=Gear)
    bodies: Mapping[str, Body] = key("components", "bodies that carry the gears", {}, of=Body)
    meshes: Mapping[str, Mesh] = key("components", "pairs of gears in mesh", {}, of=Mesh)
    bearings: Mapping[str, Bearing] = key("components", "bearings between bodies and ground", {}, of=Bearing)
    couplings: Mapping[str, Coupling] = key("components", "couplings between bodies", {}, of=Coupling)
    loads: Mapping[str, Load] = key("components", "torques and forces on bodies", {}, of=Load)
    damping: Damping | None = component(Damping, "Rayleigh and modal damping of the whole model")
    scenarios: Mapping[str, Scenario] = key("components", "what is done to the model", {}, of=Scenario)
    file: str | None = derived()
    """Path of the file the model came from."""

    # properties: pairs, geometry, phasing, body_inertia(name), body_of(gear), start_speeds(scenario)
