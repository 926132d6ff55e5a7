# SPDX-License-Identifier: Apache-2.0
"""REXS files in XML: text to `RawModel`, without entities, document types or deep nesting."""

from __future__ import annotations

from typing import Any
from xml.parsers import expat

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.rexs.raw import (
    MOST_PARTS,
    Coded,
    RawAttribute,
    RawComponent,
    RawModel,
    RawRelation,
    RawSpectrum,
)

CHILDREN = {
    "": ("model",),
    "model": ("relations", "components", "load_spectrum"),
    "relations": ("relation",),
    "relation": ("ref",),
    "components": ("component",),
    "component": ("attribute",),
    "attribute": ("array", "matrix", "array_of_arrays"),
    "array_of_arrays": ("array",),
    "array": ("c",),
    "matrix": ("r",),
    "r": ("c",),
    "load_spectrum": ("load_case", "accumulation"),
    "load_case": ("component",),
    "accumulation": ("component",),
}
"""Elements that each element may contain."""
REQUIRED = {
    "model": ("version",),
    "relation": ("id", "type"),
    "ref": ("id", "role"),
    "component": ("id",),
    "attribute": ("id",),
    "load_spectrum": ("id",),
    "load_case": ("id",),
}
"""XML attributes without which an element has no meaning."""
MOST_PROBLEMS = 50
"""Number of problems after which reading ends."""


class _RefusedError(Exception):
    """End of reading, after the last problem."""


def read_xml(data: bytes) -> RawModel:
    """Contents of an XML file.

    Parameters
    ----------
    data
        The file, in an encoding that its first line names.

    Raises
    ------
    ModelError
        With all problems found: XML that is cut or not well-formed, a document type or an entity, elements
        that REXS does not have, missing identifiers.
    """
    parser = _Parser()
    parser.read(data)
    if parser.problems:
        raise ModelError(parser.problems)
    return parser.model


