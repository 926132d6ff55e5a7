# SPDX-License-Identifier: Apache-2.0
"""Keys and sections of a model file: name, component class and rules of each section.

`Model`, `Parts`, the checks, the schema and `system.compile` are derived from this table. Other packages add
sections by an entry point with the name of the section in the group ``pitchpoint.kinds``.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.plugins import plugin_objects
from pitchpoint.model.component import Checked
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
from pitchpoint.model.components.housing import HOUSINGS, Housing
from pitchpoint.model.components.joint import Joint
from pitchpoint.model.components.load import Load
from pitchpoint.model.components.load_case import LoadCase
from pitchpoint.model.components.lubricant import Lubricant
from pitchpoint.model.components.marker import Triple
from pitchpoint.model.components.mesh import Mesh
from pitchpoint.model.components.own_material import OwnMaterial
from pitchpoint.model.components.parameter import Parameter
from pitchpoint.model.components.planetary_stage import PlanetaryStage
from pitchpoint.model.components.ratio import Ratio
from pitchpoint.model.components.rod import Rod
from pitchpoint.model.components.rolling_bearing import PlainBearing, RollingBearing
from pitchpoint.model.components.scissor_gear import ScissorGear
from pitchpoint.model.components.sensor import SENSORS, Sensor
from pitchpoint.model.components.shaft import Shaft
from pitchpoint.model.components.spring import Maxwell, Spring
from pitchpoint.model.components.torsion_spring import TorsionMaxwell, TorsionSpring
from pitchpoint.model.components.unbalance import Unbalance
from pitchpoint.model.components.wind import Wind
from pitchpoint.model.components.wind_rotor import WindRotor
from pitchpoint.model.keys import Key, component, defaults_of, key, keys_of, quantities, text
from pitchpoint.model.scenario import Scenario


@dataclass(frozen=True)
class Section:
    """Section of a model file: components by name, and the rules that compile them to records.

    Parameters ---------- name Key of the file. meaning Short description of the contents. component Class of
    the components, a frozen dataclass with fields from the functions of `model.keys`, or a table of classes
    by `type`. rules Functions that take `system.rules.places.Places` and return one or several `Bank`, as
    "module:function"; a module without a dot is in `system.rules`. A rule shared by several sections is
    called once. needs Kinds of elements whose kernels the rules call; these are compiled first."""

    name: str
    meaning: str
    component: Any
    rules: tuple[str, ...] = ()
    needs: tuple[str, ...] = ()

    @property
    def key(self) -> Key:
        """Key of the file."""
        return Key("components", self.meaning, of=self.component)


def section(meaning: str, of: Any, *rules: str, needs: tuple[str, ...] = (), **more: Any) -> Any:
    """Field for one section; arguments as of `Section`, others as of `keys.Key`."""
    found = Key("components", meaning, of=of, **more)
    return dataclasses.field(default_factory=dict, metadata={"key": found, "rules": rules, "needs": needs})


@dataclass(frozen=True, kw_only=True)
class Contents(Checked):
    """All keys of a model file, in their order."""

    title: str = text("title of the model", "")
    parameters: Mapping[str, Parameter] = key(
        "parameters", "named values for all keys and formulas", {}, of=Parameter, later=True
    )
    materials: Mapping[str, OwnMaterial] = section(
        "materials by name, in addition to those of the library", OwnMaterial, later=True
    )
    gravity: Triple | None = quantities(
        "acceleration",
        "acceleration of gravity in world axes; no weight if omitted",
        None,
        length=(3, 3),
        sample="[0, 0, -9.81 m/s^2]",
    )
    gears: Mapping[str, Gear] = section(
        "cylindrical gears by name",
        Gear,
        "elastic_body:elastic_bank",
        "guide:guide_bank",
        "rim_supports:rim_support_bank",
    )
    bevel_gears: Mapping[str, BevelGear] = section("bevel gears by name", BevelGear, later=True)
    bodies: Mapping[str, Body] = section("rigid bodies with their gears", Body)
    shafts: Mapping[str, Shaft] = section("elastic shafts with their gears", Shaft, "shaft:shaft_bank")
    elastic_bodies: Mapping[str, ElasticBody] = section(
        "elastic bodies from finite-element matrices",
        ElasticBody,
        "elastic_body:elastic_bank",
        "guide:guide_bank",
    )
    planetary_stages: Mapping[str, PlanetaryStage] = section(
        "planetary stages: planets with their pins and meshes",
        PlanetaryStage,
        later=True,
        also=("planetary_gears", "planetary_sets", "epicyclic_stages"),
    )
    scissor_gears: Mapping[str, ScissorGear] = section(
        "scissor gears: free halves next to fixed gears, turned against them by springs",
        ScissorGear,
        later=True,
    )
    joints: Mapping[str, Joint] = section(
        "joints between bodies",
        Joint,
        "closure:closure_bank",
        "guide:guide_bank",
        "joint_friction:friction_bank",
    )
    springs: Mapping[str, Spring] = section(
        "springs and dampers between points", Spring, "spring:spring_bank"
    )
    maxwells: Mapping[str, Maxwell] = section(
        "springs and dampers in series between points (Maxwell elements)", Maxwell, "spring:maxwell_bank"
    )
    torsion_springs: Mapping[str, TorsionSpring] = section(
        "springs and dampers about the axes of bodies", TorsionSpring, "spring:torsion_spring_bank"
    )
    torsion_maxwells: Mapping[str, TorsionMaxwell] = section(
        "springs and dampers in series about the axes of bodies (Maxwell elements)",
        TorsionMaxwell,
        "spring:torsion_maxwell_bank",
    )
    bushings: Mapping[str, Bushing] = section("elastic bushings", Bushing, "bushing:bushing_bank")
    beams: Mapping[str, Beam] = section("elastic beams between two points", Beam, "beam:beam_bank")
    clutches: Mapping[str, Clutch] = section(
        "clutches and brakes", Clutch, "clutch:clutch_bank", also=("brakes", "brake")
    )
    rolling_bearings: Mapping[str, RollingBearing] = section(
        "rolling bearings with individual rolling elements",
        RollingBearing,
        "rolling_bearing:rolling_bearing_bank",
    )
    plain_bearings: Mapping[str, PlainBearing] = section(
        "plain bearings with clearance", PlainBearing, "rolling_bearing:plain_bearing_bank"
    )
    cam_contacts: Mapping[str, CamContact] = section(
        "contacts of points and rollers with curves", CamContact, "contact:cam_banks"
    )
    curve_contacts: Mapping[str, CurveContact] = section(
        "contacts between curves in one plane", CurveContact, "contact:curve_banks"
    )
    surface_contacts: Mapping[str, SurfaceContact] = section(
        "contacts between surfaces in space", SurfaceContact, "contact:surface_banks"
    )
    unbalances: Mapping[str, Unbalance] = section("point masses on bodies", Unbalance)
    rods: Mapping[str, Rod] = section("massless rods between two points", Rod, "closure:closure_bank")
    ratios: Mapping[str, Ratio] = section("fixed ratios between joint coordinates", Ratio, "ratio:ratio_bank")
    meshes: Mapping[str, Mesh] = section("gear meshes", Mesh, "gear_mesh:mesh_bank", needs=("gear_mesh",))
    bevel_meshes: Mapping[str, BevelMesh] = section(
        "bevel gear meshes", BevelMesh, "bevel_mesh:bevel_bank", later=True
    )
    bearings: Mapping[str, Bearing] = section(
        "linear bearings between bodies and ground or a housing",
        Bearing,
        "bearing:bearing_bank",
        "loose_bearing:loose_bearing_bank",
    )
    couplings: Mapping[str, Coupling] = section("couplings between bodies", Coupling, "bearing:bearing_bank")
    loads: Mapping[str, Load] = section("torques and forces on bodies", Load, "load:load_banks")
    winds: Mapping[str, Wind] = section("winds by name", Wind, later=True)
    wind_rotors: Mapping[str, WindRotor] = section(
        "rotors of wind turbines: loads of the air on their blades",
        WindRotor,
        "wind_rotor:wind_rotor_bank",
        later=True,
        also=("rotors", "wind_turbines"),
    )
    sensors: Mapping[str, Sensor] = section("sensors: signals of motion and loads", SENSORS)
    blocks: Mapping[str, Block] = section("signals computed from other signals", BLOCKS)
    controllers: Mapping[str, Controller] = section("discrete controllers", CONTROLLERS)
    actuators: Mapping[str, Actuator] = section("torques and forces driven by signals", ACTUATORS)
    housing: Housing | None = key(
        "variant",
        "housing of all bearings with body and without a housing of their own; default: ground",
        None,
        of=HOUSINGS,
        tag="type",
        later=True,
    )
    lubricant: Lubricant | None = component(
        Lubricant,
        "oil of all meshes, for contact analyses and oil films",
        later=True,
        also=("oil", "lubrication", "lubricants"),
    )
    damping: Damping | None = component(Damping, "Rayleigh and modal damping of the whole model")
    load_cases: Mapping[str, LoadCase] = section(
        "load cases: speeds, loads, temperature and share of the time", LoadCase, later=True
    )
    load_case: str | None = text(
        "name of the load case in effect: its speeds and loads replace those of loads and scenarios",
        None,
        later=True,
    )
    scenarios: Mapping[str, Scenario] = section("simulation scenarios", Scenario)


SECTIONS: dict[str, Section] = {
    f.name: Section(f.name, held.meaning, held.of, f.metadata["rules"], f.metadata["needs"])
    for f in dataclasses.fields(Contents)
    if (held := f.metadata["key"]).kind == "components"
}
"""Sections of this package by name."""
GROUPS = tuple(SECTIONS)
"""Their names, in the order of a file."""
_OTHERS: dict[str, Section] = {}
_CLASSES: list[type] = []


def extensible(cls: type) -> type:
    """Register a class whose keys are extended by the sections of other packages, as empty attributes.

    The class has no `__getattr__`, so that IPython completes its attributes and the names in its sections.
    """
    _CLASSES.append(cls)
    return cls


def register(found: Section) -> None:
    """Add a section at run time.

    Raises
    ------
    ModelError
        If the name is already in use by another key.
    """
    if _OTHERS.get(found.name) == found:
        return
    if found.name in _OTHERS or found.name in keys_of(Contents) or not found.name.isidentifier():
        raise ModelError(
            [Message(found.name, "is not a usable name for a section", remedy="choose another name")]
        )
    _OTHERS[found.name] = found
    for cls in _CLASSES:
        keys_of(cls)[found.name] = found.key
        defaults_of(cls)[found.name] = {}
        setattr(cls, found.name, MappingProxyType({}))


def find(name: str) -> Section | None:
    """Section by name, of this package or of another one; None if not found."""
    if name not in SECTIONS and name not in _OTHERS:
        for found in plugin_objects(Section, name):
            register(found)
    return SECTIONS.get(name) or _OTHERS.get(name)


def load_others() -> None:
    """Register the sections of all installed packages."""
    for found in plugin_objects(Section):
        register(found)


def is_other(name: str) -> bool:
    """Whether a section was registered by another package."""
    return name in _OTHERS


def groups_of(machine: Any) -> tuple[str, ...]:
    """Names of the sections of a model or its parts: all of this package, and those of other packages in
    use."""
    return (*GROUPS, *machine.others)
