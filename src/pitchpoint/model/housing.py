# SPDX-License-Identifier: Apache-2.0
"""Housing of a model: representation by bodies, joints and bushings, and the seats of the bearings in it.

A rigid housing with a mass is the body `housing`. Every node of a housing matrix is a body `housing-NODE` at
its bearing; the rule of the system connects them by the matrix.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.components.body import Body
from pitchpoint.model.components.bushing import Bushing
from pitchpoint.model.components.housing import HousingBody, HousingMatrix, RigidHousing
from pitchpoint.model.components.joint import Joint
from pitchpoint.model.components.law import FormulaLaw
from pitchpoint.model.components.marker import Marker
from pitchpoint.model.frames import GROUND, Array, body_frame
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.rings import mounted_place
from pitchpoint.model.shafts import SEATED

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

NAME = "housing"
"""Key of the file, and name of the body of a rigid housing."""
BARE = 1e-9
"""Mass [kg] and inertia [kg m^2] of the body of a node; a body must not be massless."""
TRANSLATIONS = ("x", "y", "z")


def seat_name(node: str) -> str:
    """Name of the body of a node of a housing matrix.

    Examples
    --------
    >>> seat_name("input_left")
    'housing-input_left'
    """
    return f"{NAME}-{node}"


def bearings_in(machine: Any) -> dict[str, tuple[str, Any]]:
    """Bearings that are in the housing of a model or its parts: section and component by name.

    These are all bearings with `body` and without a housing of their own.
    """
    return {
        name: (group, part)
        for group in SEATED
        for name, part in getattr(machine, group).items()
        if part.body is not None and (part.housing is None or part.given is not None)
    }


def node_bodies(machine: Any) -> tuple[str, ...]:
    """Names of the bodies that only represent the nodes of a housing matrix."""
    held = machine.housing
    if not isinstance(held, HousingMatrix):
        return ()
    return tuple(name for node in held.nodes if (name := seat_name(node)) in machine.bodies)


# --- representation -----------------------------------------------------------------------------------------
def add_housing(parts: Parts, report: Reader) -> None:
    """Check the housing and add its bodies, joints and bushings."""
    held = parts.housing
    if held is None:
        return
    before = len(report.problems)
    if isinstance(held, RigidHousing):
        _add_rigid(parts, held, report)
    elif isinstance(held, HousingMatrix):
        _add_nodes(parts, held, report)
    else:
        _known_body(parts, held.body, (NAME, "body"), report)
    _fix_parts(parts, held, report)
    if len(report.problems) > before:
        parts.housing = None  # later problems are consequences


def _add(parts: Parts, group: str, name: str, part: Any, report: Reader, at: Place = (NAME,)) -> None:
    """Add one component of the housing; reports a name that is taken."""
    if name in parts.known(group):
        report.problem(
            at, f"needs the name {name}, which {group}.{name} has already", remedy="rename that component"
        )
        return
    parts.section(group)[name] = part
    parts.names[group] = parts.known(group) | {name}
    report.aliases[group, name] = at


def _add_rigid(parts: Parts, held: RigidHousing, report: Reader) -> None:
    """Body of a rigid housing with its mounts."""
    if held.mass is None:
        if held.mounts and (NAME, "mass") not in report.tainted:
            report.problem(
                (NAME, "mounts"),
                "have no effect on a housing that is ground",
                remedy="give mass, or remove them",
            )
        return
    if held.inertia_tensor is None and (NAME, "inertia_tensor") not in report.tainted:
        report.problem(
            (NAME, "inertia_tensor"),
            "is missing: a housing on mounts tilts",
            remedy="give [Ixx, Iyy, Izz, Ixy, Iyz, Izx] about the centre of mass",
        )
    if not held.mounts and (NAME, "mounts") not in report.tainted:
        report.problem(
            (NAME, "mounts"),
            "is missing: nothing holds the housing",
            remedy="add mounts: {foot_1: {position: [x, y, z], stiffness: {radial: 1e8, axial: 1e8}}}",
        )
    markers = {name: Marker(position=mount.position) for name, mount in held.mounts.items()}
    body = Body(
        motion="free",
        mass=held.mass,
        center_of_mass=held.center_of_mass,
        inertia_tensor=held.inertia_tensor,
        position=(0.0, 0.0, 0.0),
        markers=markers,
        of_housing=True,
    )
    _add(parts, "bodies", NAME, body, report)
    for name, mount in held.mounts.items():
        spring = Bushing(
            ends=(f"{NAME}.{name}", GROUND), stiffness=mount.stiffness, damping=mount.damping, of_housing=True
        )
        _add(parts, "bushings", f"{NAME}-{name}", spring, report, (NAME, "mounts", name))


def _add_nodes(parts: Parts, held: HousingMatrix, report: Reader) -> None:
    """Bodies of the nodes of a housing matrix."""
    at: Place = (NAME, "nodes")
    seats = bearings_in(parts)
    known = {*seats, *held.feet, *held.parts}
    if held.rows_per_node not in (3, 6):
        report.problem((NAME, "rows_per_node"), "is neither 3 nor 6", value=str(held.rows_per_node))
        return
    for k, node in enumerate(held.nodes):
        if node in held.nodes[:k]:
            report.problem((*at, k), f"names {node} twice", remedy="name each node once")
        elif node not in known:
            report.problem(
                (*at, k),
                f"names {node[:40]!r}, which is neither a bearing in the housing nor a foot or part",
                remedy=did_you_mean(node, known) + f"there are {', '.join(sorted(known)) or 'none'}",
            )
    for node in sorted(known - set(held.nodes)):
        if node in seats and not _complete(parts, seats[node][0], report):
            continue
        what = f"{seats[node][0]}.{node}" if node in seats else node
        report.problem(
            at,
            f"does not contain {what}, which is in the housing",
            remedy=f"add {node}"
            + (f", or give {what} housing: ground" if node in seats else " or remove it"),
        )
    for node in dict.fromkeys(held.nodes):
        foot = held.feet.get(node)
        if node not in known or (foot is not None and foot.stiffness is None):
            continue  # a fixed foot
        name = seat_name(node)
        where: Place = (NAME, "feet", node) if foot is not None else at
        _add(parts, "bodies", name, _node(held, None if foot is None else foot.position), report, where)
        if held.rows_per_node == 3:
            slides = {c: (FormulaLaw(c, (c,)),) for c in TRANSLATIONS}
            joint = Joint(
                type="user",
                bodies=(GROUND, name),
                coordinates=dict.fromkeys(TRANSLATIONS, "length"),
                motion=slides,
                axes=held.axes,
                of_housing=True,
            )
            _add(parts, "joints", name, joint, report, where)
        if foot is not None and foot.stiffness is not None:
            spring = Bushing(ends=(name, GROUND), stiffness=foot.stiffness, of_housing=True)
            _add(parts, "bushings", name, spring, report, where)


def _complete(parts: Parts, group: str, report: Reader) -> bool:
    """Whether all components of a section could be read."""
    return set(getattr(parts, group)) == parts.known(group) and (group,) not in report.tainted


def _node(held: HousingMatrix, position: Any) -> Body:
    """Body of one node."""
    return Body(
        mass=BARE,
        inertia=BARE,
        transverse_inertia=BARE,
        motion="free" if held.rows_per_node == 6 else None,
        position=position,
        axes=held.axes,
        of_housing=True,
    )


def _known_body(parts: Parts, name: str, at: Place, report: Reader) -> bool:
    """Whether a body exists; reports one that does not."""
    if parts.has("bodies", name):
        return True
    names = parts.known("bodies")
    report.problem(
        at,
        f"names the body {name[:40]!r}, which does not exist",
        remedy=did_you_mean(name, names) + f"there are {', '.join(sorted(names)) or 'none'}",
    )
    return False


def _fix_parts(parts: Parts, held: Any, report: Reader) -> None:
    """Joints that fix bodies in the housing."""
    for k, name in enumerate(held.parts):
        at: Place = (NAME, "parts", k)
        if not _known_body(parts, name, at, report):
            continue
        body = parts.bodies.get(name)
        if body is not None and body.motion is not None:
            report.problem(
                ("bodies", name, "motion"),
                f"does not apply to {name}, which is fixed in the housing",
                value=body.motion,
                remedy="remove motion",
            )
        if isinstance(held, HousingMatrix):
            base = seat_name(name)
        elif isinstance(held, HousingBody):
            owner = parts.bodies.get(held.body)
            own = owner is not None and name in owner.markers
            base = f"{held.body}.{name}" if own else held.body
        else:
            base = GROUND if held.mass is None else NAME
        joint = Joint(type="fixed", bodies=(base, name), of_housing=True)
        _add(parts, "joints", f"{name}-{NAME}", joint, report, at)


# --- places -------------------------------------------------------------------------------------------------
def place_nodes(parts: Parts) -> None:
    """Locate the nodes of a housing matrix at their bearings and parts."""
    held = parts.housing
    if not isinstance(held, HousingMatrix):
        return
    seats = bearings_in(parts)
    for node in held.nodes:
        name = seat_name(node)
        if name not in parts.bodies or parts.bodies[name].origin is not None:
            continue
        place: Array | None = None
        if node in seats and seats[node][1].body in parts.bodies:
            place = mounted_place(parts, seats[node][1])
        elif node in parts.bodies:
            place = body_frame(parts, node)[0]
        if place is not None:
            x, y, z = (float(v) for v in place)
            parts.bodies[name] = replace(parts.bodies[name], origin=(x, y, z))


def connect_housing(parts: Parts, report: Reader) -> None:
    """Give every bearing without a housing of its own its seat in the housing."""
    held = parts.housing
    if held is None or (isinstance(held, RigidHousing) and held.mass is None):
        return
    for name, (group, part) in bearings_in(parts).items():
        if isinstance(held, RigidHousing):
            seat: str | None = NAME
        elif isinstance(held, HousingMatrix):
            seat = seat_name(name)
        else:
            seat = _nearest(parts, held, name, (group, part), report)
        if seat is not None:
            parts.section(group)[name] = replace(part, housing=seat, given=part)
            report.aliases[group, name, "housing"] = (NAME,)


def _nearest(parts: Parts, held: HousingBody, name: str, seat: tuple[str, Any], report: Reader) -> str | None:
    """Node of the body of a housing at a bearing; None with a problem if there is none."""
    owner = parts.bodies.get(held.body)
    if owner is None or ("bodies", held.body) in report.tainted:
        return None
    if name in owner.markers:
        return f"{held.body}.{name}"
    if owner.elastic is None:
        return held.body
    group, part = seat
    centre = mounted_place(parts, part) if part.body in parts.bodies else None
    origin, axes = body_frame(parts, held.body)
    if centre is None or origin is None or not owner.markers:
        return None
    apart = {
        node: float(np.linalg.norm(origin + axes @ np.array(marker.position) - centre))
        for node, marker in owner.markers.items()
    }
    node = min(apart, key=lambda n: apart[n])
    if apart[node] > held.within:
        report.problem(
            (group, name),
            f"has no node of the housing {held.body}; the nearest, {node}, is "
            f"{1e3 * apart[node]:.6g} mm away",
            limit=f"{1e3 * held.within:.6g} mm, key within of housing",
            remedy=f"add a node {name} to elastic_bodies.{held.body}, correct the positions, or give "
            "housing: ground",
        )
        return None
    return f"{held.body}.{node}"
