# SPDX-License-Identifier: Apache-2.0
"""Checks of winds and of the rotors of wind turbines."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pitchpoint.core.errors import ModelError
from pitchpoint.model.beam_tables import part_in_file
from pitchpoint.model.checks.references import known
from pitchpoint.model.components.beam import FILES
from pitchpoint.model.frames import GROUND, axes_of, place_of, split
from pitchpoint.model.keys import Place, defaults_of
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.rotor_input import rotor_input
from pitchpoint.model.scenario import ERROR_METHODS, STIFF_METHODS

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor
    from pitchpoint.model.parts import Parts

_OF_SPEED = ("height", "profile", "exponent", "roughness_length", "inflow_angle", "direction")
"""Keys of a wind that only describe its speed."""
_APART = 0.2
"""Largest distance of an end of a blade from that of its beam, relative to the beam."""


def check_wind_rotors(parts: Parts, report: Reader) -> None:
    """Check winds, and number and kind of the blades of all rotors."""
    for name, wind in parts.winds.items():
        at = ("winds", name)
        if wind.speed is not None and wind.height is None and at not in report.tainted:
            report.problem(
                at, "has no height", remedy="give the height of its speed, such as that of the hub"
            )
        if wind.box is not None:
            usual = defaults_of(type(wind))
            for key in _OF_SPEED:
                if getattr(wind, key) != usual[key]:
                    text = "is given together with box, which contains the wind"
                    report.problem((*at, key), text, remedy=f"remove {key}, or give speed instead of box")
        if wind.box is not None and wind.gust is not None:
            report.problem((*at, "gust"), "has no steady wind to change", remedy="give speed instead of box")
        try:
            _ = wind.steady, wind.gust.data if wind.gust is not None else None
        except ModelError as error:
            for p in error.problems:
                within = ("gust",) if p.where.startswith("gust") else ()
                key = p.where.rpartition(".")[2].replace("hub_height", "height")
                report.problem((*at, *within, key), p.text, value=p.value, limit=p.limit, remedy=p.remedy)
    for name, rotor in parts.wind_rotors.items():
        at = ("wind_rotors", name)
        if at not in report.tainted:
            _stations(rotor, at, report)
            _turns(rotor, at, report)
            _blades(rotor, at, report)
            _beams(parts, rotor, at, report)
            _diameters(parts, rotor, at, report)
            _wind(parts, rotor, at, report)
            _step(parts, rotor, at, report)
    for name, scenario in parts.scenarios.items():
        if scenario.wind is not None:
            known(parts, "winds", scenario.wind, ("scenarios", name, "wind"), report)


def _turns(rotor: WindRotor, at: Place, report: Reader) -> None:
    """Check that the hub is on a body."""
    if split(rotor.hub)[0] == GROUND:
        remedy = "give the body that turns with the blades"
        report.problem((*at, "hub"), "is on ground, which does not turn", remedy=remedy)


def _beams(parts: Parts, rotor: WindRotor, at: Place, report: Reader) -> None:
    """Check that every beam is where its blade is, in the order of the blades."""
    if len(rotor.beams) != rotor.blades or any(at == t[: len(at)] for t in report.tainted):
        return
    centre, hub = place_of(parts, rotor.hub), axes_of(parts, rotor.hub)
    shape = rotor_input(rotor).rotor
    for k, name in enumerate(rotor.beams):
        beam = parts.beams.get(name)
        ends = [] if beam is None else [place_of(parts, end) for end in beam.ends]
        if centre is None or not ends or any(end is None for end in ends):
            continue
        length = float(np.linalg.norm(ends[1] - ends[0]))  # type: ignore[operator]
        turn = 2.0 * math.pi * k / rotor.blades
        out = math.cos(turn) * hub[:, 0] + math.sin(turn) * hub[:, 1]
        for n, end in ((0, ends[0]), (-1, ends[1])):
            arm = math.sqrt(max(shape.radius[n] ** 2 - shape.blade.sweep[n] ** 2, 0.0)) * out
            station = (
                centre + arm - shape.blade.sweep[n] * np.cross(hub[:, 2], out) + shape.axial[n] * hub[:, 2]
            )
            apart = float(np.linalg.norm(station - end))
            if apart > _APART * length:
                part = f"the {'tip' if n else 'root'} of blade {k + 1}"
                report.problem(
                    (*at, "beams", k),
                    f"is the distance of {part} from the end of {name}",
                    value=f"{apart:.4g} m",
                    limit=f"<= {_APART * length:.4g} m, a fifth of the beam",
                    remedy="name the beams in the order of rotation, from the direction of x of the hub",
                )
                break
        else:
            _file_of_blade(parts, name, rotor, report)


def _file_of_blade(parts: Parts, name: str, rotor: WindRotor, report: Reader) -> None:
    """Report the file of a tower for a blade, once for the blades of a rotor."""
    part = parts.beams[name].properties
    if part is None or part_in_file(part) != "tower":
        return
    key = next(k for k in FILES if getattr(part, k) is not None)
    place = ("beams", name, "properties", key)
    if any(("beams", other, "properties", key) in report.tainted for other in rotor.beams):
        report.taint(place)
        return
    remedy = "give component: blade" if key == "windio" else "give a blade file"
    file = Path(str(getattr(part, key))).name
    report.problem(place, "describes a tower, and the beam is a blade", value=f"'{file}'", remedy=remedy)


def _diameters(parts: Parts, rotor: WindRotor, at: Place, report: Reader) -> None:
    """Refuse diameters of blades, which are drawn with their chords."""
    for k, name in enumerate(rotor.beams):
        beam = parts.beams.get(name)
        if beam is not None and beam.diameters and (*at, "beams", k) not in report.tainted:
            remedy = "remove them: a blade has the chords of its stations"
            report.problem(("beams", name, "diameters"), "are not for blades", remedy=remedy)


def _blades(rotor: WindRotor, at: Place, report: Reader) -> None:
    if rotor.bodies and rotor.beams:
        remedy = "give bodies for rigid blades, or beams for elastic ones"
        report.problem((*at, "beams"), "is given together with bodies", remedy=remedy)
    for key in ("bodies", "beams"):
        count = len(getattr(rotor, key))
        if count not in (0, rotor.blades):
            report.problem(
                (*at, key),
                "is the number of names",
                value=str(count),
                limit=f"{rotor.blades}, one for each blade",
                remedy="name one for each blade, in the order of rotation, or correct blades",
            )
    if rotor.stall == "dynamic" and rotor.inflow != "dynamic":
        report.problem((*at, "stall"), "requires dynamic inflow", remedy="give inflow: dynamic")


def _stations(rotor: WindRotor, at: Place, report: Reader) -> None:
    """Hub radius, and the blade of the files or lists."""
    if rotor.tower_flow and rotor.windio is None:
        report.problem((*at, "tower_flow"), "is the tower of a windIO file", remedy="give windio")
    if rotor.hub_radius is None and rotor.windio is None:
        report.problem(at, "has no hub_radius", remedy="give the distance of the blade roots from the axis")
        return
    if any(at == tainted[: len(at)] for tainted in report.tainted):
        return
    try:
        found = rotor_input(rotor).rotor
    except ModelError as error:
        reported = {p.text for p in report.problems}
        for problem in error.problems:
            if problem.text in reported and rotor.windio is not None:  # at a beam of the same file
                report.taint((*at, "windio"))
            else:
                report.hand_on(at, problem)
        return
    if found.hub_radius > found.blade.length:
        report.problem(
            (*at, "hub_radius"),
            "is larger than the blade",
            value=f"{found.hub_radius:.6g} m",
            limit=f"<= {found.blade.length:.6g} m, the length of the blade",
            remedy="give the distance of the blade roots from the axis, with its unit",
        )


def _wind(parts: Parts, rotor: WindRotor, at: Place, report: Reader) -> None:
    if rotor.wind is not None:
        return  # its name is checked with all names
    winds = sorted(parts.known("winds"))
    if not winds:
        report.problem(at, "has no wind", remedy="add a wind to winds")
    elif len(winds) > 1:
        report.problem(at, "names no wind", limit=", ".join(winds), remedy="give wind: NAME")


def _step(parts: Parts, rotor: WindRotor, at: Place, report: Reader) -> None:
    for name, scenario in parts.scenarios.items():
        if rotor.step and scenario.method in (*ERROR_METHODS, *STIFF_METHODS):
            report.problem(
                (*at, "step"),
                f"is the method of scenario {name} and has no fixed steps",
                value=scenario.method,
                limit="generalized_alpha, adams or rk4",
                remedy="change the method, or omit step",
            )
