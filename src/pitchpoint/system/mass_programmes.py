# SPDX-License-Identifier: Apache-2.0
"""Shorter programmes of the mass matrix if it is block diagonal.

Explicit methods factor the mass matrix at every evaluation, because the inertia of a shaft changes with its
tilt. The programmes of the full matrix also process the coupling blocks of springs and flanks, which are
zero in the mass matrix. Bodies on ground require only their diagonal blocks.
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
    """Programmes mass_proj, mass_factor, mass_solve; those of the full matrix if masses may be coupled."""
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
    """Whether the records of a kind add nothing to the mass matrix."""
    return registry.find(name).massless or only_observes(name, bank)
