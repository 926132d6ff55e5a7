# SPDX-License-Identifier: Apache-2.0
"""From model to mesh record: the same machine whichever of its coordinates are free."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.contact.compliance.pair import pair_slice
from pitchpoint.core.errors import SolverError
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.time import run_time
from pitchpoint.solvers.time_summary import Memory
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.contact_trains import planets
from tests.support.machines import compiled

PAIR = """\
gears:
  g1: {{number_of_teeth: 30, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0.1{helix}}}
  g2: {{number_of_teeth: 77, normal_module: 3 mm, face_width: 25 mm{other}}}
bodies:
  b1: {{gears: [g1], motion: {motion}, position: [0, 0, 0]}}
  b2: {{gears: {{g2: {shift} mm}}, position: [{a} mm, 0, 0]}}
meshes:
  stage: {{gears: [g1, g2], center_distance: {a} mm, stiffness: {law}}}
loads:
  in: {{body: b1, torque: 10 N m}}
  out: {{body: b2, torque: balance}}
"""
BEARING = "bearings:\n  s: {body: b1, stiffness: {radial: 1e15 N/m, axial: 1e15 N/m, tilt: 1e13 N m/rad}}\n"
LAWS = (
    "{law: constant, value: 1e8}",
    "{law: rectangular, high: 2e8, low: 1e8}",
    "{law: fourier, mean: 1e8, cosine: [0.1]}",
    "{law: table, values: [1e8, 2e8, 3e8]}",
    "{law: pair_table, single_stiffness: 1.4e10, values: [0.7, 1, 0.6]}",
    "{law: energy}",
    "{law: din3990, low_load: true}",
)


def machine(law: str, motion: str, *, internal: bool, helical: bool, shift: float = 0.0):
    helix = ", helix_angle: 15 deg, hand: right" if helical else ""
    other = helix if internal else helix.replace("right", "left")
    text = PAIR.format(
        helix=helix,
        other=other + (", type: internal" if internal else ""),
        motion=motion,
        shift=shift,
        a={(True, False): 70.5, (True, True): 73.0, (False, False): 161.0, (False, True): 166.5}[
            internal, helical
        ],
        law=law,
    )
    return compiled(text + (BEARING if motion == "free" else ""))[1]


@pytest.mark.parametrize("helical", [False, True])
@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("motion", ["torsion", "free"])
def test_every_law_carries_the_torque(law, internal, helical, motion):
    system = machine(law, motion, internal=internal, helical=helical)
    found = solve_equilibrium(system)
    r_b1 = system.records["gear_mesh"]["r_b1"][0]
    assert float(found["mesh_force[stage]"]) == pytest.approx(10.0 / r_b1, rel=1e-6)


@pytest.mark.parametrize("shift", [0.0, 5.0, -7.0])
@pytest.mark.parametrize("helical", [False, True])
@pytest.mark.parametrize("law", [LAWS[0], "{law: din3990}"])
def test_partly_overlapping_gears_touch_over_the_same_width(law, helical, shift):
    """Widths 20 and 25 mm about middles that are shifted; a body that can only spin has no other contact."""
    spins, all_six = (
        machine(law, motion, internal=False, helical=helical, shift=shift) for motion in ("torsion", "free")
    )
    one, six = (solve_equilibrium(system) for system in (spins, all_six))
    low, high = (spins.records["gear_mesh"]["now"][key][0] for key in ("z_lo", "z_hi"))
    assert high - low == pytest.approx(min(20e-3, 22.5e-3 - abs(shift) * 1e-3), abs=1e-12)
    for channel in ("transmission_error[stage]", "mesh_force[stage]"):
        assert float(one[channel]) == pytest.approx(float(six[channel]), rel=1e-6)


def test_a_users_stiffness_gets_the_time(tmp_path):
    """k = k_0 (1 + a t); what its growth feeds in is half of the square of the deflection times k_0 a."""
    (tmp_path / "law.py").write_text("def k(t, psi, p):\n    return p[0] * (1.0 + p[1] * t)\n")
    law = '{law: user, python: {python: "law.py:k", parameters: [1e8, 500]}}'
    text = PAIR.format(helix="", other="", motion="torsion", shift=0, a=161.0, law=law)
    scenario = "scenarios: {run: {speed: {b1: 100 rpm}, duration: 2 ms, settle_time: 0 s}}\n"
    (tmp_path / "m.yaml").write_text(text + scenario)
    system = compile_model(load_model(tmp_path / "m.yaml", allow_code=True), "run")
    memory = Memory()
    run_time(system, sink=memory)
    time, rows = np.concatenate(memory.times), np.concatenate(memory.rows)
    found = {
        name: rows[:, system.layout.channel(f"{name}[stage]")]
        for name in ("mesh_stiffness", "mesh_force", "parametric_power")
    }
    k = 1e8 * (1.0 + 500.0 * time)
    assert time[-1] == pytest.approx(2e-3)
    assert found["mesh_stiffness"] == pytest.approx(k, rel=1e-12)
    feed = 0.5 * (found["mesh_force"] / k) ** 2 * 1e8 * 500.0
    assert found["parametric_power"] == pytest.approx(feed, rel=1e-6)


def test_a_users_stiffness_that_fails_later_is_named_with_the_time(tmp_path):
    (tmp_path / "law.py").write_text(
        "from math import sqrt\n\n\ndef k(t, psi, p):\n    return p[0] * sqrt(1.0 - 1000.0 * t)\n"
    )
    law = '{law: user, python: {python: "law.py:k", parameters: [1e8]}}'
    text = PAIR.format(helix="", other="", motion="torsion", shift=0, a=161.0, law=law)
    (tmp_path / "m.yaml").write_text(text)
    system = compile_model(load_model(tmp_path / "m.yaml", allow_code=True))
    state = system.initial_state()
    evaluate.residual(system, state)
    state.t = 2e-3
    with pytest.raises(SolverError, match=r"k .*\(t = 0.002 s, x = "):
        evaluate.residual(system, state)


def test_equal_pairs_share_the_stiffness_of_their_flexible_teeth(monkeypatch):
    """Three planets with sun and ring: two kinds of pairs, each computed once and kept."""
    from pitchpoint.system.rules import flexible_teeth

    found = []

    def counted(pair, *rest):
        found.append(pair.gear2.z)
        return pair_slice(pair, *rest)

    flexible_teeth._shape_of.cache_clear()
    monkeypatch.setattr(flexible_teeth, "pair_slice", counted)
    text = planets(0.0)
    assert len(loads_model(text).meshes) == 6
    for _ in range(2):
        compile_model(loads_model(text))
    assert len(found) == len(set(found)) == 2
