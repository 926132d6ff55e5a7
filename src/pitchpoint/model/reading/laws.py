# SPDX-License-Identifier: Apache-2.0
"""Readers of laws, Python functions and materials.

Formulas are parsed by the whitelist parser of `core.formula.formula` and never evaluated as Python. A Python
function is only named here, and only if the caller allows code.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import did_you_mean, nearest
from pitchpoint.core.unit_table import UNITS
from pitchpoint.core.unit_table import WORDS as UNIT_WORDS
from pitchpoint.model.components.law import AXES, LAWS, Balance, Constant, FormulaLaw, PythonLaw, TableLaw
from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.reading import data_files, formulas
from pitchpoint.model.reading.bare_numbers import note_formula
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.model.components.own_material import OwnMaterial
    from pitchpoint.model.reading.reader import Reader

MATERIALS = "materials"
"""Section of the materials of a model."""
BALANCE = "balance"
"""Word for the torque that balances the others."""
VARIABLES = ("t", "angle", "speed")
_WORDS = re.compile(r"(?<![\w.])(?:[a-zA-Z_]\w*)")
_CALL = re.compile(r"[a-zA-Z_]\w*\s*\(")


def law(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a torque, force or prescribed motion in any of its forms."""
    if isinstance(data, LAWS):
        return data
    motion = key.dimension in ("angle", "angular_speed", "length", "speed")
    variables = key.variables or (("t",) if motion else VARIABLES)
    if isinstance(data, Mapping):
        if "python" in data:
            return python(reader, key, data, path)
        if "table" in data:
            return _table(reader, key, data, path, variables)
        return reader.problem(
            path,
            "is neither a table nor a Python function",
            remedy="write {table: [[t, value], ...], over: time}",
        )
    if data == BALANCE and key.dimension == "torque":
        return Balance()
    if isinstance(data, str) and (
        any(w in variables for w in _WORDS.findall(data))
        or _CALL.search(data) is not None
        or _has_unknown_factor(reader, data)
    ):
        return formula(reader, key, data, path, variables)
    if key.dimension == "torque" and isinstance(data, str) and _is_misspelt(reader, data):
        remedy = "write balance, or a torque such as 150 N m"
        return reader.problem(path, "is neither balance nor a torque", value=shown(data), remedy=remedy)
    value = reader.number(key, data, path)
    return BAD if value is BAD else Constant(value)


def _has_unknown_factor(reader: Reader, text: str) -> bool:
    """Whether a text is a product with a word that is neither a unit nor a parameter: a misspelt variable."""
    known = {"pi", *UNITS, *UNIT_WORDS, *reader.parameters, *reader.unreadable}
    return "*" in text and any(word not in known for word in _WORDS.findall(text))


def _is_misspelt(reader: Reader, text: str) -> bool:
    """Whether a text is a word similar to `balance` that is not a parameter."""
    return bool(nearest(text, [BALANCE])) and text.strip() not in {*reader.parameters, *reader.unreadable}


