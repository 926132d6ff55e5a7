# SPDX-License-Identifier: Apache-2.0
"""Ring modes of flexible rims in `check`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


def ring_modes(model: Model) -> int:
    """Number of modes of all flexible rims on bodies."""
    rims = [model.gears[g].flexible_rim for body in model.bodies.values() for g in body.gears]
    return sum(rim.coordinates for rim in rims if rim is not None)


def rims_of_model(model: Model) -> dict[str, Any]:
    """Natural frequencies of all flexible rims, see `pitchpoint.system.rules.flexible_rim.rim_facts`."""
    from pitchpoint.system.rules.flexible_rim import rim_facts

    return rim_facts(model)
