# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies of a system: their records, and the hidden bodies that carry their modal coordinates."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import registry

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def elastic_records(system: System) -> list[tuple[str, np.void, tuple[str, ...]]]:
    """Name and record of every elastic body, and the fields of the hidden bodies; body i is its frame."""
    found = []
    for kind, bank in system.records.items():
        fields = registry.find(kind).modal
        names = system.names.get(kind, ())
        for k, record in enumerate(bank if fields else ()):
            found.append((names[k] if k < len(names) else f"{kind}{k}", record, fields))
    return found


def modal_bodies(system: System, frames: bool = False) -> list[int]:
    """Numbers of all bodies that carry modal coordinates; on request of the frames, too."""
    own = ("i",) if frames else ()
    found = {int(r[field]) for _, r, fields in elastic_records(system) for field in (*own, *fields)}
    return sorted(found - {0})
