# SPDX-License-Identifier: Apache-2.0
"""Stiffness descriptions from the stiffness laws of a model."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.contact.stiffness import law_function
from pitchpoint.contact.stiffness.description import Description
from pitchpoint.model.components.stiffness import UserStiffness, standard_options
from pitchpoint.system.rules.flank_contact import surface_shape

if TYPE_CHECKING:
    from pitchpoint.contact.stiffness.din3990 import SingleStiffness
    from pitchpoint.core.user_law import UserLaw
    from pitchpoint.model.components.law import PythonLaw
    from pitchpoint.model.model import Model

N_TRIES = 1024
"""Number of mesh phases at which a user-defined stiffness law is tested before it is used."""


def single_stiffness_of(model: Model, mesh: str) -> SingleStiffness:
    """Single and mesh stiffness of a mesh to DIN 3990 / ISO 6336-1, with the factors of its gears."""
    from pitchpoint.contact.stiffness.din3990 import single_stiffness

    part = model.meshes[mesh]
    teeth = getattr(part.stiffness, "virtual_teeth", "iso")
    gears = [model.gears[g] for g in part.gears]
    return single_stiffness(model.pairs[mesh], **standard_options(gears, teeth))


def describe_stiffness(model: Model, mesh: str) -> Description:
    """Stiffness description of a mesh by the law in the model."""
    part = model.meshes[mesh]
    if part.contact is not None:
        gears = [model.gears[g] for g in part.gears]
        c_prime = single_stiffness_of(model, mesh).c_prime
        return surface_shape(part.contact, model.pairs[mesh], gears, c_prime)
    options = part.stiffness.options([model.gears[g] for g in part.gears])
    if isinstance(part.stiffness, UserStiffness):  # the only law that runs code
        own = user_law(part.stiffness.python, f"meshes.{mesh}.stiffness.python")
        _try(own)
        options = {"function": lambda psi: own(0.0, psi)}
    found: Description = law_function(part.stiffness.law)(model.pairs[mesh], **options)
    return found


def _try(law: UserLaw) -> None:
    """Test the law over one mesh cycle; a failure raises a SolverError, since the model file is valid."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import NOT_FINITE, REFUSED

    for k in range(N_TRIES):
        message = law.diagnose(0.0, k / N_TRIES)
        if message:
            raise SolverError(f"{message} (mesh phase {k / N_TRIES:.4f})", NOT_FINITE)
        value = law(0.0, k / N_TRIES)
        if value <= 0.0:
            raise SolverError(
                f"{law.source} gives {value:.6g} N/m (mesh phase {k / N_TRIES:.4f}; limit > 0)",
                REFUSED,
            )


def user_law(law: PythonLaw, where: str) -> UserLaw:
    """Load a user-defined Python law; permission has already been checked when the model was loaded.

    Parameters
    ----------
    law
        File, function and parameters.
    where
        Path in the model, for messages.

    Raises
    ------
    ModelError
        If the file or function does not exist, or has other arguments.
    """
    from pitchpoint.core.user_law import load_user_law
    from pitchpoint.model.signals import APPENDED

    path = Path(law.file)
    return load_user_law(
        f"{path.name}:{law.function}",
        path.parent,
        allow_code=True,
        parameters=law.parameters,
        appended=APPENDED.get(where.partition(".")[0], 0),
        where=where,
    )
