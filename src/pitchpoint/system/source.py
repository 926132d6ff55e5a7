# SPDX-License-Identifier: Apache-2.0
"""Where in the model file a record comes from, so that a failed computation can name component and line."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from pitchpoint.core.errors import ModelError
from pitchpoint.model.show import dotted

if TYPE_CHECKING:
    from pitchpoint.model.model import Model
    from pitchpoint.system.system import System

SIGNALS = ("sensors", "blocks", "controllers", "actuators")
SECTIONS: dict[str, tuple[str, ...]] = {
    "ball_on_surface": ("surface_contacts",),
    "beam": ("beams",),
    "bearing": ("bearings", "couplings"),
    "bevel_mesh": ("bevel_meshes",),
    "bushing": ("bushings",),
    "clearance_bearing": ("plain_bearings",),
    "closure": ("joints", "rods"),
    "coupling": ("torsion_springs",),
    "curve_on_curve": ("curve_contacts",),
    "curve_curve": ("curve_contacts",),
    "flexible_body": ("elastic_bodies",),
    "force": ("loads",),
    "friction_clutch": ("clutches",),
    "gear_mesh": ("meshes",),
    "guide": ("joints", "elastic_bodies"),
    "joint_friction": ("joints",),
    "loose_bearing": ("bearings",),
    "maxwell": ("maxwells",),
    "point_curve": ("cam_contacts",),
    "point_on_curve": ("cam_contacts",),
    "point_surface": ("surface_contacts",),
    "ratio": ("ratios",),
    "rolling_bearing": ("rolling_bearings",),
    "shaft_beam": ("shafts",),
    "signal": SIGNALS,
    "signal_of_loads": SIGNALS,
    "spring_damper": ("springs",),
    "surface_surface": ("surface_contacts",),
    "torque": ("loads",),
    "torsion_maxwell": ("torsion_maxwells",),
}
"""Sections of a model file whose components become records of a kind."""
CONTACTS = ("ball_on_surface", "curve_on_curve", "point_on_curve")
"""Kinds whose rows are gaps."""
LENGTHS = ("x", "y", "z")
"""Last words of closures that are distances; the others are angles."""


def source(system: System, kind: str, name: str) -> str:
    """Place in the model file of a record, such as "loads.push (line 6)".

    Parameters
    ----------
    system
        A system.
    kind, name
        Kind of the record and its name; a component may have several, NAME.x or NAME.2.

    Returns
    -------
    str
        Without a model, or where none of its components has the name: kind and name.
    """
    if kind == "drive" and (told := _drive(system, name)):
        return told
    found = _component(system, kind, name)
    if found is None:
        return f"{kind.replace('_', ' ')} {name!r}"
    section, component = found
    line = system.model.line((section, component)) if system.model is not None else None
    return f"{section}.{name}" + (f" (line {line})" if line is not None else "")


def coordinate_source(system: System, name: str) -> str:
    """A coordinate, as results name it, with the line of its body: "rotor.z (line 4)"."""
    body = name.rpartition(".")[0]
    for section in ("bodies", "shafts", "elastic_bodies") if system.model is not None else ():
        line = system.model.line((section, body.partition(".")[0])) if system.model is not None else None
        if line is not None:
            return f"{name} (line {line})"
    return name


def _drive(system: System, name: str) -> str:
    """Place of a drive in its scenario; "" without a model."""
    if system.model is None or system.scenario is None:
        return ""
    scenario = next((n for n, s in system.model.scenarios.items() if s is system.scenario), "")
    line = system.model.line(("scenarios", scenario, "drive", name))
    place = f"scenarios.{scenario}.drive.{name}" if scenario else f"drive.{name}"
    return place + (f" (line {line})" if line is not None else "")


def row_source(system: System, row: int) -> str:
    """The same for a constraint row by its number."""
    words = system.layout.rows[row]
    kind, name = _row(words)
    return source(system, kind, name) if kind and _component(system, kind, name) else words


def row_unit(system: System, row: int) -> str:
    """Unit of what a constraint row is off by, with a blank before it; "" for angles and ratios."""
    kind, name = _row(system.layout.rows[row])
    distance = kind in CONTACTS or (kind == "closure" and name.rpartition(".")[2] in LENGTHS)
    rod = kind == "closure" and system.model is not None and name in system.model.rods
    return " m" if distance or rod else ""


def with_lines(model: Model, error: ModelError) -> ModelError:
    """The error with the lines of those of its problems that have none but name a place in the file."""
    places = {dotted(place): line for place, line in (model.lines or {}).items()}

    def line_of(where: str) -> int | None:
        """Line of the key, or of the nearest one around it."""
        while where and where not in places:
            where = where.rpartition(".")[0]
        return places.get(where)

    found = [p if p.line is not None else replace(p, line=line_of(p.where)) for p in error.problems]
    return ModelError(found, error.file or model.file)


def _row(words: str) -> tuple[str, str]:
    """Kind and name of a row; both empty for rows that are no component's."""
    kind, _, name = words.partition(" ")
    return (kind, name) if kind in SECTIONS else ("", "")


def _component(system: System, kind: str, name: str) -> tuple[str, str] | None:
    """Section and name of the component that a record comes from."""
    if system.model is None:
        return None
    for section in SECTIONS.get(kind, ()):
        known = getattr(system.model, section, {})
        for candidate in (name, name.rpartition(".")[0], name.partition(".")[0]):
            if candidate in known:
                return section, candidate
    return None
