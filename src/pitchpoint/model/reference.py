# SPDX-License-Identifier: Apache-2.0
"""Reference page of the model file, generated from the keys of the components."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator, Mapping

from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.model.keys import TYPE, Key, defaults_of, keys_of
from pitchpoint.model.model import Model
from pitchpoint.model.schema import default_text
from pitchpoint.model.show import limit_text

HEAD = """# Keys of a model file

A model file is a YAML text of sections. Quantities are written with a unit (`3 mm`, `1500 rpm`,
`14 N/(mm um)`, see [Units](units.md)); bare numbers are SI. Unknown keys are errors. NaN, infinity and
booleans are rejected where a number is expected. `pitchpoint new` writes a model to start from, and
[Parameters, formulas, several files](../howto/parameters.md) describes what all sections have in common.

(model-formulas)=
## Formulas

Every number may be a formula of numbers with units, [parameters](#model-parameters), `pi` and functions:
`302.585 mm * cos(120 deg)`. A *law* is a constant, a formula of the time `t` (loads: also `angle` and
`speed`; along lines: `elongation` and `rate`), a table `{table: [[0 s, 0], [1 s, 150 N m]], over: time}` or
`{table: FILE.csv, over: angle, shift: 60 deg}`, or a Python function `{python: "file.py:function"}`; a torque
may be `balance`, the value that balances all others.

(model-include)=
## include

Other model files, by their paths from the folder of the model file; their sections are added by name.

```yaml
include: [gears.yaml, bearings/main.yaml]
```
"""
WORDS = {
    "integer": "whole number",
    "text": "text",
    "boolean": "true or false",
    "names": "list of names",
    "words": "list of words",
    "end": "ground, BODY or BODY.MARKER",
    "ends": "list of ground, BODY or BODY.MARKER",
    "file": "file name",
    "library": "file name",
    "records": "{RECORD: signal or number}",
    "record_signals": "{RECORD: signal}",
    "law": "[law](#model-formulas)",
    "laws": "list of [laws](#model-formulas)",
    "formula": "[formula](#model-formulas)",
    "parameter": "number or [formula](#model-formulas)",
    "python": "FILE.py:function",
    "code": "FILE.py:function",
    "material": "name, or {youngs_modulus, poisson_ratio, density}",
    "gears": "list of names, or {NAME: axial position}",
    "matrix": "6 rows of 6 numbers in SI units",
    "matrices": "list of matrices, each of 6 rows of 6 numbers in SI units",
    "orders": "{ORDER: [amplitude, phase]}",
    "coordinates": "{NAME: length or angle}",
    "displacements": "{COORDINATE: value}",
    "rates": "{COORDINATE: rate}",
    "motions": "{COORDINATE: [law](#model-formulas)}",
    "terms": "{COORDINATE: coefficient}",
    "value": "number in SI units, or with its unit",
    "values": "list of numbers",
    "gains": "{NAME: number}",
    "wires": "{VARIABLE: SIGNAL}",
    "curve": "rows [input, value], or file name",
    "points": "rows [x, y], or file name",
}
"""Forms of the values of the kinds of keys without dimension or component."""


def reference_page(snippets: Mapping[str, str] | None = None) -> str:
    """Markdown page with all keys of a model file: form, default, range, meaning.

    Parameters
    ----------
    snippets
        Part of a model file by section, shown at the beginning of the section.
    """
    return "\n".join([HEAD, *_Page(snippets or {}).lines()])


def snippets_of(text: str) -> dict[str, str]:
    """Sections of the text of a model file, with their comments.

    Parameters
    ----------
    text
        The text.

    Examples
    --------
    >>> snippets_of("title: a\\nrods:\\n  r: {ends: [a, b]}\\n")["rods"]
    'rods:\\n  r: {ends: [a, b]}'
    """
    found: dict[str, list[str]] = {}
    name = ""
    for line in text.splitlines():
        if begins := re.match(r"([a-z_]+):", line):
            name = begins[1]
        elif not line.startswith(" "):
            name = ""
        if name:
            found.setdefault(name, []).append(line)
    return {name: "\n".join(lines) for name, lines in found.items()}


class _Page:
    """Headings, texts and tables of all component classes, each once with the paths of all its uses."""

    def __init__(self, snippets: Mapping[str, str]) -> None:
        self.snippets = snippets
        self.uses: dict[type, list[tuple[str, ...]]] = {}
        self._collect(Model, ())

    def _collect(self, cls: type, path: tuple[str, ...]) -> None:
        known = cls in self.uses
        self.uses.setdefault(cls, []).append(path)
        if not known:
            for name, key in keys_of(cls).items():
                for form, nested in _classes(key):
                    self._collect(nested, (*path, name, *([form] if form else [])))

    def lines(self) -> Iterator[str]:
        """All lines of the page."""
        yield from [
            "## The whole file",
            "",
            "The keys at the top of the file; each section has a heading below.",
            "",
        ]
        yield from ["| key | meaning |", "|---|---|"]
        for name, key in keys_of(Model).items():
            yield f"| [{name}](#{self._label((name,))}) | {_escape(key.meaning)} |"
        yield ""
        for name, key in keys_of(Model).items():
            yield from [f"({self._label((name,))})=", f"## {name}", "", f"{_sentence(key.meaning)}", ""]
            if name in self.snippets:
                yield from ["```yaml", self.snippets[name], "```", ""]
            for form, cls in _classes(key):
                if self.uses[cls][0][: 1 + bool(form)] == (name, *([form] if form else [])):
                    yield from self._class(cls, key, form, top=not form)

    def _class(self, cls: type, key: Key, form: str, top: bool) -> Iterator[str]:
        """Text and table of one class, then those of the classes that it introduces."""
        path = self.uses[cls][0]
        if not top:
            yield from [f"({self._label(path)})=", f"### {' / '.join(path)}", ""]
        yield from [" ".join((cls.__doc__ or "").strip().split("\n\n")[0].split()), ""]
        others = [" / ".join(p) for p in dict.fromkeys(self.uses[cls][1:])]
        if others:
            yield from [f"Also: {', '.join(others)}.", ""]
        if form:
            yield from [f"`{TYPE if key.kind == 'components' else key.tag}: {form}`", ""]
        yield from self._table(cls)
        for name, inner in keys_of(cls).items():
            for word, nested in _classes(inner):
                if self.uses[nested][0] == (*path, name, *([word] if word else [])):
                    yield from self._class(nested, inner, word, top=False)

    def _label(self, path: tuple[str, ...]) -> str:
        return "-".join(["model", *path]).replace("_", "-")

    def _table(self, cls: type) -> Iterator[str]:
        keys, defaults = keys_of(cls), defaults_of(cls)
        if not keys:
            return
        yield "| key | value | default | range | meaning |"
        yield "|---|---|---|---|---|"
        for name, key in keys.items():
            default = default_text(key, defaults[name]) if name in defaults else "**required**"
            cells = (
                f"`{name}`",
                self._form(name, key),
                default,
                _range(key),
                _escape(key.meaning),
            )
            yield f"| {' | '.join(cells)} |"
        yield ""

    def _form(self, name: str, key: Key) -> str:
        """Form of the value of a key, with a link to its description."""
        linked = [f"[{word or name}](#{self._label(self.uses[c][0])})" for word, c in _classes(key)]
        if linked:
            form = " or ".join(linked)
            if key.kind == "components":
                return f"{{NAME: {form}}}"
            return f"list of {form}" if key.kind == "list" else form
        if key.kind == "choice":
            return "word"
        if key.kind in WORDS:
            form = WORDS[key.kind]
            if key.kind == "text" and key.names in keys_of(Model):
                form = f"name in [{key.names}](#{self._label((key.names,))})"
            return form if key.kind not in ("law", "laws") else f"{form}, {_quantity(key)}"
        one = _quantity(key)
        of_lists = {"quantities": "list", "grid": "rows", "pitch": "list", "speeds": "{NAME: value}"}
        return f"{of_lists[key.kind]}, {one}" if key.kind in of_lists else one


def _classes(key: Key) -> list[tuple[str, type]]:
    """Component classes of a key, with their form if there are several."""
    if isinstance(key.of, dict):
        return list(key.of.items())
    return [("", key.of)] if dataclasses.is_dataclass(key.of) and isinstance(key.of, type) else []


def _quantity(key: Key) -> str:
    """Dimension of a key with its SI unit."""
    row = DIMENSIONS[key.dimension]
    words = key.dimension.replace("_", " ")
    return f"{words} [{row.si}](units.md)" if row.si else "number"


def _range(key: Key) -> str:
    if key.choices:
        return ", ".join(key.choices)
    return limit_text(key) if key.kind in ("quantity", "quantities") else key.limit


def _sentence(text: str) -> str:
    """Meaning of a key as a sentence."""
    return text[:1].upper() + text[1:] + "."


def _escape(text: str) -> str:
    return text.replace("|", "\\|")
