# SPDX-License-Identifier: Apache-2.0
"""Docstrings as text: what reStructuredText would take for markup is none, but code in backticks."""

from __future__ import annotations

import re
from typing import Any

from sphinx.application import Sphinx

CODE = re.compile(r"(``[^`]+``|`[^`\n]+`)")
MARKUP = re.compile(r"([*|\\])|(?<=\w)(_)(?!\w)")
# numpydoc writes sources as footnotes; their numbers repeat from function to function, so they become a list
SOURCE = re.compile(r"\.\. \[(\w+)\] ")
REFERENCE = re.compile(r"\[(\w+)\]_(?!\w)")


def as_text(lines: list[str]) -> list[str]:
    """Lines of a docstring in which only code in backticks and doctests are markup.

    Parameters
    ----------
    lines
        Lines as they are in the source.

    Returns
    -------
    list of str
        The same with stars, bars, backslashes and final underscores escaped, `code` as ``code``, and sources
        as list items.
    """
    found: list[str] = []
    in_doctest = in_source = False
    for line in lines:
        in_source = in_source and bool(line.strip())
        in_doctest = line.lstrip().startswith((">>>", "...")) or (in_doctest and bool(line.strip()))
        if in_doctest:
            found.append(line)
            continue
        source = SOURCE.match(line)
        if source or in_source:
            in_source = True
            line = f"* [{source[1]}] {line[source.end() :]}" if source else f"  {line.strip()}"
            found += [""] if source and found and found[-1] else []
            found.append(line[:2] + MARKUP.sub(r"\\\g<0>", line[2:]))
            continue
        parts = CODE.split(REFERENCE.sub(r"[\1]", line))
        for i, part in enumerate(parts):
            if i % 2:
                parts[i] = part if part.startswith("``") else f"`{part}`"
            else:
                parts[i] = MARKUP.sub(r"\\\g<0>", part)
        found.append("".join(parts))
    return found


def process(app: Sphinx, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:
    """Escape the lines of one docstring in place, before its sections are read."""
    lines[:] = as_text(lines)


def skip(app: Sphinx, what: str, name: str, obj: Any, skip: bool, options: Any) -> bool | None:
    """Omit the fields of named tuples: their numbers give no information, the class states what they are."""
    return True if type(obj).__name__ == "_tuplegetter" else None


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx, ahead of napoleon."""
    app.connect("autodoc-process-docstring", process, priority=100)
    app.connect("autodoc-skip-member", skip)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
