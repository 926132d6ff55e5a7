# SPDX-License-Identifier: Apache-2.0
"""Scissor gears: representation of a free half as gear, body, spring and meshes.

The free half is on its own body on the axis of the fixed half. Each mesh of the fixed half exists a second
time with the free half: the spring presses one half against the front flanks, the other one against the back
flanks.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.clutch import Clutch
from pitchpoint.model.components.coupling import Coupling
from pitchpoint.model.components.law import Constant
from pitchpoint.model.components.marker import Marker
from pitchpoint.model.components.scissor_gear import ScissorGear
from pitchpoint.model.components.torsion_spring import TorsionSpring
from pitchpoint.model.frames import body_frame
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.stand_ins import path_of

if TYPE_CHECKING:
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.parts import Parts

SECTION = "scissor_gears"
MOTIONS = ("torsion", "planar", "free")
"""Motions of the body of the fixed half."""
TOUCHING = 1e-9
"""Share of the distance of the halves that is rounding."""


def add_scissor_gears(parts: Parts, report: Reader) -> None:
    """Check the references of the scissor gears and add the components of their free halves.

    Later problems of these components are reported for the scissor gears.
    """
    for name, scissor in parts.scissor_gears.items():
        if not _usable(parts, name, scissor, report):
            report.tainted.update(
                ((SECTION, name), ("gears",), ("bodies",), ("meshes",), ("torsion_springs",))
            )
            parts.names["gears"] = parts.known("gears") | {name}
            parts.names["bodies"] = parts.known("bodies") | {name}
            continue
        body = str(parts.body_of(scissor.gear))
        if parts.bodies[body].shaft is not None:  # the spring acts at the gear, not at the start of the shaft
            seat = Marker(position=(0.0, 0.0, parts.bodies[body].gears[scissor.gear]))
            markers = {**parts.bodies[body].markers, name: seat}
            parts.bodies[body] = replace(parts.bodies[body], markers=markers)
        for group, word, part in list(members(parts, name, scissor)):
            parts.section(group)[word] = part
            parts.names[group] = parts.known(group) | {word}
        report.aliases |= places_of_free_half(parts, name, scissor)


def _usable(parts: Parts, name: str, scissor: ScissorGear, report: Reader) -> bool:
    """Check names and values of a scissor gear."""
    at: Place = (SECTION, name)
    before = len(report.problems)
    if not parts.has("gears", scissor.gear):
        remedy = did_you_mean(scissor.gear, parts.known("gears"))
        remedy += f"there are {', '.join(sorted(parts.known('gears'))) or 'none'}"
        text = f"names the gear {scissor.gear[:40]!r}, which does not exist"
        report.problem((*at, "gear"), text, remedy=remedy)
        return False
    if scissor.torque == 0.0:
        text = "is zero: the spring would not turn the halves against each other"
        report.problem((*at, "torque"), text, remedy="give the torque with its sign")
    body = parts.body_of(scissor.gear)
    if body is None or body not in parts.bodies or scissor.gear not in parts.gears:
        return False  # reported for the gear
    least = 0.5 * (parts.gears[scissor.gear].face_width + scissor.face_width)
    if scissor.position is not None and abs(scissor.position) < least * (1.0 - TOUCHING):
        report.problem(
            (*at, "position"),
            f"lets the free half overlap {scissor.gear}",
            value=f"{1e3 * scissor.position:.6g} mm",
            limit=f"at least {1e3 * least:.6g} mm, half of both face widths, to either side",
            remedy="remove position, or move the free half",
        )
    _beside(parts, name, scissor, report)
    _check_body(parts, name, scissor, body, report)
    for group, word, _ in members(parts, name, scissor):
        if word in parts.known(group):
            text = f"needs the name {word}, which {group}.{word} has already"
            report.problem(at, text, remedy="rename that component or the scissor gear")
    return len(report.problems) == before and at not in report.tainted


def _beside(parts: Parts, name: str, scissor: ScissorGear, report: Reader) -> None:
    """Check that two free halves of one gear are not at the same place."""
    for other, earlier in parts.scissor_gears.items():
        if other == name:
            return
        apart = 0.5 * (earlier.face_width + scissor.face_width)
        if earlier.gear == scissor.gear and (
            abs(distance(parts, earlier) - distance(parts, scissor)) < apart * (1.0 - TOUCHING)
        ):
            report.problem(
                (SECTION, name, "position"),
                f"is that of {other}, a free half of the same gear",
                limit=f"{1e3 * apart:.6g} mm apart, half of both face widths",
                remedy=f"remove {name}, or give it a position on the other side of {scissor.gear}",
            )


def _check_body(parts: Parts, name: str, scissor: ScissorGear, body: str, report: Reader) -> None:
    """Check that the body of the fixed half can carry a free half."""
    at: Place = (SECTION, name)
    held = parts.bodies[body]
    jointed = any(body == end.partition(".")[0] for joint in parts.joints.values() for end in joint.bodies)
    motion = held.motion or "torsion"
    what = ""
    if (owner := held.stage or parts.gears[scissor.gear].stage) is not None:
        what = f"is part of {path_of(owner)}"
    elif held.elastic is not None:
        what = f"is on the elastic body {body}"
    elif jointed:
        what = f"is on {body}, which has a joint"
    elif motion not in MOTIONS:
        what = f"is on {body} with motion: {motion}"
    if what:
        report.problem(
            (*at, "gear"),
            f"names {scissor.gear}, which {what}",
            limit="a gear on a shaft, or on a body with motion: torsion, planar or free",
            remedy="write the free half as a gear and a body of its own with a torsion spring",
        )
    elif (
        motion != "torsion" and scissor.hub_stiffness is None and (*at, "hub_stiffness") not in report.tainted
    ):
        report.problem(
            (*at, "hub_stiffness"),
            f"is missing: {body} moves sideways, and the hub guides the free half",
            remedy="give hub_stiffness: {radial: 1e9 N/m"
            + ("}" if motion == "planar" else ", axial: 1e9 N/m, tilt: 1e5 N m/rad}"),
        )
    elif motion == "torsion" and scissor.hub_stiffness is not None:
        report.problem(
            (*at, "hub_stiffness"),
            f"has no effect: {body} has motion: torsion",
            remedy="remove it, or give the body motion: planar or free",
        )


def members(parts: Any, name: str, scissor: ScissorGear) -> Iterator[tuple[str, str, Any]]:
    """Components of a free half: section, name, component."""
    fixed: Gear = parts.gears[scissor.gear]
    body = str(parts.body_of(scissor.gear))
    held: Body = parts.bodies[body]
    stage = f"{SECTION}.{name}"
    yield "gears", name, _gear(fixed, scissor, stage)
    yield "bodies", name, _body(held, name, scissor, stage)
    ends = (name, f"{body}.{name}" if held.shaft is not None else body)
    spring = TorsionSpring(
        bodies=ends,
        stiffness=scissor.stiffness,
        damping=scissor.damping,
        angle=scissor.torque / scissor.stiffness,
        stage=stage,
    )
    yield "torsion_springs", name, spring
    if scissor.friction > 0.0:
        yield (
            "clutches",
            f"{name}-friction",
            Clutch(bodies=ends, capacity=Constant(scissor.friction), stage=stage),
        )
    if scissor.hub_stiffness is not None:
        hub = Coupling(
            bodies=(body, name),
            position=(0.0, 0.0, held.gears[scissor.gear] + distance(parts, scissor)),
            stiffness=scissor.hub_stiffness,
            damping=scissor.hub_damping,
            stage=stage,
        )
        yield "couplings", name, hub
    for word, mesh in list(parts.meshes.items()):
        if scissor.gear in mesh.gears and mesh.stage is None:
            gears = tuple(name if gear == scissor.gear else gear for gear in mesh.gears)
            law = (
                {}
                if scissor.mesh_stiffness is None
                else {"stiffness": scissor.mesh_stiffness, "contact": None}
            )
            yield "meshes", mesh_name(word, name), replace(mesh, gears=gears, stage=stage, **law)


def places_of_free_half(machine: Any, name: str, scissor: ScissorGear) -> dict[Place, Place]:
    """Paths in the file that describe the components of a free half; for its meshes those of the other."""
    at: Place = (SECTION, name)
    found: dict[Place, Place] = {
        ("gears", name): (*at, "gear"),
        ("gears", name, "face_width"): (*at, "face_width"),
        ("bodies", name): at,
        ("torsion_springs", name): at,
        ("clutches", f"{name}-friction"): (*at, "friction"),
        ("couplings", name): (*at, "hub_stiffness"),
    }
    for word, mesh in machine.meshes.items():
        if scissor.gear in mesh.gears:
            found["meshes", mesh_name(word, name)] = ("meshes", word)
            found["meshes", mesh_name(word, name), "gears"] = (*at, "position")
    return found


def lines_of_free_halves(machine: Any, lines: Mapping[Place, int]) -> Iterator[tuple[Place, int]]:
    """Components of free halves with the lines of the keys that describe them."""
    for name, scissor in machine.scissor_gears.items():
        for place, key in places_of_free_half(machine, name, scissor).items():
            known = [line for n in range(len(key), 1, -1) if (line := lines.get(key[:n])) is not None]
            if known:
                yield place, known[0]


def mesh_name(mesh: str, name: str) -> str:
    """Name of the mesh of a free half; `mesh` is that of the fixed half.

    Examples
    --------
    >>> mesh_name("stage_2", "free")
    'stage_2-free'
    """
    return f"{mesh}-{name}"


def distance(parts: Any, scissor: ScissorGear) -> float:
    """Axial distance of the mid-faces of both halves [m]."""
    if scissor.position is not None:
        return scissor.position
    return 0.5 * (float(parts.gears[scissor.gear].face_width) + scissor.face_width)


def _gear(fixed: Gear, scissor: ScissorGear, stage: str) -> Gear:
    """Gear of a free half: the teeth of the fixed half without its faults and deviations, on a solid disc."""
    return replace(
        fixed,
        face_width=scissor.face_width,
        rim_thickness=None,
        web_thickness=None,
        mass=None,
        polar_inertia=None,
        transverse_inertia=None,
        solid=None,
        initial_angle=None,
        deviations=None,
        faults={},
        stage=stage,
    )


def _body(held: Body, name: str, scissor: ScissorGear, stage: str) -> Body:
    """Body of a free half."""
    return Body(
        gears={name: 0.0},
        motion=held.motion or "torsion",
        mass=scissor.mass,
        inertia=scissor.inertia,
        transverse_inertia=scissor.transverse_inertia,
        axes=held.axes,
        stage=stage,
    )


def place_free_halves(parts: Parts) -> None:
    """Locate the free halves on the axes of the fixed ones, as far as those are located."""
    for name, scissor in parts.scissor_gears.items():
        body = parts.body_of(scissor.gear) if scissor.gear in parts.gears else None
        if body is None or name not in parts.bodies or parts.bodies[name].origin is not None:
            continue
        origin, axes = body_frame(parts, body)
        if origin is not None:
            along = parts.bodies[body].gears[scissor.gear] + distance(parts, scissor)
            x, y, z = (float(v) for v in origin + along * axes[:, 2])
            parts.bodies[name] = replace(parts.bodies[name], origin=(x, y, z))
