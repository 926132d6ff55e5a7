# SPDX-License-Identifier: Apache-2.0
"""Faults of teeth and seats together: each alone in the limit, sums to first order, power that closes."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system.compile import compile_model
from tests.invariants.test_eccentric_meshes import mesh_powers, mesh_wrenches
from tests.invariants.test_tangents import gears, pressed
from tests.support.machines import compiled
from tests.support.pressed_pair import turned_forces

#: Two faults each: of teeth of gear 1, and another one of either gear or of the axes.
PIT = {"position": 6e-3, "length": 5e-3, "height": 3e-3, "depth": 60e-6}
TEETH = {
    "broken": {"type": "broken_tooth", "tooth": 3, "at": "end", "width": 6e-3},
    "crack": {"type": "root_crack", "tooth": 3, "flank": "both", "depth": 2e-3, "length": 15e-3},
    "pits": {"type": "pitting", "tooth": 3, "flank": "both", "patches": [PIT]},
    "wear": {"type": "wear", "flank": "both", "depth": 4e-6},
}
OTHERS = {
    "eccentricity": ("gears.g1.faults.two", {"type": "eccentricity", "amount": 4e-6, "phase": 0.5}),
    "eccentric mate": ("gears.g2.faults.two", {"type": "eccentricity", "amount": 4e-6, "phase": 0.5}),
    "wobble": ("gears.g1.faults.two", {"type": "wobble", "amount": 2e-4, "phase": 0.5}),
    "misalignment": ("meshes.stage.misalignment", {"in_plane": 2e-4, "out_of_plane": -3e-4}),
    "pitch": ("gears.g1.faults.two", {"type": "pitch_error", "tooth": 3, "amount": 3e-6}),
}
BOTH = [
    ("broken", "eccentricity"),
    ("broken", "eccentric mate"),
    ("crack", "wobble"),
    ("pits", "misalignment"),
    ("wear", "pitch"),
]
every_pair_of_faults = pytest.mark.parametrize(("one", "two"), BOTH)
LAWS = {
    "linear": {"law": "din3990", "tip_relief_factor": 0.4},
    "hertz": {"law": "hertz", "force": 2e3, "depth": 10e-6, "tip_relief_factor": 0.4},
}
every_law = pytest.mark.parametrize("law", LAWS)
DEPTH = 12e-6
ANGLES = np.linspace(-1.5, 0.1, 213)
"""Gear 1 turns so that tooth 3, and some before and after it, come into contact."""


@lru_cache
def base(law, beta):
    hands = [f", helix_angle: {beta} deg, hand: {h}" if beta else "" for h in ("right", "left")]
    size = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    distance = float(1.5 * 62 / np.cos(np.radians(beta)) + 0.1)
    return loads_model(
        f"gears:\n  g1: {{number_of_teeth: 21, {size}{hands[0]}}}\n"
        f"  g2: {{number_of_teeth: 41, {size}{hands[1]}}}\n"
        "bodies: {driver: {gears: [g1]}, driven: {gears: [g2]}}\n"
        f"meshes: {{stage: {{gears: [g1, g2], center_distance: {distance!r} mm}}}}\n"
    ).replace("meshes.stage.stiffness", LAWS[law])


def tooth_fault(name, model):
    """A fault of gear 1; pits lie on its reference circle."""
    if name != "pits":
        return TEETH[name]
    return TEETH[name] | {"patches": [PIT | {"diameter": model.gears["g1"].geometry.d}]}


def scaled(fault, severity):
    """A fault with its severity; a misalignment has its angles scaled."""
    return (
        {k: severity * v for k, v in fault.items()} if "type" not in fault else fault | {"severity": severity}
    )


def forces(law, beta, one=None, two=None):
    """Forces over the roll with (name, severity) of a fault of a tooth and of another one."""
    changes = {}
    model = base(law, beta)
    if one is not None:
        changes["gears.g1.faults.one"] = scaled(tooth_fault(one[0], model), one[1])
    if two is not None:
        path, fault = OTHERS[two[0]]
        changes[path] = scaled(fault, two[1])
    return turned_forces(model.replace_all(changes) if changes else model, ANGLES, DEPTH)


@pytest.mark.each_value
@every_pair_of_faults
@every_law
def test_without_severity_one_fault_is_the_other_alone(one, two, law):
    """To the last bit: a faulty tooth without severity on an eccentric gear is the eccentric gear."""
    for beta in (0.0, 15.0):
        alone = forces(law, beta, two=(two, 1.0))
        assert np.array_equal(forces(law, beta, (one, 0.0), (two, 1.0)), alone)
        alone = forces(law, beta, (one, 1.0))
        assert np.array_equal(forces(law, beta, (one, 1.0), (two, 0.0)), alone)
        assert abs(forces(law, beta, (one, 1.0), (two, 1.0)) - alone).max() > 1e-4 * alone.max()


@pytest.mark.each_value
@every_pair_of_faults
@every_law
@pytest.mark.parametrize("beta", [0.0, 15.0])
def test_small_faults_add_up(one, two, law, beta):
    """What both do together is the sum of what each does, up to their product: halved, a quarter is left.
    Less for cracks and pits, whose effect grows faster than their severity."""
    healthy = forces(law, beta)
    left = []
    for severity in (0.6, 0.3) if one == "pits" else (0.2, 0.1):
        first, second, both = (
            forces(law, beta, a and (one, severity), b and (two, severity)) - healthy
            for a, b in ((True, None), (None, True), (True, True))
        )
        left.append(abs(both - first - second).sum())
        assert left[-1] < 0.15 * abs(first).sum()
    assert left[1] < 0.3 * left[0] + 1e-12 * healthy.sum()


@pytest.mark.parametrize("kind", ["external", "internal"])
@pytest.mark.parametrize("beta", [0, 20])
@every_pair_of_faults
@every_law
@pytest.mark.parametrize("flank", [1, -1])
def test_power_of_combined_faults_closes(kind, beta, one, two, law, flank):
    """Free, tilted, rolling bodies, every tooth faulty: what the gears do to their bodies is what energy and
    losses account for. Curved contact lines between stations leave 2e-5 of the powers, cells that slanted
    lines cross 1e-4, of wear, steep near base circles, 1e-3. Three points integrate x^1.5 to 1e-3."""
    losses = ", damping: {d_in: 2e4, d_out: 2e4}, damper: {value: 1e3}, friction: {mu: 0.08}"
    model = compiled(gears(kind, beta, "free", losses, "law: din3990"))[0]
    fault = tooth_fault(one, model)
    teeth = range(1 if one == "wear" else 23)
    own = {f"f{k}": fault | ({} if one == "wear" else {"tooth": k}) for k in teeth}
    path, other = OTHERS[two]
    model = model.replace_all({"gears.g1.faults": own, path.replace("stage", "m"): other})
    system = compile_model(model.replace("meshes.m.stiffness", LAWS[law]))
    state = pressed(system, np.random.default_rng(5), 300.0, flank, 1e-4)
    friction, damping, parametric, energy, stored = mesh_powers(system, state)
    assert energy > 0.0 and friction > 0.0
    F = mesh_wrenches(system, state)
    fr = system.workspace.fr
    power = sum(F[k] @ fr["tw"][k] for k in (1, 2))
    scale = abs(parametric) + abs(stored) + friction + abs(damping)
    slanted = {"broken": 2e-5, "crack": 1e-4, "pits": 1e-4, "wear": 1e-3}[one]
    most = 1e-3 if law == "hertz" else slanted if beta else 2e-5
    assert -power + parametric == pytest.approx(stored + friction + damping, abs=most * scale)
