# SPDX-License-Identifier: Apache-2.0
"""Checks of the coordinates, observations and bodies named by sensors and actuators.

A check runs if the parts that it depends on could be read.
"""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

from pitchpoint.core.nearest import did_you_mean
from pitchpoint.model.checks.beam_ends import is_beam
from pitchpoint.model.checks.mechanism import coordinates_listed
from pitchpoint.model.components.actuator import TorqueActuator
from pitchpoint.model.components.sensor import JointSensor, Listener, LoadSensor
from pitchpoint.model.frames import GROUND, axes_of, split
from pitchpoint.model.keys import Place, keys_of
from pitchpoint.model.mechanism import coordinate, seat_frame
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.sections import GROUPS, Contents, groups_of

if TYPE_CHECKING:
    from pitchpoint.model.parts import Parts

SAME = math.sqrt(0.5)
"""Minimum cosine of the angle between two spin axes that are coupled by a torque."""
PARALLEL = 1.0 - 1e-9
NO_HOLD = ("free", "shaft")
"""Joint types without constraints."""
IDLE = {
    "bodies": ("position", "mass", "inertia", "transverse_inertia", "center_of_mass"),
    "joints": ("position", "start", "speed", "friction", "lead"),
}
"""Keys whose problems do not affect the kinematic tree and its axes."""
BODIES = ("bodies", "shafts", "elastic_bodies")


def check_signal_places(parts: Parts, report: Reader) -> None:
    """Check that sensors and actuators are compatible with the mechanism, as far as it is known."""
    whole = _tree_known(parts, report)
    for name, sensor in parts.sensors.items():
        at: Place = ("sensors", name)
        if isinstance(sensor, JointSensor):
            _joint_sensor(parts, at, sensor, report, whole)
        elif isinstance(sensor, LoadSensor):
            _load_sensor(parts, at, sensor, report, whole)
        elif isinstance(sensor, Listener):
            _listener(parts, at, sensor, report)
    for name, actuator in parts.actuators.items():
        if isinstance(actuator, TorqueActuator):
            _torque(parts, ("actuators", name, "bodies"), actuator, report, whole)


def _tree_known(parts: Parts, report: Reader) -> bool:
    """Whether all data of the kinematic tree could be read."""
    if not _all_read(parts, report, ("joints", *BODIES)) or parts.mechanism.floating:
        return False
    if any(parts.known(group) - set(getattr(parts, group)) for group in ("joints", *BODIES)):
        return False
    return all(p[2] in IDLE[str(p[0])] for p in report.tainted if p[0] in IDLE and len(p) > 2)


def _all_read(parts: Parts, report: Reader, groups: tuple[str, ...]) -> bool:
    """Whether the names of all parts of some sections are known: none of these sections is misspelled."""
    values = set(keys_of(Contents)) - set(GROUPS)
    broken = {str(p[0]) for p in report.tainted if len(p) == 1} - values
    lost = {word for word in broken if not parts.known(word)}
    return not any(word in groups or word not in GROUPS for word in lost)


def _joint_sensor(parts: Parts, at: Place, sensor: JointSensor, report: Reader, whole: bool) -> None:
    """Check the coordinate of a joint sensor; its use in the tree only if the tree is known."""
    found = coordinate(parts.mechanism, parts, sensor.coordinate) if whole else None
    if not whole and _names_nothing(parts, sensor.coordinate, report):
        found = coordinate(parts.mechanism, parts, sensor.coordinate)
    if isinstance(found, str):
        remedy = (
            coordinates_listed(parts) if whole else did_you_mean(*_meant(parts, sensor.coordinate)).strip()
        )
        report.problem((*at, "coordinate"), found, remedy=remedy or None)
    if found is None or isinstance(found, str):
        return
    seat = parts.mechanism.seats[found[0]]
    word = seat.coordinates[found[1]]
    tilts = "alpha" in seat.coordinates or "beta" in seat.coordinates
    quantity = ("angle", "angular_velocity", "angular_acceleration")[sensor.derivative]
    remedy = f"write {{type: frames, quantity: {quantity}, ends: [{found[0]}, {seat.end}]}}"
    if seat.kind == "user":
        report.problem(
            (*at, "coordinate"),
            f"names {sensor.coordinate}, whose joint is defined by functions",
            remedy="measure positions and angles between frames: type: frames",
        )
    elif tilts and word in ("alpha", "beta", "spin"):
        report.problem(
            (*at, "coordinate"),
            f"names {sensor.coordinate}, one of several rotations ({seat.kind}), which is not a plane angle",
            remedy=remedy,
        )


def _meant(parts: Parts, name: str) -> tuple[str, set[str]]:
    """The unknown part of a coordinate name, and the possible names."""
    part, dot, word = name.partition(".")
    if dot and part in parts.joints:
        return word, set(parts.joints[part].names)
    return part, parts.known("joints") if dot else _body_names(parts)


