# SPDX-License-Identifier: Apache-2.0
"""State of a conversion: data of the model file, names, and the list of what was taken, changed, ignored."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.errors import Message
from pitchpoint.core.units import display_unit, in_unit, parse_quantity
from pitchpoint.io.rexs.conversion.frames import Frame
from pitchpoint.io.rexs.document import RexsAttribute, RexsComponent, RexsModel, Value
from pitchpoint.io.rexs.units import RexsUnit, unit_of
from pitchpoint.model.write import quantity_text

if TYPE_CHECKING:
    from pitchpoint.io.rexs.conversion.profile_amounts import ProfileAmount

TAKEN, DEFAULT, CHANGED, IGNORED = "taken", "default", "changed", "ignored"
"""Kinds of entries: value of the file; default for a missing one; value of the file that was replaced or
simplified; value of the file without effect in the model."""
LONGEST_NAME = 48


@dataclass(frozen=True)
class Item:
    """One entry of the list of an import.

    Attributes
    ----------
    kind
        "taken", "default", "changed" or "ignored".
    component
        Component, as in "shaft 12 (Shaft [6])", or a type with its number of components.
    attribute
        Id of the attribute, or a word for several.
    value
        Value in the model; empty if there is none.
    target
        Key of the model file; empty if there is none.
    reason
        Reason of a default, change or omission.
    """

    kind: str
    component: str
    attribute: str
    value: str = ""
    target: str = ""
    reason: str = ""


@dataclass
class Seat:
    """A shaft of the file in the model: its body, and the place of its start on the axis of the body.

    Attributes
    ----------
    body
        Name of the shaft or body.
    start
        Position of u = 0 on the z axis of the body [m].
    frame
        Frame at u = 0 in the world, with z along the z axis of the body.
    sections
        Start and end along u, outer and inner diameter [m].
    sign
        +1; -1 if u is opposite to the z axis of the body.
    """

    body: str
    start: float
    frame: Frame
    sections: list[tuple[float, float, float, float]] = field(default_factory=list)
    sign: float = 1.0

    def place(self, u: float) -> float:
        """Position on the axis of the body of a coordinate u on the shaft [m]."""
        return self.start + self.sign * u

    def point(self, u: float) -> np.ndarray:
        """Point of a coordinate u in the world [m]."""
        return self.frame.at(self.sign * u)

    def coordinate(self, point: np.ndarray) -> float:
        """Coordinate u of a point in the world [m]."""
        return self.sign * float((point - self.frame.origin) @ self.frame.z)

    def bore_at(self, u: float) -> float:
        """Inner diameter at a coordinate u [m]; 0 outside the shaft."""
        return next((inner for a, b, _, inner in self.sections if a <= u <= b), 0.0)


@dataclass
class Meshing:
    """Two gears in mesh whose profile shifts may follow from the centre distance.

    Attributes
    ----------
    stage, gears
        Stage and gears of the file.
    entries
        Data of the gears for the model file.
    distance
        Centre distance [m].
    """

    stage: RexsComponent
    gears: list[RexsComponent]
    entries: list[dict[str, Any]]
    distance: float


class Conversion:
    """What the converters of the parts share.

    Parameters
    ----------
    source
        The REXS model, with the values of the load case.
    """

    def __init__(self, source: RexsModel) -> None:
        self.source = source
        self.data: dict[str, Any] = {}
        self.items: list[Item] = []
        self._listed: set[Item] = set()
        self.problems: list[Message] = []
        self.used: set[tuple[int, str]] = set()
        self.done: set[int] = set()
        """Components that are in the model, or in the list."""
        self.names: dict[int, str] = {}
        self.given: set[tuple[str, str]] = set()
        self.frames: dict[int, Frame] = {}
        self.held: list[str] = []
        self.seats: dict[int, Seat] = {}
        self.meshings: list[Meshing] = []
        self.own = source.application.startswith("pitchpoint")
        """Whether pitchpoint wrote the file: names, directions and zeros are then those of a model."""
        self.profile_amounts: list[ProfileAmount] = []
        self.directions: list[np.ndarray] = [np.array([0.0, 0.0, 1.0])]
        self.origins: dict[tuple[str, str], RexsComponent] = {}
        """Component of each entry of the model file."""

    # --- entries of the model file --------------------------------------------------------------------------
    def put(self, section: str, component: RexsComponent, values: dict[str, Any], name: str = "") -> str:
        """Add an entry to a section, under the name of the component; its name is returned."""
        name = name or self.name(component)
        self.data.setdefault(section, {})[name] = values
        self.origins[section, name] = component
        self.done.add(component.id)
        return name

    def name(self, component: RexsComponent) -> str:
        """Name of a component in the model file: its own, without characters that names must not have."""
        if component.id not in self.names:
            text = component.name or f"{component.type} {component.id}"
            name = text if self.own and re.fullmatch(r"[A-Za-z][\w-]*", text) else plain_name(text)
            self.names[component.id] = self.free(name, component.id, component.type if self.own else "")
        return self.names[component.id]

    def free(self, name: str, number: int | None = None, group: str = "") -> str:
        """A name that no other component has; in files of pitchpoint none of the same type."""
        found, k = name, number if number is not None else 2
        while (group, found) in self.given:
            found, k = f"{name}_{k}", k + 1
        self.given.add((group, found))
        return found

    def aligned(self, frame: Frame) -> tuple[Frame, float]:
        """Frame with z along that of the other parallel parts, and -1 if it had to be turned.

        Gears of a model mesh on shafts with equal directions of z.
        """
        for direction in () if self.own else self.directions:
            if abs(abs(float(frame.z @ direction)) - 1.0) < 1e-9:
                found = frame.along(direction)
                return found, 1.0 if found is frame else -1.0
        self.directions.append(frame.z)
        return frame, 1.0

    # --- values ---------------------------------------------------------------------------------------------
    def value(self, component: RexsComponent, attribute: str, target: str = "") -> Value | None:
        """Value of an attribute, which is listed as taken; None if it is not given."""
        found = component.attributes.get(attribute)
        if found is None:
            return None
        if (component.id, attribute) not in self.used:
            self.used.add((component.id, attribute))
            self.items.append(Item(TAKEN, str(component), attribute, shown(found), target))
        return found.value

    def number(self, component: RexsComponent, attribute: str, target: str = "") -> float | None:
        """Number of an attribute."""
        found = self.value(component, attribute, target)
        return float(found) if isinstance(found, int | float) and not isinstance(found, bool) else None

    def need(self, component: RexsComponent, attribute: str, unit: str, target: str = "") -> float | None:
        """Number of an attribute that must be given: a problem if it is missing."""
        found = self.number(component, attribute, target)
        if found is None:
            self.problem(component, "is missing", attribute, remedy=f"give {attribute} ({unit})")
        return found

    def flag(self, component: RexsComponent, attribute: str) -> bool | None:
        """Truth value of an attribute."""
        found = self.value(component, attribute)
        return found if isinstance(found, bool) else None

    def word(self, component: RexsComponent, attribute: str, target: str = "") -> str | None:
        """Word of an attribute."""
        found = self.value(component, attribute, target)
        return found if isinstance(found, str) else None

    # --- list and problems ----------------------------------------------------------------------------------
    def default(
        self, component: RexsComponent | str, attribute: str, value: str, target: str, reason: str = ""
    ) -> None:
        """List a default for a missing value."""
        self._add(Item(DEFAULT, str(component), attribute, value, target, reason))

    def changed(
        self, component: RexsComponent | str, attribute: str, value: str, target: str, reason: str
    ) -> None:
        """List a value that was replaced or simplified."""
        self._add(Item(CHANGED, str(component), attribute, value, target, reason))

    def ignored(
        self, component: RexsComponent | str, attribute: str, reason: str, *, values: bool = False
    ) -> None:
        """List a component or value without effect in the model; `values`: each with its value."""
        names = [attribute]
        if isinstance(component, RexsComponent):
            self.done.add(component.id)
            found = component.attributes
            self.used |= {(component.id, name) for name in found if attribute in (name, "all")}
            names = list(found) if values and attribute == "all" and found else names
        for name in names:
            known = component.attributes.get(name) if isinstance(component, RexsComponent) else None
            text = "" if known is None else shown(known)
            self._add(Item(IGNORED, str(component), name, text, reason=reason))

    def _add(self, item: Item) -> None:
        """Add an entry once."""
        if item not in self._listed:
            self._listed.add(item)
            self.items.append(item)

    def problem(
        self,
        component: RexsComponent,
        text: str,
        attribute: str = "",
        value: str | None = None,
        limit: str | None = None,
        remedy: str | None = None,
    ) -> None:
        """Add a problem at a component or at one of its attributes."""
        found = component.attributes.get(attribute)
        place = found.where if found is not None else f"{component.where}, {component}"
        if found is None and attribute:
            place += f", {attribute}"
        if component.file:
            place = f"{component.file}: {place}"
        problem = Message(place, text, value, limit, remedy)
        if problem not in self.problems:
            self.problems.append(problem)
        self.done.add(component.id)

    # --- places ---------------------------------------------------------------------------------------------
    def parts(self, component: RexsComponent, *types: str) -> list[RexsComponent]:
        """Parts of an assembly, in their order if it has one."""
        relations = [
            *self.source.related("assembly", assembly=component.id),
            *sorted(
                self.source.related("ordered_assembly", assembly=component.id), key=lambda r: r.order or 0
            ),
        ]
        ids = dict.fromkeys(r.roles["part"] for r in relations if "part" in r.roles)
        found = [self.source.components[i] for i in ids]
        return [c for c in found if not types or c.type in types]

    def owner(self, component: RexsComponent, *types: str) -> RexsComponent | None:
        """Assembly of one of these types that a component is part of."""
        for relation in self.source.related("assembly", part=component.id):
            found = self.source.components.get(relation.roles.get("assembly", -1))
            if found is not None and found.type in types:
                return found
        return None

    def referenced(self, component: RexsComponent, *types: str) -> list[RexsComponent]:
        """Components that a component refers to, such as its material."""
        found = []
        for kind in ("reference", "ordered_reference"):
            for relation in self.source.related(kind, origin=component.id):
                other = self.source.components.get(relation.roles.get("referenced", -1))
                if other is not None and other.type in types:
                    found.append(other)
        return found


def plain_name(text: str) -> str:
    """Name for a model file: lower case, with underscores, in ASCII.

    Examples
    --------
    >>> plain_name("Planetenträger [3] @ 0,0°"), plain_name("Cylindrical gear [27]")
    ('planetentraeger_3_0_0', 'cylindrical_gear_27')
    >>> plain_name("33014")
    'part_33014'
    """
    text = text.lower().translate(_GERMAN)
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    words, name = re.findall(r"[a-z0-9]+", plain), ""
    for word in words:
        if name and len(name) + len(word) >= LONGEST_NAME:
            break
        name = f"{name}_{word}".strip("_")[:LONGEST_NAME]
    return name if re.search("[a-z]", name) else f"part_{name}".strip("_")


_GERMAN = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss"})


ROUNDING = 1e-14
"""Relative rounding of sums and differences of values of the file."""


def q(value: float, dimension: str) -> Any:
    """Quantity for the model file, without the rounding of sums and differences.

    Examples
    --------
    >>> q(0.12 - 0.11, "length"), q(0.36651914291880922, "angle"), q(2.0, "dimensionless")
    ('10 mm', '21 deg', 2.0)
    """
    exact = quantity_text(float(value), dimension)
    if not isinstance(exact, str):
        return exact
    unit = display_unit(dimension, value)
    short = f"{in_unit(value, dimension, unit):.12g} {unit}"
    return short if abs(parse_quantity(short, dimension) - value) <= ROUNDING * abs(value) else exact


def vector(values: Any, dimension: str = "length") -> list[Any]:
    """Vector for the model file; rounding errors of rotations are removed."""
    found = np.asarray(values, float)
    found = np.where(np.abs(found) < 1e-12 * max(1.0, np.abs(found).max()), 0.0, found)
    return [0 if v == 0.0 else q(v, dimension) for v in found]


def shown(attribute: RexsAttribute) -> str:
    """Short text of a value in the unit of the file.

    Examples
    --------
    >>> shown(RexsAttribute("face_width", 808, 0.05, unit="mm")), shown(RexsAttribute("kind", 9214, "oil"))
    ('50 mm', 'oil')
    """
    unit = unit_of(attribute.unit) if attribute.number is not None else unit_of("none")
    text = _text(attribute.value, unit)
    return text if unit.si == "1" and attribute.unit != "%" else f"{text} {attribute.unit}"


def _text(value: Value, unit: RexsUnit) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{unit.from_si(value):.8g}"
    if isinstance(value, tuple):
        inner = ", ".join(_text(v, unit) for v in value[:3])
        return f"[{inner}{', ...' if len(value) > 3 else ''}]"
    return str(value)


def counted(names: list[str]) -> str:
    """Names with their numbers, as in "material (3), lubricant".

    >>> counted(["material", "lubricant", "material"])
    'material (2), lubricant'
    """
    return ", ".join(name if n == 1 else f"{name} ({n})" for name, n in Counter(names).items())
