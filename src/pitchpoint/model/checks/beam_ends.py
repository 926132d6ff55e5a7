# SPDX-License-Identifier: Apache-2.0
"""Ends at stations of beams, BEAM.2, BEAM.3, ...: what they move with, and branches of other beams."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.model.frames import GROUND, split
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts


def is_beam(parts: Parts, name: str) -> bool:
    """Whether an end with this name is on a beam; a body takes precedence over a beam of its name."""
    return parts.has("beams", name) and not parts.has("bodies", name) and name != GROUND


def part_of(parts: Parts, end: str) -> str:
    """What an end moves with: ground, a body, or a station of a beam."""
    body = split(end)[0]
    return end if is_beam(parts, body) else body


def check_branches(parts: Parts, report: Reader) -> None:
    """Check that no beam begins or ends on itself over stations of others, and remove such beams."""
    for name in list(parts.beams):
        if _returns(parts, name):
            report.problem(
                ("beams", name, "ends"),
                f"lead back to {name}: the position of the beam follows from itself",
                value=" and ".join(parts.beams[name].ends),
                remedy="name a body at one of the ends",
            )
            parts.names["beams"] = parts.known("beams")
            del parts.beams[name]


def _returns(parts: Parts, name: str) -> bool:
    """Whether the position of a beam depends on itself."""
    seen: set[str] = set()
    open_ = [name]
    while open_:
        for end in parts.beams[open_.pop()].ends:
            below = split(end)[0]
            if below == name and is_beam(parts, below):
                return True
            if below in parts.beams and is_beam(parts, below) and below not in seen:
                seen.add(below)
                open_.append(below)
    return False
