# SPDX-License-Identifier: Apache-2.0
"""The example `advanced-contact` with the contact table that its README has computed."""

from __future__ import annotations

import shutil
from pathlib import Path

from pitchpoint.io.contact_table import write_contact_table
from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.contact_inputs import contact_inputs
from pitchpoint.solvers.contact_analysis.precompute import TableRequest, contact_table

EXAMPLE = Path(__file__).parents[2] / "examples" / "advanced-contact"


def folder_with_table(folder: Path) -> Path:
    """Copy the models to a folder and write `stage.gcp.h5` for 600 N m there."""
    for path in EXAMPLE.glob("*.yaml"):
        shutil.copy(path, folder)
    flexible = load_model(folder / "flexible.yaml")
    tables = {
        side: contact_table(flexible, "stage", TableRequest(torque=600.0), flank)
        for side, flank in (("front", 1), ("back", -1))
    }
    inputs = contact_inputs(flexible, "stage", flexible.meshes["stage"].contact)
    # dampings are not part of a table
    write_contact_table(folder / "stage.gcp.h5", tables, inputs)
    return folder
