# SPDX-License-Identifier: Apache-2.0
"""Differences between two gear units: parts added, removed, moved, and values changed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from pitchpoint.io.rexs.comparison.equality import (
    ROUNDING,
    equal,
    factor_of,
    is_reference,
    numbers_in,
    shape_of,
)
from pitchpoint.io.rexs.comparison.load_cases import paired_cases
from pitchpoint.io.rexs.comparison.matching import match
from pitchpoint.io.rexs.comparison.structure import moves
from pitchpoint.io.rexs.comparison.wording import in_words, words
from pitchpoint.io.rexs.conversion.state import shown
from pitchpoint.io.rexs.document import RexsAttribute, RexsModel, Value

ADDED, REMOVED, MOVED, CHANGED = "added", "removed", "moved", "changed"
"""Kinds of differences: part or load case only in the second file, only in the first one; another place in
the structure; another value."""
NOTHING = "–"
SHORT = 4
"""Length up to which arrays are shown as a whole."""


@dataclass(frozen=True)
class Difference:
    """One difference between two gear units.

    Attributes
    ----------
    kind
        "added", "removed", "moved" or "changed".
    part
        Part in words, as in the first file; added parts as in the second file.
    id_a, id_b
        Ids of the component in the files.
    what
        Attribute or role in words; empty for a whole part.
    a, b
        Values in words in the unit of the first file.
    difference
        Second minus first value; of arrays the number of different entries and the largest difference.
    load_case
        Load case of the first file, or of the second one if it is only there; "total" for values accumulated
        over a load spectrum; empty for the parts.
    attribute
        Id of the attribute in the newest version of REXS.
    si_a, si_b
        Values in SI units and radians.
    """

    kind: str
    part: str
    id_a: int | None = None
    id_b: int | None = None
    what: str = ""
    a: str = ""
    b: str = ""
    difference: str = ""
    load_case: str = ""
    attribute: str = ""
    si_a: Value | None = None
    si_b: Value | None = None

    def __str__(self) -> str:
        """The difference as a sentence."""
        case = f"load case {self.load_case}, " if self.load_case and self.part else ""
        if not self.what:
            return f"{case}{self.part or 'load case ' + self.load_case}: {self.kind}"
        by = f" ({self.difference})" if self.difference else ""
        return f"{case}{self.part}: {self.what} {self.a} -> {self.b}{by}"


def differences(a: RexsModel, b: RexsModel, tolerance: float = ROUNDING) -> list[Difference]:
    """Differences between two gear units, in the order of the first file.

    Components are paired by what they are and by their place in the gear unit: other ids, names, units,
    formats, versions and another order do not count.

    Parameters
    ----------
    a, b
        The gear units.
    tolerance
        Relative difference up to which numbers are equal.
    """
    pairs = match(a, b)
    found = [
        Difference(REMOVED, in_words(a, i), i, what="", a=str(c))
        for i, c in a.components.items()
        if i not in pairs
    ]
    back = {j: i for i, j in pairs.items()}
    found += [
        Difference(ADDED, in_words(b, j), None, j, b=str(c)) for j, c in b.components.items() if j not in back
    ]
    for i, role, one, two in moves(a, b, pairs):
        found.append(Difference(MOVED, in_words(a, i), i, pairs[i], words(role), one, two))
    compared = _Comparison(a, b, pairs, tolerance)
    for i, j in pairs.items():
        found += compared.values(i, a.components[i].attributes, b.components[j].attributes, "")
    return found + list(_of_loads(compared))


def _of_loads(compared: _Comparison) -> Iterator[Difference]:
    """Differences of the load cases and of the values accumulated over them."""
    pairs = compared.pairs
    for case, a, b in paired_cases(compared.a, compared.b, pairs):
        if a is None or b is None:
            yield Difference(ADDED if a is None else REMOVED, "", load_case=case)
            continue
        for i in a:
            if i in pairs:
                yield from compared.values(i, a[i], b.get(pairs[i], {}), case)
        for i, j in pairs.items():
            if i not in a and j in b:
                yield from compared.values(i, {}, b[j], case)


class _Comparison:
    """Comparison of the values of two components."""

    def __init__(self, a: RexsModel, b: RexsModel, pairs: Mapping[int, int], tolerance: float) -> None:
        self.a, self.b, self.pairs, self.tolerance = a, b, pairs, tolerance

    def values(
        self, i: int, a: Mapping[str, RexsAttribute], b: Mapping[str, RexsAttribute], case: str
    ) -> Iterator[Difference]:
        """Different values of a component, given by its id in the first file."""
        for name in dict.fromkeys([*a, *b]):
            one, two = a.get(name), b.get(name)
            if one is not None and two is not None and equal(one, two, self.pairs, self.tolerance):
                continue
            yield Difference(
                CHANGED,
                in_words(self.a, i),
                i,
                self.pairs[i],
                words(name),
                self.text(one, one, self.a),
                self.text(two, one, self.b),
                _change(one, two),
                case,
                name,
                None if one is None else one.value,
                None if two is None else two.value,
            )

    def text(self, value: RexsAttribute | None, like: RexsAttribute | None, model: RexsModel) -> str:
        """Value in the unit of the first file; a dash for a missing one."""
        if value is None:
            return NOTHING
        if is_reference(value) and value.value in model.components:
            return str(model.components[value.value])  # type: ignore[index]
        if len(shape_of(value.value)) == 1 and len(value.value) > SHORT:  # type: ignore[arg-type]
            return f"{len(value.value)} numbers"  # type: ignore[arg-type]
        if len(shape_of(value.value)) > 1:
            return f"matrix {' x '.join(map(str, shape_of(value.value)))}"
        return shown(value if like is None else replace(value, unit=like.unit))


def _change(a: RexsAttribute | None, b: RexsAttribute | None) -> str:
    """Second minus first value in the unit of the first file."""
    if a is None or b is None or is_reference(a) or shape_of(a.value) != shape_of(b.value):
        return ""
    one, two = numbers_in(a.value), numbers_in(b.value)
    if one is None or two is None:
        return ""
    unit = {"none": "", "C": "K"}.get(a.unit, a.unit) if a.number is not None else ""
    steps = [(y - x) / factor_of(a) for x, y in zip(one, two, strict=True)]
    if not isinstance(a.value, tuple):
        return f"{steps[0]:+.6g} {unit}".strip()
    largest = max(steps, key=abs)
    count = sum(step != 0.0 for step in steps)
    return f"{count} of {len(steps)}, largest {largest:+.6g} {unit}".strip()
