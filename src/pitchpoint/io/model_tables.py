# SPDX-License-Identifier: Apache-2.0
"""Tables of pre-computed contact of a model, read from their files and compared with the gears."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model.components.flank_contact import PrecomputedContact
from pitchpoint.model.contact_inputs import contact_inputs

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def read_tables(model: Model) -> Model:
    """The model with the tables of all pre-computed contacts.

    Raises
    ------
    ModelError
        If a file is missing or damaged, or was computed from other gears.
    """
    problems = []
    for name, mesh in model.meshes.items():
        if not isinstance(mesh.contact, PrecomputedContact) or mesh.contact.tables is not None:
            continue
        from pitchpoint.io.contact_table import ContactTableError, read_contact_table

        try:
            stored = read_contact_table(mesh.contact.file)
            options = stored.inputs.get("contact", {})
            stored = read_contact_table(mesh.contact.file, contact_inputs(model, name, options))
        except ContactTableError as error:
            problems.append(Message(f"meshes.{name}.contact.file", str(error)))
            continue
        # a derived field, set once before the model is used
        object.__setattr__(mesh.contact, "tables", stored)
    if problems:
        raise ModelError(problems, model.file)
    return model
