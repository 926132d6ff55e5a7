# SPDX-License-Identifier: Apache-2.0
"""Blade of BeamDyn: key points of its axis, and the stiffness and mass matrices of its stations."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import FileLine, ModelError
from pitchpoint.geometry.section_matrix import check_inertia, check_stiffness
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.openfast.text import InputText, Line, beside, in_file, read_input

FloatArray = NDArray[np.float64]
_MOST_STATIONS = 1000
_ROWS = 13
"""Lines of a station: its place, and six rows of each matrix."""
_DIGITS = 6
"""Digits of places in files; stations and key points at one place are one."""


def read_beamdyn(path: str | os.PathLike[str]) -> SectionTable:
    """Section matrices of a blade from BeamDyn's primary file and the blade file that it names.

    Parameters
    ----------
    path
        The primary file.

    Returns
    -------
    SectionTable
        Axis 1 is flapwise without twist, downwind; the line of the beam is the z axis of the root. With
        damping factors BeamDyn has the damping matrix mu_i K_ij of a section; the table has
        sqrt(mu_i mu_j) K_ij, which is the same without coupling or with equal factors, and dissipates for any
        motion.

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
        blade = read_input(beside(Path(path), name))
        damping = _damping(blade)
        place, stiffness, inertia = _stations(blade)
    except ModelError as error:
        at = FileLine(named.number, text.path.name)
        raise ModelError(in_file(error, name, at), str(text.path)) from None
    arc = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(points[:, :3], axis=0), axis=1))]
    matrices = {"stiffness": stiffness, "inertia": inertia, "damping": damping}
    return section_table(place, matrices, points[:, :3], -np.radians(points[:, 3]), arc)


def beamdyn_files(path: str | os.PathLike[str]) -> tuple[str, ...]:
    """Files that `read_beamdyn` reads besides the primary file; none if that cannot be read."""
    try:
        named = read_input(path).find("BldFile")
    except ModelError:
        return ()
    return () if named is None else (str(beside(Path(path), named.tokens[0])),)


def section_table(
    place: FloatArray,
    matrices: dict[str, FloatArray],
    axis: FloatArray,
    twist: FloatArray,
    at: FloatArray,
) -> SectionTable:
    """Section matrices over the length of a blade from those of its stations and its curved axis.

    Parameters
    ----------
    place
        Stations as shares of the length, from 0 to 1, shape (n,).
    matrices
        Stiffness and inertia at these stations, shape (n, 6, 6), and damping, shape (6,).
    axis
        Points of the curved axis, shape (m, 3) [m]; z increases.
    twist
        Rotation of the axes of the sections about z at these points, shape (m,) [rad].
    at
        Coordinate of these points along the blade that a share of the length refers to, shape (m,).

    Examples
    --------
    >>> both = np.stack([np.eye(6), np.eye(6)])
    >>> axis = np.array([[0.0, 0, 0], [0.1, 0, 5.0], [0.4, 0, 10.0]])
    >>> given = {"stiffness": both, "inertia": both, "damping": np.zeros(6)}
    >>> table = section_table(np.array([0.0, 1.0]), given, axis, np.zeros(3), axis[:, 2])
    >>> table.length, table.offset_1.tolist(), table.position.tolist()
    (10.0, [0.0, 0.1, 0.4], [0.0, 0.5, 1.0])
    """
    share = (at - at[0]) / (at[-1] - at[0])
    every = np.union1d(place.round(_DIGITS), share.round(_DIGITS))
    z = np.interp(every, share, axis[:, 2])
    length = float(axis[-1, 2] - axis[0, 2])
    position = (z - z[0]) / length
    position[0], position[-1] = 0.0, 1.0
    return SectionTable(
        position=position,
        stiffness=between(place, matrices["stiffness"], every),
        inertia=between(place, matrices["inertia"], every),
        damping=matrices["damping"],
        twist=np.interp(every, share, twist),
        offset_1=np.interp(every, share, axis[:, 0]),
        offset_2=np.interp(every, share, axis[:, 1]),
        length=length,
    )


