# SPDX-License-Identifier: Apache-2.0
"""Values of the parameters of a model: a number with its unit, or a formula of other parameters.

A parameter retains its dimension. Without a unit it is a plain number, not a number in SI units.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import UnitError
from pitchpoint.core.nearest import hint
from pitchpoint.core.unit_table import DIMENSIONS, UNITS
from pitchpoint.core.units import natural_quantity
from pitchpoint.model.components.parameter import Parameter
from pitchpoint.model.keys import BAD
from pitchpoint.model.origin import drop
from pitchpoint.model.reading.bare_numbers import USUAL, Bare, is_doubtful
from pitchpoint.model.reading.formula_text import is_formula
from pitchpoint.model.show import shown

if TYPE_CHECKING:
    from pitchpoint.core.formula.formula import Amount
    from pitchpoint.model.reading.reader import Reader

VARIABLES = ("t", "angle", "speed", "elongation", "rate")
SECTION = "parameters"
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_WORDS = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
_SIMPLE = "use letters, digits and '_', such as radial_clearance"


def good_name(reader: Reader, name: str) -> bool:
    """Check the name of a parameter: a word that means nothing else in a formula."""
    from pitchpoint.core.formula.formula import CONSTANTS, FUNCTIONS

    what = ""
    if not _NAME.fullmatch(name):
        what = "is not a name that a formula can use"
    elif name in FUNCTIONS or name in CONSTANTS:
        what = "is a function or constant of formulas"
    elif name in VARIABLES:
        what = "is a variable of formulas"
    elif name in UNITS:
        what = "is the symbol of a unit"
    if what:
        reader.problem((SECTION, name), what, remedy=_SIMPLE)
    return not what


def resolve(parameters: Mapping[str, Parameter], reader: Reader) -> dict[str, Amount]:
    """SI values and units of all parameters; problems are added to the reader.

    Parameters
    ----------
    parameters
        The parameters by name.
    reader
        Collects the problems; `unreadable` then contains the names without value.
    """
    words = {name: _WORDS.findall(p.value) for name, p in parameters.items() if isinstance(p.value, str)}
    graph = {name: {w for w in words.get(name, ()) if w in parameters} for name in parameters}
    found: dict[str, Amount] = {}
    for name in _in_order(graph, reader):
        if reader.unreadable.intersection(words.get(name, ())):
            reader.unreadable.add(name)
            continue
        amount = amount_of(parameters[name].value, reader, name, found)
        if amount is BAD:
            reader.unreadable.add(name)
        else:
            found[name] = amount
    return found


def _in_order(graph: Mapping[str, set[str]], reader: Reader) -> list[str]:
    """Names in the order of their evaluation, without those that depend on themselves."""
    graph = dict(graph)
    while True:
        try:
            return list(TopologicalSorter(graph).static_order())
        except CycleError as error:
            ring = list(reversed(error.args[1]))
            first = min(range(len(ring) - 1), key=lambda k: list(graph).index(ring[k]))
            ring = [*ring[first:-1], *ring[: first + 1]]
            path = " -> ".join(ring)
            reader.problem(
                (SECTION, ring[0]), f"depends on itself: {path}", remedy="give one of them a number"
            )
            reader.unreadable |= set(ring)
            graph = {name: needs - set(ring) for name, needs in graph.items() if name not in ring}


def amount_of(data: Any, reader: Reader, name: str, known: Mapping[str, Amount]) -> Any:
    """Value and unit of a parameter; BAD with a problem.

    Parameters
    ----------
    data
        Number or text of the file.
    reader
        Collects the problem.
    name
        Name of the parameter.
    known
        Values of the parameters that it may use.
    """
    from pitchpoint.core.formula.dimension import of_number, si_unit
    from pitchpoint.core.formula.formula import Amount, FormulaError, constant

    place = (SECTION, name)
    try:
        if not isinstance(data, str):
            return Amount(float(data), "")
        if not is_formula(data, known):
            value, unit = natural_quantity(data)
            amount = Amount(value, si_unit(of_number(1.0, unit)) if unit else "")
        else:
            amount = constant(data, "", known)[0]
    except FormulaError as error:
        remedy = error.remedy or "a parameter may use other parameters, pi, numbers with units and functions"
        return reader.problem(place, f"cannot be read as a formula: {error}", remedy=remedy)
    except UnitError as error:
        message, _, wanted = str(error).partition("; expected ")
        return reader.problem(place, message, remedy=f"write {wanted}" if wanted else None)
    if "." in amount.unit:
        remedy = "give the parameter a whole power, and take the root where it is used"
        return reader.problem(place, "has a unit with a fractional power", value=amount.unit, remedy=remedy)
    if amount.unit == "s^-1" and "min" in data:
        remedy = "write rpm for a speed, or Hz for a frequency"
        return reader.problem(place, "does not state what is counted", value=shown(data), remedy=remedy)
    return amount


def replaced(
    old: Mapping[str, Parameter], path: tuple[str, ...], value: Any, reader: Reader
) -> Mapping[str, Parameter]:
    """Parameters with one of them replaced; it retains its dimension.

    Parameters
    ----------
    old
        The present parameters.
    path
        Path below the section: NAME, or NAME and a key; empty for all parameters.
    value
        New value; a bare number is in the SI unit of the parameter.
    reader
        Reader with the present values; collects the problems.
    """
    if not path:
        found = reader.value(_key(), value if value is not None else {}, (SECTION,))
        return old if found is BAD else found
    name, *rest = path
    place = (SECTION, *path)
    if name not in old:
        reader.problem(place, "does not exist", remedy=hint(name, old))
        return old
    if len(rest) > 1 or (rest and rest[0] not in ("value", "text")):
        reader.problem(place, "is an unknown key", remedy="allowed are value, text")
        return old
    if value is None and not rest:
        return {n: p for n, p in old.items() if n != name}
    if rest == ["text"]:
        return {**old, name: replace(old[name], text=str(value or ""))}
    if isinstance(value, Parameter):
        return {**old, name: value}
    if isinstance(value, Mapping):
        found = reader.component(Parameter, value, place)
        return old if found is BAD else {**old, name: found}
    drop(reader, (SECTION, name))
    value = in_its_unit(value, name, reader)
    found = reader.component(Parameter, {"value": value, "text": old[name].text}, place)
    return old if found is BAD else {**old, name: found}


def in_its_unit(value: Any, name: str, reader: Reader) -> Any:
    """New value of a parameter: a bare number is in the SI unit of the present one.

    Parameters
    ----------
    value
        Number, or text of a file.
    name
        Name of the parameter.
    reader
        Reader with the present values; collects numbers that are rarely meant in SI units.
    """
    unit = reader.parameters[name].unit if name in reader.parameters else ""
    if not unit or not isinstance(value, int | float) or isinstance(value, bool):
        return value
    from pitchpoint.core.formula.dimension import of_number, readable, si_unit

    for dimension in USUAL:
        if si_unit(of_number(1.0, DIMENSIONS[dimension].si)) == unit and is_doubtful(value, dimension):
            reader.bare.append(Bare((SECTION, name), float(value), dimension))
    return f"{value!r} {readable(unit)}"


def check_units(old: Mapping[str, Amount], new: Mapping[str, Amount], reader: Reader) -> None:
    """Report every parameter whose dimension would change."""
    from pitchpoint.core.formula.dimension import readable

    for name, amount in new.items():
        if name in old and old[name].unit != amount.unit:
            is_now = f"has the unit {readable(amount.unit)}" if amount.unit else "has no unit"
            unit = readable(old[name].unit)
            was = f"the unit {unit}" if unit else "none"
            remedy = f"give a value in {unit}" if unit else "give a plain number"
            reader.problem((SECTION, name), f"{is_now}, but the value in the file has {was}", remedy=remedy)


def _key() -> Any:
    from pitchpoint.model.keys import Key

    return Key("parameters", "", of=Parameter)
