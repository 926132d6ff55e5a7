# SPDX-License-Identifier: Apache-2.0
"""Everything that may go wrong, as a small family of exceptions.

Nothing but a `PitchpointError` ever leaves the package on purpose. Messages have the form
*where - value - limit - what to do*; a wrong description carries all of its problems at once.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


class PitchpointError(Exception):
    """Base of all errors that the package raises on purpose."""


class Message(str):
    """One thing that a user should know: a sentence that keeps its parts.

    It is the sentence, so that it can be shown, joined and stored like any text.

    Parameters
    ----------
    where
        Place in the description, such as "gears.pinion.face_width"; '' if it concerns the whole.
    text
        What is wrong or notable.
    value, limit
        The value found, and what is allowed.
    remedy
        What to do about it.
    line
        Line of the file, from 1.
    kind
        "problem": nothing can be computed; "warning": outside a usual or stated range; "remark": probably not
        what was meant; "note": an assumption or limitation of a result.

    Examples
    --------
    >>> message = Message("gears.g1.face_width", "is out of range", "-1 mm", "> 0", "write 1 mm", line=4)
    >>> print(message)
    gears.g1.face_width (line 4): -1 mm is out of range (limit > 0); write 1 mm
    >>> message.limit, message.kind
    ('> 0', 'problem')
    """

    where: str
    text: str
    value: str | None
    limit: str | None
    remedy: str | None
    line: int | None
    kind: str

    def __new__(
        cls,
        where: str,
        text: str,
        value: str | None = None,
        limit: str | None = None,
        remedy: str | None = None,
        line: int | None = None,
        kind: str = "problem",
    ) -> Message:
        """Put the sentence together."""
        place = where if line is None else f"{where} (line {line})"
        sentence = f"{place}: " if place else ""
        sentence += text if value is None else f"{value} {text}"
        sentence += "" if limit is None else f" (limit {limit})"
        sentence += "" if remedy is None else f"; {remedy}"
        self = super().__new__(cls, sentence)
        self.where, self.text, self.value, self.limit = where, text, value, limit
        self.remedy, self.line, self.kind = remedy, line, kind
        return self

    @property
    def parts(self) -> dict[str, Any]:
        """Its parts by name, in the order of the arguments."""
        return dict(vars(self))

    def changed(self, **parts: Any) -> Message:
        """The same with some parts changed."""
        return Message(**{**self.parts, **parts})

    def __reduce__(self) -> tuple[Any, ...]:
        return Message, tuple(self.parts.values())


def remark(where: str, text: str, remedy: str | None = None, line: int | None = None) -> Message:
    """Something in a description that is allowed, but probably not what was meant.

    Parameters
    ----------
    where, text, remedy, line
        As for `Message`.
    """
    return Message(where, text, remedy=remedy, line=line, kind="remark")


def note(text: str, where: str = "", remedy: str | None = None) -> Message:
    """An assumption or limitation of a result.

    Parameters
    ----------
    text, where, remedy
        As for `Message`.
    """
    return Message(where, text, remedy=remedy, kind="note")


class ModelError(PitchpointError, ValueError):
    """A description is wrong; carries every problem found in one pass.

    Parameters
    ----------
    problems
        All problems, in the order of the file.
    file
        Name of their file, if any.
    """

    def __init__(self, problems: Sequence[Message], file: str | None = None) -> None:
        self.problems = tuple(problems)
        self.file = file
        head = f"{file}: " if file else ""
        count = len(self.problems)
        title = f"{head}{count} problem{'s' if count != 1 else ''}"
        super().__init__("\n".join([title, *(f"  {p}" for p in self.problems)]))


class UnitError(PitchpointError, ValueError):
    """A quantity could not be read, or has the wrong dimension."""


class GeometryError(PitchpointError, ValueError):
    """A gear or pair that cannot exist: the message gives place, value, limit and remedy.

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
        self.problem = Message(where, message, value, limit, remedy)
        super().__init__(str(self.problem))


class CompileError(PitchpointError, RuntimeError):
    """A model is valid but cannot be turned into equations (for example a floating body)."""


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
