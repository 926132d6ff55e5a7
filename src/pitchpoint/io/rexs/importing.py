# SPDX-License-Identifier: Apache-2.0
"""Import of a REXS file as a model: `import_rexs`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.rexs.conversion.bearings import ROLLING, convert_bearing
from pitchpoint.io.rexs.conversion.bevels import convert_bevel_stage
from pitchpoint.io.rexs.conversion.casing import convert_casing
from pitchpoint.io.rexs.conversion.couplings import COUPLINGS, convert_coupling, convert_held_shaft
from pitchpoint.io.rexs.conversion.loads import (
    convert_gravity,
    convert_loads,
    convert_speeds,
    time_response,
    with_load_case,
)
from pitchpoint.io.rexs.conversion.masses import convert_mass
from pitchpoint.io.rexs.conversion.meshes import convert_stage
from pitchpoint.io.rexs.conversion.operating import active_loads, convert_load_cases, convert_lubricant
from pitchpoint.io.rexs.conversion.planetary import convert_carriers, convert_planetary_stage
from pitchpoint.io.rexs.conversion.profile_amounts import settle_profile_amounts
from pitchpoint.io.rexs.conversion.profile_shifts import settle_shifts
from pitchpoint.io.rexs.conversion.shafts import convert_shaft
from pitchpoint.io.rexs.conversion.state import CHANGED, DEFAULT, IGNORED, TAKEN, Conversion, Item, shown
from pitchpoint.io.rexs.document import RexsComponent, RexsModel
from pitchpoint.io.rexs.housing_file import matrix_text, stored
from pitchpoint.io.rexs.reading import read_rexs
from pitchpoint.model.build import build_model
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader

BY_HAND = "remove it, and write this part of the model by hand: "
REFUSED = {
    "worm_stage": ("a model has no worm stages", "remove it with its gears and shafts"),
    "hydrodynamic_radial_plain_bearing": ("plain bearings are not converted", f"{BY_HAND}plain_bearings"),
    "slide_bearing": ("slide bearings are not converted", f"{BY_HAND}plain_bearings"),
    "general_stage": ("general stages are not converted", f"{BY_HAND}meshes"),
}
"""Components without which a gear unit would be another one: reason and remedy."""
MOST_VALUES = 3
"""Number of different values of an attribute without effect that are listed."""
FRAMEWORK = ("gear_unit", "gear_casing", "planet_carrier")


@dataclass(frozen=True)
class Imported:
    """Result of an import.

    Attributes
    ----------
    model
        The model.
    items
        What was taken, defaults for missing values, what was changed and what was ignored.
    source
        The REXS model.
    load_case
        Number of the load case of the loads; None without load cases.
    files
        Texts of the files that the model needs in its folder, by name: the stiffness matrix of the housing.
    """

    model: Model
    items: tuple[Item, ...]
    source: RexsModel
    load_case: int | None = None
    files: Mapping[str, str] = field(default_factory=dict)

    def save(self, path: str | Path) -> Path:
        """Write the model file, and the files that it needs next to it; its path is returned."""
        target = Path(path)
        for name, text in self.files.items():
            (target.parent / name).write_text(text, encoding="utf-8")
        target.write_text(self.text(), encoding="utf-8")
        return target

    def of(self, kind: str) -> tuple[Item, ...]:
        """Entries of one kind."""
        return tuple(item for item in self.items if item.kind == kind)

    def joined(self, kind: str) -> list[tuple[str, str, str, str]]:
        """Key of the model file, value, attribute and reason of the entries of one kind.

        Entries of several components with the same value are joined: `gears.*` are all gears.
        """
        found: dict[tuple[str, ...], list[str]] = {}
        for item in self.of(kind):
            section, _, rest = item.target.partition(".")
            name, _, key = rest.partition(".")
            same = (section, key, item.value, item.attribute, item.reason)
            if name not in found.setdefault(same, []):
                found[same].append(name)
        rows = []
        for (section, key, value, attribute, reason), names in found.items():
            every = getattr(self.model, section, None) if section else None
            many = len(names) > 1 and isinstance(every, Mapping) and len(names) == len(every)
            listed = "*" if many else ",".join(names)
            rows.append((".".join(filter(None, (section, listed, key))), value, attribute, reason))
        return rows

    def text(self) -> str:
        """The model file as YAML, with the defaults and changes as comments at its beginning."""
        head = [f"imported from {Path(self.source.file).name} (REXS {self.source.version}"]
        head[0] += f", {self.source.application})" if self.source.application else ")"
        for kind, title in ((DEFAULT, "missing in the file, with the default:"), (CHANGED, "changed:")):
            rows = [row for row in self.joined(kind) if row[0]]
            head += [title] if rows else []
            head += [f"  {where}: {value}" + (f" ({why})" if why else "") for where, value, _, why in rows]
        return "".join(f"# {one_line(line)}\n" for line in head) + self.model.to_yaml()


def one_line(text: str) -> str:
    """Text of a file without line breaks and control characters, for comments and tables.

    >>> one_line("a\\nb\\x07")
    'a b '
    """
    return "".join(c if c.isprintable() else " " for c in text)


def import_rexs(path: str | Path, load_case: int | None = None, *, name: str | None = None) -> Imported:
    """Import a REXS file as a model.

    Parameters
    ----------
    path
        XML, JSON or ZIP file of versions 1.0 to 2.0.0.
    load_case
        Number of the load case for loads and speeds; by default the first one.
    name
        Beginning of the names of further files; by default that of the REXS file.

    Returns
    -------
    Imported
        The model, and the list of what was taken, what was missing and what was ignored.

    Raises
    ------
    ModelError
        With all problems: of the file, of parts that a model cannot represent, and of missing data.
    """
    whole = read_rexs(path)
    source, case = with_load_case(whole, load_case)
    number = case.id if case is not None else None
    conversion = Conversion(source)
    matrix = _convert(conversion, whole)
    _list_the_rest(conversion)
    if conversion.problems:
        raise ModelError([*conversion.problems, *_losses(whole)], str(path))
    files, place = {}, None
    if matrix is not None:
        stem = name or Path(path).name.split(".")[0]
        file = conversion.data["housing"]["stiffness_file"] = f"{stem}_housing.csv"
        files[file] = matrix_text(matrix, conversion.data["housing"]["nodes"])
        place = stored(file, files[file]).with_name(f"{stem}.yaml")
    try:
        model = _built(conversion, place)
        if settle_profile_amounts(conversion, model):
            model = _built(conversion, place)
        steady = time_response(conversion, model)
        if steady is not None:
            conversion.data["scenarios"]["steady"] = steady
            model = _built(conversion, place)
    except ModelError as error:
        raise ModelError(
            [*(_at_component(conversion, p) for p in error.problems), *_losses(whole)], str(path)
        ) from None
    return Imported(model, tuple(conversion.items), whole, number, files)


def _built(conversion: Conversion, place: Path | None) -> Model:
    """Model of the data, as if its file were at a place."""
    reader = Reader() if place is None else Reader(directory=str(place.parent))
    return build_model(_ordered(conversion), reader, None if place is None else str(place))


def _losses(source: RexsModel) -> list[Message]:
    """Remarks on lost values, which explain what is missing."""
    return [remark for remark in source.remarks if "has lost" in str(remark)]


def _convert(conversion: Conversion, whole: RexsModel) -> np.ndarray | None:
    """Convert all parts; the order matters, because a seat must exist before what is on it.

    The stiffness matrix of the housing is returned, None if it is rigid.
    """
    source = conversion.source
    for component in source.of_type(*REFUSED):
        reason, remedy = REFUSED[component.type]
        conversion.problem(component, f"cannot be imported: {reason}", remedy=remedy)
    if not source.of_type("shaft"):
        where = source.file
        raise ModelError(
            [Message("", "has no shafts, so it is not a gear unit", remedy="export the whole gear unit")],
            where,
        )
    convert_gravity(conversion)
    carriers = convert_carriers(conversion)
    _each(conversion, ("shaft",), convert_held_shaft)
    _each(conversion, ("shaft",), convert_shaft)
    for stage in source.of_type("planetary_stage"):
        if stage.id in carriers:
            convert_planetary_stage(conversion, stage, carriers[stage.id])
    _each(conversion, ("cylindrical_stage",), convert_stage)
    _each(conversion, ("bevel_stage",), convert_bevel_stage)
    settle_shifts(conversion)
    _each(conversion, ("concept_bearing", *ROLLING), convert_bearing)
    _each(conversion, COUPLINGS, convert_coupling)
    _each(conversion, ("additional_mass",), convert_mass)
    matrix = convert_casing(conversion)
    convert_lubricant(conversion)
    convert_loads(conversion, active_loads(whole))
    convert_speeds(conversion)
    convert_load_cases(conversion, whole)
    return matrix


def _each(
    conversion: Conversion, types: tuple[str, ...], convert: Callable[[Conversion, RexsComponent], None]
) -> None:
    """Convert all components of some types that are not in the model yet."""
    for component in conversion.source.of_type(*types):
        if component.id not in conversion.done:
            convert(conversion, component)


def _ordered(conversion: Conversion) -> dict[str, object]:
    """Data of the model file, in the order of its sections."""
    units = conversion.source.of_type("gear_unit")
    title = next((str(u.get("model_name")) for u in units if u.get("model_name")), "")
    title = title or f"gear unit of {Path(conversion.source.file).stem}"
    return {"title": title, **conversion.data}


def _at_component(conversion: Conversion, problem: Message) -> Message:
    """Problem of the model at the component of the file that caused it."""
    keys = problem.where.split(".")
    origin = conversion.origins.get((keys[0], keys[1])) if len(keys) > 1 else None
    if origin is None:
        return problem
    return problem.changed(where=f"{origin.where}, {origin}, {problem.where}", line=None)


def _list_the_rest(conversion: Conversion) -> None:
    """List the components and values that no converter used."""
    source = conversion.source
    parts: Counter[str] = Counter()
    values: dict[tuple[str, str], list[str]] = {}
    for component in source.components.values():
        if component.id not in conversion.done and component.type not in FRAMEWORK:
            parts[component.type] += 1
            continue
        for name, attribute in component.attributes.items():
            if (component.id, name) not in conversion.used:
                values.setdefault((component.type, name), []).append(shown(attribute))
    for kind, count in parts.items():
        what = f"{kind} ({count})" if count > 1 else kind
        conversion.items.append(
            Item(IGNORED, what, "all", reason="not part of a model, or not connected to one")
        )
    for (kind, name), found in values.items():
        what = f"{kind} ({len(found)})" if len(found) > 1 else kind
        different = list(dict.fromkeys(found))
        value = ", ".join(different[:MOST_VALUES]) + (", ..." if len(different) > MOST_VALUES else "")
        conversion.items.append(Item(IGNORED, what, name, value, reason="without effect in a model"))


__all__ = ["CHANGED", "DEFAULT", "IGNORED", "TAKEN", "Imported", "Item", "import_rexs"]
