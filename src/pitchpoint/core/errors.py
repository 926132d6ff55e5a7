# SPDX-License-Identifier: Apache-2.0
"""Everything that may go wrong, as a small family of exceptions.

Nothing but a `PitchpointError` ever leaves the package on purpose. Messages have the form
*where - value - limit - what to do*; a wrong description carries all of its problems at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


class PitchpointError(Exception):
    """Base of all errors that the package raises on purpose."""


@dataclass(frozen=True)
class Problem:
    """One thing wrong with a description: where it stands, what it says, what is allowed, what to do."""

    where: str
    message: str
    value: str | None = None
    limit: str | None = None
    remedy: str | None = None
    line: int | None = None

    def __str__(self) -> str:
        place = self.where if self.line is None else f"{self.where} (line {self.line})"
        text = f"{place}: " if place else ""
        if self.value is not None:
            text += f"{self.value} "
        text += self.message
        if self.limit is not None:
            text += f" (limit {self.limit})"
        if self.remedy is not None:
            text += f"; {self.remedy}"
        return text


class ModelError(PitchpointError, ValueError):
    """A description is wrong; carries every problem found in one pass.

    Parameters
    ----------
    problems
        All problems, in the order of the file.
    file
        Name of the file they stand in, if any.
    """

    def __init__(self, problems: Sequence[Problem], file: str | None = None) -> None:
        self.problems = tuple(problems)
        self.file = file
        head = f"{file}: " if file else ""
        count = len(self.problems)
        title = f"{head}{count} problem{'s' if count != 1 else ''}"
        super().__init__("\n".join([title, *(f"  {p}" for p in self.problems)]))


class UnitError(PitchpointError, ValueError):
    """A quantity could not be read, or has the wrong dimension."""


class GeometryError(PitchpointError, ValueError):
    """No such gear or pair: the message says where, value, limit and remedy.

    `problem` holds the same as data, so that a loader can add the line of the file.
    """

    def __init__(
        self,
        message: str,
        *,
        where: str = "",
        value: str | None = None,
        limit: str | None = None,
        remedy: str | None = None,
    ) -> None:
        self.problem = Problem(where, message, value, limit, remedy)
        super().__init__(str(self.problem))


class CompileError(PitchpointError, RuntimeError):
    """A model is valid but cannot be turned into equations (a floating body, say)."""


class SolverError(PitchpointError, RuntimeError):
    """A computation failed; keeps the status and whatever was computed before.

    Parameters
    ----------
    message
        What happened, in a sentence.
    status
        Integer status of `pitchpoint.core.status`.
    partial
        The result so far (a Dataset or the path of the file that holds it), or None.
    """

    def __init__(self, message: str, status: int, partial: Any = None) -> None:
        super().__init__(message)
        self.status = status
        self.partial = partial


class MissingDependencyError(PitchpointError, ImportError):
    """An optional library is needed; the message names the extra that brings it."""


class ValidityWarning(UserWarning):
    """A formula is used outside the range its source states."""
