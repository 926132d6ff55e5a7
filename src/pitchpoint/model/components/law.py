# SPDX-License-Identifier: Apache-2.0
"""Laws that a user writes for a torque, a force or a prescribed motion.

A law is data: a constant, a formula of the whitelist parser, a table, a named Python function or the word
`balance`. Nothing here evaluates anything.
"""

from __future__ import annotations

import hashlib
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeAlias

AXES = {"time": "time", "angle": "angle", "elongation": "length", "rate": "speed"}
"""What a table may run over, with the dimension of that."""


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
    """Formula as the user wrote it; its result is in SI."""
    variables: tuple[str, ...] = ("t", "angle", "speed")
    """Names the formula may use, in the order the compiled program expects them."""


@dataclass(frozen=True)
class TableLaw:
    """Piecewise linear table over time, the angle of the body it acts on, an elongation or its rate."""

    abscissa: tuple[float, ...]
    """Time [s], angle [rad], elongation [m] or rate [m/s], strictly increasing, at least two entries."""
    values: tuple[float, ...]
    """SI values, same length."""
    over: str = "time"
    """One of `AXES`, or a coordinate of a user joint; held constant outside the table, but over angles
    repeated with its length."""


@dataclass(frozen=True)
class PythonLaw:
    """A Python function `f(t, x, parameters) -> float` in a file next to the model file."""

    file: str
    """Path of the Python file, as resolved from the directory of the model file."""
    function: str
    """Name of the function in it."""
    parameters: tuple[float, ...] = ()
    """Numbers handed to the function."""
    digest: str = field(init=False, default="", repr=False)
    """SHA-256 of the file as it was when the law was named: a changed function is another model."""

    def __post_init__(self) -> None:
        with suppress(OSError, ValueError):  # a missing file is reported by the checks
            found = hashlib.sha256(Path(self.file).read_bytes()).hexdigest()
            object.__setattr__(self, "digest", found)


@dataclass(frozen=True)
class Balance:
    """The constant value that balances all other loads at the start, pulsating ones in the mean."""


Law: TypeAlias = Constant | FormulaLaw | TableLaw | PythonLaw | Balance
