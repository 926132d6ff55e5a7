# SPDX-License-Identifier: Apache-2.0
"""A gear unit as the text of a REXS file: XML, JSON, or ZIP with XML."""

from __future__ import annotations

import io
import json
import zipfile
from collections.abc import Iterator, Mapping
from typing import Any
from xml.sax.saxutils import escape, quoteattr

from pitchpoint.io.rexs import tables
from pitchpoint.io.rexs.document import RexsAttribute, RexsModel
from pitchpoint.io.rexs.writing.notation import Written, written

FORMATS = {".rexs": "xml", ".xml": "xml", ".rexsj": "json", ".json": "json", ".rexsz": "zip", ".zip": "zip"}
"""Format by the ending of the file."""
INSIDE = "pitchpoint.rexs"
"""Name of the model in a ZIP archive."""
_EPOCH = (1980, 1, 1, 0, 0, 0)


def rexs_bytes(model: RexsModel, format: str = "xml") -> bytes:
    """Contents of a REXS file in the version of the model.

    Parameters
    ----------
    model
        The gear unit. Values that its version does not have are omitted.
    format
        "xml", "json" or "zip".
    """
    if format == "json":
        return (json.dumps({"model": _object(model)}, indent=1, ensure_ascii=False) + "\n").encode()
    text = "\n".join(_lines(model)) + "\n"
    if format == "xml":
        return text.encode()
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        entry = zipfile.ZipInfo(INSIDE, _EPOCH)
        entry.compress_type = zipfile.ZIP_DEFLATED
        archive.writestr(entry, text)
    return packed.getvalue()


def _head(model: RexsModel) -> dict[str, str]:
    program, _, number = model.application.partition(" ")
    return {
        "applicationId": program,
        "applicationVersion": number,
        "date": model.date,
        "version": model.version,
    }


def _values(model: RexsModel, values: Mapping[str, RexsAttribute]) -> list[Written]:
    found = (written(one, model.version) for one in values.values())
    return [one for one in found if one is not None]


# --- XML ----------------------------------------------------------------------------------------------------
def _tag(name: str, given: Mapping[str, object], end: str = "") -> str:
    return f"<{name}{''.join(f' {key}={quoteattr(str(value))}' for key, value in given.items())}{end}>"


def _lines(model: RexsModel) -> Iterator[str]:
    yield '<?xml version="1.0" encoding="UTF-8" standalone="no"?>'
    yield _tag("model", _head(model))
    yield " <relations>"
    for relation in model.relations:
        order = {} if relation.order is None else {"order": relation.order}
        yield "  " + _tag("relation", {"id": relation.id, "type": relation.type, **order})
        for role, id in relation.roles.items():
            yield "   " + _tag("ref", {"id": id, "role": role, "hint": model.components[id].type}, "/")
        yield "  </relation>"
    yield " </relations>"
    yield " <components>"
    for component in model.components.values():
        name = {"name": component.name} if component.name else {}
        yield from _component(
            model, {"id": component.id, "type": component.type, **name}, component.attributes
        )
    yield " </components>"
    for spectrum in model.load_spectra:
        yield " " + _tag("load_spectrum", {"id": spectrum.id})
        for case in spectrum.cases:
            yield " " + _tag("load_case", {"id": case.id})
            yield from _of_case(model, case.components)
            yield " </load_case>"
        if spectrum.accumulation:
            yield " <accumulation>"
            yield from _of_case(model, spectrum.accumulation)
            yield " </accumulation>"
        yield " </load_spectrum>"
    yield "</model>"


def _of_case(model: RexsModel, parts: Mapping[int, Mapping[str, RexsAttribute]]) -> Iterator[str]:
    for id, values in parts.items():
        yield from _component(model, {"id": id, "type": model.components[id].type}, values)


def _component(
    model: RexsModel, head: Mapping[str, object], values: Mapping[str, RexsAttribute]
) -> Iterator[str]:
    yield "  " + _tag("component", head)
    for one in _values(model, values):
        yield f"   {_tag('attribute', {'id': one.id, 'unit': one.unit})}{_cells(one)}</attribute>"
    yield "  </component>"


def _cells(one: Written) -> str:
    """Value of an attribute as XML."""
    if one.type.endswith("_matrix"):
        rows = ("".join(f"<c>{_plain(x)}</c>" for x in row) for row in one.value)
        return f"<matrix>{''.join(f'<r>{row}</r>' for row in rows)}</matrix>"
    if one.type == "array_of_integer_arrays":
        return f"<array_of_arrays>{''.join(map(_array, one.value))}</array_of_arrays>"
    return _array(one.value) if isinstance(one.value, list) else _plain(one.value)


def _array(values: list[Any]) -> str:
    return f"<array>{''.join(f'<c>{_plain(x)}</c>' for x in values)}</array>"


def _plain(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value) if isinstance(value, float) else escape(str(value))


# --- JSON ---------------------------------------------------------------------------------------------------
def _object(model: RexsModel) -> dict[str, Any]:
    found: dict[str, Any] = dict(_head(model))
    found["relations"] = [
        {
            "id": r.id,
            "type": r.type,
            **({} if r.order is None else {"order": r.order}),
            "refs": [
                {"id": id, "role": role, "hint": model.components[id].type} for role, id in r.roles.items()
            ],
        }
        for r in model.relations
    ]
    found["components"] = [
        {
            "id": c.id,
            "type": c.type,
            **({"name": c.name} if c.name else {}),
            "attributes": _attributes(model, c.attributes),
        }
        for c in model.components.values()
    ]
    spectra: list[dict[str, Any]] = []
    for one in model.load_spectra:
        spectrum: dict[str, Any] = {
            "id": one.id,
            "load_cases": [{"id": c.id, "components": _case(model, c.components)} for c in one.cases],
        }
        if one.accumulation:
            spectrum["accumulation"] = {"components": _case(model, one.accumulation)}
        spectra.append(spectrum)
    if spectra:
        found["load_spectrum"] = spectra[0] if len(spectra) == 1 else spectra
    return found


def _case(model: RexsModel, parts: Mapping[int, Mapping[str, RexsAttribute]]) -> list[dict[str, Any]]:
    return [
        {"id": id, "type": model.components[id].type, "attributes": _attributes(model, values)}
        for id, values in parts.items()
    ]


def _attributes(model: RexsModel, values: Mapping[str, RexsAttribute]) -> list[dict[str, Any]]:
    return [{"id": one.id, "unit": one.unit, one.type: one.value} for one in _values(model, values)]


def omitted(model: RexsModel) -> list[str]:
    """Values and components of a gear unit that its version of REXS does not have."""
    place = tables.VERSIONS.index
    found = []
    for component in model.components.values():
        since, until = tables.component_types().get(
            component.type, tables.VERSIONS[:: len(tables.VERSIONS) - 1]
        )
        if not place(since) <= place(model.version) <= place(until):
            found.append(f"{component}: not a component of REXS {model.version}")
        found += [
            f"{component}, {name}: not in REXS {model.version}"
            for name, one in component.attributes.items()
            if written(one, model.version) is None
        ]
    return found
