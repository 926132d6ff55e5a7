# SPDX-License-Identifier: Apache-2.0
"""Programmes of the mass matrix alone: where no mass couples two bodies, its blocks are independent.

Explicit methods factor the mass matrix at every evaluation, because a tilt turns the inertia of a shaft. The
programmes of the whole matrix also go through the blocks by which springs and flanks couple the bodies; of
the mass matrix these are zero. Bodies on ground need nothing but their own diagonal blocks.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.elements import registry
from pitchpoint.multibody.block_lu import FINISH, INVERT, INVERT_MASS
from pitchpoint.system.link import only_observes

NODE = 6


def mass_programmes(
    program: Mapping[str, NDArray[Any]], records: Mapping[str, NDArray[np.void]]
) -> dict[str, NDArray[Any]]:
    """Programmes mass_proj, mass_factor, mass_solve; those of the whole matrix where masses may couple."""
    body, path, proj = program["body"], program["path"], program["proj"]
    alone = np.all(body["count"] <= 1) and not np.any(body["shares"])
    if not alone or not all(_no_mass(name, bank) for name, bank in records.items()):
        return {f"mass_{name}": program[name] for name in ("proj", "factor", "solve")}
    own = path["body"][proj["pi"]] == path["body"][proj["pj"]]
    factor, solve = program["factor"], program["solve"]
    alone_factor = factor[factor["op"] == INVERT]
    alone_factor["op"][alone_factor["na"] == NODE] = INVERT_MASS
    return {
        "mass_proj": proj[own],
        "mass_factor": alone_factor,
        "mass_solve": solve[solve["op"] == FINISH],
    }


def _no_mass(name: str, bank: NDArray[np.void]) -> bool:
    """Whether the records of a kind bring no mass."""
    return registry.find(name).massless or only_observes(name, bank)
