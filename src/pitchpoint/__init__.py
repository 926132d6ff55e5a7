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
    from pitchpoint.io.measured.reading import read_measured
    from pitchpoint.io.results import open_result
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.model.model import Model
    from pitchpoint.report.write import write_report
    from pitchpoint.solvers.campbell_dataset import solve_campbell
    from pitchpoint.solvers.contact_analysis.on_shafts import solve_contacts_on_shafts
    from pitchpoint.solvers.contact_analysis.relief.design import design_relief
    from pitchpoint.solvers.contact_analysis.relief.plan import ReliefPlan
    from pitchpoint.solvers.contact_analysis.solve import solve_contact
    from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
    from pitchpoint.solvers.frequency_response import solve_frequency_response
    from pitchpoint.solvers.mesh_response import solve_mesh_response
    from pitchpoint.solvers.modal import solve_modal
    from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
    from pitchpoint.solvers.reduction.reduce import reduce_system
    from pitchpoint.solvers.time import solve_time
    from pitchpoint.sweep.cases import cases_dataset, run_cases
    from pitchpoint.sweep.speed import sweep_speed
    from pitchpoint.system.compile import compile_model
    from pitchpoint.system.planet_loads import planet_loads

__all__ = [
    "BasicRack",
    "CompileError",
    "CylindricalGear",
    "GearPair",
    "GeometryError",
    "Model",
    "ModelError",
    "PitchpointError",
    "ReliefPlan",
    "SolverError",
    "UnitError",
    "ValidityWarning",
    "__version__",
    "analyse",
    "cases_dataset",
    "compile_model",
    "design_relief",
    "load_model",
    "open_result",
    "planet_loads",
    "read_measured",
    "reduce_system",
    "run_cases",
    "solve_campbell",
    "solve_contact",
    "solve_contacts_on_shafts",
    "solve_equilibrium",
    "solve_frequency_response",
    "solve_mesh_response",
    "solve_modal",
    "solve_quasistatic",
    "solve_time",
    "sweep_speed",
    "write_report",
]

__version__: str

_HOMES = {
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
    "io.measured.reading": ("read_measured",),
    "io.results": ("open_result",),
    "io.yaml_model": ("load_model",),
    "model.model": ("Model",),
    "report.write": ("write_report",),
    "solvers.campbell_dataset": ("solve_campbell",),
    "solvers.contact_analysis.on_shafts": ("solve_contacts_on_shafts",),
    "solvers.contact_analysis.solve": ("solve_contact",),
    "solvers.contact_analysis.relief.design": ("design_relief",),
    "solvers.contact_analysis.relief.plan": ("ReliefPlan",),
    "solvers.equilibrium.solve": ("solve_equilibrium",),
    "solvers.frequency_response": ("solve_frequency_response",),
    "solvers.mesh_response": ("solve_mesh_response",),
    "solvers.modal": ("solve_modal",),
    "solvers.quasistatic.roll": ("solve_quasistatic",),
    "solvers.reduction.reduce": ("reduce_system",),
    "solvers.time": ("solve_time",),
    "sweep.cases": ("cases_dataset", "run_cases"),
    "sweep.speed": ("sweep_speed",),
    "system.compile": ("compile_model",),
    "system.planet_loads": ("planet_loads",),
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
