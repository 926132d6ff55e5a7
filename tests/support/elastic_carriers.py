# SPDX-License-Identifier: Apache-2.0
"""Planetary stages whose carrier is an elastic body, and the same machines with the rigid carrier."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from pitchpoint.io.yaml_model import load_model
from pitchpoint.model.model import Model
from pitchpoint.multibody.beam_section import Beam, Section, rectangle, tube
from pitchpoint.multibody.structure import Member, Structure, beam_frame, make_structure
from tests.support.planet_stages import ARM, LAW, stage_file

STEEL = 2.1e11
HALF = 30e-3
"""Half of the distance of the walls [m]."""
PIN, WEB = tube(40e-3), rectangle(30e-3, 25e-3)
WALL, HUB = rectangle(40e-3, 20e-3), tube(60e-3)


def around(k: int, count: int, shift: float = 0.0, radius: float = ARM) -> tuple[float, float]:
    """Place k of `count` on a circle [m]."""
    psi = math.tau * (k + shift) / count
    return radius * math.cos(psi), radius * math.sin(psi)


def two_wall_carrier(
    E: float = STEEL, count: int = 3, wall: float = 1.0
) -> tuple[Structure, dict[str, tuple[float, float, float]]]:
    """Two walls of spokes, joined by pins and by webs between them, and shafts of 60 mm at both ends.

    `wall` is the stiffness of the spokes relative to E. Nodes: out, in, and p1 ... in the middle of the pins.
    """
    places: list[tuple[float, float, float]] = [(0, 0, -HALF), (0, 0, HALF), (0, 0, 90e-3), (0, 0, -60e-3)]
    members = [member(1, 2, HUB, E), member(0, 3, HUB, E)]
    nodes = {"out": places[2], "in": places[3]}
    for k in range(count):
        for shift, section in ((0.0, PIN), (0.5, WEB)):
            x, y = around(k, count, shift)
            first, aside = len(places), (-y, x, 0.0)
            steps = (-HALF, 0.0, HALF) if section is PIN else (-HALF, HALF)
            places += [(x, y, z) for z in steps]
            last = len(places) - 1
            members += [member(0, first, WALL, wall * E, aside), member(1, last, WALL, wall * E, aside)]
            members += [member(j, j + 1, section, E, aside) for j in range(first, last)]
            if section is PIN:
                nodes[f"p{k + 1}"] = places[first + 1]
    return beam_frame(places, members), nodes


def member(
    one: int, two: int, section: Section, E: float, axis: tuple[float, float, float] = (1.0, 0.0, 0.0)
) -> Member:
    """Beam of steel."""
    return Member((one, two), Beam(section=section, length=1.0, E=E, G=E / 2.6, rho=7850.0), axis)


def carrier_on_springs(
    stiffness: float, count: int = 3, mass: float = 1e-7
) -> tuple[Structure, dict[str, tuple[float, float, float]]]:
    """Rigid carrier of 10 kg with pins on springs along x and y; the mass of a pin [kg].

    Pins have no rotations: they tilt with the carrier.
    """
    places = [(0.0, 0.0, 0.0), *((*around(k, count), 0.0) for k in range(count))]
    n = 6 + 3 * count
    K, M = np.zeros((n, n)), np.diag([10.0] * 3 + [0.06, 0.06, 0.1] + [mass] * 3 * count)
    for k in range(count):
        rows = np.zeros((3, n))
        rows[:, 6 + 3 * k : 9 + 3 * k] = np.eye(3)
        rows[:, :3] = -np.eye(3)
        for d in range(3):
            rows[:, 3 + d] = -np.cross(np.eye(3)[d], places[1 + k])
        K += rows.T @ np.diag([stiffness, stiffness, 1e6 * stiffness]) @ rows
    node = [0] * 6 + [1 + k for k in range(count) for _ in range(3)]
    direction = [*range(6)] + [0, 1, 2] * count
    names = {"out": places[0]} | {f"p{k + 1}": places[1 + k] for k in range(count)}
    return make_structure(K, M, places, node, direction), names


def files(
    folder: Path,
    carrier: tuple[Structure, dict[str, tuple[float, float, float]]],
    more: str,
    modes: int = 30,
    mesh: str = LAW,
    bearing: float = 2e9,
    static_shapes: str = "true",
    **how: str | float,
) -> tuple[str, str]:
    """Texts of the models with the rigid and with the elastic carrier; writes the matrices.

    The carrier runs in bearings at its nodes out and in; the load is at out. `more` are keys of the stage.
    """
    structure, nodes = carrier
    np.savez(
        folder / "carrier.npz",
        K=structure.K.toarray(),
        M=structure.M.toarray(),
        places=structure.places,
        node=structure.node,
        direction=structure.direction,
    )
    marks = "".join(f"      {n}: {{position: {[float(v) for v in at]!r}}}\n" for n, at in nodes.items())
    text = stage_file(more, mesh=mesh, **how).replace("body: carrier, torque", "body: out, torque")
    line = next(row for row in text.splitlines() if row.startswith("  carrier: {inertia"))
    ends = [n for n in nodes if not n.startswith("p")]
    rows = "".join(
        f"  at_{n}: {{body: {n}, stiffness: {{radial: {bearing!r} N/m"
        + (f", axial: {bearing!r} N/m" if n == "out" else "")
        + (", tilt: 1e8 N m/rad}}\n" if len(ends) == 1 else "}}\n")
        for n in ends
    )
    text = text.replace("\nbearings:\n", f"\nbearings:\n{rows}") if "\nbearings:" in text else text
    text += "" if "\nbearings:" in text else f"bearings:\n{rows}"
    text += "joints:\n" + "".join(f"  on_{n}: {{type: fixed, bodies: [carrier.{n}, {n}]}}\n" for n in ends)
    journals = "".join(f"  {n}: {{mass: 0 kg}}\n" for n in ends)
    own = f"  carrier:\n{_rigid_body(structure)}    position: [0, 0, 0]\n    markers:\n{marks}"
    pins = ", ".join(n for n in nodes if n.startswith("p"))
    text = text.replace("    carrier: carrier\n", f"    carrier: carrier\n    pins: [{pins}]\n")
    rigid = text.replace(f"{line}\n", f"{own}    motion: free\n{journals}")
    elastic = text.replace(f"{line}\n", journals)
    elastic += (
        f"elastic_bodies:\n  carrier:\n    file: carrier.npz\n    rotor: true\n    modes: {modes}\n"
        f"    static_shapes: {static_shapes}\n    position: [0, 0, 0]\n    nodes:\n{marks}"
    )
    return rigid, elastic


def models(folder: Path, *args, **how) -> tuple[Model, Model]:
    """Models with the rigid and with the elastic carrier, see `files`."""
    found = []
    for name, text in zip(("rigid", "elastic"), files(folder, *args, **how), strict=True):
        file = folder / f"{name}.yaml"
        file.write_text(text, encoding="utf-8")
        found.append(load_model(file))
    return found[0], found[1]


def _rigid_body(structure: Structure) -> str:
    """Mass, centre of mass and inertia of a structure as keys of a body."""
    rigid = structure.rigid()
    whole = rigid.T @ (structure.M @ rigid)
    mass = float(whole[0, 0])
    x, y, z = (float(v) / mass for v in (whole[1, 5], -whole[0, 5], whole[0, 4]))
    arm = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    J = whole[3:, 3:] - mass * arm.T @ arm
    tensor = [float(J[a, b]) for a, b in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))]
    return f"    mass: {mass!r} kg\n    center_of_mass: {[x, y, z]!r}\n    inertia_tensor: {tensor!r}\n"
