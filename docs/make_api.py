# SPDX-License-Identifier: Apache-2.0
"""Pages of the Python reference: one per layer that people call, every public name of its modules."""

from __future__ import annotations

import importlib
import inspect
import pkgutil
from pathlib import Path
from types import ModuleType

import pitchpoint

GROUPS = {
    "Models and files": (
        "load_model",
        "write_model",
        "Model",
        "import_rexs",
        "read_rexs",
        "read_measured",
        "open_result",
        "write_report",
        "export_fmu",
    ),
    "Components of models": (
        "Gear",
        "BevelGear",
        "Body",
        "Shaft",
        "ElasticBody",
        "PlanetaryStage",
        "ScissorGear",
        "Joint",
        "Mesh",
        "BevelMesh",
        "Bearing",
        "RollingBearing",
        "PlainBearing",
        "Coupling",
        "Clutch",
        "Spring",
        "Maxwell",
        "TorsionSpring",
        "TorsionMaxwell",
        "Bushing",
        "Beam",
        "Rod",
        "Ratio",
        "CamContact",
        "CurveContact",
        "SurfaceContact",
        "Unbalance",
        "Wind",
        "WindRotor",
        "Load",
        "LoadCase",
        "RigidHousing",
        "HousingMatrix",
        "HousingBody",
        "OwnMaterial",
        "Lubricant",
        "Damping",
        "Parameter",
        "Scenario",
    ),
    "Compile and solve": (
        "compile_model",
        "solve_equilibrium",
        "planet_loads",
        "solve_quasistatic",
        "solve_modal",
        "solve_campbell",
        "solve_frequency_response",
        "solve_mesh_response",
        "solve_contact",
        "solve_contacts_on_shafts",
        "design_relief",
        "ReliefPlan",
        "solve_time",
        "Stepper",
        "estimate_communication_error",
        "reduce_system",
        "state_space",
    ),
    "Wind": (
        "SteadyWind",
        "WindClass",
        "RotorSite",
        "Gust",
        "KaimalTurbulence",
        "make_turbulence",
        "WindBox",
        "add_mean",
        "WindField",
        "read_turbsim",
        "write_turbsim",
        "MannGeometry",
        "read_mann",
        "write_mann",
    ),
    "Many runs": ("sweep_speed", "run_cases", "cases_dataset", "run_study"),
    "Analyse": ("analyse", "by_component", "plot"),
    "Wind turbine rotors": (
        "Rotor",
        "Blade",
        "Polar",
        "Tower",
        "RotorFlow",
        "extrapolate_polar",
        "read_aerodyn",
        "read_airfoil",
        "read_beamdyn",
        "read_elastodyn",
        "read_windio_rotor",
        "read_windio_beam",
        "BeamTable",
        "SectionTable",
        "solve_rotor_performance",
        "solve_rotor_transient",
        "solve_multiblade_modes",
    ),
    "Gears": ("CylindricalGear", "GearPair", "BasicRack"),
    "Errors": (
        "PitchpointError",
        "ModelError",
        "UnitError",
        "GeometryError",
        "CompileError",
        "SolverError",
        "ValidityWarning",
    ),
}
# package -> what its page is about
LAYERS = {
    "geometry": "Teeth and pairs of cylindrical gears, symbols by ISO 21771; internal gears are negative.",
    "contact": "Stiffness of teeth, contact lines, Hertz, friction, damping, wear.",
    "analysis": "Arrays in, numbers out. Measured and simulated signals share every function.",
}


def listed(name: str, thing: object) -> str:
    """Directive of one function or class, to be in a block of reStructuredText."""
    if inspect.isclass(thing):
        members = "" if issubclass(thing, Exception) else "\n   :members:"
        return f".. autoclass:: {name}{members}\n"
    return f".. autofunction:: {name}\n"


def block(module: str, names: dict[str, object]) -> str:
    """Directives of the names of one module."""
    inner = "\n".join(listed(name, thing) for name, thing in names.items())
    return f"```{{eval-rst}}\n.. currentmodule:: {module}\n\n{inner}```\n"


def public_page() -> str:
    """Page of the public names of the package, by group."""
    grouped = {"__version__", *(name for names in GROUPS.values() for name in names)}
    if missing := set(pitchpoint.__all__) - grouped:
        raise SystemExit(f"docs/make_api.py: public names without a group: {sorted(missing)}")
    parts = ["# `pitchpoint`\n\n`import pitchpoint as pp`; every name is imported when it is first used.\n"]
    for title, names in GROUPS.items():
        things = {name: getattr(pitchpoint, name) for name in names}
        parts.append(f"## {title}\n\n{block('pitchpoint', things)}")
    return "\n".join(parts)


def documented(module: ModuleType) -> dict[str, object]:
    """Public functions and classes of a module that are its own and for people: kernels are omitted."""
    found = {}
    for name, thing in vars(module).items():
        own = getattr(thing, "__module__", None) == module.__name__
        if not name.startswith("_") and own and (inspect.isfunction(thing) or inspect.isclass(thing)):
            found[name] = thing
    return found


def layer_page(layer: str, text: str) -> str:
    """Page of one layer, a section for each of its modules."""
    package = importlib.import_module(f"pitchpoint.{layer}")
    parts = [f"# `pitchpoint.{layer}`\n\n{text}\n"]
    public = {getattr(pitchpoint, name) for name in pitchpoint.__all__ if name != "__version__"}
    for info in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        module = importlib.import_module(info.name)
        names = {name: thing for name, thing in documented(module).items() if thing not in public}
        if not names:
            continue
        head = (module.__doc__ or "").strip().split("\n\n")[0].replace("\n", " ")
        short = info.name.removeprefix("pitchpoint.")
        parts.append(f"## `{short}`\n\n{head}\n\n{block(info.name, names)}")
    return "\n".join(parts)


def write_pages(target: Path) -> None:
    """Write all pages below a folder."""
    target.mkdir(parents=True, exist_ok=True)
    (target / "pitchpoint.md").write_text(public_page(), encoding="utf-8")
    for layer, text in LAYERS.items():
        (target / f"{layer}.md").write_text(layer_page(layer, text), encoding="utf-8")
