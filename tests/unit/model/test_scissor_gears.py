# SPDX-License-Identifier: Apache-2.0
"""Scissor gears: contact of both flanks against the closed form, on all kinds of bodies; what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.write import model_text
from pitchpoint.report.static_power import static_powers
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.solvers.modal import solve_modal
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model

SPRING, RATE, MESH = 5.0, 20.0, 4e8
PAIR = """
gears:
  pinion: {{number_of_teeth: 30, normal_module: 2 mm, face_width: 30 mm, {teeth}}}
  wheel: {{number_of_teeth: {z}, normal_module: 2 mm, face_width: 12 mm, {wheel}, bore_diameter: {bore}}}
bodies:
  input: {{gears: {{pinion: 3 mm}}, motion: torsion, position: [0, 0, 0]{axes}}}
{output}
scissor_gears:
  free: {{gear: wheel, face_width: 6 mm, torque: {torque} N m, stiffness: 20 N m/rad{more}}}
meshes:
  stage: {{gears: [pinion, wheel], backlash: {{circumferential: 0.1 mm}}, damper: {{ratio: 0.1}},
          stiffness: {{law: constant, value: 4e8 N/m}}{line}}}
loads:
  load: {{body: output, torque: {load} N m{place}}}
scenarios:
  held: {{hold: [input], duration: 1 ms}}
  turning: {{drive: {{input: {{speed: 60 rpm}}}}, duration: 20 ms, step: 10 us}}
