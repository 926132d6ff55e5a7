# SPDX-License-Identifier: Apache-2.0
"""Selection of channels by name or pattern."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from pitchpoint.core.errors import SolverError
from pitchpoint.core.nearest import nearest
from pitchpoint.core.status import INCONSISTENT

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def chosen_channels(system: System, patterns: Sequence[str]) -> list[int]:
    """Numbers of the channels that match the patterns, in the order of the system; without patterns all.

    Parameters
    ----------
    system
        The compiled system.
    patterns
        Channel names; * matches any characters, as in `mesh_force[*]`.

    Raises
    ------
    SolverError
        If a pattern matches no channel.
    """
    names = [c.name for c in system.layout.channels]
    if not patterns:
        return list(range(len(names)))
    found: set[int] = set()
    for pattern in patterns:
        whole = re.compile(".*".join(map(re.escape, pattern.split("*"))))
        hits = {k for k, name in enumerate(names) if whole.fullmatch(name)}
        if not hits:
            near = nearest(pattern, names) or names[:1]
            raise SolverError(
                f"channels: {pattern!r} matches none of the {len(names)} channels; an example is "
                f"{' '.join(near)} (* matches any characters)",
                INCONSISTENT,
            )
        found |= hits
    return sorted(found)
