# SPDX-License-Identifier: Apache-2.0
"""pitchpoint simulates gears inside machines: geometry, mesh stiffness, flank contact, dynamics.

The public names below are imported when they are first used, so that importing the package costs next to
nothing.
"""

from __future__ import annotations

import importlib
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pitchpoint.analysis.by_component import by_component
    from pitchpoint.analysis.dataset import analyse
    from pitchpoint.core.errors import (
        CompileError,
        GeometryError,
        ModelError,
        PitchpointError,
        SolverError,
        UnitError,
        ValidityWarning,
    )
    from pitchpoint.geometry import BasicRack, CylindricalGear, GearPair
    from pitchpoint.geometry.beam_table import BeamTable
    from pitchpoint.geometry.rotor.blade import Blade, Rotor
    from pitchpoint.geometry.rotor.flow import RotorFlow
    from pitchpoint.geometry.rotor.polar import Polar
    from pitchpoint.geometry.rotor.polar_range import extrapolate_polar
    from pitchpoint.geometry.rotor.tower import Tower
    from pitchpoint.geometry.section_table import SectionTable
    from pitchpoint.io.measured.reading import read_measured
    from pitchpoint.io.results import open_result
    from pitchpoint.io.rexs.importing import import_rexs
    from pitchpoint.io.rexs.reading import read_rexs
    from pitchpoint.io.wind.mann import MannGeometry, read_mann, write_mann
    from pitchpoint.io.wind.turbsim import write_turbsim
    from pitchpoint.io.yaml_model import load_model, write_model
    from pitchpoint.model.components.beam import Beam
    from pitchpoint.model.components.bearing import Bearing
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.components.body import Body
    from pitchpoint.model.components.bushing import Bushing
    from pitchpoint.model.components.clutch import Clutch
    from pitchpoint.model.components.contact import CamContact, CurveContact, SurfaceContact
    from pitchpoint.model.components.coupling import Coupling
    from pitchpoint.model.components.damping import Damping
    from pitchpoint.model.components.elastic_body import ElasticBody
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.housing import HousingBody, HousingMatrix, RigidHousing
    from pitchpoint.model.components.joint import Joint
    from pitchpoint.model.components.load import Load
    from pitchpoint.model.components.load_case import LoadCase
    from pitchpoint.model.components.lubricant import Lubricant
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.components.own_material import OwnMaterial
    from pitchpoint.model.components.parameter import Parameter
    from pitchpoint.model.components.planetary_stage import PlanetaryStage
    from pitchpoint.model.components.ratio import Ratio
    from pitchpoint.model.components.rod import Rod
    from pitchpoint.model.components.rolling_bearing import PlainBearing, RollingBearing
    from pitchpoint.model.components.scissor_gear import ScissorGear
    from pitchpoint.model.components.shaft import Shaft
    from pitchpoint.model.components.spring import Maxwell, Spring
    from pitchpoint.model.components.torsion_spring import TorsionMaxwell, TorsionSpring
    from pitchpoint.model.components.unbalance import Unbalance
    from pitchpoint.model.components.wind import Wind
    from pitchpoint.model.components.wind_rotor import WindRotor
    from pitchpoint.model.model import Model
    from pitchpoint.model.openfast.aerodyn import read_aerodyn
    from pitchpoint.model.openfast.airfoil import read_airfoil
    from pitchpoint.model.openfast.beamdyn import read_beamdyn
    from pitchpoint.model.openfast.elastodyn import read_elastodyn
    from pitchpoint.model.scenario import Scenario
    from pitchpoint.model.wind.box import WindBox
    from pitchpoint.model.wind.iec import Gust, RotorSite, WindClass
    from pitchpoint.model.wind.steady import SteadyWind
    from pitchpoint.model.wind.turbsim import read_turbsim
    from pitchpoint.model.wind.turbulence import KaimalTurbulence
    from pitchpoint.model.windio.beam import read_windio_beam
    from pitchpoint.model.windio.rotor import read_windio_rotor
    from pitchpoint.report.exported_model import export_fmu
    from pitchpoint.report.pictures import plot
    from pitchpoint.report.write import write_report
    from pitchpoint.solvers.campbell_dataset import solve_campbell
    from pitchpoint.solvers.communication_error import estimate_communication_error
    from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
    from pitchpoint.solvers.contact_analysis.relief.design import design_relief
    from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan
    from pitchpoint.solvers.contact_analysis.solve import solve_contact
    from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
    from pitchpoint.solvers.frequency_response import solve_frequency_response
    from pitchpoint.solvers.mesh_response import solve_mesh_response
    from pitchpoint.solvers.modal import solve_modal
    from pitchpoint.solvers.multiblade import solve_multiblade_modes
    from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
    from pitchpoint.solvers.reduction.reduce import reduce_system
    from pitchpoint.solvers.rotor_performance import solve_rotor_performance
    from pitchpoint.solvers.rotor_transient import solve_rotor_transient
    from pitchpoint.solvers.state_space import state_space
    from pitchpoint.solvers.stepper import Stepper
    from pitchpoint.solvers.time import solve_time
    from pitchpoint.solvers.turbulence.box import make_turbulence
    from pitchpoint.sweep.cases import cases_dataset, run_cases
    from pitchpoint.sweep.speed import sweep_speed
    from pitchpoint.sweep.study.run_study import run_study
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.planet_loads import planet_loads
    from pitchpoint.system.wind import WindField, add_mean

