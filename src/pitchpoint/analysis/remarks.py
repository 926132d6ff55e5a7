# SPDX-License-Identifier: Apache-2.0
"""Notes in addition to findings: each reason once, with all subjects that it applies to."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Note:
    """A reason, and one thing that it holds of.

    Attributes
    ----------
    reason
        Sentence with `{}` for the subjects; without it if it applies to the whole record.
    subject
        The thing.
    """

    reason: str
    subject: str = ""


def grouped(notes: Iterable[Note]) -> list[str]:
    """Sentences with one reason each, in the order in which the reasons come up first.

    Parameters
    ----------
    notes
        Reasons with their things; the same thing may come up more than once.

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
