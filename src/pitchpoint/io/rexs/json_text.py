# SPDX-License-Identifier: Apache-2.0
"""REXS files in JSON: text to `RawModel`."""

from __future__ import annotations

import contextlib
import json
from typing import Any

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.rexs.raw import Coded, RawAttribute, RawComponent, RawModel, RawRelation, RawSpectrum
from pitchpoint.io.rexs.xml_text import MOST_PROBLEMS

KINDS = frozenset(
    (
        *("boolean", "string", "integer", "floating_point", "enum", "reference_component", "file_reference"),
        *(
            "date_time",
            "floating_point_array",
            "integer_array",
            "boolean_array",
            "string_array",
            "enum_array",
        ),
        *("reference_component_array", "floating_point_matrix", "integer_matrix", "boolean_matrix"),
        *("string_matrix", "array_of_integer_arrays", "floating_point_array_coded", "integer_array_coded"),
        *("floating_point_matrix_coded", "integer_matrix_coded"),
    )
)
"""Keys of the value of an attribute."""


class _RefusedError(Exception):
    """End of reading, after the last problem."""


def read_json(data: bytes) -> RawModel:
    """Contents of a JSON file; a byte-order mark is permitted.

    Parameters
    ----------
    data
        The file.

    Raises
    ------
    ModelError
        With all problems found.
    """
    try:
        tree = json.loads(data.decode("utf-8-sig"), parse_constant=_not_a_number)
    except UnicodeDecodeError as error:
        problem = Message("", f"is not UTF-8 text, from byte {error.start}", remedy="save it as UTF-8")
        raise ModelError([problem]) from None
    except json.JSONDecodeError as error:
        cut = error.pos >= len(error.doc.rstrip()) - 1 or error.msg.startswith("Unterminated")
        remedy = "the file is cut off: export or copy it again" if cut else "export the file again"
        problem = Message("", f"is not JSON: {error.msg}", remedy=remedy, line=error.lineno)
        raise ModelError([problem]) from None
    except RecursionError:
        raise ModelError([Message("", "is nested too deeply for a REXS file")]) from None
    except ValueError as error:
        raise ModelError([Message("", f"is not JSON: {error}", remedy="export the file again")]) from None
    reader = _Reader()
    with contextlib.suppress(_RefusedError):
        reader.model_of(tree)
    if reader.problems:
        raise ModelError(reader.problems)
    return reader.model


def _not_a_number(text: str) -> float:
    raise ValueError(f"{text} is not a number")


