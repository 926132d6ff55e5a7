# SPDX-License-Identifier: Apache-2.0
"""Input files of AeroDyn v15: options of the theory, blade and polars."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import FileLine, Message, ModelError
from pitchpoint.geometry.rotor.blade import Blade
from pitchpoint.geometry.rotor.flow import TOWER_SECTORS, RotorFlow
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.polar_range import range_problem
from pitchpoint.geometry.rotor.tower import Tower
from pitchpoint.model.openfast.airfoil import read_airfoil
from pitchpoint.model.openfast.text import InputText, Line, beside, in_file, read_input

_COLUMNS = ("BlSpn", "BlCrvAC", "BlSwpAC", "BlCrvAng", "BlTwist", "BlChord", "BlAFID")
_MOST_AIRFOILS = 1000
_NEEDED = ("InCol_Alfa", "InCol_Cl", "InCol_Cd", "NumAFfiles", "AFNames", "ADBlFile(1)")
"""Names of every primary file of AeroDyn from version 15."""
_CONTINUE = (
    "complete the table, or give the blade as lists: blade: {polars: {NAME: {file: ..., aspect_ratio: ...}}} "
    "continues it as a stalled plate"
)
_UNITS = "correct the value; the file has metres and degrees"


@dataclass(frozen=True)
class AeroDynInput:
    """Contents of an AeroDyn file.

    Attributes
    ----------
    blade
        The first blade with its polars.
    flow
        Options of blade-element momentum theory and density of the air; the wind is not part of the file.
    notes
        What the file contains that is not used.
    """

    blade: Blade
    flow: RotorFlow
    notes: tuple[str, ...]


def read_aerodyn(path: str | os.PathLike[str]) -> AeroDynInput:
    """Primary input file of AeroDyn v15 with its first blade and its airfoils.

    Parameters
    ----------
    path
        The file; names in it are relative to its folder.

    Returns
    -------
    AeroDynInput
        Blade, options and notes.

    Raises
    ------
    ModelError
        With every problem, its file and line.
    """
    text = read_input(path)
    remedy = "give the primary file of AeroDyn, version 15 or later"
    text.require("a primary file of AeroDyn v15", _NEEDED, remedy, ("WakeMod", "Wake_Mod", "TipLoss"))
    columns = [text.count(f"InCol_{name}") for name in ("Alfa", "Cl", "Cd", "Cm")]
    if 0 in columns[:3] and not text.problems:
        text.problem("InCol_Alfa, InCol_Cl, InCol_Cd", "are columns of the airfoil files", None, ">= 1")
    flow, notes = _flow(text)
    airfoils = _airfoil_files(text)
    line = text.find("ADBlFile(1)")
    text.stop()
    problems: list[Message] = []
    polars = []
    for name in airfoils:
        try:
            polars.append(_complete(read_airfoil(beside(text.path, name), columns=columns)))
        except ModelError as error:
            problems += in_file(error, name, _line_of(text, name))
    if problems or line is None:
        raise ModelError(problems, str(text.path))
    name = line.tokens[0]
    try:
        blade = read_aerodyn_blade(beside(text.path, name), polars)
    except ModelError as error:
        at = FileLine(line.number, text.path.name)
        raise ModelError(in_file(error, name, at), str(text.path)) from None
    return AeroDynInput(blade, flow, tuple(notes))


def aerodyn_files(path: str | os.PathLike[str]) -> tuple[str, ...]:
    """Files that `read_aerodyn` reads besides the primary file; none if that cannot be read."""
    try:
        text = read_input(path)
    except ModelError:
        return ()
    blade = text.find("ADBlFile(1)")
    names = [*_airfoil_files(text), *([] if blade is None else [blade.tokens[0]])]
    return tuple(str(beside(text.path, name)) for name in names)


def read_aerodyn_blade(path: str | os.PathLike[str], polars: Sequence[Polar]) -> Blade:
    """Blade file of AeroDyn v15.

    Parameters
    ----------
    path
        The file.
    polars
        Polars in the order of its column BlAFID.

    Raises
    ------
    ModelError
        With every problem and its line.
    """
    text = read_input(path)
    text.require(
        "a blade file of AeroDyn v15", ("NumBlNds",), "give a blade file of AeroDyn, version 15 or later"
    )
    start = text.find("NumBlNds")
    assert start is not None
    count = text.count("NumBlNds")
    title = next((line for line in text.lines if line.tokens[0].lower() == "blspn"), None)
    names = [token.lower() for token in title.tokens] if title else [name.lower() for name in _COLUMNS]
    missing = [name for name in _COLUMNS if name.lower() not in names]
    if missing:
        text.problem(
            ", ".join(missing),
            "are missing in the titles of the columns",
            None,
            None,
            title.number if title else None,
        )
        text.stop()
    at = [names.index(name.lower()) for name in _COLUMNS]
    rows = np.array(text.rows(start, count, max(at) + 1, "stations"), dtype=float).reshape(-1, max(at) + 1)
    text.stop()
    data = rows[:, at]
    _check_rows(text, start, data, len(polars))
    try:
        return Blade(
            span=data[:, 0],
            prebend=data[:, 1],
            sweep=data[:, 2],
            curve_angle=np.radians(data[:, 3]),
            twist=np.radians(data[:, 4]),
            chord=data[:, 5],
            polar_index=data[:, 6].astype(np.int64) - 1,
            polars=polars,
        )
    except ModelError as error:
        raise ModelError(error.problems, str(text.path)) from None


def _check_rows(text: InputText, start: Line, data: NDArray[np.float64], airfoils: int) -> None:
    """Stop at values that no blade has: order of the stations, numbers of airfoils, wrong units."""
    span, twist, chord, index = (data[:, k] for k in (0, 4, 5, 6))
    length = float(span[-1])
    wrong = (index != np.round(index)) | (index < 1) | (index > airfoils)
    known = f"1 to {airfoils}, the airfoils of the primary file"
    falling = np.r_[False, np.diff(span) <= 0.0]
    before = f"> {span[max(int(np.argmax(falling)) - 1, 0)]:.6g} m"
    outside = "is out of range"
    for column, bad, words, unit, limit, remedy in (
        (6, wrong, "is not the number of an airfoil", "", known, "correct it, or name the airfoil"),
        (0, falling, "does not increase", " m", before, "sort the stations from root to tip"),
        (5, chord <= 0.0, outside, " m", "> 0", "give the length of the chord"),
        (5, chord > length, outside, " m", f"<= {length:.6g} m, the length of the blade", _UNITS),
        (4, np.abs(twist) > 90.0, outside, " deg", "-90 to 90 deg", _UNITS),
    ):
        for k in np.flatnonzero(bad)[:1]:
            name = f"{_COLUMNS[column]}, row {k + 1}"
            value = f"{data[k, column]:.6g}{unit}"
            text.problem(name, words, value, limit, text.row_line(start, int(k)), remedy)
        if bad.any() and column in (0, 6):
            text.stop()
    text.stop()


def _complete(polar: Polar) -> Polar:
    """Polar of all angles of attack.

    Raises
    ------
    ModelError
        If it has a smaller range.
    """
    if polar.complete:
        return polar
    raise ModelError([range_problem(polar, _CONTINUE)])


def _airfoil_files(text: InputText) -> list[str]:
    """Names of the airfoil files."""
    before = len(text.problems)
    count = text.count("NumAFfiles")
    if len(text.problems) > before:
        return []
    first = text.find("AFNames")
    if first is None:
        text.problem("AFNames", "is missing", None, None, remedy="give the names of the airfoil files")
        return []
    if not 1 <= count <= _MOST_AIRFOILS:
        text.problem("NumAFfiles", "is out of range", str(count), f"1 to {_MOST_AIRFOILS}")
        return []
    at = text.lines.index(first)
    lines: list[Line] = text.lines[at : at + count]
    names = [lines[0].tokens[0], *(line.tokens[0] for line in lines[1:] if _is_name(line))]
    if len(names) < count:
        text.problem(
            "AFNames",
            "names follow",
            str(len(names)),
            f"{count}, see NumAFfiles",
            first.number,
            "correct one of them",
        )
    return names


def _line_of(text: InputText, name: str) -> FileLine:
    """Line that begins with the name of a file."""
    return FileLine(next(line.number for line in text.lines if line.tokens[0] == name), text.path.name)


def _is_name(line: Line) -> bool:
    """Whether a line of a list holds the name of a file only, or with a remark."""
    return not (len(line.tokens) > 1 and line.tokens[1].lower().startswith("usebl"))


def _flow(text: InputText) -> tuple[RotorFlow, list[str]]:
    """Options of the theory, and notes on what is not used."""
    notes = []
    wake = int(text.number("WakeMod", "Wake_Mod", default=1.0))
    if wake == 3:
        line = text.find("WakeMod", "Wake_Mod")
        text.problem(
            "WakeMod",
            "is the free vortex wake, which is not available",
            "3",
            "0, 1 or 2",
            line.number if line else None,
            "use 1",
        )
    if wake == 2:
        notes.append("WakeMod 2: dynamic inflow in solve_rotor_transient only, with time constants that vary")
    if text.number("AFAeroMod", "UA_Mod", default=1.0) > (0.0 if text.find("UA_Mod") else 1.0):
        notes.append("dynamic stall in solve_rotor_transient only, by the model of Øye")
    if text.number("TwrShadow", default=0.0) != 0.0:
        notes.append("TwrShadow: the wake of the tower is not used")
    potential = text.number("TwrPotent", default=0.0)
    if potential == 2.0:
        notes.append("TwrPotent 2: potential flow around the tower without Bak's correction")
    if text.find("Skew_Mod"):
        skewed = (
            text.number("Skew_Mod", default=1.0) == 1.0 and text.number("SkewRedistr_Mod", default=1.0) == 1.0
        )
    else:
        skewed = text.number("SkewMod", default=2.0) == 2.0
    density = text.number("AirDens", default=1.225)
    try:
        flow = RotorFlow(
            density=density if density == density else 1.225,
            axial_induction=wake != 0,
            tangential_induction=wake != 0 and text.flag("TanInd", default=True),
            drag_in_axial_induction=text.flag("AIDrag", default=False),
            drag_in_tangential_induction=text.flag("TIDrag", default=False),
            tip_loss=text.flag("TipLoss", default=True),
            hub_loss=text.flag("HubLoss", default=True),
            skewed_wake=skewed,
            tower=_tower(text) if potential in (1.0, 2.0) else None,
            sectors=TOWER_SECTORS if potential in (1.0, 2.0) else 12,
        )
    except ModelError as error:
        text.problems += [p.changed(file=text.path.name) for p in error.problems]
        flow = RotorFlow()
    return flow, notes


def _tower(text: InputText) -> Tower | None:
    """Elevations and diameters of the tower."""
    start = text.find("NumTwrNds")
    if start is None:
        text.problem("NumTwrNds", "is missing", None, None, remedy="set TwrPotent to 0")
        return None
    rows = text.rows(start, text.count("NumTwrNds"), 2, "tower")
    if text.problems:
        return None
    table = np.array(rows).reshape(-1, 2)
    return Tower(elevation=table[:, 0], diameter=table[:, 1])
