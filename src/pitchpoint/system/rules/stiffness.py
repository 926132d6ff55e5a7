# SPDX-License-Identifier: Apache-2.0
"""From the stiffness law of a model file to a stiffness description."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.contact.stiffness import law_function
from pitchpoint.contact.stiffness.description import Description
from pitchpoint.model.components.stiffness import UserStiffness, standard_options

if TYPE_CHECKING:
    from pitchpoint.contact.stiffness.din3990 import SingleStiffness
    from pitchpoint.core.user_law import UserLaw
    from pitchpoint.model.components.law import PythonLaw
    from pitchpoint.model.model import Model

N_TRIES = 1024
"""Mesh phases at which a user's stiffness law is called once before anything is computed with it."""


def single_stiffness_of(model: Model, mesh: str) -> SingleStiffness:
    """Single and mesh stiffness of a mesh by DIN 3990 / ISO 6336-1, with the factors of its gears."""
    from pitchpoint.contact.stiffness.din3990 import single_stiffness

    part = model.meshes[mesh]
    teeth = getattr(part.stiffness, "virtual_teeth", "iso")
    gears = [model.gears[g] for g in part.gears]
    return single_stiffness(model.pairs[mesh], **standard_options(gears, teeth))


def describe_stiffness(model: Model, mesh: str) -> Description:
    """Stiffness description of a mesh, by the law that its model names."""
    part = model.meshes[mesh]
    options = part.stiffness.options([model.gears[g] for g in part.gears])
    if isinstance(part.stiffness, UserStiffness):  # the only law that runs code
        own = user_law(part.stiffness.python, f"meshes.{mesh}.stiffness.python")
        _try(own)
        options = {"function": lambda psi: own(0.0, psi)}
    found: Description = law_function(part.stiffness.law)(model.pairs[mesh], **options)
    return found


def _try(law: UserLaw) -> None:
    """Go once through the mesh cycle: a law that fails is a failed computation, not a wrong file."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import NOT_FINITE, REFUSED

    for k in range(N_TRIES):
        message = law.diagnose(0.0, k / N_TRIES)
        if message:
            raise SolverError(f"{message} (mesh phase {k / N_TRIES:.4f})", NOT_FINITE)
        value = law(0.0, k / N_TRIES)
        if value <= 0.0:
            raise SolverError(
                f"{law.source} gives {value:.6g} N/m (mesh phase {k / N_TRIES:.4f}); a stiffness is > 0",
                REFUSED,
            )


def user_law(law: PythonLaw, where: str) -> UserLaw:
    """Load a user's Python law; the loader of the model has checked the permission already.

    Parameters
    ----------
    law
        File, function and parameters.
    where
        Place in the model that names it, for messages.

    Raises
    ------
    ModelError
        If there is no such file or function, or it takes other arguments.
    """
    from pitchpoint.core.user_law import load_user_law

    path = Path(law.file)
    reference = f"{path.name}:{law.function}"
    return load_user_law(reference, path.parent, allow_code=True, parameters=law.parameters, where=where)
