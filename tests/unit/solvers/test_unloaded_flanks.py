# SPDX-License-Identifier: Apache-2.0
"""Modes without load: every mesh is taken at the flank that a small torque through the train presses."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.solvers.modal import find_modes
from tests.support.machines import compiled

TEETH = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
MESH = "stiffness: {law: constant, value: 3e8 N/m}, backlash: {base_tangent: 0.05 mm}"


def train(order: str, loads: str = "") -> str:
    """Driver, idler and wheel around a corner, all on radial bearings; `order` lists the second mesh."""
    gears = "".join(
        f"  {n}: {{number_of_teeth: {z}, {TEETH}}}\n" for n, z in (("a", 20), ("b", 25), ("c", 30))
    )
    bodies = "".join(
        f"  {n.upper()}: {{gears: [{n}], motion: planar, mass: {m} kg, inertia: {j} kg m^2{place}}}\n"
        for n, m, j, place in (
            ("a", 2, 1e-3, ", position: [0, 0, 0]"),
            ("b", 3, 2e-3, ""),
            ("c", 4, 4e-3, ""),
        )
    )
    bearings = "".join(f"  s{n}: {{body: {n}, stiffness: {{radial: 4e7 N/m}}}}\n" for n in "ABC")
    return (
        f"gears:\n{gears}bodies:\n{bodies}meshes:\n  ab: {{gears: [a, b], direction: 0 deg, {MESH}}}\n"
        f"  bc: {{gears: {order}, direction: {DIRECTION[order]}, {MESH}}}\nbearings:\n{bearings}{loads}"
    )


DIRECTION = {"[b, c]": "70 deg", "[c, b]": "250 deg"}


def loaded(torque: float) -> str:
    """A small torque through the train, in at A and out at C."""
    return f"loads:\n  i: {{body: A, torque: {torque} N m}}\n  o: {{body: C, torque: balance}}\n"


@pytest.mark.parametrize("order", ["[b, c]", "[c, b]"])
def test_an_idler_train_without_load_vibrates_as_under_a_small_torque(order):
    """One of the two states that a torque makes, not a third one."""
    free = find_modes(compiled(train(order))[1])
    states = [find_modes(compiled(train(order, loaded(t)))[1]).frequency for t in (1e-3, -1e-3)]
    assert not np.allclose(states[0][1:], states[1][1:], rtol=1e-3)
    contact = min(np.abs(free.frequency[1:] / state[1:] - 1.0).max() for state in states)
    assert contact < 1e-6


def test_the_note_names_the_flanks():
    notes = " ".join(find_modes(compiled(train("[b, c]"))[1]).notes)
    assert "assumed at the front of ab and the back of bc, as for a small torque through the train" in notes