"""
SPUR = "profile_shift_coefficient: 0"
RIGID = "  output: {gears: [wheel], motion: torsion}"
HUB = ", hub_stiffness: {radial: 1e9 N/m, axial: 1e9 N/m, tilt: 1e6 N m/rad}"
BEARINGS = """bearings:
  left: {body: output, position: [0, 0, 0], stiffness: {radial: 1e9 N/m, axial: 1e9 N/m}}
  right: {body: output, position: [0, 0, 80 mm], stiffness: {radial: 1e9 N/m}}"""
SHAFT = (
    "shafts:\n  output: {sections: [{length: 80 mm, diameter: 40 mm}], gears: {wheel: 40 mm}}\n" + BEARINGS
)
FREE = "  output: {gears: {wheel: 40 mm}, motion: free}\n" + BEARINGS


def text(
    load=0.0, torque=-SPRING, output=RIGID, z=45, teeth=SPUR, wheel=SPUR, axes="", more="", place="", line=""
):
    """Model file of a pinion that is held and a scissor gear under a load."""
    bore = "200 mm" if "internal" in wheel else "20 mm" if output == RIGID else "40 mm"
    return PAIR.format(
        load=load,
        torque=torque,
        output=output,
        z=z,
        teeth=teeth,
        wheel=wheel,
        axes=axes,
        more=more,
        place=place,
        bore=bore,
        line=line,
    )


def held(load, sense, **how):
    """Torques of both halves and of the spring [N m] under a load; the spring turns the free half backwards.

    With the base radius r, the mesh stiffness c and the forces F_1 = (L + T)/r, F_2 = T/r the halves are
    twisted by u = (j + (F_1 + F_2)/c)/r, and T = T_0 - k u. Without j if both are on the same flank.
    """
    model = loads_model(text(load=sense * load, torque=-sense * SPRING, **how))
    found = solve_equilibrium(compile_model(model, "held"))
    radius = 0.5 * abs(model.gears["wheel"].geometry.d_b)
    sag = RATE / (MESH * radius**2)
    gap = RATE * model.backlash("stage") / radius if load > -SPRING else 0.0
    spring = (SPRING - gap - sag * load) / (1.0 + 2.0 * sag)
    wanted = sense * (load + spring), -sense * spring, -sense * spring
    names = ("mesh_force[stage]", "mesh_force[stage-free]", "torque[free]")
    values = [float(np.ravel(found[name].values)[-1]) for name in names]
    lever = (
        radius * model.gears["wheel"].sign
    )  # the front flanks of an internal gear are driven the other way
    return (lever * values[0], lever * values[1], values[2]), wanted


HELICAL = "helix_angle: 20 deg, hand: {}, profile_shift_coefficient: 0"


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize(
    "how",
    [
        {},
        {"teeth": HELICAL.format("left"), "wheel": HELICAL.format("right")},
        {"wheel": f"{SPUR}, type: internal", "z": 80},
        {"axes": ", axes: {z: [0, 1, 0], x: [0, 0, 1]}"},
        {"output": FREE, "more": HUB},
        {"output": SHAFT, "more": HUB, "place": ", position: [0, 0, 40 mm]"},
    ],
    ids=["spur", "helical", "internal", "axis along y", "rigid 3-D", "elastic shaft"],
)
def test_both_flanks_are_closed_up_to_the_torque_of_the_spring(how, sense):
    """The spring turns the free half to one flank with T_0 - k j/r_b and the fixed half to the other one; the
    load L leaves the fixed half there while L > -(T_0 - k j/r_b). Beyond, it crosses the backlash.

    The tolerance in 3-D is the deflection of hub and bearings, a few um: k * 4 um/r_b = 2e-3 N m.
    """
    slack = 2e-3 if "more" in how else 1e-6
    for load in (0.0, 20.0, -4.5, -5.2):
        values, wanted = held(load, sense, **how)
        assert values == pytest.approx(wanted, abs=slack), load


def test_friction_and_stiffness_of_the_free_half():
    """A clutch between both halves, and a mesh of the free half that is softer than that of the fixed one."""
    more = ", friction: 2 N m, mesh_stiffness: {law: constant, value: 2e8 N/m}"
    run = solve_time(compile_model(loads_model(text(load=3.0, more=more)), "turning"))
    assert np.abs(run["torque[free-friction]"].values).max() <= 2.0
    assert float(run["mesh_stiffness[stage-free]"][-1]) == pytest.approx(2e8)
    assert float(run["mesh_stiffness[stage]"][-1]) == pytest.approx(4e8)


def test_a_run_keeps_both_flanks_in_contact():
    """Mean speed ratio, and contact states front and back at all times."""
    run = solve_time(compile_model(loads_model(text(load=3.0)), "turning"))
    front, back = run["contact_state[stage]"].values, run["contact_state[stage-free]"].values
    assert set(np.abs(front)) == {1.0} and np.array_equal(front, -back)
    assert float(run["speed[free]"][-1]) == pytest.approx(-math.tau * 30.0 / 45.0, rel=1e-3)


def test_a_model_is_written_with_its_section():
    model = loads_model(text())
    again = loads_model(model_text(model))
    assert again == model
    assert "stage-free" not in model_text(model)
    changed = model.replace("scissor_gears.free.torque", "-2 N m")
    assert changed.torsion_springs["free"].angle == pytest.approx(-0.1)
    with pytest.raises(
        ModelError, match=r"belongs to scissor_gears\.free; replace keys of scissor_gears\.free"
    ):
        model.replace("meshes.stage-free.backlash.circumferential", "1 mm")


def test_messages_are_on_the_key_that_is_wrong():
    for change, message in {
        ("gear: wheel,", "gear: wheal,"): r"scissor_gears\.free\.gear \(line 9\): .* did you mean wheel",
        ("-5.0 N m", "0 N m"): r"scissor_gears\.free\.torque .* is zero",
        ("free: {gear", "wheel: {gear"): r"scissor_gears\.wheel .* needs the name wheel",
        ("gear: wheel,", "gear: wheel, position: 30 mm,"): r"scissor_gears\.free\.position .* do not overlap",
        ("gear: wheel,", "gear: wheel, position: -8 mm,"): r"free\.position .* overlap wheel .* 9 mm",
        ("motion: torsion}", "motion: planar}"): r"scissor_gears\.free\.hub_stiffness .* is missing: output",
        ("[wheel], motion: torsion", "[wheel], motion: fixed"): r"scissor_gears\.free\.gear .* motion: fixed",
        ("gear: wheel,", "gear: wheel, hub_stiffness: {radial: 1},"): r"hub_stiffness .* has no effect",
    }.items():
        with pytest.raises(ModelError, match=message):
            loads_model(text().replace(*change))


def test_states_of_the_friction_have_no_kinetic_energy():
    """Bristles of the clutch between the halves are coordinates without mass; the bodies share the energy."""
    found = solve_modal(compile_model(loads_model(text(more=", friction: 2 N m")), "turning"))
    shares = found["kinetic_share"].sum("motion")
    assert np.all(shares.sel(part="free-friction.state") == 0.0)
    assert shares.sum("part").values == pytest.approx(1.0)


@pytest.mark.parametrize("sense", [1, -1])
def test_the_power_flow_contains_the_preload(sense):
    """Torques of balance with rigid teeth: T on the free half, L + T on the fixed one."""
    model = loads_model(text(load=sense * 3.0, torque=-sense * SPRING, more=", friction: 2 N m"))
    flow = static_powers(model)["turning"]
    gap = model.backlash("stage") / (0.5 * model.gears["wheel"].geometry.d_b)
    spring = SPRING - RATE * gap
    torques = [flow["links"][name]["torques"][1] for name in ("stage", "stage-free")]
    assert torques == pytest.approx([-sense * (3.0 + spring), sense * spring], rel=1e-9)
    powers = [row["power"] for row in flow["external"] if row["section"] != "torsion_springs"]
    assert sum(powers) == pytest.approx(0.0, abs=1e-9)
