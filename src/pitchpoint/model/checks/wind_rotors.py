# SPDX-License-Identifier: Apache-2.0
"""Checks of winds and of the rotors of wind turbines."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pitchpoint.core.errors import ModelError
from pitchpoint.model.checks.references import known
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.rotor_input import rotor_input
from pitchpoint.model.scenario import ERROR_METHODS, STIFF_METHODS

if TYPE_CHECKING:
    from pitchpoint.model.components.wind_rotor import WindRotor
    from pitchpoint.model.parts import Parts


def check_wind_rotors(parts: Parts, report: Reader) -> None:
    """Check winds, and number and kind of the blades of all rotors."""
    for name, wind in parts.winds.items():
        at = ("winds", name)
        if wind.speed is not None and wind.height is None and at not in report.tainted:
            report.problem(
                at, "has no height", remedy="give the height of its speed, such as that of the hub"
            )
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
            _blades(rotor, at, report)
            _wind(parts, rotor, at, report)
            _step(parts, rotor, at, report)
    for name, scenario in parts.scenarios.items():
        if scenario.wind is not None:
            known(parts, "winds", scenario.wind, ("scenarios", name, "wind"), report)


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
        told = {p.text for p in report.problems}
        for problem in error.problems:
            if problem.text in told and rotor.windio is not None:  # at a beam of the same file
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