def laws(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a list of laws."""
    return reader.sequence(key, data, path, lambda k, entry, at: law(reader, k, entry, at))


def formula(reader: Reader, key: Key, text: str, path: Place, variables: tuple[str, ...]) -> Any:
    """Read a formula of the variables; its parameters are replaced by their values in SI units."""
    from pitchpoint.core.formula.formula import FormulaError

    if reader.unreadable.intersection(_WORDS.findall(text)):
        return reader.taint(path)  # the parameter has been reported
    try:
        values_in_si = formulas.expanded(reader, text, variables, key.dimension)
    except FormulaError as error:
        remedy = error.remedy or (
            f"a formula may use {', '.join(variables)}, pi, numbers with units and listed functions"
        )
        return reader.problem(path, f"cannot be read as a formula: {error}", remedy=remedy)
    note_formula(reader, key, text, variables, path)
    return FormulaLaw(values_in_si, variables)


def _table(reader: Reader, key: Key, data: Mapping[str, Any], path: Place, variables: tuple[str, ...]) -> Any:
    reader.unknown(data, ("table", "over", "shift"), path)
    choices = ("time", *(v for v in AXES if v in variables))
    over = reader.word(Key("choice", "", choices=choices), data.get("over", "time"), (*path, "over"))
    x_key = Key("quantity", "", dimension=AXES.get(over, "time"))
    points = table_points(reader, key, data["table"], (*path, "table"), x_key, over)
    shift = reader.number(x_key, data.get("shift", 0.0), (*path, "shift")) if "shift" in data else 0.0
    if BAD in (points, shift, over):
        return BAD
    return TableLaw(tuple(p[0] + shift for p in points), tuple(p[1] for p in points), over)


def table_points(reader: Reader, key: Key, rows: Any, at: Place, x_key: Key, over: Any) -> Any:
    """Read rows of two values with increasing first values, or a text file of them; BAD with any problem."""
    if isinstance(rows, str):
        return BAD if over is BAD else data_files.pairs(reader, rows, (x_key.dimension, key.dimension), at)
    if over is BAD:
        return BAD

    def read(column: int, cell: Any, place: Place) -> Any:
        """Value of a column."""
        return reader.number(key if column else x_key, cell, place)

    return data_files.increasing_rows(
        reader, rows, at, read, str(over), "[[0 s, 0], [1 s, 150]], or name a text file"
    )


def python(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read 'file.py:function' with parameters; reports a problem unless code is allowed."""
    if isinstance(data, PythonLaw):
        return data
    parameters: Any = ()
    name = data
    if isinstance(data, Mapping):
        reader.unknown(data, ("python", "parameters"), path)
        name = data.get("python")
        numbers = Key("quantities", "", dimension="dimensionless", length=(0, 1000))
        parameters = reader.sequence(
            numbers, data.get("parameters", []), (*path, "parameters"), reader.number
        )
    match = re.fullmatch(r"(.+\.py):([A-Za-z_]\w*)", name) if isinstance(name, str) else None
    if match is None:
        return reader.problem(path, "does not name a Python function", remedy="write 'file.py:function'")
    if not reader.allow_code:
        return reader.problem(
            path,
            f"names Python code ('{match[1]}'), which is not run unless allowed",
            remedy="read the code, then use --allow-code (allow_code=True)",
        )
    if parameters is BAD:
        return BAD
    return PythonLaw(str(Path(reader.directory) / match[1]), match[2], parameters)


def material(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the name of a material of the library or of the model, or the properties of a material."""
    from pitchpoint.geometry import materials
    from pitchpoint.model.components.own_material import OwnMaterial

    if isinstance(data, Mapping):
        found = reader.component(OwnMaterial, data, path)
        return BAD if found is BAD else found.named()
    if isinstance(data, materials.Material) or (isinstance(data, str) and data in materials.LIBRARY):
        return data
    if isinstance(data, str) and data in reader.materials:
        reader.used.add(material_source(data))
        own = reader.materials[data]
        return reader.taint(path) if own is None else own.named(data)
    known = [*reader.materials, *sorted(materials.LIBRARY)]
    return reader.problem(
        path,
        f"{str(data)[:40]!r} is neither a material of the model nor of the library",
        remedy=f"{did_you_mean(data, known)}available are {', '.join(known)}",
    )


def material_source(name: str) -> str:
    """Word for a material of the model among the names of the parameters of a value.

    Examples
    --------
    >>> material_source("cast")
    'materials.cast'
    """
    return f"{MATERIALS}.{name}"


def note_materials(reader: Reader, found: Mapping[str, OwnMaterial], names: Iterable[object]) -> None:
    """Make the materials of the model known for the values that follow.

    Parameters
    ----------
    reader
        Reader of the model.
    found
        Materials that could be read.
    names
        All names of the section.
    """
    from pitchpoint.geometry.materials import LIBRARY

    for name in [name for name in found if name in LIBRARY]:
        reader.problem((MATERIALS, name), "is a material of the library", remedy="choose another name")
    reader.materials = {**{str(name): None for name in names}, **found}
