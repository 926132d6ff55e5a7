# SPDX-License-Identifier: Apache-2.0
"""Numbers without unit that are rarely meant in SI units: a speed of 3000, a width of 20, an angle of 15.

The rule is the same for the numbers of a file, of ``--set`` and ``--vary``, and for options of commands.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

from pitchpoint.core.errors import Message, UnitError, remark
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import format_quantity, in_unit, natural_quantity
from pitchpoint.model.keys import Key, Place
from pitchpoint.model.reading.formula_text import is_formula

if TYPE_CHECKING:
    from pitchpoint.core.formula.dimension import Kind
    from pitchpoint.model.reading.reader import Reader

USUAL = {"angular_speed": "rpm", "length": "mm", "angle": "deg"}
"""Unit that a number without unit is probably in."""

SIGNAL = "signal"
"""In place of a dimension: that of a signal, which is known when all blocks and sensors have been read."""

LARGE = 1.0
"""Length [m] from which a number without unit rather is in millimetres."""


def is_doubtful(value: float, dimension: str) -> bool:
    """Whether a number without unit may be meant in rpm, millimetres or degrees.

    Speeds always: a number in rad/s has no typical size. Lengths from 1 m, where most parts are smaller.
    Angles beyond a turn, and whole numbers: 15 rad is rarely meant, 0.26 rad often is.

    Parameters
    ----------
    value
        Number as written.
    dimension
        Dimension of its key.

    Examples
    --------
    >>> is_doubtful(3000, "angular_speed"), is_doubtful(0.02, "length"), is_doubtful(15, "angle")
    (True, False, True)
    """
    size = abs(value)
    if dimension == "angular_speed":
        return size > 0.0
    if dimension == "length":
        return size >= LARGE
    return dimension == "angle" and size > 0.0 and (size > 2.0 * math.pi or size == round(size))


class Bare(NamedTuple):
    """Number without unit that is rarely meant in SI units.

    `value` is in SI units, of a function the largest in the first second. `written` is a parameter, a
    constant formula or a function of time, as `form` states; it is empty for a number. `unit` is the one that
    it probably is in, if not that of `USUAL`.
    """

    place: Place
    value: float
    dimension: str
    written: str = ""
    form: str = "number"
    in_file: bool = True
    unit: str = ""

    @property
    def text(self) -> str:
        """What is read, and how."""
        number = f"{self.value:g} has no unit and is read as {self._both}"
        if self.form == "function":
            si = DIMENSIONS[self.dimension].si
            most = f"up to {self._both} in the first second"
            return f"{self.written!r} has no unit and is read in {si}: {most}"
        return f"{'parameter ' * (self.form == 'parameter')}{self.written} = {number}".removeprefix(" = ")

    @property
    def _both(self) -> str:
        """The value in SI and in its customary unit."""
        in_si = f"{self.value:g} {DIMENSIONS[self.dimension].si}"
        if self.unit:
            usual = f"{in_unit(self.value, self.dimension, self.unit):.5g} {self.unit}"
        else:
            usual = format_quantity(self.value, self.dimension)
        return in_si if in_si == usual else f"{in_si} = {usual}"

    @property
    def cure(self) -> str:
        """How to write it in the unit that it probably is in."""
        usual = self.unit or USUAL[self.dimension]
        if self.form in ("formula", "function"):
            return f"multiply it by 1 {usual}"
        return f"write {self.written}: {self.value:g} {usual}".replace("write :", "write")

    @property
    def remedy(self) -> str:
        """How to write it, in either unit."""
        si = DIMENSIONS[self.dimension].si
        meant = f"by 1 {si}" if self.form in ("formula", "function") else f"{self.value:g} {si}"
        return f"{self.cure}, or {meant} if that is meant"


def note_number(reader: Reader, key: Key, data: Any, value: float, path: Place) -> None:
    """Keep a number, a text or a constant formula if it has no unit and is rarely meant in SI.

    Parameters
    ----------
    reader
        Reader with the parameters; it collects the numbers.
    key
        Description of the key.
    data
        Value as written.
    value
        Value in SI units.
    path
        Path of the key.
    """
    if is_doubtful(value, key.dimension):
        _note(reader, key, data, Bare(path, value, key.dimension))


def note_signal(reader: Reader, key: Key, data: Any, value: float, path: Place) -> None:
    """Keep the value of a signal if it has no unit; that of the signal is not yet known.

    Parameters
    ----------
    reader, key, data, value, path
        As in `note_number`.
    """
    if value != 0.0 and path[:1] in (("blocks",), ("controllers",), ("scenarios",)):
        _note(reader, key, data, Bare(path, value, SIGNAL))


def _note(reader: Reader, key: Key, data: Any, found: Bare) -> None:
    """Keep a number if it has no unit as written."""
    if isinstance(data, str):
        name = data.strip()
        if name in reader.parameters:
            if not reader.parameters[name].unit:
                reader.bare.append(found._replace(written=name, form="parameter"))
            return
        if is_formula(data, reader.parameters):
            if is_without_unit(reader, key, data):
                reader.bare.append(found._replace(written=name, form="formula"))
            return
    if is_without_unit(reader, key, data):
        reader.bare.append(found)


def note_formula(reader: Reader, key: Key, text: str, variables: tuple[str, ...], path: Place) -> None:
    """Keep a formula of variables that has no unit, if its values in the first second are doubtful.

    Parameters
    ----------
    reader, key, path
        As in `note_number`.
    text
        Formula as written.
    variables
        Names of the variables.
    """
    if key.dimension not in USUAL:
        return
    import numpy as np

    from pitchpoint.core.formula.formula import Formula, parsed

    parser = parsed(text, variables, key.dimension, reader.parameters)
    if not is_bare(parser.kind):
        return
    values = Formula.parse(parser.expanded(), variables)(*[np.linspace(0.0, 1.0, 101)] * len(variables))
    finite = np.abs(values[np.isfinite(values)])
    if finite.size and is_doubtful(float(finite.max()), key.dimension):
        reader.bare.append(Bare(path, float(finite.max()), key.dimension, text.strip(), "function"))


def is_bare(kind: Kind) -> bool:
    """Whether no number of a formula has a unit; pi makes radians of its numbers."""
    return kind.bare and not kind.written and not kind.turned


def said_of(reader: Reader, path: Place) -> str:
    """Remedy for a value that is refused because a number has no unit; empty if all numbers are plausible.

    Parameters
    ----------
    reader
        Reader with the numbers without unit.
    path
        Path of the value, or of a list.
    """
    for bare in reader.bare:
        if (
            bare.dimension != SIGNAL
            and bare.place[: len(path)] == path
            and all(isinstance(step, int) for step in bare.place[len(path) :])
        ):
            return f"{bare.text}; {bare.cure}"
    return ""


def is_without_unit(reader: Reader, key: Key, data: Any) -> bool:
    """Whether a value has no unit: a number, also as text, or a formula.

    Parameters
    ----------
    reader
        Reader with the parameters.
    key
        Description of the key.
    data
        Value as written.
    """
    if not isinstance(data, str):
        return True
    if is_formula(data, reader.parameters):
        from pitchpoint.core.formula.formula import parsed

        return is_bare(parsed(data, (), key.dimension, reader.parameters).kind)
    try:
        return natural_quantity(data)[1] == ""
    except UnitError:
        return False


def messages_on(numbers: Iterable[Bare], line: Any = None) -> tuple[Message, ...]:
    """A remark for every number without unit; the numbers of a list have one.

    Parameters
    ----------
    numbers
        The numbers.
    line
        Function of the line of a path in the file; None without a file.
    """
    from pitchpoint.model.show import dotted

    lists: dict[tuple[Any, ...], list[Bare]] = {}
    for bare in numbers:
        lists.setdefault((bare.dimension, *(s for s in bare.place if not isinstance(s, int))), []).append(
            bare
        )
    found = []
    for first, *rest in lists.values():
        also = f", like {len(rest)} more of its values" if rest else ""
        at = line(first.place) if line is not None and first.in_file else None
        found.append(remark(dotted(first.place), f"{first.text}{also}", first.remedy, at))
    return tuple(found)


def message_on_option(text: str, dimension: str, option: str) -> Message | None:
    """The remark on the quantity of an option; None if it has a unit or is plausible in SI.

    Parameters
    ----------
    text
        Quantity as written.
    dimension
        Dimension of the option.
    option
        Name of the option.

    Examples
    --------
    >>> print(message_on_option("3", "length", "--centre-distance"))
    --centre-distance: 3 has no unit and is read as 3 m = 3000 mm; write 3 mm, or 3 m if that is meant
    """
    try:
        value, unit = natural_quantity(text)
    except UnitError:
        return None
    if unit or not is_doubtful(value, dimension):
        return None
    return messages_on([Bare((option,), value, dimension)])[0]
