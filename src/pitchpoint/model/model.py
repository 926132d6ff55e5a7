# SPDX-License-Identifier: Apache-2.0
"""The model: what stands in drawings and data sheets, frozen and valid by construction."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

from pitchpoint.core.errors import ModelError, Problem
from pitchpoint.model.bevel_places import assemble_bevels, bevel_gap, bevel_pair
from pitchpoint.model.components.actuator import ACTUATORS, Actuator
from pitchpoint.model.components.beam import Beam
from pitchpoint.model.components.bearing import Bearing
from pitchpoint.model.components.bevel_gear import BevelGear
from pitchpoint.model.components.bevel_mesh import BevelMesh
from pitchpoint.model.components.block import BLOCKS, Block
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.bushing import Bushing
from pitchpoint.model.components.clutch import Clutch
from pitchpoint.model.components.contact import CamContact, CurveContact, SurfaceContact
from pitchpoint.model.components.controller import CONTROLLERS, Controller
from pitchpoint.model.components.coupling import Coupling
from pitchpoint.model.components.damping import Damping
from pitchpoint.model.components.elastic_body import ElasticBody
from pitchpoint.model.components.gear import Gear
from pitchpoint.model.components.joint import Joint
from pitchpoint.model.components.load import Load
from pitchpoint.model.components.marker import Triple
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.components.ratio import Ratio
from pitchpoint.model.components.rod import Rod
from pitchpoint.model.components.rolling_bearing import PlainBearing, RollingBearing
from pitchpoint.model.components.sensor import SENSORS, Sensor
from pitchpoint.model.components.shaft import Shaft
from pitchpoint.model.components.spring import Maxwell, Spring
from pitchpoint.model.components.torsion_spring import TorsionMaxwell, TorsionSpring
from pitchpoint.model.components.unbalance import Unbalance
from pitchpoint.model.inertia import BodyInertia, body_inertia
from pitchpoint.model.keys import (
    Place,
    component,
    defaults_of,
    derived,
    key,
    keys_of,
    quantities,
    text,
)
from pitchpoint.model.mechanism import Mechanism
from pitchpoint.model.pair_check import gap
from pitchpoint.model.parts import Parts, carriers_of
from pitchpoint.model.phasing import Phasing, assemble
from pitchpoint.model.read import Reader
from pitchpoint.model.recheck import recheck
from pitchpoint.model.replace import replace_at
from pitchpoint.model.scenario import Scenario
from pitchpoint.model.shafts import own_bodies, station_names, stations_of
from pitchpoint.model.speed_ratios import start_speeds, sweep_meshes
from pitchpoint.model.validate import check

if TYPE_CHECKING:
    from pitchpoint.geometry.bevel_pair import BevelPair
    from pitchpoint.geometry.gear_pair import GearPair

V = TypeVar("V")


class Frozen(dict[str, V]):
    """A dictionary that refuses to be changed."""

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("a model is frozen; use model.replace(path, value)")

    __setitem__ = __delitem__ = update = pop = popitem = clear = setdefault = _refuse
    __ior__ = _refuse

    def __reduce__(self) -> tuple[type, tuple[dict[str, V]]]:
        return type(self), (dict(self),)


@dataclass(frozen=True, kw_only=True)
class Model:
    """Gears, bodies, meshes, supports, loads and scenarios of one machine.

    Making a `Model` checks it; every problem is reported in one `ModelError`. All values are SI and radians.
    """

    title: str = text("what the file describes", "")
    gravity: Triple | None = quantities(
        "acceleration",
        "acceleration of gravity along the axes of the world; without it nothing has weight",
        None,
        length=(3, 3),
        sample="[0, 0, -9.81 m/s^2]",
    )
    gears: Mapping[str, Gear] = key("components", "the gears by name", {}, of=Gear)
    bevel_gears: Mapping[str, BevelGear] = key(
        "components", "the bevel gears by name", {}, of=BevelGear, later=True
    )
    bodies: Mapping[str, Body] = key("components", "bodies, with the gears that they carry", {}, of=Body)
    shafts: Mapping[str, Shaft] = key("components", "elastic shafts, with the gears on them", {}, of=Shaft)
    elastic_bodies: Mapping[str, ElasticBody] = key(
        "components", "elastic bodies from finite-element matrices", {}, of=ElasticBody
    )
    joints: Mapping[str, Joint] = key("components", "joints between bodies", {}, of=Joint)
    springs: Mapping[str, Spring] = key("components", "springs and dampers between points", {}, of=Spring)
    maxwells: Mapping[str, Maxwell] = key(
        "components", "springs and dampers one behind the other between points", {}, of=Maxwell
    )
    torsion_springs: Mapping[str, TorsionSpring] = key(
        "components", "springs and dampers about the axes of bodies", {}, of=TorsionSpring
    )
    torsion_maxwells: Mapping[str, TorsionMaxwell] = key(
        "components",
        "springs and dampers one behind the other about the axes of bodies",
        {},
        of=TorsionMaxwell,
    )
    bushings: Mapping[str, Bushing] = key("components", "elastic bushings", {}, of=Bushing)
    beams: Mapping[str, Beam] = key("components", "elastic beams between two places", {}, of=Beam)
    clutches: Mapping[str, Clutch] = key("components", "clutches and brakes", {}, of=Clutch)
    rolling_bearings: Mapping[str, RollingBearing] = key(
        "components", "bearings with their rolling elements", {}, of=RollingBearing
    )
    plain_bearings: Mapping[str, PlainBearing] = key(
        "components", "bearings with clearance", {}, of=PlainBearing
    )
    cam_contacts: Mapping[str, CamContact] = key(
        "components", "points and rollers on curves", {}, of=CamContact
    )
    curve_contacts: Mapping[str, CurveContact] = key(
        "components", "curves on curves in one plane", {}, of=CurveContact
    )
    surface_contacts: Mapping[str, SurfaceContact] = key(
        "components", "surfaces on surfaces in space", {}, of=SurfaceContact
    )
    unbalances: Mapping[str, Unbalance] = key("components", "point masses on bodies", {}, of=Unbalance)
    rods: Mapping[str, Rod] = key("components", "rods that hold two points at a distance", {}, of=Rod)
    ratios: Mapping[str, Ratio] = key("components", "fixed ratios between coordinates", {}, of=Ratio)
    meshes: Mapping[str, Mesh] = key("components", "pairs of gears in mesh", {}, of=Mesh)
    bevel_meshes: Mapping[str, BevelMesh] = key(
        "components", "pairs of bevel gears in mesh", {}, of=BevelMesh, later=True
    )
    bearings: Mapping[str, Bearing] = key("components", "bearings between bodies and ground", {}, of=Bearing)
    couplings: Mapping[str, Coupling] = key("components", "couplings between bodies", {}, of=Coupling)
    loads: Mapping[str, Load] = key("components", "torques and forces on bodies", {}, of=Load)
    sensors: Mapping[str, Sensor] = key("components", "signals of motion and loads", {}, of=SENSORS)
    blocks: Mapping[str, Block] = key("components", "signals of other signals", {}, of=BLOCKS)
    controllers: Mapping[str, Controller] = key(
        "components", "sampled controllers, which read and make signals", {}, of=CONTROLLERS
    )
    actuators: Mapping[str, Actuator] = key(
        "components", "torques and forces that signals make", {}, of=ACTUATORS
    )
    damping: Damping | None = component(Damping, "Rayleigh and modal damping of the whole model")
    scenarios: Mapping[str, Scenario] = key("components", "what is done to the model", {}, of=Scenario)
    file: str | None = derived()
    """Path of the file the model came from."""
    lines: Mapping[Place, int] | None = derived()
    """Lines of the keys that it has there, counted from 1."""
    changed: bool | None = derived()
    """Whether values have been replaced since: the file no longer says what the model is."""
    allow_code: bool = derived(False)
    """Whether it was read with permission to name Python functions; `replace` then permits them too."""
    pairs: Mapping[str, GearPair] = derived()
    """Pair of every mesh at its centre distance; the common face width is what overlaps."""
    mechanism: Mechanism = derived()
    """How the bodies hang on each other: tree, cut joints, places and frames of joints."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "bodies", own_bodies(self.bodies))
        for group in GROUPS:
            object.__setattr__(self, group, Frozen(getattr(self, group)))
        report = Reader()
        recheck(self, (), report)
        if report.problems:
            raise ModelError(report.problems, self.file)
        parts = self._parts()
        check(parts, report)
        if report.problems:
            raise ModelError(report.problems, self.file)
        self._settle(parts)

    @classmethod
    def from_parts(
        cls,
        parts: Parts,
        keys: Mapping[str, Any],
        file: str | None = None,
        lines: Mapping[Place, int] | None = None,
        *,
        allow_code: bool = False,
    ) -> Model:
        """Model of parts that `validate.check` has settled and found without problems.

        Parameters
        ----------
        parts
            The parts.
        keys
            Values of the keys that are no sections; those left out have their defaults.
        file, lines, allow_code
            As in the class.
        """
        model = object.__new__(cls)
        plain = {n: v for n, v in {**defaults_of(cls), **keys}.items() if n not in GROUPS}
        own = {
            "file": file,
            "lines": lines,
            "changed": None,
            "damping": parts.damping,
            "allow_code": allow_code,
        }
        for name, value in {**plain, **own}.items():
            object.__setattr__(model, name, value)
        model._settle(parts)
        return model

    def _settle(self, parts: Parts) -> None:
        for group in (*GROUPS, "pairs"):
            object.__setattr__(self, group, Frozen(getattr(parts, group)))
        object.__setattr__(self, "mechanism", parts.mechanism)

    def _parts(self) -> Parts:
        parts = Parts.of({group: getattr(self, group) for group in GROUPS}, self.damping)
        parts.mechanism = self.mechanism or parts.mechanism
        return parts

    def replace(self, path: str, value: Any, *, allow_code: bool | None = None) -> Model:
        """New model with one value changed; everything that follows from it is settled again.

        Parameters
        ----------
        path
            Dotted path of the keys of a file, such as "gears.pinion.profile_shift_coefficient".
        value
            What a file could hold there (number in SI, text with unit, mapping), or a component; None takes
            an optional key, or a component such as "loads.input", away.
        allow_code
            Whether the value may name a Python function; None: if the model was read with that permission.

        Raises
        ------
        ModelError
            If there is no such key, the value cannot be read, or the changed model is not possible.
        """
        return self.replace_all({path: value}, allow_code=allow_code)

    def replace_all(self, changes: Mapping[str, Any], *, allow_code: bool | None = None) -> Model:
        """New model with several values changed at once: only the whole must be possible, no step to it.

        Parameters
        ----------
        changes
            New values by path, both as in `replace`.
        allow_code
            As in `replace`.

        Raises
        ------
        ModelError
            With every path that does not exist and every value that cannot be read, or with what makes the
            changed model impossible.
        """
        code = self.allow_code if allow_code is None else allow_code
        report = Reader(allow_code=code, directory=str(Path(self.file).parent) if self.file else ".")
        tops: dict[str, Any] = {}
        problems: list[Problem] = []
        for path, value in changes.items():
            name, *rest = path.split(".")
            if rest and name in keys_of(Model):
                part = tops.get(name, getattr(self, name))
                part = own_bodies(part) if name == "bodies" else part
                tops[name] = replace_at(part, tuple(rest), value, report, (name,), keys_of(Model)[name])
            else:
                whole = replace_at(self, (name, *rest), value, report)
                if not report.problems:
                    tops[name] = getattr(whole, name)
            problems += report.problems
            report.problems.clear()
        if problems:
            raise ModelError(problems)
        return dataclasses.replace(self, **tops, changed=True)

    # --- what follows ----------------------------------------------------------------------------------
    def line(self, place: Place) -> int | None:
        """Line of a key in the file the model came from, such as ("loads", "push"); None if it has none."""
        return (self.lines or {}).get(place)

    def backlash(self, mesh: str) -> float:
        """Total gap along the base tangent at the centre distance [m]: the given one, or of the geometry.

        That of a bevel mesh is at the mean cone distance.
        """
        if mesh in self.bevel_meshes:
            return bevel_gap(self.bevel_pairs[mesh], self.bevel_meshes[mesh])
        return gap(self.pairs[mesh], self.meshes[mesh])

    @cached_property
    def phasing(self) -> Phasing:
        """How the gears are put together, see `pitchpoint.model.phasing`."""
        return assemble(self.gears, self.meshes)

    @property
    def toothed(self) -> dict[str, Gear | BevelGear]:
        """All gears with teeth, cylindrical and bevel ones; their names differ."""
        return {**self.gears, **self.bevel_gears}

    @property
    def every_mesh(self) -> dict[str, Mesh | BevelMesh]:
        """Meshes of cylindrical and of bevel gears; their names differ."""
        return {**self.meshes, **self.bevel_meshes}

    def section_of(self, mesh: str) -> str:
        """Section of the file that a mesh stands in."""
        return "meshes" if mesh in self.meshes else "bevel_meshes"

    @cached_property
    def bevel_pairs(self) -> dict[str, BevelPair]:
        """Pair of every bevel mesh."""
        return {name: bevel_pair(self, mesh) for name, mesh in self.bevel_meshes.items()}

    @cached_property
    def bevel_angles(self) -> dict[str, float]:
        """Angle of the centre of tooth 0 of every bevel gear from the x axis of its body at spin 0 [rad]."""
        return assemble_bevels(self)

    def body_of(self, gear: str) -> str | None:
        """Name of the body that carries a gear, None without bodies."""
        return self._carriers.get(gear)

    @cached_property
    def _carriers(self) -> dict[str, str]:
        return carriers_of(self.bodies)

    def body_inertia(self, body: str) -> BodyInertia:
        """Mass and moments of inertia of a body, given or summed over its gears."""
        return body_inertia(self.bodies[body], self.gears, self.bevel_gears)

    def start_speeds(self, scenario: str | Scenario) -> dict[str, float]:
        """Speed of every body at the start of a scenario [rad/s], through the gear ratios.

        All stations of a shaft start with its speed.
        """
        chosen = self.scenarios[scenario] if isinstance(scenario, str) else scenario
        found = start_speeds(self._parts(), chosen.speed)[0]
        for name, places in self.stations.items():
            found |= dict.fromkeys(station_names(name, len(places)), found[name])
        return found

    @cached_property
    def stations(self) -> dict[str, tuple[float, ...]]:
        """Places of the stations that every shaft is cut at, from its start [m]."""
        return stations_of(self)

    def sweep_mesh(self, scenario: str | Scenario) -> str:
        """Mesh whose frequency a sweep counts."""
        chosen = self.scenarios[scenario] if isinstance(scenario, str) else scenario
        if chosen.sweep is None:
            raise ModelError([Problem("scenarios", "is no sweep", remedy="name a scenario with sweep")])
        meshes = sweep_meshes(self._parts(), chosen.sweep.body)
        return chosen.sweep.mesh or next(iter(meshes))

    def _repr_html_(self) -> str:
        """Tables of gears, meshes and bodies for notebooks."""
        from pitchpoint.model.table import model_table

        return model_table(self)


GROUPS = tuple(name for name, found in keys_of(Model).items() if found.kind == "components")
"""Sections of a file that hold components by name."""