class _Reader:
    def __init__(self) -> None:
        self.model = RawModel()
        self.problems: list[Message] = []

    def problem(self, where: str, text: str, value: str | None = None, remedy: str | None = None) -> None:
        """Add a problem."""
        self.problems.append(Message(where, text, value, remedy=remedy))
        if len(self.problems) >= MOST_PROBLEMS:
            raise _RefusedError

    def mapping(self, data: Any, where: str) -> dict[str, Any]:
        """The data if it is an object, else a problem."""
        if isinstance(data, dict):
            return data
        self.problem(where, "is not an object", remedy="write {...}")
        return {}

    def entries(self, data: Any, where: str) -> list[tuple[dict[str, Any], str]]:
        """Objects of a list, each with its place."""
        if data is None:
            return []
        if not isinstance(data, list):
            self.problem(where, "is not a list", remedy="write [...]")
            return []
        return [(self.mapping(one, f"{where}[{k}]"), f"{where}[{k}]") for k, one in enumerate(data)]

    def word(self, data: dict[str, Any], key: str, where: str, required: bool = True) -> str:
        """A text of an object."""
        found = data.get(key)
        if isinstance(found, str):
            return found
        if found is not None or required:
            what = "is missing" if found is None else "is not a text"
            self.problem(f"{where}.{key}", what, remedy=f"give {key} as text")
        return ""

    def model_of(self, tree: Any) -> None:
        """Read the whole file."""
        if not isinstance(tree, dict) or not isinstance(tree.get("model"), dict):
            self.problem(
                "", "is not a REXS file: it has no object 'model'", remedy="export the model as REXS"
            )
            return
        data = tree["model"]
        self.model.head = {k: v for k, v in data.items() if isinstance(v, str)}
        for one, at in self.entries(data.get("relations"), "relations"):
            relation = RawRelation(one.get("id"), self.word(one, "type", at), one.get("order"), at)
            for ref, ref_at in self.entries(one.get("refs"), f"{at}.refs"):
                relation.refs.append((self.word(ref, "role", ref_at), ref.get("id")))
            self.model.relations.append(relation)
        self.model.components = self.components(data.get("components"), "components", typed=True)
        self.spectra(data)

    def spectra(self, data: dict[str, Any]) -> None:
        """Read the load spectra: one object, or a list; the accumulated values within it or after it."""
        found = data.get("load_spectrum")
        found = [found] if isinstance(found, dict) else found
        for one, at in self.entries(found, "load_spectrum"):
            spectrum = RawSpectrum(one.get("id"), at)
            for case, case_at in self.entries(one.get("load_cases"), f"{at}.load_cases"):
                parts = self.components(case.get("components"), f"{case_at}.components")
                spectrum.cases.append((case.get("id"), parts))
            total = one.get("accumulation") or data.get("accumulation")
            if total is not None:
                total = self.mapping(total, f"{at}.accumulation").get("components")
                spectrum.accumulation = self.components(total, f"{at}.accumulation.components")
            self.model.spectra.append(spectrum)

    def components(self, data: Any, where: str, typed: bool = False) -> list[RawComponent]:
        """Read components; those of load cases may lack their type."""
        found = []
        for one, at in self.entries(data, where):
            kind, name = self.word(one, "type", at, typed), self.word(one, "name", at, False)
            part = RawComponent(one.get("id"), kind, name, at)
            for attribute, attribute_at in self.entries(one.get("attributes"), f"{at}.attributes"):
                part.attributes.append(self.attribute(attribute, attribute_at))
            found.append(part)
        return found

    def attribute(self, data: dict[str, Any], where: str) -> RawAttribute:
        """Read an attribute."""
        name, unit = self.word(data, "id", where), data.get("unit")
        if unit is not None and not isinstance(unit, str):
            self.problem(f"{where}.unit", "is not a text", remedy="give the unit as text")
            unit = None
        at = f"{where} ({name})" if name else where
        kinds = [key for key in data if key in KINDS]
        if len(kinds) > 1:
            self.problem(where, f"has several values: {', '.join(kinds)}", remedy="give one")
        if not kinds:
            others = [key for key in data if key not in ("id", "unit")]
            if others:  # without any key the value is missing, as in an empty element of an XML file
                what = f"has the unknown key {others[0][:40]!r}"
                self.problem(where, what, remedy="give its value, such as floating_point: 1.0")
            return RawAttribute(name, unit, None, None, at)
        value, kind = data[kinds[0]], kinds[0]
        if kind.endswith("_coded"):
            value, kind = self.coded(value, f"{where}.{kind}"), kind.removesuffix("_coded")
        return RawAttribute(name, unit, value, kind, at)

    def coded(self, data: Any, where: str) -> Coded | None:
        """Read a coded array or matrix."""
        found = self.mapping(data, where)
        counts: list[int | None] = []
        for key in ("rows", "columns"):
            count = found.get(key)
            whole = isinstance(count, int) and not isinstance(count, bool)
            if count is not None and (not whole or not 0 <= count < 10**9):
                self.problem(f"{where}.{key}", "is not a number of rows or columns", value=str(count)[:40])
                count = None
            counts.append(count)
        code, value = self.word(found, "code", where), self.word(found, "value", where)
        return Coded(code, value, *counts)
