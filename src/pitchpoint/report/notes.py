# SPDX-License-Identifier: Apache-2.0
"""Notes of results and warnings of the model for the remarks of a report, each once."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

_NUMBERS = re.compile(r"(?<![\w.])[-−]?\d+(\.\d+)?(e[+-]?\d+)?(?![\w.]*\w)")
"""Numbers as words of their own, unlike those in names of components."""


def own_notes(notes: Sequence[tuple[str, Sequence[str]]]) -> list[str]:
    """Notes of all results, each once; with the names of the results if not all have it.

    Parameters
    ----------
    notes
        Name of a result and its notes.

    Examples
    --------
    >>> own_notes([("a", ["too slow", "too soft"]), ("b", ["too slow"])])
    ['too slow', 'a: too soft']
    """
    owners: dict[str, list[str]] = {}
    for name, own in notes:
        for text in own:
            owners.setdefault(text, []).append(name)
    return [
        text if len(names) == len(notes) else f"{', '.join(dict.fromkeys(names))}: {text}"
        for text, names in owners.items()
    ]


def remarks_of(warnings: Iterable[str], notes: Iterable[str]) -> list[str]:
    """Warnings of the model, and what results add to them.

    A note that repeats a warning is omitted. Of notes that differ in values with units only, as those of the
    cases of a study, the first one is kept with their number.

    Examples
    --------
    >>> remarks_of(["x is low."], ["run: x is low", "case 1: 2.5 mm deep", "case 2: 3 mm deep"])
    ['x is low.', 'case 1: 2.5 mm deep (and 1 similar note)']
    >>> remarks_of([], ["a is deep; check it.", "a is deep: check it"])
    ['a is deep; check it.']
    >>> remarks_of([], ["z1 is thin", "z2 is thin"])
    ['z1 is thin', 'z2 is thin']
    """
    known = list(dict.fromkeys(warnings))
    plain = tuple(map(_plain, known))
    kinds: dict[str, dict[str, str]] = {}
    for note in notes:
        text = _plain(note)
        if not text.endswith(plain):
            kinds.setdefault(_NUMBERS.sub("#", text), {}).setdefault(text, note)
    return known + [f"{next(iter(own.values()))}{_similar(len(own) - 1)}" for own in kinds.values()]


def _plain(text: str) -> str:
    """Text without the punctuation in which the same note differs between a result and a message."""
    return re.sub(r"[.;:](?=\s|$)", "", text)


def _similar(count: int) -> str:
    return f" (and {count} similar note{'s' if count > 1 else ''})" if count else ""
