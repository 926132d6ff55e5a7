# SPDX-License-Identifier: Apache-2.0
"""Modifications in the kernels of a mesh: penetration of the contact nodes, slopes, minimum gap."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.kernel import plain
from pitchpoint.elements.mesh.flank_modifications import modification
from pitchpoint.elements.mesh.surface.compliance import _height
from pitchpoint.elements.mesh.surface.nodes import ON_PATH
from pitchpoint.geometry.modifications import base_tangent, deviation, flank_range
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates

ONE = """
      left: {tip_relief: {amount: 20 um, length: 3.3 mm}, lead_crowning: 7 um, helix_slope: -9 um}
      right: {root_relief: {amount: 11 um, length: 2.7 mm, shape: parabolic}, profile_slope: 5 um}
"""
TWO = """
      left: {end_relief: {amount: 6 um, length: 3.1 mm}, profile_crowning: 4 um}
      right: {tip_relief: {amount: 15 um, length: 4.1 mm, shape: parabolic}, helix_slope: 3 um}
"""


def machine(internal: bool = False, beta: int = 0, more: str = "") -> FlankStates:
    """Pair with different modifications of all flanks."""
    hand = "left" if internal else "right"
    ring = "type: internal, " if internal else ""
    model = loads_model(f"""
gears:
  one:
    {{number_of_teeth: 23, normal_module: 3 mm, face_width: 21 mm, profile_shift_coefficient: 0.1,
    helix_angle: {beta} deg, hand: left{more}, modifications: {{{_flow(ONE)}}}}}
  two:
    {{{ring}number_of_teeth: 71, normal_module: 3 mm, face_width: 18 mm, profile_shift_coefficient: 0.1,
    helix_angle: {beta} deg, hand: {hand}, modifications: {{{_flow(TWO)}}}}}
meshes:
  stage:
    gears: [one, two]
    contact: {{level: rigid, stiffness: 3e8 N/m, planes: 7}}
""")
    return FlankStates(model, "stage")


def _flow(block: str) -> str:
    return ", ".join(line.strip() for line in block.strip().splitlines())


@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize(("internal", "beta"), [(False, 0), (False, 20), (True, 0), (True, 20)])
def test_penetration_of_nodes(internal: bool, beta: int, flank: int) -> None:
    """x_0 less both removed materials at the node, by their definitions; front flanks of rings are right."""
    flanks = machine(internal, beta)
    flanks.flank = flank
    states = flanks.states(np.arange(16) / 16)
    states["x_0"] = 200e-6  # all nodes are in contact
    nodes = flanks.solve(states, keep_nodes=True)
    assert nodes is not None
    node = nodes[np.arange(nodes.shape[1]) < states["n_nodes"][:, None]]
    node = node[node["place"] == ON_PATH]
    assert node.size > 100
    gaps = np.zeros(node.size)
    for k, name in enumerate(("one", "two")):
        gear = flanks.model.gears[name]
        side = "left" if (flank == 1) != (internal and k == 1) else "right"
        roll, z = np.abs(node["roll"][:, k]), node["z"]
        low, high = sorted(flank_range(gear.geometry))
        removed = deviation(
            gear.modifications.side(side).of_geometry(),
            gear.geometry,
            np.clip(roll, low, high),
            np.clip(z, -0.5 * gear.face_width, 0.5 * gear.face_width),
        )
        gaps += base_tangent(removed, gear.geometry)
    assert np.ptp(gaps) > 20e-6
    assert node["x"] == pytest.approx(200e-6 - gaps, abs=1e-15)


@pytest.mark.nojit
@pytest.mark.parametrize("internal", [False, True])
def test_slopes(internal: bool) -> None:
    """Slopes over width and signed length of roll against central differences of a smooth region."""
    flanks = machine(internal, 20)
    record, h = flanks.record, 1e-7
    for flank in (1, -1):
        record["now"]["flank"] = flank
        for gear in range(2):
            low, high = sorted(record["roll"][gear])
            sign = -1.0 if internal and gear == 1 else 1.0
            for share, z in ((0.05, -8e-3), (0.3, 2e-3), (0.6, 6.5e-3), (0.97, 8.2e-3)):
                roll = sign * (low + share * (high - low))
                _, by_z, by_roll = modification(record, gear, z, roll)
                over_z = [modification(record, gear, z + s * h, roll)[0] for s in (1, -1)]
                over_roll = [modification(record, gear, z, roll + s * h)[0] for s in (1, -1)]
                assert (over_z[0] - over_z[1]) / (2.0 * h) == pytest.approx(by_z, abs=1e-9)
                assert (over_roll[0] - over_roll[1]) / (2.0 * h) == pytest.approx(by_roll, abs=1e-9)


def test_constant_beyond_the_flank() -> None:
    record = machine().record
    record["now"]["flank"] = 1
    low, high = record["roll"][0]
    assert modification(record, 0, 1e-3, 1.1 * high)[2] == 0.0
    assert modification(record, 0, 1e-3, 1.1 * high)[0] == pytest.approx(
        modification(record, 0, 1e-3, high)[0], abs=1e-20
    )
    assert modification(record, 0, 1e-3, 0.9 * low)[2] == 0.0
    assert modification(record, 0, 0.1, 0.5 * (low + high))[1] == 0.0


def test_minimum_of_modifications_and_grids() -> None:
    """Sum of the minima of both gears; a pitch deviation of -10 um cos(alpha_t) lowers that of one gear."""
    plain = machine()
    assert plain.record["sep_min"] == pytest.approx(least(plain), abs=1e-12)
    pitch = ", ".join(["0"] * 11 + ["10 um", "-10 um"] + ["0"] * 10)
    moved = machine(more=f", deviations: {{pitch: [{pitch}]}}")
    steps = 10e-6 * np.cos(np.radians(20.0)) * np.array([1.0 - 1.0 / 23.0, 1.0 / 23.0])
    # a left flank displaced counter-clockwise is nearer to its mate, a right flank farther
    gears = flank_minima(plain)
    shifted = min(gears[0][0] - steps[0], gears[0][1] - steps[1]) + min(gears[1])
    assert moved.record["sep_min"] == pytest.approx(shifted, abs=1e-9)


def flank_minima(flanks: FlankStates) -> list[list[float]]:
    """Minimum gap of both flanks of both gears from fine samples."""
    found: list[list[float]] = []
    for name in ("one", "two"):
        gear = flanks.model.gears[name]
        z = np.linspace(-0.5, 0.5, 401)[:, None] * gear.face_width
        roll = np.linspace(*flank_range(gear.geometry), 401)
        found.append(
            [
                float(deviation(gear.modifications.side(side).of_geometry(), gear.geometry, roll, z).min())
                for side in ("left", "right")
            ]
        )
    return found


def least(flanks: FlankStates) -> float:
    """Sum of the minima of both gears."""
    return sum(min(gear) for gear in flank_minima(flanks))


BELOW = """
gears:
  one: {number_of_teeth: %d, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0%s}
  two: {number_of_teeth: %d, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0%s}
