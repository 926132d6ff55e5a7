# SPDX-License-Identifier: Apache-2.0
"""Defaults of a model: the keys that its file omits, with the values in effect."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from typing import TYPE_CHECKING, Any

from pitchpoint.core.units import format_quantity
from pitchpoint.geometry.section_table import SectionTable
from pitchpoint.model.beam_tables import beam_table_of
from pitchpoint.model.components.beam import BESIDE_MATRICES, IN_FILE, MATRICES, OPTIONAL, Beam
from pitchpoint.model.components.flank_contact import default_clamp
from pitchpoint.model.components.rolling_bearing import RollingBearing
from pitchpoint.model.keys import defaults_of, keys_of
from pitchpoint.model.remarks.collect import follows_flanks
from pitchpoint.model.scenario import ERROR_METHODS, STIFF_METHODS
from pitchpoint.model.sections import groups_of
from pitchpoint.model.stand_ins import own_parts

if TYPE_CHECKING:
    from pitchpoint.model.model import Model


WITHOUT_GEARS = {"sum over the gears": "none", "that of the gears": "its origin"}
"""Defaults of bodies without gears."""
FOLLOWS = ("sum over the gears", "that of the gears", "from geometry", "round about the z axis")
"""Defaults replaced by the values of a solid."""


def defaults(model: Model) -> list[tuple[str, str]]:
    """List the optional keys at their defaults; equal defaults of several components are merged."""
    merged: dict[tuple[str, str, str], list[str]] = {}
    for group, name, key, value in _walk(model):
        merged.setdefault((group, key, value), []).append(name)
    lines = []
    for (group, key, value), names in merged.items():
        every = getattr(model, group, None)
        whole = isinstance(every, Mapping) and len(names) == len(own_parts(every)) > 1
        where = group if not names[0] else f"{group}.{'*' if whole else ','.join(names)}"
        lines.append((f"{where}.{key}", value))
    return lines


def _walk(model: Model) -> Iterator[tuple[str, str, str, str]]:
    """Yield (group, name, key, default in words) for every key at its default."""
    for group in groups_of(model):
        found = own_parts(getattr(model, group))
        for name, part in found.items():
            idle = _keys_without_effect(part)
            if getattr(part, "contact", None) is not None and group == "meshes":
                idle |= {"stiffness", "width", "slices"}
            elif group == "meshes" and follows_flanks(model, name):
                idle.discard("slices")  # grids of gaps are evaluated on slices for every width integral
            for key, value in _unset(part):
                if key == "contact.clamp":
                    value = default_clamp(model.pairs[name].a_w < 0.0)
                if key not in idle:
                    if getattr(part, "solid", None) is not None:
                        value = value if value not in FOLLOWS else "of the solid"
                    elif group == "bodies" and not part.gears and not part.bevel_gears:
                        value = WITHOUT_GEARS.get(value, value)
                    yield group, name, key, value


def _keys_without_effect(part: Any) -> set[str]:
    """Keys without effect on this component in its present configuration."""
    if isinstance(part, RollingBearing):
        found = part.geometry
        idle = {"slices"} if found.effective_length is None else {"grooves"}
        if found.axial_clearance is None:
            idle |= {"axial_clearance", "flange_stiffness"}
        return idle if found.clearance_class is not None else idle | {"clearance_class"}
    if isinstance(part, Beam):
        return _idle_of_a_beam(part)
    idle = (
        {"inertia_tensor"}
        if getattr(part, "inertia_tensor", None) is None
        else {"inertia", "transverse_inertia"}
    )
    if getattr(part, "joint", None) is not None:
        idle.add("motion")
    if getattr(part, "width", "slices") != "slices":
        idle.add("slices")
    method = getattr(part, "method", "gstiff")
    if method not in ERROR_METHODS:
        idle.add("tolerance")
    if method not in STIFF_METHODS:
        idle |= {"order", "form"}
    if getattr(part, "kind", "time") != "time":
        idle |= {"settle_time", "statistics", "sample_rate", "step"}
    if getattr(part, "step", None) is None or method != "generalized_alpha":
        idle.add("long_step")
    if method in (*ERROR_METHODS, "constant_bdf"):
        idle.add("statistics")
    return idle


def _idle_of_a_beam(part: Beam) -> set[str]:
    """Lists of properties that its file or its section matrices contain, and the material of a section."""
    given = part.properties
    if given is None:
        return set()
    if given.beamdyn is not None or given.windio is not None:
        idle = {*OPTIONAL, *MATRICES}
    elif given.stiffness:
        idle = set(OPTIONAL) - set(BESIDE_MATRICES)
    else:
        idle = {*MATRICES, *(IN_FILE if given.elastodyn is not None else ())}
    table = beam_table_of(given)
    damped = isinstance(table, SectionTable) and bool(table.damping.any())
    return {"material", *(["internal_damping"] if damped else []), *(f"properties.{name}" for name in idle)}


def _unset(part: Any, path: str = "") -> Iterator[tuple[str, str]]:
    """Keys of one component with a default that is a number, a word or a rule."""
    keys, known = keys_of(type(part)), defaults_of(type(part))
    for field in fields(part):
        if field.name not in keys:
            continue
        key, value = keys[field.name], getattr(part, field.name)
        where = f"{path}{field.name}"
        if field.name not in known or value != known[field.name]:
            if is_dataclass(value) and not isinstance(value, type):
                yield from _unset(value, f"{where}.")
            continue
        if key.display:
            yield where, key.display
        elif isinstance(value, bool | int | float | str) and value != "":
            yield where, _words(value, key.dimension or "dimensionless")


def _words(value: bool | int | float | str, dimension: str) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return str(value) if isinstance(value, int | str) else format_quantity(value, dimension, 7)
