# SPDX-License-Identifier: Apache-2.0
"""Conversion of a model to plain data with the keys and units of model files; the inverse of `read`."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pitchpoint.core.discon.installed import package_of
from pitchpoint.core.unit_table import DIMENSIONS
from pitchpoint.core.units import display_unit, in_unit, parse_quantity
from pitchpoint.model.component import HOOKS, Unread, as_written
from pitchpoint.model.components.joint import DISPLACEMENTS, RATES
from pitchpoint.model.components.law import AXES, Balance, Constant, FormulaLaw, PythonLaw, TableLaw
from pitchpoint.model.components.modifications import FlankPitch
from pitchpoint.model.components.ratio import Arm
from pitchpoint.model.keys import TYPE, Key, Place, defaults_of, keys_of
from pitchpoint.model.origin import KEPT, Source
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.stand_ins import own_parts

if TYPE_CHECKING:
    from pitchpoint.model.components.law import Law
    from pitchpoint.model.components.tooth_profile import Points
    from pitchpoint.model.model import Model


ONE_LINE = 100
"""Length of the mappings that are written in one line."""


def quantity_text(value: float, dimension: str) -> float | str:
    """Shortest text that reads back to exactly this SI value, in the customary unit if possible.

    Examples
    --------
    >>> quantity_text(0.15966, "length"), quantity_text(0.145, "dimensionless")
    ('159.66 mm', 0.145)
    """
    if DIMENSIONS[dimension].si == "":
        return value
    unit = display_unit(dimension, value)
    shown = in_unit(value, dimension, unit)
    for digits in (6, 10, 15, 17):
        text = f"{shown:.{digits}g} {unit}"
        if parse_quantity(text, dimension) == value:
            return text
    return f"{value!r} {DIMENSIONS[dimension].si}"


def plain(model: Model, *, as_written: bool = True) -> dict[str, Any]:
    """Nested dictionaries as in a model file; values equal to their defaults are omitted.

    Parameters
    ----------
    model
        The model. Paths of Python files become relative to the model file.
    as_written
        Texts and formulas of the file; else all quantities as numbers with customary units.
    """
    base = Path(model.file).parent if model.file else Path()
    writer = _Writer(base)
    writer.sources = model.origin.sources if as_written else {}
    writer.reader = Reader(parameters=model.amounts)
    out: dict[str, Any] = writer.component(model)
    return out


def plain_component(part: Any) -> dict[str, Any]:
    """Keys and values of one component that differ from their defaults; file names remain absolute."""
    return _Writer(Path()).component(part)


def plain_law(law: Law) -> Any:
    """A law with numbers in SI units."""
    return _Writer(Path()).law(Key("law", "", dimension="dimensionless"), law)


def model_text(model: Model) -> str:
    """The model as JSON, which is valid YAML and reads back to an equal model; faster than a YAML writer."""
    return json.dumps(plain(model), ensure_ascii=False)


def yaml_text(model: Model) -> str:
    """YAML text of a model that reads back to an equal model.

    Texts and formulas are as in the file, or in the arguments, of the model; other quantities have customary
    units if the conversion is exact, else SI units.
    """
    from io import StringIO

    from ruamel.yaml import YAML

    yaml = YAML(typ="rt", pure=True)
    yaml.default_flow_style = False
    yaml.width = 110
    stream = StringIO()
    yaml.dump({name: _styled(value, section=True) for name, value in plain(model).items()}, stream)
    return re.sub(r" +\n", "\n", stream.getvalue())


def _styled(data: Any, section: bool = False) -> Any:
    """Plain data for the YAML writer: lists of values and short mappings in one line, sections in several."""
    from ruamel.yaml.comments import CommentedMap, CommentedSeq

    if isinstance(data, dict):
        mapping = CommentedMap((name, _styled(value)) for name, value in data.items())
        if not section and len(str(data)) <= ONE_LINE:
            mapping.fa.set_flow_style()
        return mapping
    if isinstance(data, list):
        sequence = CommentedSeq(map(_styled, data))
        if len(str(data)) <= ONE_LINE or not any(isinstance(entry, dict | list) for entry in data):
            sequence.fa.set_flow_style()
        return sequence
    return data


class _Writer:
    def __init__(self, base: Path) -> None:
        self.base = base
        self.within: Any = None
        """Component being written."""
        self.sources: Mapping[Place, Source] = {}
        """Values with parameters, as written."""
        self.reader: Reader | None = None
        """Reader of the values as written."""
        self.at: Place = ()
        """Path of the component being written."""

    def component(self, part: Any) -> dict[str, Any]:
        """Keys and values that differ from the defaults."""
        defaults = defaults_of(type(part))
        out: dict[str, Any] = {}
        at = self.at
        for name, key in keys_of(type(part)).items():
            self.within, self.at = part, (*at, name)
            value = getattr(part, name)
            if key.kind == "components" and isinstance(value, Mapping):
                value = own_parts(value)  # without those that represent shafts and planets
            # the stiffness law is always written: its default should not need looking up
            if value is None or (key.kind != "variant" and name in defaults and _same(value, defaults[name])):
                continue
            source = self.sources.get(self.at)
            known = source is not None and self.still_holds(key, value, source)
            out[name] = source.data if known and source is not None else self.value(key, value)
        self.at = at
        return out

    def still_holds(self, key: Key, value: Any, source: Source) -> bool:
        """Whether a value as written is still that of the model, which may have been copied with another."""
        if self.reader is None or key.kind not in KEPT:
            return True
        return bool(self.reader.value(key, source.data, self.at) == value)

    def value(self, key: Key, value: Any) -> Any:
        """Value of a key, by the kind of the key."""
        if isinstance(value, Unread):
            return as_written(value.data)
        writer = _WRITERS.get(key.kind)
        return value if writer is None else writer(self, key, value)

    def quantity(self, key: Key, value: float) -> Any:
        """A number with its unit."""
        return quantity_text(value, key.dimension)

    def quantities(self, key: Key, value: Any) -> list[Any]:
        """List of numbers with units; zeros without."""
        return [0 if str(v) == "0.0" else quantity_text(v, key.dimension) for v in value]

    def grid(self, key: Key, value: Any) -> list[list[Any]]:
        """Rows of numbers with units."""
        return [self.quantities(key, row) for row in value]

    def points(self, key: Key, value: Points) -> list[list[Any]]:
        """Points as pairs of lengths."""
        return self.grid(key, value.xy)

    def pitch(self, key: Key, value: Any) -> Any:
        """Pitch deviations: by flank, or one list for both flanks."""
        return self.component(value) if isinstance(value, FlankPitch) else self.quantities(key, value)

    def matrix(self, key: Key, value: Any) -> list[list[float]]:
        """Rows of plain numbers."""
        return [list(row) for row in value]

    def matrices(self, key: Key, value: Any) -> list[list[list[float]]]:
        """Matrices as rows of plain numbers."""
        return [self.matrix(key, rows) for rows in value]

    def strings(self, key: Key, value: Any) -> list[str]:
        """A list of names."""
        return list(value)

    def plain_list(self, key: Key, value: Any) -> list[float]:
        """A list of plain numbers."""
        return list(value)

    def nested(self, key: Key, value: Any) -> dict[str, Any]:
        """Nested component."""
        return self.component(value)

    def nested_list(self, key: Key, value: Any) -> list[dict[str, Any]]:
        """List of components."""
        return [self.component(v) for v in value]

    def nested_names(self, key: Key, value: Mapping[str, Any]) -> dict[str, Any]:
        """Components by name, with their type if there are several."""
        at, out = self.at, {}
        for name, v in value.items():
            self.at = (*at, name)
            out[name] = {**({TYPE: v.form} if isinstance(key.of, dict) else {}), **self.component(v)}
        self.at = at
        return out

    def parameters(self, key: Key, value: Mapping[str, Any]) -> dict[str, Any]:
        """Parameters by name: their value, and the description if there is one."""
        return {name: self.component(p) if p.text else p.value for name, p in value.items()}

    def variant(self, key: Key, value: Any) -> dict[str, Any]:
        """Component that is identified by its law or level."""
        return {key.tag: getattr(value, key.tag), **self.component(value)}

    def speeds(self, key: Key, value: Mapping[str, float]) -> dict[str, Any]:
        """Quantities by name."""
        return {name: quantity_text(v, key.dimension) for name, v in value.items()}

    def gears(self, key: Key, value: Mapping[str, float]) -> Any:
        """Gears of a body: their names, with positions unless all are zero."""
        if not any(value.values()):
            return list(value)
        return {name: quantity_text(v, "length") for name, v in value.items()}

    def orders(self, key: Key, value: Any) -> dict[int, list[Any]]:
        """Amplitudes and phases by order."""
        return {n: [quantity_text(a, "length"), quantity_text(p, "angle")] for n, a, p in value}

    def law(self, key: Key, value: Any) -> Any:
        """A number, formula, table or Python law."""
        if isinstance(value, Constant):
            return quantity_text(value.value, key.dimension)
        if isinstance(value, FormulaLaw):
            return value.text
        if isinstance(value, TableLaw):
            own = dict(getattr(self.within, "coordinates", {}))
            abscissa = {**AXES, **own}[value.over]
            rows = [
                [quantity_text(x, abscissa), quantity_text(y, key.dimension)]
                for x, y in zip(value.abscissa, value.values, strict=True)
            ]
            return {"table": rows, "over": value.over}
        return "balance" if isinstance(value, Balance) else self.python(key, value)

    def laws(self, key: Key, value: Any) -> list[Any]:
        """List of laws."""
        return [self.law(key, v) for v in value]

    def file(self, key: Key, value: str) -> str:
        """Path relative to the model file."""
        return self.relative(value)

    def library(self, key: Key, value: str) -> str:
        """Name of the package of an installed library, else its path relative to the model file."""
        return package_of(value) or self.relative(value)

    def relative(self, name: str) -> str:
        """Path relative to the directory of the model file."""
        file = Path(name)
        return (file.relative_to(self.base) if file.is_relative_to(self.base) else file).as_posix()

    def center(self, key: Key, value: Any) -> Any:
        """Centre of mass: axial position, or three coordinates."""
        return self.quantities(key, value) if isinstance(value, tuple) else self.quantity(key, value)

    def displacements(self, key: Key, value: Mapping[str, float]) -> dict[str, Any]:
        """Displacements by coordinate, each with its own unit."""
        return {name: quantity_text(v, self.within.dimension(name)) for name, v in value.items()}

    def rates(self, key: Key, value: Mapping[str, float]) -> dict[str, Any]:
        """Rates by coordinate, each with its own unit."""
        return {name: quantity_text(v, RATES[self.within.dimension(name)]) for name, v in value.items()}

    def mapping(self, key: Key, value: Mapping[str, Any]) -> dict[str, Any]:
        """Names and values, unchanged."""
        return dict(value)

    def motions(self, key: Key, value: Mapping[str, Any]) -> dict[str, Any]:
        """Laws by coordinate; a list if a coordinate has several."""
        out = {}
        for name, laws in value.items():
            found = [self.law(Key("law", "", dimension=DISPLACEMENTS[name]), law) for law in laws]
            out[name] = found if len(found) > 1 else found[0]
        return out

    def terms(self, key: Key, value: Mapping[str, float]) -> dict[str, Any]:
        """Coefficients by name; lengths with their unit."""
        return {n: quantity_text(float(v), "length") if isinstance(v, Arm) else v for n, v in value.items()}

    def python(self, key: Key, value: PythonLaw) -> Any:
        """File and function, and the parameters if there are any."""
        name = f"{self.relative(value.file)}:{value.function}"
        if key.kind in ("python", "code") and not value.parameters:
            return name
        return {"python": name, **({"parameters": list(value.parameters)} if value.parameters else {})}

    def material(self, key: Key, value: Any) -> Any:
        """Name of a material, or its numbers."""
        if isinstance(value, str):
            return value
        return {
            "youngs_modulus": quantity_text(value.youngs_modulus, "pressure"),
            "poisson_ratio": value.poisson_ratio,
            "density": quantity_text(value.density, "density"),
        }


def _same(value: Any, default: Any) -> bool:
    """Equal and of the same type, so that a law equal in all numbers to another one is still written."""
    return type(value) is type(default) and bool(value == default) or (not value and default == {} == value)


_WRITERS: dict[str, Callable[[_Writer, Key, Any], Any]] = {
    "quantity": _Writer.quantity,
    "quantities": _Writer.quantities,
    "names": _Writer.strings,
    "words": _Writer.strings,
    "component": _Writer.nested,
    "components": _Writer.nested_names,
    "list": _Writer.nested_list,
    "variant": _Writer.variant,
    "gears": _Writer.gears,
    "speeds": _Writer.speeds,
    "grid": _Writer.grid,
    "pitch": _Writer.pitch,
    "points": _Writer.points,
    "tooth_profile": _Writer.nested,
    "matrix": _Writer.matrix,
    "matrices": _Writer.matrices,
    "orders": _Writer.orders,
    "law": _Writer.law,
    "laws": _Writer.laws,
    "python": _Writer.python,
    "code": _Writer.python,
    "values": _Writer.plain_list,
    "gains": _Writer.mapping,
    "wires": _Writer.mapping,
    "curve": _Writer.matrix,
    "material": _Writer.material,
    "center": _Writer.center,
    "ends": _Writer.strings,
    "file": _Writer.file,
    "library": _Writer.library,
    "records": _Writer.mapping,
    "record_signals": _Writer.mapping,
    "coordinates": _Writer.mapping,
    "displacements": _Writer.displacements,
    "rates": _Writer.rates,
    "motions": _Writer.motions,
    "parameters": _Writer.parameters,
    "terms": _Writer.terms,
}

HOOKS["component"], HOOKS["law"] = plain_component, plain_law
