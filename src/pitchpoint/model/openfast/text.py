# SPDX-License-Identifier: Apache-2.0
"""Lines of OpenFAST's input files: a value and its name, or rows of numbers."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from pitchpoint.core.errors import FileLine, Message, ModelError
from pitchpoint.model.files import contents

_TOKEN = re.compile(r'"[^"]*"|\'[^\']*\'|[^\s,]+')
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?")


@dataclass(frozen=True)
class Line:
    """Line of a file: its number, from 1, and its tokens without quotes."""

    number: int
    tokens: tuple[str, ...]


@dataclass
class InputText:
    """Input file with the problems found in it so far.

    Parameters
    ----------
    path
        The file.
    lines
        Its lines without comments and empty ones.
    title
        Its first line, without signs of a comment.
    """

    path: Path
    lines: list[Line]
    problems: list[Message] = field(default_factory=list)
    title: str = ""

    def require(self, kind: str, names: Sequence[str], remedy: str, first: Sequence[str] = ()) -> None:
        """Stop with one sentence if names are missing that every file of a kind has.

        Parameters
        ----------
        kind
            Kind of the file, for the message.
        names
            Names of lines.
        remedy
            Corrective action for a file without any of them.
        first
            Names before these: with one of them the file is cut off.
        """
        missing = [name for name in names if self.find(name) is None]
        if not missing:
            return
        listed = f"it has no {' or '.join([', '.join(missing[:-1]), missing[-1]][not missing[1:] :])}"
        name = f"'{self.path.name}'"
        if not self.lines:
            problem = Message("", f"is empty and not {kind}", name, remedy="copy the file again")
        elif len(missing) == len(names) and self.find(*first) is None:
            begins = f", and begins with '{self.title[:60]}'" if self.title else ""
            problem = Message("", f"is not {kind}: {listed}{begins}", name, remedy=remedy)
        else:
            text = f"is cut off, or of another version than {kind}: {listed}"
            problem = Message("", text, name, remedy="complete the file, or copy it again")
        self.problems.append(problem)
        self.stop()

    def problem(
        self,
        where: str,
        text: str,
        value: str | None,
        limit: str | None,
        line: int | None = None,
        remedy: str | None = None,
    ) -> None:
        """Add a problem at a line of this file."""
        at = None if line is None else FileLine(line, self.path.name)
        self.problems.append(Message(where, text, value, limit, remedy, at, file=self.path.name))

    def stop(self) -> None:
        """Raise the problems found, if any."""
        if self.problems:
            raise ModelError(self.problems, str(self.path))

    def find(self, *names: str) -> Line | None:
        """Line whose second token is one of these names, whatever their case."""
        wanted = {name.lower() for name in names}
        return next((ln for ln in self.lines if len(ln.tokens) > 1 and ln.tokens[1].lower() in wanted), None)

    def number(self, *names: str, default: float | None = None) -> float:
        """Number with one of these names; its default if it is missing or the word "default"."""
        line = self.find(*names)
        if line is None or (line.tokens[0].lower() == "default" and default is not None):
            if default is None:
                self.problem(
                    names[0], "is missing", None, None, remedy="add the line, or use an AeroDyn v15 file"
                )
            return math.nan if default is None else default
        return self.value(line, 0, names[0])

    def count(self, *names: str) -> int:
        """Number of rows or files; 0 with a problem if it is not a whole number."""
        value = self.number(*names)
        if not (0 <= value <= 1_000_000 and value == int(value)):
            line = self.find(*names)
            if line is not None and math.isfinite(value):
                self.problem(
                    names[0],
                    "is not a number of lines",
                    f"{value:g}",
                    "a whole number >= 0",
                    line.number,
                    "correct the number",
                )
            return 0
        return int(value)

    def flag(self, *names: str, default: bool) -> bool:
        """Value True or False, in Fortran's spellings."""
        line = self.find(*names)
        if line is None or line.tokens[0].lower() == "default":
            return default
        word = line.tokens[0].strip(".").lower()
        if word in ("true", "t", "false", "f"):
            return word.startswith("t")
        self.problem(names[0], "is not a flag", line.tokens[0], "True or False", line.number)
        return default

    def value(self, line: Line, k: int, name: str) -> float:
        """Token k of a line as a finite number."""
        token = line.tokens[k] if k < len(line.tokens) else ""
        if not _NUMBER.fullmatch(token):
            shown = f"'{token[:40]}'" if token else "nothing"
            self.problem(name, "is not a number", shown, None, line.number, "give a number")
            return math.nan
        value = float(token.replace("d", "e").replace("D", "e"))
        if not math.isfinite(value):
            self.problem(name, "is not finite", token[:40], None, line.number, "give a finite number")
        return value

    @staticmethod
    def is_number(token: str) -> bool:
        """Whether a token is a number."""
        return _NUMBER.fullmatch(token) is not None

    def row_line(self, after: Line, k: int) -> int:
        """Number of the line of row k after a line; that of this line if there is none."""
        rows = [
            line for line in self.lines[self.lines.index(after) + 1 :] if _NUMBER.fullmatch(line.tokens[0])
        ]
        return rows[k].number if k < len(rows) else after.number

    def rows(self, after: Line, count: int, width: int, name: str) -> list[list[float]]:
        """Rows of numbers after a line; titles and units in between are skipped.

        Parameters
        ----------
        after
            Line with the number of rows.
        count
            Number of rows.
        width
            Least number of columns.
        name
            What the rows are, for messages.
        """
        start = self.lines.index(after) + 1
        while start < len(self.lines) and not _NUMBER.fullmatch(self.lines[start].tokens[0]):
            start += 1
        found = self.lines[start : start + count]
        out = []
        short = []
        for k, line in enumerate(found):
            if not _NUMBER.fullmatch(line.tokens[0]):
                found = found[:k]
                break
            if len(line.tokens) < width:
                short.append(k)
                continue
            out.append(self._row(line, width, f"{name}, row {k + 1}"))
        if short and not (
            len(found) < count and short == [len(found) - 1]
        ):  # otherwise the file is cut off there
            first = found[short[0]]
            more = f", as in {len(short) - 1} other rows" if short[1:] else ""
            self.problem(
                f"{name}, row {short[0] + 1}",
                f"columns are too few{more}",
                str(len(first.tokens)),
                f">= {width}",
                first.number,
                "complete the row, or correct the titles of the columns",
            )
        if len(found) < count:
            self.problem(
                name,
                "is the number of rows before the table ends",
                str(len(found)),
                f"{count} as stated",
                after.number,
                "complete the file or correct the number",
            )
        return out

    def _row(self, line: Line, width: int, name: str) -> list[float]:
        """Numbers of a row; only its first problem is reported."""
        before, values = len(self.problems), [math.nan] * width
        for c in range(width):
            values[c] = self.value(line, c, f"{name}, column {c + 1}")
            if len(self.problems) > before:
                break
        return values


