# SPDX-License-Identifier: Apache-2.0
"""Import of a REXS file as a model: `import_rexs`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.io.rexs.conversion.bearings import ROLLING, convert_bearing
from pitchpoint.io.rexs.conversion.couplings import COUPLINGS, convert_coupling, convert_held_shaft
from pitchpoint.io.rexs.conversion.loads import (
    convert_gravity,
    convert_loads,
    convert_speeds,
    load_cases,
    time_response,
    with_load_case,
)
from pitchpoint.io.rexs.conversion.masses import convert_mass
from pitchpoint.io.rexs.conversion.meshes import convert_stage
from pitchpoint.io.rexs.conversion.planetary import convert_carriers, convert_planetary_stage
from pitchpoint.io.rexs.conversion.profile_shifts import settle_shifts
from pitchpoint.io.rexs.conversion.shafts import convert_shaft
from pitchpoint.io.rexs.conversion.state import CHANGED, DEFAULT, IGNORED, TAKEN, Conversion, Item
from pitchpoint.io.rexs.document import RexsComponent, RexsModel
from pitchpoint.io.rexs.reading import read_rexs
from pitchpoint.model.build import build_model
from pitchpoint.model.model import Model
from pitchpoint.model.reading.reader import Reader

BY_HAND = "remove it, and write this part of the model by hand: "
REFUSED = {
    "worm_stage": ("a model has no worm stages", "remove it with its gears and shafts"),
    "bevel_stage": ("bevel stages are not converted", f"{BY_HAND}bevel_gears, bevel_meshes"),
    "involute_spline_connection": ("splines are not converted", f"{BY_HAND}couplings"),
    "hydrodynamic_radial_plain_bearing": ("plain bearings are not converted", f"{BY_HAND}plain_bearings"),
    "slide_bearing": ("slide bearings are not converted", f"{BY_HAND}plain_bearings"),
    "general_stage": ("general stages are not converted", f"{BY_HAND}meshes"),
}
"""Components without which a gear unit would be another one: reason and remedy."""
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
    """

    model: Model
    items: tuple[Item, ...]
    source: RexsModel
    load_case: int | None = None

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


def import_rexs(path: str | Path, load_case: int | None = None) -> Imported:
    """Import a REXS file as a model.

    Parameters
    ----------
    path
        XML, JSON or ZIP file of versions 1.0 to 2.0.0.
    load_case
        Number of the load case for loads and speeds; by default the first one.

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
    conversion = Conversion(source)
    _convert(conversion)
    _list_the_rest(conversion, whole, case.id if case is not None else None)
    if conversion.problems:
        raise ModelError([*conversion.problems, *_losses(whole)], str(path))
    try:
        model = build_model(_ordered(conversion), Reader())
        steady = time_response(conversion, model)
        if steady is not None:
            conversion.data["scenarios"]["steady"] = steady
            model = build_model(_ordered(conversion), Reader())
    except ModelError as error:
        raise ModelError(
            [*(_at_component(conversion, p) for p in error.problems), *_losses(whole)], str(path)
        ) from None
    return Imported(model, tuple(conversion.items), whole, case.id if case is not None else None)


def _losses(source: RexsModel) -> list[Message]:
    """Remarks on lost values, which explain what is missing."""
    return [remark for remark in source.remarks if "has lost" in str(remark)]


def _convert(conversion: Conversion) -> None:
    """Convert all parts; the order matters, because a seat must exist before what is on it."""
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
    settle_shifts(conversion)
    _each(conversion, ("concept_bearing", *ROLLING), convert_bearing)
    _each(conversion, COUPLINGS, convert_coupling)
    _each(conversion, ("additional_mass",), convert_mass)
    convert_loads(conversion)
    convert_speeds(conversion)


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


def _list_the_rest(conversion: Conversion, whole: RexsModel, case: int | None) -> None:
    """List the components and values that no converter used."""
    source = conversion.source
    parts: Counter[str] = Counter()
    values: Counter[tuple[str, str]] = Counter()
    for component in source.components.values():
        if component.id not in conversion.done and component.type not in FRAMEWORK:
            parts[component.type] += 1
            continue
        for name in component.attributes:
            if (component.id, name) not in conversion.used:
                values[component.type, name] += 1
    for kind, count in parts.items():
        what = f"{kind} ({count})" if count > 1 else kind
        conversion.items.append(
            Item(IGNORED, what, "all", reason="not part of a model, or not connected to one")
        )
    for (kind, name), count in values.items():
        what = f"{kind} ({count})" if count > 1 else kind
        conversion.items.append(Item(IGNORED, what, name, reason="without effect in a model"))
    for other in load_cases(whole):
        if other.id != case:
            reason = f"one load case at a time: --load-case {other.id}"
            conversion.items.append(Item(IGNORED, f"load case {other.id}", "all", reason=reason))


__all__ = ["CHANGED", "DEFAULT", "IGNORED", "TAKEN", "Imported", "Item", "import_rexs"]
