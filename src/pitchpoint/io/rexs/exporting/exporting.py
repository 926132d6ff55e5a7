# SPDX-License-Identifier: Apache-2.0
"""Export of a model as the contents of a REXS file."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.document import RexsModel
from pitchpoint.io.rexs.exporting.bevels import add_bevels
from pitchpoint.io.rexs.exporting.draft import MILLI, Draft, Omission, uvw
from pitchpoint.io.rexs.exporting.gears import MeshStiffness, add_gears, add_meshes
from pitchpoint.io.rexs.exporting.keys import WRITTEN, list_keys
from pitchpoint.io.rexs.exporting.loads import Values, add_loads, load_spectra
from pitchpoint.io.rexs.exporting.operating import SeatStiffness, add_housing, add_lubricant
from pitchpoint.io.rexs.exporting.shafts import add_planetary_stages, add_shafts
from pitchpoint.io.rexs.exporting.supports import add_supports
from pitchpoint.model.stand_ins import own_parts

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

SECTIONS = (*WRITTEN, "scenarios", "elastic_bodies", "load_cases", "materials")
"""Sections of a model that are written."""


@dataclass(frozen=True)
class Exported:
    """Result of an export.

    Attributes
    ----------
    rexs
        Contents of the file.
    omissions
        What of the model is not in it.
    """

    rexs: RexsModel
    omissions: tuple[Omission, ...]


def export_rexs(
    model: Model,
    version: str = tables.NEWEST,
    *,
    stiffness: Mapping[str, MeshStiffness] | None = None,
    housing: SeatStiffness | None = None,
    results: Callable[[Draft], Mapping[str, Values]] | None = None,
) -> Exported:
    """Contents of a REXS file with the gear unit of a model.

    Parameters
    ----------
    model
        The model.
    version
        Version of REXS.
    stiffness
        Attributes of the stiffness of meshes, by mesh.
    housing
        Nodes and matrix of `system.housing_matrices.supported_stiffness` of a housing matrix.
    results
        Function that returns the results of scenarios, by scenario and component of the draft.
    """
    from pitchpoint.model.sections import groups_of

    draft = Draft(model)
    draft.unit = draft.add("gear_unit", model.title or "gear unit", **_unit(model))
    draft.casing = draft.part("gear_casing", "casing", draft.unit)
    add_shafts(draft)
    add_gears(draft)
    add_planetary_stages(draft)
    add_meshes(draft, stiffness)
    add_bevels(draft)
    add_supports(draft)
    add_lubricant(draft)
    add_housing(draft, housing)
    loads = add_loads(draft)
    spectra = load_spectra(draft, loads, results(draft) if results is not None else {})
    list_keys(draft, model)
    for section in groups_of(model):
        if section not in SECTIONS:
            parts = own_parts(getattr(model, section))
            if parts:
                draft.omit(section, f"not written: {', '.join(parts)}")
    from pitchpoint import __version__

    rexs = RexsModel(
        version,
        f"pitchpoint {__version__}",
        datetime.now(UTC).isoformat(timespec="seconds"),
        draft.components,
        tuple(draft.relations),
        spectra,
        model.file or "",
    )
    return Exported(rexs, tuple(draft.omissions))


def _unit(model: Model) -> dict[str, Any]:
    """Values of the gear unit: its own frame, title and gravity."""
    values: dict[str, Any] = {
        "reference_component_for_position": 1,
        "support_vector": (0.0, 0.0, 0.0),
        "u_axis_vector": (MILLI, 0.0, 0.0),
        "w_axis_vector": (0.0, 0.0, MILLI),
        "model_name": model.title or None,
        "account_for_gravity": model.gravity is not None,
    }
    if model.gravity is not None:
        size = float(np.linalg.norm(model.gravity))
        values["gravitational_acceleration"] = size
        along = uvw(np.array(model.gravity) / (size or 1.0))
        values |= {f"direction_vector_gravity_{a}": x for a, x in zip("uvw", along, strict=True)}
    return values
