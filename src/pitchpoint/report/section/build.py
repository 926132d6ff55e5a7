# SPDX-License-Identifier: Apache-2.0
"""`section_of`: section of the gearbox of a model, developed in the order of the power flow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.units import format_quantity
from pitchpoint.core.words import listed, ranges
from pitchpoint.report.section.axes import Joined, Line, alike, connections, drawn_bodies, lines_of
from pitchpoint.report.section.carriers import pin_pieces
from pitchpoint.report.section.housing import walls_of
from pitchpoint.report.section.layout import Box, Frame, unfold
from pitchpoint.report.section.pieces import pieces_of, pitch_diameter
from pitchpoint.report.section.places import flow_order, positions_of
from pitchpoint.viz.section_content import Piece, Section, SectionAxis, SectionLink

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

SOLID = ("gear", "teeth", "shaft", "spindle", "drum", "mass", "outer", "linear", "plate", "flange")
SPEED, TORQUE, POWER = "angular_speed", "torque", "power"
"""Dimensions of the numbers of a shaft."""
SCHEMATIC = {
    "spindle": "shafts of bodies without sections",
    "drum": "connections of ring gears",
    "plate": "carriers",
    "linear": "bearings by stiffness",
    "mass": "bodies without gears",
    "seat": "housing",
}
"""Kinds of parts whose shape the model does not give, in words."""
COPIES = 2
"""Number of equal planets that are drawn, one on each side."""
TOUCH = 2e-3
"""Distance of pitch lines, relative to the size of the machine, from which gears count as apart."""


def section_of(model: Model, flow: Mapping[str, Any] | None = None) -> Section | None:
    """Section of the gearbox; None for a model without gears and shafts.

    Parameters
    ----------
    model
        The model.
    flow
        Power flow with the input and the numbers of the shafts, as of `report.static_power`.
    """
    bodies = drawn_bodies(model)
    if not any(model.bodies[b].gears or model.bodies[b].bevel_gears or b in model.shafts for b in bodies):
        return None
    lines = lines_of(model, bodies)
    joined = connections(model, lines)
    order = flow_order(model, bodies, None if flow is None else flow.get("input"))
    at = positions_of(model, lines, order)
    groups = alike(model, lines, joined)
    hidden = {k for members in groups.values() for k in members[COPIES:]}
    named = _names(model, lines, groups)
    size = _size(model, lines)
    carried = {each.lines[1]: lines[each.lines[0]] for each in joined if each.kind == "carrier"}
    drawn = {}
    for k, line in enumerate(lines):
        if k not in hidden:
            found = pieces_of(model, line, at, size, named)
            drawn[k] = [*pin_pieces(model, at, line, carried.get(k)), *found]
    of = {body: k for k, line in enumerate(lines) for body in line.bodies}
    turn = list(dict.fromkeys(of[body] for body in order))
    frames = unfold(lines, joined, {k: _hull(p) for k, p in drawn.items()}, turn, _apexes(model))
    copies = {k for members in groups.values() for k in members[1:COPIES]}
    axes = []
    for k, frame in frames.items():
        pieces = [replace(p, name="", words="") if k in copies else p for p in drawn[k]]
        names = list(lines[k].bodies)
        axes.append(
            SectionAxis(
                origin=frame.origin,
                way=frame.way,
                side=frame.side,
                pieces=pieces,
                name="" if k in copies else _title(lines, k, groups),
                words=() if k in copies or flow is None else _words(flow, names),
            )
        )
    walls, notes = walls_of(axes), []
    if at.schematic:
        notes.append("axial positions are schematic: gears overlap in the model")
    kinds = {p.kind for pieces in drawn.values() for p in pieces}
    schematic = [words for kind, words in SCHEMATIC.items() if kind in kinds]
    if schematic:
        notes.append(f"schematic: {listed(schematic)}")
    return Section(
        title=model.title,
        axes=axes,
        distances=_distances(model, lines, frames, joined, groups),
        apart=_apart(model, lines, frames, joined, at, hidden, size),
        notes=notes,
        walls=walls,
    )


def gearbox_drawing(model: Model, flows: Mapping[str, Any] | None = None) -> str | None:
    """SVG drawing of the gearbox of a model; None for a model without gears and shafts.

    Parameters
    ----------
    model
        The model.
    flows
        Power flows by scenario, as of `report.static_power`; the first one with speeds gives directions and
        numbers.
    """
    from pitchpoint.report.section.transverse import transverse_of
    from pitchpoint.viz.gearbox_drawing import gearbox_svg

    known = [flow for flow in (flows or {}).values() if "failure" not in flow]
    flow = next((f for f in known if f["turns"]), known[0] if known else None)
    section = section_of(model, flow)
    return None if section is None else gearbox_svg(section, transverse_of(model, flow))


def _names(model: Model, lines: list[Line], groups: Mapping[int, list[int]]) -> dict[str, list[str]]:
    """Gears that the gears of the first of several equal axes represent."""
    found: dict[str, list[str]] = {}
    for first, members in groups.items():
        own = [g for b in lines[first].bodies for g in model.bodies[b].gears]
        for place, gear in enumerate(own):
            found[gear] = [
                [g for b in lines[k].bodies for g in model.bodies[b].gears][place] for k in members
            ]
    return found


def _size(model: Model, lines: list[Line]) -> float:
    """Size of the machine across its axes [m]."""
    points = np.array([line.point for line in lines])
    reach = [abs(g.geometry.d_f) for g in model.gears.values()] + [
        g.geometry.d_ae for g in model.bevel_gears.values()
    ]
    long = [shaft.length for shaft in model.shafts.values()]
    return max([float(np.ptp(points, axis=0).max()) + max(reach, default=0.0), *long, 1e-3])


def _hull(pieces: list[Piece]) -> list[Box]:
    """Rectangles around the solid parts of an axis."""
    found = []
    for piece in pieces:
        ring_teeth = piece.kind == "teeth" and piece.line[0, 1] > piece.line[-1, 1]  # pinions are among them
        if piece.kind in SOLID and not ring_teeth:
            (z0, r0), (z1, r1) = piece.line.min(axis=0), piece.line.max(axis=0)
            found.append((float(z0), float(z1), float(r0), float(r1)))
    return found


def _apexes(model: Model) -> dict[str, Any]:
    """Common apex of every bevel mesh in the world [m]."""
    from pitchpoint.model.frames import body_frame

    found = {}
    for name, mesh in model.bevel_meshes.items():
        body = model.body_of(mesh.gears[0])
        if body is not None:
            origin, axes = body_frame(model, body)
            apex = model.bodies[body].bevel_gears[mesh.gears[0]]
            found[name] = (np.zeros(3) if origin is None else origin) + apex * axes[:, 2]
    return found


def _title(lines: list[Line], k: int, groups: Mapping[int, list[int]]) -> str:
    """Names of the bodies of an axis, and of the axes that it represents."""
    members = next((m for m in groups.values() if k in m), [k])
    return ranges([body for m in members for body in lines[m].bodies])


def _words(flow: Mapping[str, Any], bodies: list[str]) -> list[str]:
    """Speed and torque of the bodies of an axis, once for equal numbers; power of its inputs and outputs."""
    found: dict[str, list[str]] = {}
    for body in bodies:
        row = flow["shafts"].get(body)
        if row is None:
            continue
        speed = row["speed"]
        turns = "at rest" if speed == 0.0 else format_quantity(speed, SPEED, 5) if speed else ""
        parts = [turns] if turns else []
        parts += [] if not row[TORQUE] else [format_quantity(row[TORQUE], TORQUE, 4)]
        found.setdefault(", ".join(parts), []).append(body)
    outer = [
        f"{'in' if row[POWER] > 0.0 else 'out'}: {row['name']}, {format_quantity(abs(row[POWER]), POWER, 4)}"
        for row in flow["external"]
        if row["body"] in bodies and row[POWER]
    ]
    if len(found) == 1:
        return [*found, *outer]
    return [*(f"{ranges(names)}: {words}" for words, names in found.items()), *outer]


def _distances(
    model: Model,
    lines: list[Line],
    frames: Mapping[int, Frame],
    joined: list[Joined],
    groups: Mapping[int, list[int]],
) -> list[SectionLink]:
    """Centre distances of the meshes whose axes are at their true distance in the drawing, once per pair of
    axes."""
    copies = {k for members in groups.values() for k in members[1:]}
    found, seen = [], set()
    for each in joined:
        one, two = each.lines
        if (
            each.kind != "mesh"
            or not {one, two} <= frames.keys()
            or {one, two} & copies
            or (one, two) in seen
        ):
            continue
        seen |= {(one, two), (two, one)}
        a = abs(model.meshes[each.name].a_w or 0.0)
        start, end = frames[one].origin, frames[two].origin
        across = float(abs((end - start) @ frames[one].side))
        if abs(across - a) < 1e-3 * a:
            found.append(SectionLink(start=start, end=end, words=f"a = {format_quantity(a, 'length', 5)}"))
    return found


def _apart(
    model: Model,
    lines: list[Line],
    frames: Mapping[int, Frame],
    joined: list[Joined],
    at: Any,
    hidden: set[int],
    size: float,
) -> list[SectionLink]:
    """Meshes of drawn gears that are apart in the drawing plane."""
    found = []
    for each in joined:
        one, two = each.lines
        if each.kind != "mesh" or {one, two} & hidden or not {one, two} <= frames.keys():
            continue
        gears = model.meshes[each.name].gears
        if model.body_of(gears[0]) not in lines[one].bodies:
            gears = gears[::-1]
        a = abs(model.meshes[each.name].a_w or 0.0)
        gap = frames[two].origin - frames[one].origin
        across = float(gap @ frames[one].side)
        if abs(abs(across) - a) < TOUCH * size and abs(frames[one].way @ frames[two].way) > 0.999:
            continue
        r_1, r_2 = (0.5 * pitch_diameter(model, g) for g in gears)
        way = 1.0 if across > 0.0 else -1.0
        start = frames[one].at(at.gears[gears[0]], way * r_1)
        end = frames[two].at(at.gears[gears[1]], -way * r_2)
        found.append(SectionLink(start=start, end=end, words=each.name))
    return found
