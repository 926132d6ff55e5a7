# SPDX-License-Identifier: Apache-2.0
"""What a model says that will have no effect: allowed, but a user should know."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

from pitchpoint.core.errors import ValidityWarning

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

#: Laws that describe one tooth pair; all others prescribe the stiffness of the whole mesh.
OF_PAIRS = ("din3990", "energy", "pair_table")


def follows_flanks(model: Model, mesh: str) -> bool:
    """Whether modifications, deviations or profiles of the gears of a mesh have an effect."""
    found = model.meshes[mesh]
    return found.stiffness.law in OF_PAIRS and any(model.gears[g].is_modified for g in found.gears)


def ignored_flanks(model: Model) -> tuple[str, ...]:
    """A sentence for every mesh whose law knows no tooth pairs while its gears have flanks of their own."""
    found = []
    for name, mesh in model.meshes.items():
        gears = [g for g in mesh.gears if model.gears[g].is_modified]
        if gears and mesh.stiffness.law not in OF_PAIRS:
            found.append(
                f"meshes.{name}: the law {mesh.stiffness.law} prescribes the stiffness of the whole mesh, so "
                f"modifications, deviations and profiles of {' and '.join(gears)} have no effect; "
                f"{', '.join(OF_PAIRS[:-1])} and {OF_PAIRS[-1]} follow them"
            )
    return tuple(found)


def warn_of_ignored_flanks(model: Model) -> None:
    """Issue these sentences as `ValidityWarning`."""
    for text in ignored_flanks(model):
        warnings.warn(text, ValidityWarning, stacklevel=2)
