# SPDX-License-Identifier: Apache-2.0
"""Values of a windIO file by their path, with the line in messages."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import FileLine, Message, ModelError
from pitchpoint.core.nearest import nearest
from pitchpoint.model.files import read_once
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.yaml_tree import Tree, TreeError, text_of
from pitchpoint.model.show import dotted

FloatArray = NDArray[np.float64]
MOST_POINTS = 10_000
"""Largest number of points of a distribution."""
BAD = np.array([0.0, 1.0])
MISSING = "is missing"
LARGEST = 1000.0
"""Length of a blade or height of a tower that no turbine has [m]."""


@dataclass
class Ontology:
    """Contents of a windIO file, and the problems and notes of its reading so far.

    Parameters
    ----------
    path
        The file.
    data
        Its contents.
    lines
        Lines of keys and list entries by their path.
    """

    path: Path
    data: Any
    lines: Mapping[Place, int]
    problems: list[Message] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def version(self) -> int:
        """Number of the layout: 1 (radians, `outer_shape_bem`) or 2 (degrees, `outer_shape`)."""
        if "windIO_version" in self.data:
            return 1 if str(self.data["windIO_version"]).split(".")[0] == "1" else 2
        return 2 if self.has("components", "blade", "outer_shape") else 1

    def angle(self, value: Any) -> Any:
        """Angle of the file in rad."""
        return np.radians(value) if self.version == 2 else value

    def problem(
        self,
        place: Place,
        text: str,
        value: str | None = None,
        limit: str | None = None,
        remedy: str | None = None,
    ) -> None:
        """Add a problem at the line of a value, or of the nearest value around it."""
        known = next((place[:n] for n in range(len(place), -1, -1) if place[:n] in self.lines), ())
        line = FileLine(self.lines.get(known, 1), self.path.name)
        self.problems.append(Message(dotted(place), text, value, limit, remedy, line))

    def stop(self) -> None:
        """Raise the problems found, if any."""
        if self.problems:
            raise ModelError(self.problems, str(self.path))

    def has(self, *place: Any) -> bool:
        """Whether there is a value at a path."""
        return self._find(place) is not None

    def get(self, *place: Any) -> Any:
        """Value at a path; None with a problem if it, or what contains it, is missing."""
        found = self._find(place)
        if found is None:
            first = next(place[: n + 1] for n in range(len(place)) if self._find(place[: n + 1]) is None)
            if any(p.where == dotted(first) and p.text == MISSING for p in self.problems):
                return None
            around = self._find(first[:-1])
            near = nearest(str(first[-1]), [str(k) for k in around]) if isinstance(around, Mapping) else []
            remedy = f"did you mean {near[0]}?" if near else "complete the file"
            self.problem(first, MISSING, remedy=remedy)
        return found

    def check_range(
        self, place: Place, values: FloatArray, least: float, most: float, unit: str, remedy: str
    ) -> None:
        """Add a problem for the first value of a list beyond a range, at its line."""
        for k in np.flatnonzero((values < least) | (values > most))[:1]:
            limit = f"{least:.6g} to {most:.6g} {unit}".rstrip()
            shown = f"{values[k]:.6g} {unit}".rstrip()
            self.problem((*place, int(k)), "is out of range", shown, limit, remedy)

    def check_angle(self, value: Any, *place: Any, most: float = 0.5 * math.pi) -> None:
        """Add a problem for an angle or a list of angles, as in the file, beyond +-`most` [rad]."""
        unit, other = ("deg", "degrees") if self.version == 2 else ("rad", "radians")
        limit = float(np.degrees(most)) if self.version == 2 else most
        each = np.atleast_1d(np.asarray(value, float))
        remedy = f"windIO {self.version} has angles in {other}: correct the values, or windIO_version"
        before = len(self.problems)
        self.check_range(place, each, -limit, limit, unit, remedy)
        if np.ndim(value) == 0 and len(self.problems) > before:  # a number has no index
            self.problems[-1] = self.problems[-1].changed(where=dotted(place))

    def _find(self, place: Any) -> Any:
        found = self.data
        for step in place:
            if isinstance(found, Mapping):
                found = found.get(step)
            elif isinstance(found, list) and isinstance(step, int) and step < len(found):
                found = found[step]
            else:
                return None
        return found

    def number(self, *place: Any, default: float | None = None, positive: bool = False) -> float:
        """Number at a path; NaN with a problem if there is none."""
        if default is not None and not self.has(*place):
            return default
        found = self.get(*place)
        if found is None:
            return math.nan
        value = _finite(found)
        if value is None:
            self.problem(place, "is not a finite number", _shown(found), remedy="give a number")
            return math.nan
        if positive and not value > 0.0:
            self.problem(place, "is out of range", f"{value:g}", "> 0", "correct the value")
        return value

    def entries(self, *place: Any) -> list[Any]:
        """List at a path; empty with a problem if there is none."""
        found = self.get(*place)
        if found is not None and not isinstance(found, list):
            self.problem(place, "is not a list", _shown(found), remedy="give a list")
        return found if isinstance(found, list) else []

    def numbers(self, *place: Any) -> FloatArray:
        """List of finite numbers at a path; empty with a problem if it is none."""
        found = self.entries(*place)
        if len(found) > MOST_POINTS:
            self.problem(place, "is the number of values", str(len(found)), f"<= {MOST_POINTS}")
            return np.zeros(0)
        for k, value in enumerate(found):
            if _finite(value) is None:
                self.problem((*place, k), "is not a finite number", _shown(value), remedy="give a number")
                return np.zeros(0)
        return np.array(found, dtype=float)

    def curve(self, *place: Any, values: str = "values", unit: bool = True) -> tuple[FloatArray, FloatArray]:
        """Grid, increasing and with `unit` from 0 to 1, and values of a distribution, both of shape (n,)."""
        before = len(self.problems)
        if self.get(*place) is None:
            return BAD, BAD
        grid, found = self.numbers(*place, "grid"), self.numbers(*place, values)
        if len(self.problems) > before:
            return BAD, BAD
        if grid.size != found.size or grid.size < 2:
            self.problem(
                (*place, values), "is the number of values", str(found.size), f"{grid.size} as of grid, >= 2"
            )
            return BAD, BAD
        falling = np.flatnonzero(np.diff(grid) <= 0.0)
        for k in falling[:1]:
            self.problem(
                (*place, "grid", int(k) + 1), "does not increase", f"{grid[k + 1]:g}", f"> {grid[k]:g}"
            )
        if unit and not (-1e-9 <= grid[0] and grid[-1] <= 1.0 + 1e-9):
            self.problem(
                (*place, "grid"), "is beyond the component", f"{grid[0]:g} to {grid[-1]:g}", "0 to 1"
            )
        return (BAD, BAD) if len(self.problems) > before else (grid, found)


def smooth(curve: tuple[FloatArray, FloatArray], at: FloatArray) -> FloatArray:
    """Distribution at other points of its grid: monotone cubic polynomials (PCHIP), constant beyond it.

    Examples
    --------
    >>> smooth((np.array([0.0, 1.0]), np.array([2.0, 4.0])), np.array([0.25, 2.0])).tolist()
    [2.5, 4.0]
    """
    from scipy.interpolate import PchipInterpolator

    grid, values = curve
    return np.asarray(PchipInterpolator(grid, values)(np.clip(at, grid[0], grid[-1])))


def read_ontology(path: str | os.PathLike[str]) -> Ontology:
    """Contents of a windIO file; repeated reading of the same file is quick.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    ModelError
        If it cannot be read, is not YAML, or describes no turbine.
    """
    data, lines = _contents(os.fspath(path))
    found = Ontology(Path(path), data, lines)
    given = str(data.get("windIO_version", "2"))
    if given.split(".")[0] not in ("1", "2"):
        found.problem(("windIO_version",), "is not a version that can be read", _shown(given), "1 or 2")
        found.stop()
    blade = ("components", "blade")
    old, new = found.has(*blade, "outer_shape_bem"), found.has(*blade, "outer_shape")
    if old != new and found.version != (1 if old else 2):
        key = "outer_shape_bem" if old else "outer_shape"
        remedy = f"write windIO_version: {1 if old else 2}"
        text = f"contradicts the layout: the blade has {key}, which is of version {1 if old else 2}"
        found.problem(("windIO_version",), text, _shown(given), None, remedy)
        found.stop()
    return found


@read_once(4)
def _contents(path: str) -> tuple[Any, Mapping[Place, int]]:
    name = Path(path).name
    try:
        tree = Tree(text_of(path))
    except TreeError as error:
        raise ModelError([error.problem.changed(file=name)], path) from None
    if tree.problems:
        raise ModelError([p.changed(file=name) for p in tree.problems], path)
    if not isinstance(tree.data, Mapping) or "components" not in tree.data:
        problem = Message(
            "components", "is missing", remedy="give a turbine of the ontology windIO", line=1, file=name
        )
        raise ModelError([problem], path)
    return tree.data, tree.lines


def _finite(value: Any) -> float | None:
    """Finite number of a value of the file; None if it is none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        number = float(value)
    except OverflowError:  # a whole number of more than 308 digits
        return None
    return number if math.isfinite(number) else None


def _shown(value: Any) -> str:
    """Value in a message."""
    text = str(value) if value is not None else "nothing"
    return f"'{text[:40]}'"
