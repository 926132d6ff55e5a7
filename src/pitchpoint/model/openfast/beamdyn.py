# SPDX-License-Identifier: Apache-2.0
"""Blade of BeamDyn: key points of its axis, and the stiffness and mass matrices of its stations."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import FileLine, ModelError
from pitchpoint.geometry.beam_table import BeamTable
from pitchpoint.geometry.section_matrix import continued, section_properties
from pitchpoint.model.openfast.text import InputText, Line, beside, in_file, read_input

FloatArray = NDArray[np.float64]
_MOST_STATIONS = 1000
_ROWS = 13
"""Lines of a station: its place, and six rows of each matrix."""
_DIGITS = 6
"""Digits of places in files; stations and key points at one place are one."""


def read_beamdyn(path: str | os.PathLike[str]) -> BeamTable:
    """Beam properties of a blade from BeamDyn's primary file and the blade file that it names.

    Parameters
    ----------
    path
        The primary file.

    Returns
    -------
    BeamTable
        Axis 1 is flapwise without twist, downwind; the line of the beam is the z axis of the root. Not used:
        damping, and the coupling of bending and torsion.

    Raises
    ------
    ModelError
        With every problem, its file and line.
    """
    text = read_input(path)
    needed = ("member_total", "kp_total", "BldFile")
    text.require("a primary file of BeamDyn", needed, "give the primary file of BeamDyn")
    points = _key_points(text)
    named = text.find("BldFile")
    text.stop()
    assert named is not None and points is not None
    name = named.tokens[0]
    try:
        place, sections = _stations(read_input(beside(Path(path), name)))
    except ModelError as error:
        at = FileLine(named.number, text.path.name)
        raise ModelError(in_file(error, name, at), str(text.path)) from None
    arc = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points[:, :3], axis=0), axis=1))]
    return beam_table(place, sections, points[:, :3], -np.radians(points[:, 3]), arc)


def beamdyn_files(path: str | os.PathLike[str]) -> tuple[str, ...]:
    """Files that `read_beamdyn` reads besides the primary file; none if that cannot be read."""
    try:
        named = read_input(path).find("BldFile")
    except ModelError:
        return ()
    return () if named is None else (str(beside(Path(path), named.tokens[0])),)


def beam_table(
    place: FloatArray,
    sections: list[dict[str, float]],
    axis: FloatArray,
    twist: FloatArray,
    at: FloatArray,
) -> BeamTable:
    """Properties over the length of a blade from those of its sections and its curved axis.

    Parameters
    ----------
    place
        Stations of the sections as shares of the length, from 0 to 1, shape (n,).
    sections
        Properties at these stations, of `section_properties`; their axes are made continuous.
    axis
        Points of the curved axis, shape (m, 3) [m]; z increases.
    twist
        Rotation of the axes of the sections about z at these points, shape (m,) [rad].
    at
        Coordinate of these points along the blade that a share of the length refers to, shape (m,).

    Examples
    --------
    >>> one = section_properties(np.eye(6), np.eye(6))
    >>> axis = np.array([[0.0, 0, 0], [0.1, 0, 5.0], [0.4, 0, 10.0]])
    >>> table = beam_table(np.array([0.0, 1.0]), [one, one], axis, np.zeros(3), axis[:, 2])
    >>> table.length, table.offset_1.tolist(), table.position.tolist()
    (10.0, [0.0, 0.1, 0.4], [0.0, 0.5, 1.0])
    """
    sections = continued(sections)
    share = (at - at[0]) / (at[-1] - at[0])
    every = np.union1d(place.round(_DIGITS), share.round(_DIGITS))
    z = np.interp(every, share, axis[:, 2])
    line = {f"offset_{k + 1}": np.interp(every, share, axis[:, k]) for k in range(2)}
    columns = {name: np.interp(every, place, [section[name] for section in sections]) for name in sections[0]}
    columns["twist"] = columns["twist"] + np.interp(every, share, twist)
    length = float(axis[-1, 2] - axis[0, 2])
    position = (z - z[0]) / length
    position[0], position[-1] = 0.0, 1.0
    return BeamTable(position=position, length=length, **columns, **line)


def _key_points(text: InputText) -> FloatArray | None:
    """Rows of x, y, z [m] and initial twist [deg] of the first member."""
    if (members := text.count("member_total")) > 1:
        line = text.find("member_total")
        text.problem(
            "member_total", "is the number of members", str(members), "1", line.number if line else None
        )
    count = text.count("kp_total")
    title = next((ln for ln in text.lines if ln.tokens[0].lower() == "kp_xr"), None)
    if title is None:
        text.problem("kp_xr", "is not the title of a column", None, None, remedy="give a file of BeamDyn")
        return None
    rows = np.array(text.rows(title, count, 4, "key points"), dtype=float).reshape(-1, 4)
    if not text.problems and (len(rows) < 2 or (np.diff(rows[:, 2]) <= 0.0).any()):
        text.problem("kp_zr", "does not increase from the root to the tip", None, None, title.number)
    return rows


def _stations(text: InputText) -> tuple[FloatArray, list[dict[str, float]]]:
    """Places from 0 to 1 of the stations of a blade file, and the properties there."""
    text.require("a blade file of BeamDyn", ("station_total",), "give a blade file of BeamDyn")
    count = text.count("station_total")
    if not 2 <= count <= _MOST_STATIONS:
        line = text.find("station_total")
        text.problem(
            "station_total",
            "is out of range",
            str(count),
            f"2 to {_MOST_STATIONS}",
            line.number if line else None,
            "give a blade file of BeamDyn",
        )
        text.stop()
    lines = _numbers_at_the_end(text)
    if len(lines) < _ROWS * count:
        text.problem(
            "stations", "is the number of complete stations", str(len(lines) // _ROWS), f"{count} as stated"
        )
    text.stop()
    place, found = np.zeros(count), []
    for k in range(count):
        own = lines[_ROWS * k : _ROWS * (k + 1)]
        name = f"station {k + 1}"
        place[k] = text.value(own[0], 0, name)
        rows = [
            [text.value(line, c, f"{name}, row {r}, column {c + 1}") for c in range(6)]
            for r, line in enumerate(own[1:], 1)
        ]
        if text.problems:
            continue
        try:
            found.append(section_properties(rows[:6], rows[6:]))
        except ValueError as error:
            text.problem(name, str(error), None, None, own[0].number, "correct the matrix")
    if not text.problems and (place[0] != 0.0 or place[-1] != 1.0 or (np.diff(place) <= 0.0).any()):
        text.problem("stations", "are not increasing places", f"{place[0]:g} to {place[-1]:g}", "0 to 1")
    text.stop()
    return place, found


def _numbers_at_the_end(text: InputText) -> list[Line]:
    """Lines of the stations: from the first line with a single number after all titles."""
    for k, line in enumerate(text.lines):
        if len(line.tokens) == 1 and k + 1 < len(text.lines) and text.is_number(line.tokens[0]):
            return text.lines[k:]
    return []
