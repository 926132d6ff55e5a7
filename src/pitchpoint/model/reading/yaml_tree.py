# SPDX-License-Identifier: Apache-2.0
"""Conversion of YAML text to plain data with the line of every key; syntax errors and duplicate keys.

The text is composed into nodes by ruamel.yaml (YAML 1.2, so `1e8` is a number and `on` a word) and converted
only to numbers, texts, lists and dictionaries: tags are rejected.
"""

from __future__ import annotations

import math
import re
from io import StringIO
from pathlib import Path
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.core.progress import Progress, silent
from pitchpoint.model.files import MAX_BYTES, contents
from pitchpoint.model.keys import Place
from pitchpoint.model.show import dotted

MAX_DEPTH = 60
_TAG = "tag:yaml.org,2002:"
_COMPOSED = 0.75
"""Share of the time for composing the nodes; the remainder converts them."""
_EVERY = 5000
_DECIMAL = re.compile(r"[-+]?\d+, \d.*")


def text_of(path: str | Path) -> str:
    """Text of a YAML file; raises a `ModelError` if it cannot be read."""
    data = contents(path)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line: int | None = data[: error.start].count(b"\n") + 1
        remedy = "save the file as UTF-8"
        if b"\0" in data[:1024]:
            binary = "an HDF5 file, such as a result" if data.startswith(b"\x89HDF") else "a binary file"
            line, remedy = None, f"name the model file; this is {binary}"
        problem = Message("YAML syntax", "is not UTF-8 text", remedy=remedy, line=line)
        raise ModelError([problem], str(path)) from None
    return text


def _too_large() -> Message:
    return Message("", f"the file is larger than {MAX_BYTES // 10**6} MB")


class TreeError(Exception):
    """The text is not valid YAML; contains the problem."""

    def __init__(self, problem: Message) -> None:
        self.problem = problem
        super().__init__(str(problem))


class Tree:
    """Plain data of a YAML text.

    Parameters
    ----------
    text
        The text.
    progress
        Called with the number of characters read; a megabyte takes a few seconds.

    Attributes
    ----------
    data
        Dictionaries, lists, numbers, texts, Booleans and None.
    lines
        Line of every key and list entry by its path, counted from 1.
    problems
        Duplicate keys, tags and similar.
    """

    def __init__(self, text: str, progress: Progress = silent) -> None:
        self.lines: dict[Place, int] = {}
        self.problems: list[Message] = []
        self._values = 0
        self._most = len(text) + 10_000  # more values than characters can only result from nested aliases
        self._open: set[int] = set()
        self._progress, self._size = progress, len(text)
        node = _compose(text, progress)
        self._last_line = max(1, node.end_mark.line) if node is not None else 1
        self.data: Any = None if node is None else self._read(node, ())

    def _problem(self, place: Place, message: str, line: int, remedy: str | None = None) -> None:
        self.problems.append(Message(dotted(place), message, remedy=remedy, line=line))

    def _read(self, node: Any, place: Place) -> Any:
        from ruamel.yaml.nodes import MappingNode, ScalarNode, SequenceNode

        line = node.start_mark.line + 1
        self.lines.setdefault(place, line)
        self._values += 1
        if self._values % _EVERY == 0:
            share = _COMPOSED + (1.0 - _COMPOSED) * min(line / self._last_line, 1.0)
            self._progress(share * self._size, self._size)
        if self._values > self._most:
            remedy = "write the values out, without aliases"
            raise TreeError(
                Message(dotted(place), f"makes more than {self._most} values", remedy=remedy, line=line)
            )
        if id(node) in self._open:
            raise TreeError(Message(dotted(place), "refers to itself", remedy="remove the alias", line=line))
        if isinstance(node, ScalarNode):
            return self._scalar(node, place, line)
        if len(place) > MAX_DEPTH:
            raise TreeError(
                Message(dotted(place[:5]), f"is nested deeper than {MAX_DEPTH} levels", line=line)
            )
        if str(node.tag) not in (_TAG + "map", _TAG + "seq"):
            raise TreeError(
                Message(dotted(place), f"has the tag {str(node.tag)[:40]!r}", None, None, "remove it", line)
            )
        self._open.add(id(node))
        result: Any
        if isinstance(node, SequenceNode):
            items = _rejoined(node, [(item, None) for item in node.value])
            result = []
            for i, (item, _, whole) in enumerate(items):
                read = self._read(item, (*place, i))
                result.append(read if whole is None else self._whole((*place, i), whole, line))
        elif isinstance(node, MappingNode):
            result = self._mapping(node, place)
        else:
            raise TreeError(Message(dotted(place), "is of an unknown kind", line=line))
        self._open.discard(id(node))
        return result

    def _mapping(self, node: Any, place: Place) -> dict[str, Any]:
        from ruamel.yaml.nodes import ScalarNode

        out: dict[str, Any] = {}
        for value_node, key_node, whole in _rejoined(node, [(value, key) for key, value in node.value]):
            line = key_node.start_mark.line + 1
            if not isinstance(key_node, ScalarNode):
                self._problem(place, "has a key that is not a word", line, "write the key as one word")
                continue
            key = str(key_node.value)
            if key == "<<":
                self._problem(
                    (*place, key), "merges another mapping, which is not supported", line, "repeat the keys"
                )
                continue
            here = (*place, key)
            if key in out:
                first = self.lines[here]
                self._problem(
                    here,
                    f"is given twice, in line {first} and line {line}",
                    line,
                    "rename or remove one of them",
                )
                continue
            self.lines[here] = line
            out[key] = self._read(value_node, here) if whole is None else self._whole(here, whole, line)
        return out

    def _whole(self, place: Place, formula: str, line: int) -> str:
        """Report a value that YAML has split at its commas, and continue with the complete one."""
        if _DECIMAL.fullmatch(formula):
            value = formula.replace(", ", ".")
            self._problem(
                place, f"has a decimal comma, in {formula.replace(', ', ',')}", line, f"write {value}"
            )
            return value
        remedy = f'write {f"{place[-1]}: " if isinstance(place[-1], str) else ""}"{formula}"'
        message = "is split at its commas: inside {...} and [...] a formula with commas requires quotes"
        self._problem(place, message, line, remedy)
        return formula

    def _scalar(self, node: Any, place: Place, line: int) -> Any:
        text, tag = str(node.value), str(node.tag)
        if tag == _TAG + "str":
            return text
        if tag == _TAG + "null":
            return None
        if tag == _TAG + "bool":
            return text.lower() == "true"
        if tag in (_TAG + "int", _TAG + "float"):
            number = _number(text)
            if number is not None:
                return number
        elif not tag.startswith(_TAG) or tag[len(_TAG) :] not in ("timestamp", "value", "merge"):
            self._problem(place, f"has the tag {tag[:40]!r}", line, "remove the tag")
        return text