meshes:
  stage: {gears: [one, two], contact: {level: flexible, planes: 3}}
"""
CURVED = ", modifications: {both: {profile_crowning: 9 um, root_relief: {amount: 12 um, length: 2 mm}}}"
WORN = ", faults: {old: {type: wear, flank: both, depth: 20 um}}"


@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize("more", [CURVED, WORN], ids=["modifications", "wear"])
@pytest.mark.parametrize(("teeth", "ring"), [((12, 80), ""), ((80, 12), ""), ((17, 43), ", type: internal")])
def test_removed_material_is_constant_inside_the_base_circle(
    teeth: tuple[int, int], ring: str, more: str, flank: int
) -> None:
    """As beyond the root form circle, at which the flank ends; not that of the mirrored length of roll."""
    k = 1 if teeth[0] > teeth[1] else 0
    own = [more if gear == k else "" for gear in (0, 1)]
    flanks = FlankStates(loads_model(BELOW % (teeth[0], own[0], teeth[1], own[1] + ring)), "stage", flank)
    states = flanks.states(np.arange(64) / 64)
    states["x_0"] = 100e-6
    nodes = flanks.solve(states, keep_nodes=True)
    assert nodes is not None
    node = nodes[np.arange(nodes.shape[1]) < states["n_nodes"][:, None]]
    inside = (node["place"] == ON_PATH) & (node["roll"][:, k] < 0.0)
    gaps = 100e-6 - node["x"][inside]
    # with folded lengths of roll these would be on the flank
    gear = flanks.model.gears[("one", "two")[k]].geometry
    low = flank_range(gear)[0]
    assert np.sum(-node["roll"][inside, k] > low + 0.3e-3) > 5
    assert gaps == pytest.approx(np.full(gaps.size, gaps[0]), abs=1e-15)
    if more == CURVED:
        removed = float(base_tangent(21e-6, gear))
        assert gaps[0] == pytest.approx(removed, rel=1e-12)
    else:
        assert gaps[0] > 1e-6


def test_heights_end_at_the_root_inside_the_base_circle() -> None:
    """Compliances of flexible teeth are those of the root end of the involute."""
    flanks = FlankStates(loads_model(BELOW % (12, "", 80, "")), "stage")
    assert plain(_height)(flanks.record, 0, -1.9e-3) == (-1.0, 0.0)
    ring = FlankStates(loads_model(BELOW % (17, "", 43, ", type: internal")), "stage")
    middle, half = ring.record["height"][1]
    assert plain(_height)(ring.record, 1, -middle) == (0.0, pytest.approx(-1.0 / half))
