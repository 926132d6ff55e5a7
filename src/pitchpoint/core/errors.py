# SPDX-License-Identifier: Apache-2.0
"""Exceptions and messages of the package.

Every deliberately raised error is a `PitchpointError`. Messages have the form *where - value - limit - what
to do*; the error of a wrong description contains all of its problems.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

SEPARATOR = "; "
"""Text between two notes."""


def with_time(sentence: str, t: float) -> str:
    """Sentence on a failure with the time [s], unless it has one.

    Parameters
    ----------
    sentence
        The sentence.
    t
        Time reached [s].

    Examples
    --------
    >>> with_time("not finite", 0.25), with_time("the law failed (t = 0.3 s)", 0.25)
    ('not finite (at t = 0.25 s)', 'the law failed (t = 0.3 s)')
    >>> with_time("the rate of rotor.spin is 1e+20 at t = 0.3 s; reduce `step`", 0.3)
    'the rate of rotor.spin is 1e+20 at t = 0.3 s; reduce `step`'
    """
    has_one = "(t = " in sentence or " at t = " in sentence
    return sentence if has_one else f"{sentence} (at t = {t:.6g} s)"


class PitchpointError(Exception):
    """Base class of all errors that the package raises deliberately."""


class FileLine(int):
    """Line of a file that another file includes: its number, and the name of the file.

    Examples
    --------
    >>> line = FileLine(4, "gears.yaml")
    >>> line + 1, line.file
    (5, 'gears.yaml')
    """

    file: str

    def __new__(cls, number: int, file: str) -> FileLine:
        """Create the number with its file."""
        self = super().__new__(cls, number)
        self.file = file
        return self

    def __reduce__(self) -> tuple[type[FileLine], tuple[int, str]]:
        return FileLine, (int(self), self.file)


class Message(str):
    """Message to the user: a sentence that also provides its parts as attributes.

    A subclass of `str`, so that it can be displayed, joined and stored like any text.

    Parameters
    ----------
    where
        Location in the description, such as "gears.pinion.face_width"; '' for the description as a whole.
    text
        Statement of the problem or remark.
    value, limit
        Actual value, and permitted range.
    remedy
        Corrective action.
    line
        Line of the file, from 1; a `FileLine` also names the file.
    kind
        "problem": computation impossible; "warning": outside a usual or stated range; "remark": valid, but
        probably not intended; "note": an assumption or limitation of a result.
    file
        Included file that contains the line, or without a line the option that gives the value, such as
        "--set"; None for the file itself.

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
    file: str | None

    def __new__(
        cls,
        where: str,
        text: str,
        value: str | None = None,
        limit: str | None = None,
        remedy: str | None = None,
        line: int | None = None,
        kind: str = "problem",
        file: str | None = None,
    ) -> Message:
        """Compose the sentence."""
        file, limit = getattr(line, "file", file), limit or None
        at = ", ".join(part for part in (file, f"line {line}" if line is not None else "") if part)
        place = f"{where} ({at})".lstrip() if at else where
        sentence = f"{place}: " if place else ""
        sentence += text if value is None else f"{value} {text}"
        sentence += "" if limit is None else f" (limit {limit})"
        sentence += f"; {remedy}" if remedy else ""
        self = super().__new__(cls, sentence)
        self.where, self.text, self.value, self.limit = where, text, value, limit
        self.remedy, self.line, self.kind = remedy, None if line is None else int(line), kind
        self.file = file
        return self

    @property
    def parts(self) -> dict[str, Any]:
        """Parts by name, in the order of the arguments; `file` only for a line of an included file."""
        return {name: part for name, part in vars(self).items() if name != "file" or part}

    def changed(self, **parts: Any) -> Message:
        """Copy with some parts changed."""
        return Message(**{**self.parts, **parts})

    def __reduce__(self) -> tuple[Any, ...]:
        return Message, tuple(self.parts.values())


def remark(where: str, text: str, remedy: str | None = None, line: int | None = None) -> Message:
    """Remark: a description that is valid, but probably not intended.

    Parameters
    ----------
    where, text, remedy, line
        As for `Message`.
    """
    return Message(where, text, remedy=remedy, line=line, kind="remark")


def note(text: str, where: str = "", remedy: str | None = None) -> Message:
    """Note: an assumption or limitation of a result.

    Parameters
    ----------
    text, where, remedy
        As for `Message`.
    """
    return Message(where, text, remedy=remedy, kind="note")


def join_notes(notes: Iterable[str]) -> str:
    """Notes as one text, without empty and repeated ones, as in the attribute `notes` of datasets and files.

    Parameters
    ----------
    notes
        Notes. A semicolon within one becomes a colon, so that `split_notes` returns complete notes.

    Examples
    --------
    >>> join_notes(["one", "", note("two", remedy="make it three"), "one"])
    'one; two: make it three'
    """
    return SEPARATOR.join(dict.fromkeys(str(one).replace(SEPARATOR, ": ") for one in notes if one))


def split_notes(text: str) -> list[str]:
    """Notes of a text of `join_notes`.

    Examples
    --------
    >>> split_notes("one; two: make it three"), split_notes("")
    (['one', 'two: make it three'], [])
    """
    return [one for one in text.split(SEPARATOR) if one]


class ModelError(PitchpointError, ValueError):
    """Invalid description, with all problems found.

    Parameters
    ----------
    problems
        All problems, in the order of the file.
    file
        Name of the file, if any.
    """

    def __init__(self, problems: Sequence[Message], file: str | None = None) -> None:
        self.problems = tuple(problems)
        self.file = file
        head = f"{file}: " if file else ""
        count = len(self.problems)
        title = f"{head}{count} problem{'s' if count != 1 else ''}"
        super().__init__("\n".join([title, *(f"  {p}" for p in self.problems)]))


class UnitError(PitchpointError, ValueError):
    """Invalid quantity, or wrong dimension."""


class GeometryError(PitchpointError, ValueError):
    """Geometrically impossible gear or pair; the message gives location, value, limit and remedy.

    `problem` is the same as a `Message`, so that a loader can add the line of the file.
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
    """Valid model without solvable equations (for example an unconstrained body)."""


class SolverError(PitchpointError, RuntimeError):
    """Failed computation, with its status and partial result.

    Parameters
    ----------
    message
        Description of the failure in one sentence.
    status
        Integer status of `pitchpoint.core.status`.
    partial
        Partial result (a Dataset or the path of its file), or None.
    """

    def __init__(self, message: str, status: int, partial: Any = None) -> None:
        super().__init__(message)
        self.status = status
        self.partial = partial


class MissingDependencyError(PitchpointError, ImportError):
    """Missing optional library; the message names the extra that installs it."""


class ValidityWarning(UserWarning):
    """Formula used outside the range of validity stated by its source."""