class _Parser:
    def __init__(self) -> None:
        self.model = RawModel()
        self.problems: list[Message] = []
        self.path: list[str] = []
        self.stack: list[Any] = []
        self.text: list[str] = []
        self.parts = 0
        self.expat = expat.ParserCreate()
        self.expat.buffer_text = True
        self.expat.StartElementHandler = self.start
        self.expat.EndElementHandler = self.end
        self.expat.CharacterDataHandler = self.text.append
        self.expat.StartDoctypeDeclHandler = self.document_type
        self.expat.EntityDeclHandler = self.entity

    # --- reading --------------------------------------------------------------------------------------------
    def read(self, data: bytes) -> None:
        """Read the whole text; problems are collected."""
        try:
            self.expat.Parse(data, True)
        except expat.ExpatError as error:
            text = expat.ErrorString(error.code)
            cut = text in _CUT
            at = f" within {' > '.join(self.path)}" if self.path else ""
            self.problems.append(
                Message(
                    "",
                    f"is not well-formed XML: {text}{at}",
                    remedy="the file is cut off: export or copy it again" if cut else "export the file again",
                    line=error.lineno,
                )
            )
        except (LookupError, ValueError) as error:  # unknown or unusable encodings
            self.problems.append(Message("", f"cannot be read as text: {error}", remedy="save it as UTF-8"))
        except _RefusedError:
            return

    @property
    def line(self) -> int:
        """Line of the element being read."""
        return int(self.expat.CurrentLineNumber)

    @property
    def where(self) -> str:
        """Place of the element being read."""
        return f"line {self.line}"

    def problem(self, where: str, text: str, value: str | None = None, remedy: str | None = None) -> None:
        """Add a problem at the element being read."""
        self.problems.append(Message(where, text, value, remedy=remedy, line=self.line))
        if len(self.problems) >= MOST_PROBLEMS:
            raise _RefusedError

    def document_type(self, *_: Any) -> None:
        """Refuse a document type: it can define entities of any size, and name other files."""
        self.problem("<!DOCTYPE>", "is not permitted in REXS files", remedy="remove the document type")
        raise _RefusedError

    def entity(self, name: str, *_: Any) -> None:
        """Refuse entities."""
        self.problem("<!ENTITY>", "is not permitted in REXS files", value=name[:40], remedy="write its text")
        raise _RefusedError

    # --- elements -------------------------------------------------------------------------------------------
    def start(self, name: str, given: dict[str, str]) -> None:
        """Begin an element."""
        self.parts += 1
        if self.parts > MOST_PARTS:
            self.problem("", f"has more than {MOST_PARTS} elements", remedy="export it with coded arrays")
            raise _RefusedError
        parent = self.path[-1] if self.path else ""
        if name not in CHILDREN.get(parent, ()):
            expected = ", ".join(CHILDREN.get(parent, ())) or "text only"
            what = f"<{parent}> cannot contain it" if parent else "is not a REXS file"
            self.problem(f"<{name[:40]}>", what, remedy=f"expected: {expected}")
            raise _RefusedError
        for key in REQUIRED.get(name, ()):
            if key not in given:
                self.problem(f"<{name}>", f"has no {key}", remedy=f"give {key}")
        self.path.append(name)
        self.text.clear()
        begin = getattr(self, f"begin_{name}", None)
        self.stack.append(begin(given) if begin is not None else None)

    def end(self, name: str) -> None:
        """End an element."""
        self.path.pop()
        own = self.stack.pop()
        finish = getattr(self, f"end_{name}", None)
        if finish is not None:
            finish(own)
        self.text.clear()

    def begin_model(self, given: dict[str, str]) -> None:
        """Keep the head."""
        self.model.head = dict(given)

    def begin_relation(self, given: dict[str, str]) -> RawRelation:
        """Begin a relation."""
        found = RawRelation(given.get("id"), given.get("type", ""), given.get("order"), self.where)
        self.model.relations.append(found)
        return found

    def begin_ref(self, given: dict[str, str]) -> None:
        """Add a reference to the relation."""
        self.stack[-1].refs.append((given.get("role", ""), given.get("id")))

    def begin_component(self, given: dict[str, str]) -> RawComponent:
        """Begin a component of the model or of a load case."""
        found = RawComponent(given.get("id"), given.get("type", ""), given.get("name", ""), self.where)
        group = self.model.components if self.path[-2] == "components" else self.stack[-1]
        group.append(found)
        return found

    def begin_attribute(self, given: dict[str, str]) -> RawAttribute:
        """Begin an attribute."""
        found = RawAttribute(given.get("id", ""), given.get("unit"), where=self.where)
        self.stack[-1].attributes.append(found)
        return found

    def end_attribute(self, own: RawAttribute) -> None:
        """Take the text of an attribute without arrays."""
        if own.value is None:
            own.value = "".join(self.text).strip() or None

    def begin_load_spectrum(self, given: dict[str, str]) -> RawSpectrum:
        """Begin a load spectrum."""
        found = RawSpectrum(given.get("id"), self.where)
        self.model.spectra.append(found)
        return found

    def begin_load_case(self, given: dict[str, str]) -> list[RawComponent]:
        """Begin a load case."""
        components: list[RawComponent] = []
        self.stack[-1].cases.append((given.get("id"), components))
        return components

    def begin_accumulation(self, given: dict[str, str]) -> list[RawComponent]:
        """Begin the accumulated values."""
        found: list[RawComponent] = self.stack[-1].accumulation
        return found

    # --- arrays ---------------------------------------------------------------------------------------------
    def begin_array(self, given: dict[str, str]) -> tuple[list[Any], dict[str, str]]:
        """Begin an array."""
        return [], given

    begin_matrix = begin_array_of_arrays = begin_array

    def begin_r(self, given: dict[str, str]) -> tuple[list[Any], dict[str, str]]:
        """Begin a row."""
        return [], given

    def end_c(self, own: None) -> None:
        """Add an entry to its array or row."""
        self.stack[-1][0].append("".join(self.text).strip())

    def end_r(self, own: tuple[list[Any], dict[str, str]]) -> None:
        """Add a row to its matrix."""
        self.stack[-1][0].append(own[0])

    def end_array(self, own: tuple[list[Any], dict[str, str]]) -> None:
        """Add an array to its attribute, or to its array of arrays."""
        entries, given = own
        value: Any = entries
        if "code" in given:
            value = Coded(
                given["code"],
                "".join(self.text).strip(),
                self.count(given, "rows"),
                self.count(given, "columns"),
            )
        parent = self.stack[-1]
        if isinstance(parent, RawAttribute):
            parent.value = value
        else:
            parent[0].append(value)

    end_matrix = end_array_of_arrays = end_array

    def count(self, given: dict[str, str], key: str) -> int | None:
        """Number of rows or columns of a coded matrix."""
        text = given.get(key)
        if text is None:
            return None
        if not text.isdecimal() or len(text) > 9:
            self.problem(f"<matrix {key}>", "is not a number of rows or columns", value=text[:40])
            return None
        return int(text)


_CUT = (
    expat.errors.XML_ERROR_NO_ELEMENTS,
    expat.errors.XML_ERROR_UNCLOSED_TOKEN,
    expat.errors.XML_ERROR_PARTIAL_CHAR,
)
"""Errors at the end of a file that is cut off."""
