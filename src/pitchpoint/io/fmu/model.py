# SPDX-License-Identifier: Apache-2.0
"""Model as it goes into a functional mock-up unit: memory, entry points, variables, numbers."""

from __future__ import annotations

import hashlib
import math
import re
import uuid
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from pitchpoint.core.compiler.memory_image import MemoryImage

OUTPUT, INPUT, PARAMETER, STATE, SLOPE, TIME, INDICATOR, SPEED, ACCELERATION = range(9)
"""Kinds of variables, as in `glue/instance.h`."""
CAUSALITIES = ("output", "input", "parameter", "local", "local", "independent", "local", "input", "input")


@dataclass(frozen=True)
class Variable:
    """Variable of the unit; its value reference is its position in the list.

    Parameters
    ----------
    kind
        One of the constants above.
    name, unit, text
        Name, unit and description.
    first
        OUTPUT: index of the channel; STATE, SLOPE, INDICATOR: index of the state or indicator.
    start
        Start value of a variable that can be set.
    words
        INPUT and PARAMETER: offset of each word of the memory, and coefficients of its change
        (`solvers.input_places.Place`). SPEED and ACCELERATION: offset of the record of the drive.
    least, most
        Range of the value.
    """

    kind: int
    name: str
    unit: str
    text: str
    first: int = 0
    start: float = 0.0
    words: tuple[tuple[int, tuple[float, ...]], ...] = ()
    least: float = -math.inf
    most: float = math.inf

    @property
    def is_set(self) -> bool:
        """Whether the importing program sets it."""
        return self.kind in (INPUT, PARAMETER, SPEED, ACCELERATION)

    @property
    def is_fixed(self) -> bool:
        """Whether it is a parameter."""
        return self.kind == PARAMETER


@dataclass(frozen=True)
class FmuModel:
    """Model of a functional mock-up unit.

    Parameters
    ----------
    name, title
        Name of the libraries (letters, digits, underscores), and title of the model.
    image
        Memory of the started run.
    entries
        Symbol and intermediate code of every entry point.
    code
        Offset and number of the entry point of each word of the memory that holds the address of one.
    numbers, reals
        Sizes, offsets, flags; t0 [s], h [s], rate [1/s], far [m], by the names of `Numbers` in
        `glue/instance.h`.
    variables
        All variables.
    indicators
        Event functions that are event indicators of the model exchange.
    stop, sample
        End and communication step of the default experiment [s].
    shafts
        Name of every shaft with a torque or a drive, and its torque, angle and speed.
    rest, instants, extents, depths
        Integers, instants, sizes of the coordinates, and largest deflections for the initial equilibrium, by
        their names in `glue/instance.h`.
    """

    name: str
    title: str
    image: MemoryImage
    entries: tuple[tuple[str, bytes], ...]
    code: tuple[tuple[int, int], ...]
    numbers: Mapping[str, int]
    reals: Mapping[str, float]
    variables: tuple[Variable, ...]
    indicators: tuple[int, ...]
    stop: float
    sample: float
    shafts: tuple[tuple[str, str, str, str], ...] = ()
    rest: Mapping[str, Sequence[int]] = field(default_factory=dict)
    instants: Sequence[float] = ()
    extents: Sequence[float] = ()
    depths: Sequence[float] = ()

    @cached_property
    def token(self) -> str:
        """Identifier of the model: the same for the same memory, code and variables."""
        digest = hashlib.sha256(self.image.data)
        start = self.rest, *map(tuple, (self.instants, self.extents, self.depths))
        digest.update(repr((self.name, self.code, self.numbers, self.reals, self.variables, start)).encode())
        for symbol, bitcode in self.entries:
            digest.update(symbol.encode() + bitcode)
        return "{" + str(uuid.UUID(bytes=digest.digest()[:16])) + "}"

    @property
    def exchanges(self) -> bool:
        """Whether the unit is for model exchange, too."""
        return bool(self.numbers["exchange"])

    def of_kind(self, kind: int) -> list[int]:
        """Value references of all variables of a kind."""
        return [k for k, variable in enumerate(self.variables) if variable.kind == kind]


def identifier(text: str) -> str:
    """Name of a library from the name of a file.

    Examples
    --------
    >>> identifier("5 MW gearbox-v2")
    'm5_MW_gearbox_v2'
    """
    name = re.sub(r"\W", "_", text, flags=re.ASCII)
    return name if name[:1].isalpha() else f"m{name}"
