# SPDX-License-Identifier: Apache-2.0
"""Mesh stiffness and results of runs as values of a REXS file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.io.rexs.document import RexsAttribute
    from pitchpoint.io.rexs.exporting.draft import Draft
    from pitchpoint.io.rexs.exporting.operating import SeatStiffness
    from pitchpoint.model.model import Model

POINTS = 65
"""Positions of the mesh cycle, the first and the last one with the same stiffness."""


def housing_of(model: Model) -> SeatStiffness | None:
    """Nodes and stiffness matrix of the housing; None without a matrix."""
    from pitchpoint.model.components.housing import HousingMatrix
    from pitchpoint.system.housing_matrices import supported_stiffness

    return supported_stiffness(model) if isinstance(model.housing, HousingMatrix) else None


def stiffness_of(model: Model) -> dict[str, dict[str, Any]]:
    """Stiffness of all meshes by the ids of REXS [SI units].

    c' and c_gamma_alpha by ISO 6336-1:2006 of the geometry, and the stiffness along the base tangent over
    one mesh cycle by the law of the mesh.
    """
    from pitchpoint.report.numbers import cycles_of_model
    from pitchpoint.system.rules.stiffness import single_stiffness_of

    found: dict[str, dict[str, Any]] = {}
    cycles = cycles_of_model(model, POINTS) if all(m.contact is None for m in model.meshes.values()) else {}
    for name in model.pairs:
        single = single_stiffness_of(model, name)
        found[name] = {
            "single_stiffness_iso_6336_2006": single.c_prime,
            "mean_mesh_stiffness_for_transverse_load_iso_6336_2006": single.c_gamma_alpha,
        }
        cycle, _, unit = cycles.get(name, (None, "", None))
        if cycle is not None and unit is not None:
            curve = tuple(float(unit * x) for x in cycle.stiffness_ratio)
            found[name]["meshing_stiffness_characteristic"] = curve
    return found


def results_of(draft: Draft, files: Sequence[str]) -> dict[str, dict[int, dict[str, RexsAttribute]]]:
    """Results of runs by scenario and component: means over the run.

    Parameters
    ----------
    draft
        The draft with all components.
    files
        Result files.

    Raises
    ------
    ModelError
        If a result has another model or no scenario.
    """
    from pitchpoint.core.errors import Message, ModelError
    from pitchpoint.core.provenance import content_hash
    from pitchpoint.io.results import open_result

    own = content_hash(draft.model)
    found: dict[str, dict[int, dict[str, RexsAttribute]]] = {}
    for file in files:
        with open_result(file) as result:
            scenario = str(result.attrs.get("scenario", ""))
            if scenario not in draft.model.scenarios or scenario in found:
                what = "has two results" if scenario in found else "is not a scenario of the model"
                remedy = "give results of runs of this model, one for each scenario"
                raise ModelError([Message(f"{file}, scenario", what, repr(scenario), remedy=remedy)])
            if str(result.attrs.get("model_hash", own)) != own:
                remedy = "run the scenario again, or write the model of the result"
                raise ModelError(
                    [Message(file, "is the result of another version of the model", remedy=remedy)]
                )
            found[scenario] = _values(draft, result)
    return found


def _values(draft: Draft, result: xr.Dataset) -> dict[int, dict[str, RexsAttribute]]:
    from pitchpoint.io.rexs.document import RexsAttribute
    from pitchpoint.io.rexs.exporting.draft import OWN, attribute, uvw

    found: dict[int, dict[str, RexsAttribute]] = {}

    def mean(channel: str) -> float | None:
        """Mean of a channel; None if the result does not have it."""
        return float(result[channel].mean()) if channel in result else None

    def put(id: int, key: str, value: float) -> None:
        """Add a value in SI units."""
        kind = draft.components[id].type
        found.setdefault(id, {})[key] = attribute(key, value, kind)

    for name, id in draft.supports.items():
        force = [mean(f"bearing_force[{name}.f{a}]") for a in "xyz"]
        if None not in force:
            for a, value in zip("uvw", uvw([f for f in force if f is not None]), strict=True):
                put(id, f"force_acting_on_inner_component_{a}", value)
    for name, id in draft.meshes.items():
        tangential = mean(f"mesh_force[{name}]")
        if tangential is not None:
            put(id, "nominal_tangential_force_at_base_diameter", abs(tangential))
        error = f"transmission_error[{name}]"
        if error in result:
            swing = 1e6 * float(result[error].max() - result[error].min())
            key = f"{OWN}transmission_error_peak_to_peak"
            found.setdefault(id, {})[key] = RexsAttribute(key, None, swing, unit="mum")
    if result.attrs.get("kind") != "quasi_static":  # the speed of a slow roll has no meaning
        for name, id in draft.shafts.items():
            speed = mean(f"speed[{name}]")
            if speed is not None:
                put(id, "rotational_speed", speed)
    return found