def between(grid: FloatArray, values: FloatArray, at: FloatArray) -> FloatArray:
    """Matrices at other places, linear between those of a grid, shape (n, 6, 6) to (m, 6, 6)."""
    flat = values.reshape(grid.size, -1)
    return np.stack([np.interp(at, grid, column) for column in flat.T], axis=1).reshape(-1, 6, 6)


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


def _damping(text: InputText) -> FloatArray:
    """Damping over stiffness of the six strains [s]; zero without damping."""
    line = text.find("damp_type", "damp_flag")
    if line is None:
        text.problem("damp_type", "is missing", None, None, remedy="give a blade file of BeamDyn")
        text.stop()
    assert line is not None
    kind = line.tokens[0].strip("\"'").lower()
    if kind in ("0", "f", "false"):
        return np.zeros(6)
    if kind not in ("1", "t", "true"):
        remedy = "set it to 0, and give internal_damping of the beam"
        text.problem("damp_type", "is not supported", kind, "0 or 1, by the stiffness", line.number, remedy)
        text.stop()
    title = next((ln for ln in text.lines if ln.tokens[0].lower() == "mu1"), None)
    if title is None:
        text.problem("mu1", "is not the title of a column", None, None, line.number)
        text.stop()
    assert title is not None
    rows = text.rows(title, 1, 6, "damping factors")
    text.stop()
    found = np.array(rows, dtype=float).ravel()
    if not ((found >= 0.0) & np.isfinite(found)).all():
        shown = " ".join(f"{x:g}" for x in found)
        text.problem("mu1 to mu6", "are out of range", shown, ">= 0", title.number)
        text.stop()
    return found


def _stations(text: InputText) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Places from 0 to 1 of the stations of a blade file, stiffness and mass matrices there."""
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
    _check_shape(text, lines, count)
    place, found = np.zeros(count), np.zeros((2, count, 6, 6))
    wrong: dict[str, list[tuple[int, str]]] = {}
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
        found[:, k] = rows[:6], rows[6:]
        for part, check, first in (("stiffness", check_stiffness, 0), ("mass", check_inertia, 6)):
            try:
                check(rows[first : first + 6])
            except ValueError as error:
                wrong.setdefault(part, []).append((k, str(error)))
    for part, each in wrong.items():
        k, reason = each[0]
        more = f"; {len(each) - 1} others are wrong, too" if each[1:] else ""
        at = lines[_ROWS * k + (1 if part == "stiffness" else 7)].number
        text.problem(f"station {k + 1}, {part}", f"{reason}{more}", None, None, at, "correct the matrix")
    if not text.problems and (place[0] != 0.0 or place[-1] != 1.0 or (np.diff(place) <= 0.0).any()):
        text.problem("stations", "are not increasing places", f"{place[0]:g} to {place[-1]:g}", "0 to 1")
    text.stop()
    return place, found[0], found[1]


def _check_shape(text: InputText, lines: list[Line], count: int) -> None:
    """Stop at the first line that has not the numbers of its place in a station."""
    for k, line in enumerate(lines[: _ROWS * count]):
        station, row = divmod(k, _ROWS)
        wanted = 6 if row else 1
        if len(line.tokens) < wanted or (not row and len(line.tokens) != 1):
            what = f"row {row} of its matrices" if row else "its place"
            limit, remedy = f"{wanted}, {what}", "complete the station, or correct the line"
            text.problem(
                f"station {station + 1}",
                "is the number of values of a line",
                str(len(line.tokens)),
                limit,
                line.number,
                remedy,
            )
            text.stop()


def _numbers_at_the_end(text: InputText) -> list[Line]:
    """Lines of the stations: from the first line with a single number after all titles."""
    for k, line in enumerate(text.lines):
        if len(line.tokens) == 1 and k + 1 < len(text.lines) and text.is_number(line.tokens[0]):
            return text.lines[k:]
    return []
