# SPDX-License-Identifier: Apache-2.0
"""Laws of torques, forces and prescribed motions in model files.

A law is pure data: a constant, a formula of the whitelist parser, a table, a named Python function or the
word `balance`. It is evaluated elsewhere.
"""

from __future__ import annotations

import hashlib
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

AXES = {"time": "time", "angle": "angle", "elongation": "length", "rate": "speed"}
"""Possible abscissas of a table, with their dimensions."""


@dataclass(frozen=True)
class Constant:
    """The same value at all times."""

    value: float
    """SI value in the dimension of its key."""


@dataclass(frozen=True)
class FormulaLaw:
    """A formula, parsed by `core.formula`: of `t` [s], `angle` [rad] and `speed` [rad/s] about an axis,
    of `t`, `elongation` [m] and `rate` [m/s] along lines."""

    text: str
    """Formula as in the model file; its result is in SI units."""
    variables: tuple[str, ...] = ("t", "angle", "speed")
    """Names that the formula may use, in the order of the arguments of the compiled program."""


@dataclass(frozen=True)
class TableLaw:
    """Piecewise linear table over time, the angle of the body it acts on, an elongation or its rate."""

    abscissa: tuple[float, ...]
    """Time [s], angle [rad], elongation [m] or rate [m/s], strictly increasing, at least two entries."""
    values: tuple[float, ...]
    """SI values, same length."""
    over: str = "time"
    """One of `AXES`, or a coordinate of a user joint. Constant extrapolation; tables over angles repeat with
    their length."""


@dataclass(frozen=True)
class PythonLaw:
    """A Python function `f(t, x, parameters) -> float` in a file next to the model file."""

    file: str
    """Path of the Python file, resolved from the directory of the model file."""
    function: str
    """Name of the function in it."""
    parameters: tuple[float, ...] = ()
    """Numbers passed to the function."""
    digest: str = field(init=False, default="", repr=False)
    """SHA-256 of the file when the model was read: a changed function makes a different model."""

    def __post_init__(self) -> None:
        with suppress(OSError, ValueError):  # a missing file is reported by the checks
            found = hashlib.sha256(Path(self.file).read_bytes()).hexdigest()
            object.__setattr__(self, "digest", found)


@dataclass(frozen=True)
class Balance:
    """The constant value that balances all other loads; those that repeat count with their mean."""


Law: TypeAlias = Constant | FormulaLaw | TableLaw | PythonLaw | Balance
LAWS = (Constant, FormulaLaw, TableLaw, PythonLaw, Balance)
