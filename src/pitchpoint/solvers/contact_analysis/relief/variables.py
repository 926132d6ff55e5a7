# SPDX-License-Identifier: Apache-2.0
"""Design variables: keys of the modifications of both gears, from values to rows for the kernels."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.geometry.modification_terms import N_TERM, modification_terms
from pitchpoint.geometry.modifications import flank_range
from pitchpoint.model.numbers import has_path, number_at
from pitchpoint.system.rules.separation import flank_sides

if TYPE_CHECKING:
    from pitchpoint.geometry.modifications import FlankModifications
    from pitchpoint.model.model import Model

Array = NDArray[np.float64]

AMOUNT_STEP, LENGTH_STEP = 0.5e-6, 0.1e-3
"""Drawing precision of amounts, and of lengths and diameters [m]."""
_LENGTHS = ("length", "start_diameter")
_FORM = "gears.NAME.modifications.both.tip_relief.amount"


@dataclass(frozen=True)
class Variable:
    """One key of a modification to be chosen within bounds.

    Parameters
    ----------
    path
        Path of the key, such as gears.pinion.modifications.both.tip_relief.amount.
    low, high
        Bounds [m].
    """

    path: str
    low: float
    high: float

    @property
    def step(self) -> float:
        """Drawing precision [m]."""
        return LENGTH_STEP if self.path.rpartition(".")[2] in _LENGTHS else AMOUNT_STEP


def with_values(model: Model, values: Mapping[str, Any]) -> Model:
    """Model with values by path; missing modifications are created from all values below them.

    Parameters
    ----------
    model
        The model.
    values
        Numbers in SI or texts with units by path.

    Raises
    ------
    ModelError
        With all paths that do not exist and values that do not fit.
    """
    changes: dict[str, Any] = {}
    for path, value in values.items():
        names = path.split(".")
        known = len(names)
        while known > 1 and not has_path(model, ".".join(names[:known])):
            known -= 1
        if known in (1, len(names)):
            changes[path] = value
            continue
        part = changes.setdefault(".".join(names[:known]), {})
        for name in names[known:-1]:
            part = part.setdefault(name, {})
        part[names[-1]] = value
    return model.replace_all(changes) if changes else model


class Flanks:
    """Loaded flanks of both gears as functions of the values of some keys.

    Parameters
    ----------
    model
        Model that has all of the keys.
    mesh
        Name of the mesh.
    flank
        1: front flanks (gear 1 drives counter-clockwise), -1: back flanks.
    paths
        Paths of the keys.

    Raises
    ------
    ModelError
        If a path is not a modification of a loaded flank of this mesh.
    """

    def __init__(self, model: Model, mesh: str, flank: int, paths: Sequence[str]) -> None:
        check_paths(model, mesh, paths)
        self.paths = tuple(paths)
        self.gears = [model.gears[g] for g in model.meshes[mesh].gears]
        sides = [flank_sides(gear, k == 1)[0 if flank > 0 else 1] for k, gear in enumerate(self.gears)]
        self.base: list[FlankModifications | None] = []
        for gear, side in zip(self.gears, sides, strict=True):
            own = None if gear.modifications is None else gear.modifications.side(side)
            self.base.append(None if own is None else own.of_geometry())
        problems: list[Message] = []
        self._at = [_place_of(model, mesh, sides, path, problems) for path in paths]
        if problems:
            raise ModelError(problems)
        self.start = np.array([_number(model, path) for path in paths])
        self.limits = np.array([self._limits(at) for at in self._at]).reshape(-1, 2)

    def _limits(self, at: tuple[int, tuple[str, ...]]) -> tuple[float, float]:
        """Smallest and largest value that a key can have [m]."""
        gear, names = at
        shape = self.gears[gear].geometry
        low, high = sorted((0.5 * abs(shape.d_Ff), 0.5 * abs(shape.d_Fa)))
        tiny = 1e-6 * shape.m_n
        if names[-1] == "start_diameter":
            return 2.0 * low + tiny, 2.0 * high - tiny
        if names[-1] == "length":
            ends = names[0] == "end_relief"
            most = 0.5 * shape.b if ends else abs(float(np.subtract(*flank_range(shape))))
            return tiny, most
        return (0.0, shape.m_n) if names[-1] == "amount" else (-shape.m_n, shape.m_n)

    def rows(self, values: Array) -> Array:
        """Rows of the modifications of the loaded flanks of both gears.

        Parameters
        ----------
        values
            Values of the keys [m], shape (paths,); limited to what a flank can have.

        Returns
        -------
        ndarray, shape (2, N_TERM)
        """
        parts = list(self.base)
        for (gear, names), value in zip(self._at, np.clip(values, *self.limits.T), strict=True):
            part = parts[gear]
            assert part is not None
            parts[gear] = _replaced(part, names, float(value))
        found = np.zeros((2, N_TERM))
        for k, part in enumerate(parts):
            if part is not None:
                found[k] = modification_terms(part, self.gears[k].geometry)
        return found


def _replaced(part: Any, names: Sequence[str], value: float) -> Any:
    """Copy of a nested dataclass with one value replaced."""
    if len(names) > 1:
        return replace(part, **{names[0]: _replaced(getattr(part, names[0]), names[1:], value)})
    return replace(part, **{names[0]: value})


def _number(model: Model, path: str) -> float:
    """Number at a path that has one."""
    found = number_at(model, path)
    assert found is not None
    return found[0]


def check_paths(model: Model, mesh: str, paths: Sequence[str]) -> None:
    """Check that paths have the form of modifications of the gears of a mesh.

    Raises
    ------
    ModelError
        With all others.
    """
    gears = model.meshes[mesh].gears
    remedy = f"give a path such as {_FORM} with NAME {' or '.join(gears)}"
    words = f"is not a modification of a gear of mesh {mesh}"
    split = {path: path.split(".") for path in paths}
    wrong = [
        Message(path, words, remedy=remedy)
        for path, names in split.items()
        if len(names) < 5 or names[0] != "gears" or names[1] not in gears or names[2] != "modifications"
    ]
    if wrong:
        raise ModelError(wrong)


def _place_of(
    model: Model, mesh: str, sides: Sequence[str], path: str, problems: list[Message]
) -> tuple[int, tuple[str, ...]]:
    """Gear (0, 1) and key below its side of a path."""
    _, name, _, side, *key = path.split(".")
    gear = list(model.meshes[mesh].gears).index(name)
    loaded, parts = sides[gear], model.gears[name].modifications
    effective = "both" if parts is None or getattr(parts, loaded) is None else loaded
    number = number_at(model, path)
    if side != effective:
        remedy = f"vary {effective} instead, or analyse the other flank"
        words = f"has no effect on the loaded flank, which has {effective}"
        problems.append(Message(path, words, remedy=remedy))
    elif number is None or number[1] != "m" or not math.isfinite(number[0]):
        problems.append(Message(path, "is not a length", remedy="vary an amount, a length or a diameter"))
    return gear, tuple(key)