def _rejoined(node: Any, entries: list[tuple[Any, Any]]) -> list[tuple[Any, Any, str | None]]:
    """Entries of a list or mapping as (value, key, whole); `whole` is a rejoined value, else None.

    Inside {...} and [...] a comma ends a value without quotes: min(t, 1) becomes `min(t` and a further entry
    or key `1)`, and in mappings 2,5 mm becomes `2` and a further key `5 mm`.
    """
    found: list[tuple[Any, Any, str | None]] = []
    deep = 0
    for value, key in entries:
        text = _plain_text(value) if node.flow_style else None
        if deep > 0:
            more = text if key is None else _plain_text(key) if text == "" else None
            if more is not None:
                first, first_key, begun = found[-1]
                found[-1] = (first, first_key, f"{begun or _plain_text(first)}, {more}")
                deep += more.count("(") - more.count(")")
                continue
        rest = _plain_text(key) if text == "" and key is not None else None
        if found and rest is not None and _DECIMAL.fullmatch(f"{_plain_text(found[-1][0])}, {rest}"):
            first, first_key, _ = found[-1]
            found[-1] = (first, first_key, f"{_plain_text(first)}, {rest}")
            continue
        found.append((value, key, None))
        deep = max(text.count("(") - text.count(")"), 0) if text is not None else 0
    return found


def _plain_text(node: Any) -> str | None:
    """Text of an unquoted value; None for others."""
    from ruamel.yaml.nodes import ScalarNode

    return str(node.value) if isinstance(node, ScalarNode) and not node.style else None


def value_of(text: str) -> Any:
    """Read one value in the notation of a model file.

    Examples
    --------
    >>> value_of("0.05"), value_of("50 N m"), value_of("[1, 2]")
    (0.05, '50 N m', [1, 2])
    """
    try:
        tree = Tree(f"value: {text}")
    except TreeError as error:
        raise ModelError([error.problem]) from None
    if tree.problems or not isinstance(tree.data, dict) or list(tree.data) != ["value"]:
        problems = tree.problems or [Message("value", "is not a single value", value=text)]
        raise ModelError(problems)
    return tree.data["value"]


def _number(text: str) -> int | float | None:
    """Number of a YAML 1.2 scalar; None leaves it as text."""
    plain = text.replace("_", "").lower()
    if plain.lstrip("+-") in (".inf", ".nan"):
        return math.nan if "nan" in plain else math.copysign(math.inf, -1.0 if plain[0] == "-" else 1.0)
    try:
        if len(plain) > 400:
            return None
        for prefix, base in (("0x", 16), ("0o", 8)):
            if plain.lstrip("+-").startswith(prefix):
                return int(plain.replace(prefix, ""), base)
        try:
            return int(plain)
        except ValueError:
            return float(plain)
    except ValueError:
        return None


class _Watched:
    """Text stream that reports the progress of reading."""

    def __init__(self, text: str, progress: Progress) -> None:
        self._stream, self._size, self._progress = StringIO(text), len(text), progress

    def read(self, size: int) -> str:
        """Next characters for the parser; reports the progress."""
        self._progress(_COMPOSED * self._stream.tell(), self._size)
        return self._stream.read(size)


def _compose(text: str, progress: Progress = silent) -> Any:
    from ruamel.yaml import YAML
    from ruamel.yaml.error import MarkedYAMLError, YAMLError
    from ruamel.yaml.reader import ReaderError

    if len(text) > MAX_BYTES:
        raise TreeError(_too_large())
    yaml = YAML(typ="safe", pure=True)
    try:
        return yaml.compose(_Watched(text, progress))
    except MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line = None if mark is None else mark.line + 1
        what = " ".join(str(error.problem or error.context or "cannot be read").split())
        remedy = "check indentation, colons, brackets and quotes there"
        raise TreeError(Message("YAML syntax", what, remedy=remedy, line=line)) from None
    except RecursionError:
        raise TreeError(Message("YAML syntax", "the file is nested too deeply")) from None
    except ReaderError as error:
        line = text[: error.position].count("\n") + 1
        what = f"holds the character #x{error.character:04x}, which no text file has"
        remedy = "remove it; is this a YAML text file?"
        raise TreeError(Message("YAML syntax", what, remedy=remedy, line=line)) from None
    except (YAMLError, ValueError, AttributeError, TypeError, IndexError, KeyError, AssertionError) as error:
        # ruamel.yaml lets a few plain exceptions escape on broken input
        what = " ".join(str(error).split())[:200] or type(error).__name__
        raise TreeError(Message("YAML syntax", what, remedy="is this a YAML text file?")) from None