def beside(path: Path, name: str) -> Path:
    """File named in another one; separators of Windows are accepted."""
    return path.parent / name.replace("\\", "/")


def in_file(error: ModelError, name: str, line: FileLine | None = None) -> list[Message]:
    """Problems of a file that another one names, those of the file as a whole at the line that names it."""
    return [
        p.changed(
            where=f"{name}: {p.where}".rstrip(": "), file=None, line=p.line or (None if p.where else line)
        )
        for p in error.problems
    ]


def read_input(path: str | os.PathLike[str]) -> InputText:
    """Lines of an input file; lines that begin with !, #, %, --- or === are comments.

    Parameters
    ----------
    path
        The file.

    Raises
    ------
    ModelError
        If it cannot be read, is too large, or not text.
    """
    path = Path(path)
    data = contents(path)
    if b"\0" in data:
        raise ModelError(
            [Message("", "is not a text file", remedy="give the input file of OpenFAST")], str(path)
        )
    lines = []
    every = data.decode("utf-8", errors="replace").splitlines()
    title = next((each for text in every if (each := text.strip("-!#%= \t"))), "")
    for k, text in enumerate(every, 1):
        bare = text.strip()
        if not bare or bare[0] in "!#%" or bare.startswith(("---", "===")):
            continue
        tokens = tuple(token.strip("\"'") for token in _TOKEN.findall(bare))
        if tokens:
            lines.append(Line(k, tokens))
    return InputText(path, lines, title=title)
