# SPDX-License-Identifier: Apache-2.0
"""Checks of beams: cross-section, ends, direction of axis 1."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import ModelError
from pitchpoint.model.beam_tables import beam_table_of, part_in_file
from pitchpoint.model.checks.beam_ends import is_beam
from pitchpoint.model.components.beam import BESIDE_MATRICES, FILES, IN_FILE, SHAPES
from pitchpoint.model.frames import ALONG, GROUND, place_of, split, unit
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.beam import Beam, BeamProperties, BeamSection
    from pitchpoint.model.parts import Parts

LENGTH_ERROR = 0.01
"""Largest difference of the length of a beam from that of its file, relative."""


def check_beams(parts: Parts, report: Reader) -> None:
    """Check all beams after the bodies have been located."""
    reported: set[tuple[str, str]] = set()
    for name, beam in parts.beams.items():
        at: Place = ("beams", name)
        if name in parts.bodies and beam.pieces > 1:
            report.problem(at, "has the name of a body", remedy="choose a unique name for the beam")
        if beam.section is not None and (*at, "section") not in report.tainted:
            _section(beam.section, (*at, "section"), report)
        if beam.diameters and beam.section is not None:
            remedy = "remove them: the section has its shape"
            report.problem((*at, "diameters"), "are for beams with properties", remedy=remedy)
        if len(beam.diameters) == 1:
            remedy = "give the diameters at both ends, and more between them"
            report.problem((*at, "diameters"), "is one diameter", limit="at least 2", remedy=remedy)
        if beam.properties is not None and (*at, "properties") not in report.tainted:
            _properties(beam.properties, (*at, "properties"), report, reported)
        if (*at, "ends") not in report.tainted:
            _place(parts, beam, at, report)


def _length(parts: Parts, beam: Beam, length: float, at: Place, report: Reader) -> None:
    """Length of a beam from the places of its ends, and of its file."""
    properties = (*at, "properties")
    if beam.properties is None or any(properties == t[: len(properties)] for t in report.tainted):
        return
    blades = {name for rotor in parts.wind_rotors.values() for name in rotor.beams}
    if at[1] in blades and part_in_file(beam.properties) == "tower":
        return  # reported at the rotor
    own = beam_table_of(beam.properties).length
    if own > 0.0 and abs(length / own - 1.0) > LENGTH_ERROR:
        report.problem(
            (*at, "ends"),
            "is the distance of the ends",
            value=f"{length:.6g} m",
            limit=f"{own:.6g} m as in the file, to {100 * LENGTH_ERROR:g} %",
            remedy="place the ends of the beam at both ends of the pitch axis or of the tower",
        )


def _section(section: BeamSection, at: Place, report: Reader) -> None:
    given = section.given
    whole = [shape for shape in SHAPES if given == shape]
    if not whole:
        report.problem(
            at,
            f"gives {', '.join(given)}" if given else "is not given",
            remedy="give diameter, or width and height, or area, bending and torsion",
        )
        return
    if section.bore and given != SHAPES[0]:
        report.problem((*at, "bore"), "is for round sections only", remedy="give diameter, or remove it")
    if any(section.shear) and given != SHAPES[2]:
        report.problem((*at, "shear"), "is for general sections only", remedy="remove it")
    if section.diameter is not None and section.bore >= section.diameter:
        report.problem(
            (*at, "bore"),
            "is not smaller than the diameter",
            value=f"{section.bore * 1e3:.6g} mm",
            limit=f"below the diameter {section.diameter * 1e3:.6g} mm",
            remedy="give diameters, not radii",
        )
    if section.bending and len(section.bending) != 2:
        report.problem(
            (*at, "bending"),
            f"has {len(section.bending)} entries",
            remedy="give two second moments of area: for bending in the direction of axis 1 and axis 2",
        )


def _properties(part: BeamProperties, at: Place, report: Reader, reported: set[tuple[str, str]]) -> None:
    """Check lists and file; `reported` has the problems of files that several beams name."""
    given = part.lists
    files = [name for name in FILES if getattr(part, name) is not None]
    if len(files) > 1:
        report.problem((*at, files[1]), f"is given together with {files[0]}", remedy="give one file")
        return
    if files:
        for name in [n for n in given if files[0] != "elastodyn" or n in IN_FILE]:
            report.problem((*at, name), "is in the file too", remedy=f"remove it, or remove {files[0]}")
        others = [name for name in given if name != "position"]
        if files[0] == "elastodyn" and ("position" in given) != bool(others):
            text = f"gives {', '.join(given)} without {'position' if others else 'lists at these positions'}"
            report.problem(at, text, remedy="give position and one value of each list for each of them")
            return
    elif part.stiffness:
        if missing := [name for name in ("position", "inertia") if name not in given]:
            report.problem(at, f"has no {', '.join(missing)}", remedy="give these lists with stiffness")
            return
        for name in [n for n in given if n not in BESIDE_MATRICES]:
            report.problem((*at, name), "is in the section matrices too", remedy="remove it, or stiffness")
    elif missing := [name for name in ("position", *IN_FILE[:3]) if name not in given]:
        report.problem(
            at, f"has no {', '.join(missing)}", remedy=f"give these lists, or stiffness, {', '.join(FILES)}"
        )
        return
    if any((*at, name) in report.tainted for name in (*FILES, *given)):
        return
    try:
        beam_table_of(part)
    except ModelError as error:
        for p in error.problems:
            key, _, entry = p.where.partition("[")
            file = str(getattr(part, key)) if key in FILES else ""
            if file and (file, p.text) in reported:
                report.taint((*at, key))
                continue
            reported.add((file, p.text))
            place = (*at, key, int(entry[:-1])) if entry[:-1].isdigit() else (*at, key)
            report.problem(place, p.text, value=p.value, limit=p.limit, remedy=p.remedy)


def _place(parts: Parts, beam: Beam, at: Place, report: Reader) -> None:
    one, two = beam.ends
    owners = [split(e)[0] for e in beam.ends]
    if not all(n == GROUND or n in parts.bodies or is_beam(parts, n) for n in owners):
        return  # reported already
    first, second = place_of(parts, one), place_of(parts, two)
    if first is None or second is None:
        return
    way = second - first
    length = float(np.linalg.norm(way))
    if not length > 1e-9:
        report.problem(
            (*at, "ends"),
            "coincide",
            value=f"({', '.join(f'{x * 1e3:.6g}' for x in first)}) mm",
            remedy="correct the positions of the bodies or markers, so that the beam has a length",
        )
        return
    _length(parts, beam, length, at, report)
    if beam.axis is not None:
        _axis(beam, way / length, at, report)


def _axis(beam: Beam, along: np.ndarray, at: Place, report: Reader) -> None:
    axis = unit(beam.axis or (0.0, 0.0, 0.0))
    if not np.any(axis):
        report.problem((*at, "axis"), "has no direction", remedy="give a direction perpendicular to the beam")
    elif abs(float(axis @ along)) > ALONG:
        angle = math.degrees(math.acos(min(1.0, abs(float(axis @ along)))))
        report.problem(
            (*at, "axis"),
            "points along the beam",
            value=f"{angle:.3g} deg from it",
            remedy="give a direction perpendicular to the beam",
        )
