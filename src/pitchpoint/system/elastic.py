# SPDX-License-Identifier: Apache-2.0
"""Elastic bodies of a system: their records, and the hidden bodies of their modal coordinates."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.elements import registry

if TYPE_CHECKING:
    from pitchpoint.system.system import System


def elastic_records(system: System) -> list[tuple[str, np.void, tuple[str, ...]]]:
    """Name, record and record fields of the hidden bodies of each elastic body; field i is its frame."""
    found = []
    for kind, bank in system.records.items():
        fields = registry.find(kind).modal
        names = system.names.get(kind, ())
        for k, record in enumerate(bank if fields else ()):
            found.append((names[k] if k < len(names) else f"{kind}{k}", record, fields))
    return found


def modal_bodies(system: System, frames: bool = False) -> list[int]:
    """Numbers of all bodies with modal coordinates; with `frames` also those of the floating frames.

    The frame of a flexible rim is none: it is a body with mass, and the record has none.
    """
    found = set()
    for _, record, fields in elastic_records(system):
        own = ("i",) if frames and record["mass"] > 0.0 else ()
        found |= {int(record[field]) for field in (*own, *fields)}
    return sorted(found - {0})


def frames_of(system: System) -> list[int]:
    """Number of the body whose motion each body describes, by body.

    For the hidden bodies of modal coordinates and the nodes of an elastic body it is its floating frame, for
    those of a flexible rim the body of the gear; for all others it is the body itself.
    """
    body = system.program["body"]
    found = list(range(len(body)))
    for _, record, fields in elastic_records(system):
        for field in fields:
            found[int(record[field])] = int(record["i"])
    found[0] = 0
    for b in np.flatnonzero(body["shares"]):
        found[b] = found[int(body[b]["shares"])]
    return found