__all__ = [
    "BasicRack",
    "Beam",
    "BeamTable",
    "Bearing",
    "BevelGear",
    "BevelMesh",
    "Blade",
    "Body",
    "Bushing",
    "CamContact",
    "Clutch",
    "CompileError",
    "Coupling",
    "CurveContact",
    "CylindricalGear",
    "Damping",
    "ElasticBody",
    "Gear",
    "GearPair",
    "GeometryError",
    "Gust",
    "HousingBody",
    "HousingMatrix",
    "Joint",
    "KaimalTurbulence",
    "Load",
    "LoadCase",
    "Lubricant",
    "MannGeometry",
    "Maxwell",
    "Mesh",
    "Model",
    "ModelError",
    "OwnMaterial",
    "Parameter",
    "PitchpointError",
    "PlainBearing",
    "PlanetaryStage",
    "Polar",
    "Ratio",
    "ReliefPlan",
    "RigidHousing",
    "Rod",
    "RollingBearing",
    "Rotor",
    "RotorFlow",
    "RotorSite",
    "Scenario",
    "ScissorGear",
    "SectionTable",
    "Shaft",
    "SolverError",
    "Spring",
    "SteadyWind",
    "Stepper",
    "SurfaceContact",
    "TorsionMaxwell",
    "TorsionSpring",
    "Tower",
    "Unbalance",
    "UnitError",
    "ValidityWarning",
    "Wind",
    "WindBox",
    "WindClass",
    "WindField",
    "WindRotor",
    "__version__",
    "add_mean",
    "analyse",
    "by_component",
    "cases_dataset",
    "compile_model",
    "design_relief",
    "estimate_communication_error",
    "export_fmu",
    "extrapolate_polar",
    "import_rexs",
    "load_model",
    "make_turbulence",
    "open_result",
    "planet_loads",
    "plot",
    "read_aerodyn",
    "read_airfoil",
    "read_beamdyn",
    "read_elastodyn",
    "read_mann",
    "read_measured",
    "read_rexs",
    "read_turbsim",
    "read_windio_beam",
    "read_windio_rotor",
    "reduce_system",
    "run_cases",
    "run_study",
    "solve_campbell",
    "solve_contact",
    "solve_contacts_on_shafts",
    "solve_equilibrium",
    "solve_frequency_response",
    "solve_mesh_response",
    "solve_modal",
    "solve_multiblade_modes",
    "solve_quasistatic",
    "solve_rotor_performance",
    "solve_rotor_transient",
    "solve_time",
    "state_space",
    "sweep_speed",
    "write_mann",
    "write_model",
    "write_report",
    "write_turbsim",
]

__version__: str

