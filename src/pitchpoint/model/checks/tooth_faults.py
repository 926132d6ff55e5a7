# SPDX-License-Identifier: Apache-2.0
"""Checks of tooth faults: tooth numbers, sizes, stiffness laws of the whole mesh."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from pitchpoint.core.errors import Message
from pitchpoint.model.components.bevel_gear import BevelGear
from pitchpoint.model.components.gear_faults import Eccentricity
from pitchpoint.model.components.stiffness import BEVEL_LAWS, OF_PAIRS
from pitchpoint.model.components.tooth_faults import (
    BrokenBevelTooth,
    BrokenTooth,
    PitchError,
    Pitting,
    RootCrack,
    Wear,
)
from pitchpoint.model.keys import Place
from pitchpoint.model.reading.reader import Reader

if TYPE_CHECKING:
    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.mesh import Mesh
    from pitchpoint.model.parts import Parts


def check_faults(gear: Gear | BevelGear, at: Place, report: Reader) -> None:
    """Report faults that are impossible on the teeth of a gear."""
    for label, fault in gear.faults.items():
        here = (*at, label)
        tooth = getattr(fault, "tooth", 0)
        if tooth >= gear.number_of_teeth:
            report.problem(
                (*here, "tooth"),
                "is not a tooth of this gear",
                value=str(tooth),
                limit=f"<= {gear.number_of_teeth - 1}",
                remedy="count from 0",
                taint=False,
            )
        for problem in _problems(gear, fault):
            report.hand_on(here, problem, taint=False)


def _problems(gear: Gear | BevelGear, fault: object) -> list[Message]:
    from pitchpoint.geometry.modifications import size_problems
    from pitchpoint.geometry.tooth_faults import wider_than_face

    if isinstance(fault, BrokenBevelTooth):
        return wider_than_face(fault.width or 0.0, gear.face_width)
    if isinstance(fault, PitchError):
        return size_problems({"amount": fault.amount}, gear.geometry)
    return [] if isinstance(gear, BevelGear) else _cylindrical(gear, fault)


def _cylindrical(gear: Gear, fault: object) -> list[Message]:
    from pitchpoint.geometry.modifications import size_problems
    from pitchpoint.geometry.tooth_faults import break_problems

    if isinstance(fault, BrokenTooth):
        return break_problems(fault.width or 0.0, fault.height or 0.0, gear.geometry)
    if isinstance(fault, RootCrack):
        return _crack_problems(gear, fault)
    if isinstance(fault, Pitting):
        return _pit_problems(gear, fault)
    if isinstance(fault, Wear):
        return _wear_problems(gear, fault)
    if isinstance(fault, Eccentricity):
        return size_problems({"amount": fault.amount}, gear.geometry)
    return []


def _crack_problems(gear: Gear, crack: RootCrack) -> list[Message]:
    from pitchpoint.contact.stiffness.root_crack import largest_crack
    from pitchpoint.geometry.tooth_form import tooth_form

    most = largest_crack(tooth_form(gear.geometry), crack.angle)
    found = []
    if crack.depth > most:
        found.append(
            Message(
                "depth",
                "goes beyond the centre line of the tooth",
                f"{1e3 * crack.depth:.6g} mm",
                f"{1e3 * most:.6g} mm",
                "reduce it, or use broken_tooth for a missing tooth",
            )
        )
    if crack.length is not None and crack.length > gear.face_width:
        found.append(
            Message(
                "length",
                "exceeds the face width",
                f"{1e3 * crack.length:.6g} mm",
                f"{1e3 * gear.face_width:.6g} mm",
                "remove it for the whole face",
            )
        )
    return found


def _pit_problems(gear: Gear, fault: Pitting) -> list[Message]:
    from pitchpoint.geometry.pits import Patch, patch_problems

    if bool(fault.patches) == (fault.pattern is not None):
        both = "cannot be combined with pattern" if fault.patches else "is missing, and pattern too"
        return [Message("patches", both, remedy="give one of them")]
    shape = gear.geometry
    if fault.pattern is not None:
        # the smallest possible pits, at the diameter where they cover the shortest roll length
        size = {name: 0.5 * getattr(fault.pattern, name) for name in ("length", "height", "depth")}
        outer = max(abs(shape.d_Ff), abs(shape.d_Fa))
        least = Patch(position=0.0, diameter=outer, **size)
        return [_doubled(problem) for problem in patch_problems(least, shape, "pattern")]
    found = []
    for k, patch in enumerate(fault.on(shape)):
        found += patch_problems(patch, shape, f"patches.{k}")
    return found


def _doubled(problem: Message) -> Message:
    return problem.changed(text=f"of the smallest random pit {problem.text}")


def _wear_problems(gear: Gear, wear: Wear) -> list[Message]:
    from pitchpoint.geometry.modifications import size_problems

    work = [getattr(wear, name) for name in ("coefficient", "cycles", "torque")]
    if wear.depth is not None and work == [None] * 3:
        return size_problems({"depth": wear.depth}, gear.geometry)
    if wear.depth is None and None not in work:
        return []
    remedy = "give either depth, or all of coefficient, cycles and torque"
    return [Message("depth", "does not define the wear uniquely", remedy=remedy)]


def check_fault_laws(parts: Parts, report: Reader) -> None:
    """Report tooth faults in meshes whose stiffness law describes the whole mesh."""
    for section in ("meshes", "bevel_meshes"):
        for name, mesh in getattr(parts, section).items():
            if not mesh.law.of_pairs and (section, name, "stiffness") not in report.tainted:
                _without_teeth(parts, section, name, mesh, report)


def _without_teeth(parts: Parts, section: str, name: str, mesh: Mesh | BevelMesh, report: Reader) -> None:
    """Report the tooth faults of the gears of a mesh."""
    gears: Mapping[str, Gear | BevelGear] = parts.gears if section == "meshes" else parts.bevel_gears
    laws = OF_PAIRS if section == "meshes" else [law for law in BEVEL_LAWS if law in OF_PAIRS]
    for gear in mesh.gears:
        for label in gears[gear].tooth_faults if gear in gears else ():
            report.problem(
                ("gears" if section == "meshes" else "bevel_gears", gear, "faults", label),
                f"has no effect in the mesh {name}, whose law {mesh.law.law} describes the whole mesh, "
                "not single teeth",
                remedy=f"use {'one of ' if len(laws) > 1 else ''}{', '.join(laws)} there",
                taint=False,
            )