def _names_nothing(parts: Parts, name: str, report: Reader) -> bool:
    """Whether a coordinate does not exist, independent of the kinematic tree."""
    part, dot, word = name.partition(".")
    if not dot:
        return part not in _body_names(parts) and _all_read(parts, report, BODIES)
    if part not in parts.known("joints"):
        return _all_read(parts, report, ("joints",))
    doubtful = {p[2] for p in report.tainted if p[:2] == ("joints", part) and len(p) > 2}
    return (
        part in parts.joints
        and word not in parts.joints[part].names
        and doubtful <= {*IDLE["joints"], "bodies", "axes"}
    )


def _body_names(parts: Parts) -> set[str]:
    return {name for group in BODIES for name in parts.known(group)}


def _load_sensor(parts: Parts, at: Place, sensor: LoadSensor, report: Reader, whole: bool) -> None:
    body = split(sensor.at)[0]
    if body == GROUND:
        report.problem((*at, "at"), "is ground, which no joint carries", remedy="name a body")
        return
    if is_beam(parts, body):
        report.problem(
            (*at, "at"),
            f"names {sensor.at}, a station of a beam, which no joint carries",
            remedy="measure the force of a spring or bushing there: type: observation",
        )
        return
    seat = parts.mechanism.seats.get(body)
    if whole and seat is not None and seat.kind in NO_HOLD:
        how = f"the joint {seat.joint}" if seat.joint is not None else "its motion"
        report.problem(
            (*at, "at"),
            f"names {body}, which has no joint reaction: {how} leaves all directions free",
            remedy="measure the force of a bearing or spring: type: observation",
        )


def _listener(parts: Parts, at: Place, sensor: Listener, report: Reader) -> None:
    from pitchpoint.core.nomenclature import table

    where = (*at, "channel")
    match = re.fullmatch(r"(\w+)\[([^\[\]]+)\]", sensor.channel)
    if match is None:
        report.problem(
            where,
            f"{sensor.channel[:40]!r} is not an observation",
            remedy="write for example tension[SPRING]",
        )
        return
    if match[1] == "signal":
        report.problem(where, "is a signal", remedy="use the signal by its name")
        return
    if match[1] not in table():
        report.problem(
            where,
            f"{match[1][:40]!r} is not a quantity of results",
            remedy=did_you_mean(match[1], table()) + "the names are those of a result file",
        )
        return
    if not _all_read(parts, report, GROUPS):
        return
    known = {n for group in groups_of(parts) for n in parts.known(group)}
    whole, first = match[2], match[2].split(".")[0]
    if whole not in known and first not in known:
        report.problem(
            where,
            f"names {whole[:40]!r}, which does not exist",
            remedy=did_you_mean(first, known).strip() or None,
        )


def _torque(parts: Parts, at: Place, actuator: TorqueActuator, report: Reader, whole: bool) -> None:
    bodies = [split(end)[0] for end in actuator.bodies]
    if bodies[0] == GROUND:
        report.problem(at, "name ground first", remedy="name the driven body first")
        return
    for end in actuator.bodies:
        if is_beam(parts, split(end)[0]):
            report.problem(
                at,
                f"name {end}, a station of a beam, which has no spin axis",
                remedy="write {type: force, quantity: moment, ...} instead",
            )
            return
    if not whole or any(b != GROUND and b not in parts.mechanism.seats for b in bodies):
        return
    driven = coordinate(parts.mechanism, parts, bodies[0])
    if isinstance(driven, str):
        report.problem(at, driven, remedy="write {type: force, quantity: moment, ...} instead")
        return
    if len(bodies) == 1 or bodies[1] == GROUND:
        return
    one, two = (_spin_axis(parts, body) for body in bodies)
    along = abs(float(one @ two))
    carries = bodies[0] in parts.mechanism.carried_by(bodies[1])
    spins = not carries and not isinstance(coordinate(parts.mechanism, parts, bodies[1]), str)
    # a carrier, or a body without spin, takes the torque about any axis, except one nearly parallel
    if along < SAME if spins else SAME < along < PARALLEL:
        report.problem(
            at,
            f"are tilted by {math.degrees(math.acos(along)):.4g} deg: {bodies[0]} and {bodies[1]}",
            limit="45 deg" if spins else "0 deg, or above 45 deg",
            remedy=("" if carries else "let the reaction act on the body that carries the driven one, or ")
            + "write {type: force, quantity: moment, ...}",
        )


def _spin_axis(parts: Parts, body: str) -> Any:
    seat = parts.mechanism.seats[body]
    if seat.kind == "fixed":
        return axes_of(parts, body)[:, 2]
    return seat_frame(parts, seat)[1][:, 2]