_HOMES = {
    "analysis.by_component": ("by_component",),
    "analysis.dataset": ("analyse",),
    "core.errors": (
        "CompileError",
        "GeometryError",
        "ModelError",
        "PitchpointError",
        "SolverError",
        "UnitError",
        "ValidityWarning",
    ),
    "geometry": ("BasicRack", "CylindricalGear", "GearPair"),
    "geometry.rotor.blade": ("Blade", "Rotor"),
    "geometry.rotor.flow": ("RotorFlow",),
    "geometry.rotor.polar": ("Polar",),
    "geometry.rotor.polar_range": ("extrapolate_polar",),
    "geometry.rotor.tower": ("Tower",),
    "io.measured.reading": ("read_measured",),
    "model.openfast.aerodyn": ("read_aerodyn",),
    "model.openfast.airfoil": ("read_airfoil",),
    "model.openfast.beamdyn": ("read_beamdyn",),
    "model.openfast.elastodyn": ("read_elastodyn",),
    "model.windio.beam": ("read_windio_beam",),
    "model.windio.rotor": ("read_windio_rotor",),
    "geometry.beam_table": ("BeamTable",),
    "geometry.section_table": ("SectionTable",),
    "model.components.wind": ("Wind",),
    "model.components.wind_rotor": ("WindRotor",),
    "io.results": ("open_result",),
    "io.rexs.importing": ("import_rexs",),
    "io.rexs.reading": ("read_rexs",),
    "io.yaml_model": ("load_model", "write_model"),
    "model.components.beam": ("Beam",),
    "model.components.bearing": ("Bearing",),
    "model.components.bevel_gear": ("BevelGear",),
    "model.components.bevel_mesh": ("BevelMesh",),
    "model.components.body": ("Body",),
    "model.components.bushing": ("Bushing",),
    "model.components.clutch": ("Clutch",),
    "model.components.contact": (
        "CamContact",
        "CurveContact",
        "SurfaceContact",
    ),
    "model.components.coupling": ("Coupling",),
    "model.components.damping": ("Damping",),
    "model.components.elastic_body": ("ElasticBody",),
    "model.components.gear": ("Gear",),
    "model.components.housing": ("HousingBody", "HousingMatrix", "RigidHousing"),
    "model.components.joint": ("Joint",),
    "model.components.load": ("Load",),
    "model.components.load_case": ("LoadCase",),
    "model.components.lubricant": ("Lubricant",),
    "model.components.mesh": ("Mesh",),
    "model.components.own_material": ("OwnMaterial",),
    "model.components.parameter": ("Parameter",),
    "model.components.planetary_stage": ("PlanetaryStage",),
    "model.components.scissor_gear": ("ScissorGear",),
    "model.components.ratio": ("Ratio",),
    "model.components.rod": ("Rod",),
    "model.components.rolling_bearing": (
        "PlainBearing",
        "RollingBearing",
    ),
    "model.components.shaft": ("Shaft",),
    "model.components.spring": (
        "Maxwell",
        "Spring",
    ),
    "model.components.torsion_spring": (
        "TorsionMaxwell",
        "TorsionSpring",
    ),
    "model.components.unbalance": ("Unbalance",),
    "model.model": ("Model",),
    "model.scenario": ("Scenario",),
    "report.exported_model": ("export_fmu",),
    "report.pictures": ("plot",),
    "report.write": ("write_report",),
    "solvers.campbell_dataset": ("solve_campbell",),
    "solvers.communication_error": ("estimate_communication_error",),
    "solvers.contact_analysis.on_shafts": ("solve_contacts_on_shafts",),
    "solvers.contact_analysis.solve": ("solve_contact",),
    "solvers.contact_analysis.relief.design": ("design_relief",),
    "solvers.contact_analysis.relief.plan": ("ReliefPlan",),
    "solvers.equilibrium.solve": ("solve_equilibrium",),
    "solvers.frequency_response": ("solve_frequency_response",),
    "solvers.mesh_response": ("solve_mesh_response",),
    "solvers.modal": ("solve_modal",),
    "solvers.multiblade": ("solve_multiblade_modes",),
    "solvers.quasistatic.roll": ("solve_quasistatic",),
    "solvers.reduction.reduce": ("reduce_system",),
    "solvers.rotor_performance": ("solve_rotor_performance",),
    "solvers.rotor_transient": ("solve_rotor_transient",),
    "solvers.state_space": ("state_space",),
    "solvers.stepper": ("Stepper",),
    "solvers.time": ("solve_time",),
    "sweep.cases": ("cases_dataset", "run_cases"),
    "sweep.speed": ("sweep_speed",),
    "sweep.study.run_study": ("run_study",),
    "system.compile": ("compile_model",),
    "system.planet_loads": ("planet_loads",),
    "io.wind.mann": ("MannGeometry", "read_mann", "write_mann"),
    "io.wind.turbsim": ("write_turbsim",),
    "model.wind.turbsim": ("read_turbsim",),
    "model.wind.box": ("WindBox",),
    "model.wind.iec": ("Gust", "RotorSite", "WindClass"),
    "model.wind.steady": ("SteadyWind",),
    "model.wind.turbulence": ("KaimalTurbulence",),
    "solvers.turbulence.box": ("make_turbulence",),
    "system.wind": ("WindField", "add_mean"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}


def __getattr__(name: str) -> Any:
    """Import a public name at its first use (PEP 562)."""
    if name == "__version__":
        from pitchpoint.core.provenance import package_version

        value: Any = package_version()
    elif name in _HOME_OF:
        from pitchpoint.viz.notebook import attach

        value = getattr(importlib.import_module(f"pitchpoint.{_HOME_OF[name]}"), name)
        if _HOME_OF[name].startswith("model."):
            importlib.import_module("pitchpoint.model.model")  # reads and writes the values of components
        attach()  # what this has brought in shows itself in notebooks
    else:
        raise AttributeError(f"module 'pitchpoint' has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """Public names, loaded or not."""
    return sorted(__all__)


# In a notebook gears, models and results show themselves; without IPython nothing is imported here.
if "IPython" in sys.modules:
    from pitchpoint.report.notebook import register

    register()
    del register
