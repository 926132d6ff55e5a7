# SPDX-License-Identifier: Apache-2.0
"""Checks of components created in Python: type, finiteness and range, as for a file."""

from __future__ import annotations

from collections.abc import Container, Mapping
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.model.components.law import AXES, Constant, PythonLaw, TableLaw
from pitchpoint.model.components.modifications import FlankPitch
from pitchpoint.model.components.tooth_profile import Points
from pitchpoint.model.keys import Key, Place, defaults_of, keys_of
from pitchpoint.model.reading.mechanism import recheck_motions
from pitchpoint.model.show import example, shown

if TYPE_CHECKING:
    from pitchpoint.model.reading.reader import Reader


def recheck(part: Any, place: Place, report: Reader, except_for: Container[str] = ()) -> None:
    """Report every field of a component that would be invalid in a file.

    Parameters
    ----------
    part
        Any component.
    place
        Its path in the model.
    report
        Collects the problems.
    except_for
        Names of keys that need no check.
    """
    defaults = defaults_of(type(part))
    for name, key in keys_of(type(part)).items():
        report.within = vars(part)
        value = getattr(part, name)
        if name in except_for or (value is None and defaults.get(name, ...) is None):
            continue
        _value(key, value, (*place, name), report)


def _value(key: Key, value: Any, place: Place, report: Reader) -> None:
    if key.kind == "center":
        kind = "quantities" if isinstance(value, list | tuple) else "quantity"
        _value(Key(kind, "", dimension=key.dimension, length=(3, 3)), value, place, report)
    elif key.kind in (
        "quantity",
        "integer",
        "choice",
        "text",
        "boolean",
        "end",
        "file",
        "library",
        "formula",
    ):
        if key.kind == "quantity" and not isinstance(value, Real):
            report.problem(place, "is not a number", value=shown(value), remedy=f"write {example(key)}")
        elif not (key.kind in ("file", "library") and isinstance(value, str) and Path(value).is_file()):
            report.value(key, value, place)  # a file that was read is relative to the working directory
    elif key.kind in ("displacements", "rates", "coordinates", "motions", "terms"):
        _of_joints(key, value, place, report)
    elif key.kind in (
        "quantities",
        "names",
        "ends",
        "words",
        "matrix",
        "matrices",
        "grid",
        "speeds",
        "gears",
    ):
        if not isinstance(value, list | tuple | Mapping):
            report.problem(place, "is neither a tuple nor a mapping", value=shown(value))
        elif not (key.kind == "quantities" and any(isinstance(v, str) for v in value)):
            report.value(key, value, place)
        else:
            report.problem(place, "contains text", remedy="give numbers in SI units")
    elif key.kind in ("value", "values", "gains", "records", "record_signals", "wires", "curve"):
        report.value(key, value, place)
    elif key.kind == "code":
        if not isinstance(value, PythonLaw):
            report.problem(place, "is of the wrong type", value=type(value).__name__, limit="PythonLaw")
    elif key.kind == "pitch":
        if isinstance(value, FlankPitch):
            recheck(value, place, report)
        else:
            _value(Key("quantities", "", dimension=key.dimension), value, place, report)
    elif key.kind == "points":
        if isinstance(value, Points):
            report.value(key, value.xy, place)
        else:
            report.problem(place, "is of the wrong type", value=type(value).__name__, limit="Points")
    elif key.kind in ("component", "variant", "tooth_profile"):
        allowed = tuple(key.of.values()) if isinstance(key.of, dict) else (key.of,)
        _component(allowed, value, place, report)
    elif key.kind == "components":
        allowed = tuple(key.of.values()) if isinstance(key.of, dict) else (key.of,)
        for name, part in value.items():
            if report.good_name(name, place, key.dotted):
                _component(allowed, part, (*place, name), report)
    elif key.kind == "list":
        for i, part in enumerate(value):
            _component((key.of,), part, (*place, i), report)
    elif key.kind in ("law", "laws"):
        for law in value if key.kind == "laws" else (value,):
            _law(key, law, place, report)


def _of_joints(key: Key, value: Any, place: Place, report: Reader) -> None:
    """Check mappings by coordinate name."""
    if not isinstance(value, Mapping):
        report.problem(place, "is not a mapping", value=shown(value))
    elif key.kind == "motions":
        recheck_motions(value, place, report)
    elif key.kind != "coordinates" and any(isinstance(v, str) for v in value.values()):
        report.problem(place, "contains text", remedy="give numbers in SI units")
    else:
        report.value(key, value, place)


def _component(allowed: tuple[type, ...], part: Any, place: Place, report: Reader) -> None:
    if isinstance(part, allowed):
        recheck(part, place, report)
    else:
        names = " or ".join(c.__name__ for c in allowed)
        report.problem(place, "is of the wrong type", value=type(part).__name__, limit=names)


def _law(key: Key, law: Any, place: Place, report: Reader) -> None:
    number = Key("quantity", "", dimension=key.dimension)
    if isinstance(law, Constant):
        _value(number, law.value, place, report)
    elif isinstance(law, TableLaw):
        if len(law.abscissa) != len(law.values) or len(law.values) < 2:
            report.problem(
                place, "requires two lists of equal length, at least 2", remedy="correct the table"
            )
            return
        axis = Key("quantity", "", dimension=AXES.get(law.over, "angle"))
        for i, (x, y) in enumerate(zip(law.abscissa, law.values, strict=True)):
            _value(axis, x, (*place, i), report)
            _value(number, y, (*place, i), report)
    elif isinstance(law, int | float | str):
        report.problem(place, "is not a law", value=shown(law), remedy="wrap it, as in Constant(150.0)")
