# SPDX-License-Identifier: Apache-2.0
"""Check of ends at stations of beams, after all bodies have been located: messages give their positions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.nearest import LISTED, did_you_mean
from pitchpoint.model.checks.beam_ends import is_beam
from pitchpoint.model.checks.references import ends_of
from pitchpoint.model.frames import beam_length, split
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.shafts import in_mm

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam
    from pitchpoint.model.parts import Parts


def check_stations(parts: Parts, report: Reader) -> None:
    """Check that the ends of elements on beams, and loads on beams, refer to existing stations."""
    for group, name, key, given in ends_of(parts):
        many = not isinstance(given, str)
        for i, end in enumerate(given if many else (given,)):
            if is_beam(parts, split(end)[0]):
                _station(parts, end, (group, name, key, i) if many else (group, name, key), report)
    for name, load in parts.loads.items():
        if is_beam(parts, load.body):
            _station(parts, f"{load.body}.{load.marker or ''}", ("loads", name, "marker"), report)


def _station(parts: Parts, end: str, at: Place, report: Reader) -> None:
    """Report a station that a beam does not have."""
    name, number = split(end)
    beam = parts.beams.get(name)
    if beam is None:
        return  # unreadable, reported already
    if number in (ends := {"1": beam.ends[0], str(beam.pieces + 1): beam.ends[1]}):
        report.problem(at, f"names an end of the beam {name}", value=end, remedy=f"write {ends[number]}")
    elif not number:
        report.problem(at, f"names the beam {name} without a station", remedy=_listed(parts, name, beam))
    elif number not in beam.stations:
        report.problem(
            at,
            f"names the station {number[:40]!r}, which {name} does not have",
            remedy=did_you_mean(end, [f"{name}.{k}" for k in beam.stations]) + _listed(parts, name, beam),
        )


def _listed(parts: Parts, name: str, beam: Beam) -> str:
    """The stations of a beam with their positions, for remedies."""
    if not beam.stations:
        return f"{name} has pieces: 1 and no stations; give pieces: 2 or more"
    length = beam_length(parts, beam)
    words = {
        k: f"{x:.3g} of its length" if length is None else f"{in_mm(x * length)}"
        for k, x in beam.stations.items()
    }
    listed = [f"{name}.{k} at {words[k]}" for k in beam.stations]
    if len(listed) > LISTED:
        return f"there are {listed[0]} from {beam.ends[0]}, {listed[1]}, and so on to {listed[-1]}"
    return f"there are {', '.join(listed)} from {beam.ends[0]}"
