# SPDX-License-Identifier: Apache-2.0
"""Readers of values of bodies and joints: centres of mass, ends, coordinates, motions."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.discon.installed import PACKAGES, installed_library
from pitchpoint.core.nearest import similar_file
from pitchpoint.model.components.joint import DISPLACEMENTS, RATES
from pitchpoint.model.components.law import Constant, TableLaw
from pitchpoint.model.components.ratio import Arm
from pitchpoint.model.keys import BAD, Key, Place
from pitchpoint.model.reading import formulas
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader

RESERVED = ("t", "angle", "speed", "elongation", "rate", "pi", *DISPLACEMENTS)
"""Names that are reserved in formulas and not allowed for user-defined coordinates."""
RELATIVE = "file names are relative to the directory of the model file"
"""Remedy for a file that does not exist."""
_WORDS = re.compile(r"(?<![\w.])(?:[a-zA-Z_]\w*)")


def center(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read an axial position or three numbers."""
    if isinstance(data, list | tuple):
        three = Key("quantities", key.meaning, dimension="length", length=(3, 3))
        return reader.numbers(three, data, path)
    return reader.number(key, data, path)


def end(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the name of ground, a body or a marker of a body."""
    name = reader.string(key, data, path)
    if name is not BAD and (name.count(".") > 1 or not all(name.split("."))):
        return reader.problem(
            path, "is not a point on a body", value=shown(data), remedy="write ground, BODY or BODY.MARKER"
        )
    return name


def ends(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read a list of points on bodies."""
    if isinstance(data, list | tuple) and len(data) != key.length[0] == key.length[1]:
        remedy = f"write {key.length[0]} entries, such as [ground, BODY]"
        return reader.problem(
            path, f"has {len(data)} entries", limit=f"{key.length[0]} entries", remedy=remedy
        )
    return reader.sequence(key, data, path, lambda k, entry, at: end(reader, k, entry, at))


def file(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the name of a file, relative to the directory of the model file."""
    name = reader.string(key, data, path)
    if name is BAD:
        return BAD
    found = Path(reader.directory) / name
    if "\0" in name or not found.is_file():
        text = "names a file that does not exist"
        remedy = RELATIVE
        if "\0" not in name:
            text = "names a folder" if found.is_dir() else text
            remedy = f"{similar_file(Path(reader.directory), name)}{remedy}"
        return reader.problem(path, text, value=shown(name), remedy=remedy)
    return str(found)


def library(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the name of a library, or of its package; reports a problem unless code is allowed."""
    if isinstance(data, str) and data in PACKAGES:
        found: Any = str(installed_library(data) or "")
        if not found:
            remedy = "install it with pip install 'pitchpoint[wind]', or give the file of a library"
            return reader.problem(path, f"names the package {data}, which is not installed", remedy=remedy)
    else:
        found = file(reader, key, data, path)
    if found is not BAD and not reader.allow_code:
        return reader.problem(
            path,
            f"names a library ({shown(data)}), which is not loaded unless allowed",
            remedy="if you trust it, use --allow-code (allow_code=True)",
        )
    return found


# --- joints -------------------------------------------------------------------------------------------------
def coordinates(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read the names of user-defined coordinates, each a length or an angle."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path, "is not a mapping of names", value=shown(data), remedy="write {s: length}"
        )
    out = {}
    for name, word in data.items():
        at = (*path, str(name))
        if not str(name).isidentifier() or str(name) in RESERVED:
            reader.problem(at, "is not a name for a coordinate", remedy="use a word such as s or psi")
            continue
        if str(name) in {*reader.parameters, *reader.unreadable}:
            reader.problem(at, "is also the name of a parameter", remedy="rename one of them")
            continue
        found = reader.word(Key("choice", "", choices=("length", "angle")), word, at)
        if found is not BAD:
            out[str(name)] = found
    if len(data) > 6:
        return reader.problem(path, f"has {len(data)} coordinates", limit="<= 6", remedy="use several joints")
    return out if len(out) == len(data) else BAD


def _own(reader: Reader) -> dict[str, str]:
    """Coordinates of the joint that is being read, and their dimensions."""
    found = reader.within.get("coordinates")
    return {str(k): str(v) for k, v in found.items()} if isinstance(found, Mapping) else {}


def _by_coordinate(reader: Reader, data: Any, path: Place, dimensions: Mapping[str, str]) -> Any:
    """Read numbers by the names of coordinates."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path, "is not a mapping of coordinates", value=shown(data), remedy="write {spin: 30 deg}"
        )
    reader.unknown(data, dimensions, path)
    out = {}
    for name, value in data.items():
        if str(name) in dimensions:
            number = Key("quantity", "", dimension=dimensions[str(name)])
            out[str(name)] = reader.number(number, value, (*path, str(name)))
    return BAD if any(v is BAD for v in out.values()) or len(out) != len(data) else out


def displacements(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read initial values of coordinates."""
    return _by_coordinate(reader, data, path, {**DISPLACEMENTS, **_known(_own(reader))})


def rates(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read initial rates of coordinates."""
    known = {**DISPLACEMENTS, **_known(_own(reader))}
    return _by_coordinate(reader, data, path, {n: RATES[d] for n, d in known.items()})


def _known(own: Mapping[str, str]) -> dict[str, str]:
    return {n: d for n, d in own.items() if d in RATES}


def motions(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read displacements as functions of time or of one coordinate each."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path,
            "is not a mapping of displacements",
            value=shown(data),
            remedy="write {x: 2 mm * sin(t/1 s)}",
        )
    reader.unknown(data, DISPLACEMENTS, path)
    out = {}
    for name, given in data.items():
        if str(name) not in DISPLACEMENTS:
            continue
        number = Key("quantity", "", dimension=DISPLACEMENTS[str(name)])
        at = (*path, str(name))
        many = isinstance(given, list | tuple)
        found = [
            _function(reader, number, one, (*at, i) if many else at)
            for i, one in enumerate(given if many else [given])
        ]
        out[str(name)] = BAD if BAD in found else tuple(found)
    if len(out) != len(data):
        reader.tainted.add(path)  # do not report the remaining mapping as empty
        return BAD
    return BAD if any(v is BAD for v in out.values()) else out


def _function(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read one function; its variable is t, or the coordinate that it names."""
    from pitchpoint.model.reading import laws

    own = _own(reader)
    if isinstance(data, Mapping) and "table" in data and data.get("over") in own:
        return _table(reader, key, data, path, own[data["over"]])
    if isinstance(data, str):
        used = sorted(set(_WORDS.findall(data)) & set(own))
        if len(used) > 1:
            return reader.problem(
                path,
                f"depends on {' and '.join(used)}",
                remedy="write a list of functions of one coordinate each; they are summed",
            )
        if used:
            return laws.formula(reader, key, data, path, (used[0],))
    return laws.law(reader, key, data, path)


def _table(reader: Reader, key: Key, data: Mapping[str, Any], path: Place, dimension: str) -> Any:
    """Read a table over a coordinate."""
    from pitchpoint.model.reading.laws import table_points

    reader.unknown(data, ("table", "over"), path)
    x_key = Key("quantity", "", dimension=dimension)
    points = table_points(reader, key, data["table"], (*path, "table"), x_key, data["over"])
    if points is BAD:
        return BAD
    return TableLaw(tuple(p[0] for p in points), tuple(p[1] for p in points), data["over"])


def recheck_motions(value: Mapping[str, Any], path: Place, reader: Reader) -> None:
    """Check laws of motion created in Python."""
    for name, laws in value.items():
        at = (*path, name)
        if name not in DISPLACEMENTS:
            reader.unknown({name: laws}, DISPLACEMENTS, path)
        elif not isinstance(laws, list | tuple) or not laws:
            reader.problem(at, "is not a tuple of laws", value=shown(laws), remedy="write (FormulaLaw(...),)")
        else:
            for law in laws:
                if isinstance(law, int | float | str):
                    reader.problem(
                        at, "is not a law", value=shown(law), remedy="wrap it, as in Constant(0.1)"
                    )
                elif isinstance(law, Constant):
                    reader.number(Key("quantity", "", dimension=DISPLACEMENTS[name]), law.value, at)


# --- ratios -------------------------------------------------------------------------------------------------
def terms(reader: Reader, key: Key, data: Any, path: Place) -> Any:
    """Read coefficients by coordinate; lengths become `Arm`."""
    if not isinstance(data, Mapping):
        return reader.problem(
            path, "is not a mapping of coordinates", value=shown(data), remedy="write {A: 20, B: 40}"
        )
    if not 2 <= len(data) <= 3:
        return reader.problem(
            path, f"has {len(data)} terms", limit="2 or 3 terms", remedy="use several ratios for more"
        )
    out = {}
    for name, value in data.items():
        at = (*path, str(name))
        is_text = isinstance(value, str) and not formulas.is_plain(reader, value)
        found = reader.number(
            Key("quantity", "", dimension="length" if is_text else "dimensionless"), value, at
        )
        if found is BAD:
            return BAD
        if found == 0.0:
            return reader.problem(at, "is zero", remedy="remove the term")
        out[str(name)] = Arm(found) if is_text else found
    return out
