# SPDX-License-Identifier: Apache-2.0
"""Remarks of a diagnosis: each reason once, with all its subjects."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Note:
    """A reason and one of its subjects.

    Attributes
    ----------
    reason
        Sentence with `{}` for the subjects; without it if it applies to the whole record.
    subject
        Subject of the reason, such as a bearing part or a test.
    """

    reason: str
    subject: str = ""


def grouped(notes: Iterable[Note]) -> list[str]:
    """One sentence per reason with all its subjects, in the order of first occurrence.

    Parameters
    ----------
    notes
        Reasons with their subjects; repeated ones are listed once.

    Examples
    --------
    >>> why = "no test of {}: too near to other lines"
    >>> grouped([Note(why, "a"), Note("record: is short"), Note(why, "b"), Note(why, "a")])
    ['no test of a, b: too near to other lines', 'record: is short']
    """
    subjects: dict[str, dict[str, None]] = {}
    for note in notes:
        subjects.setdefault(note.reason, {})[note.subject] = None
    return [reason.replace("{}", ", ".join(things)) for reason, things in subjects.items()]
