# SPDX-License-Identifier: Apache-2.0
"""Faults of teeth against hand calculation: which tooth, which flank, how much of the force.

The teeth in contact are found from the angles of the teeth alone (`teeth_in_contact` of the flank
deviations); even pairs carry c' b x each.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest
from scipy.optimize import brentq

from pitchpoint.contact.stiffness.root_crack import crack_compliance
from pitchpoint.geometry.sliding import specific_sliding_at
from pitchpoint.geometry.tooth_form import tooth_form
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.solvers.time import solve_time
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.validation.test_flank_deviations import C_PRIME, WIDTH, machine, teeth_in_contact

DEPTH = 12e-6


def faults(text):
    return f", faults: {{{text}}}"


def pressed(system, model, angle1, depth=DEPTH, flank=1):
    """Results with flanks pressed by a depth; its middle lies where gear 1 has its flank at the angle."""
    pair = model.pairs["stage"]
    state = system.initial_state()
    travel = flank * (0.5 * model.backlash("stage") + depth)
    r1, r2 = 0.5 * pair.gear1.d_b, 0.5 * pair.gear2.d_b
    angle1 -= 0.25 * flank * model.backlash("stage") / r1
    for body, angle in (
        ("driver", angle1 + 0.5 * travel / r1),
        ("driven", -angle1 * r1 / r2 + 0.5 * travel / r2),
    ):
        k = system.spin(body)
        turns = round(angle / (2 * math.pi))
        state.q[k] = angle - 2 * math.pi * turns
        state.turns[system.layout.bodies.index(body)] = turns
    values = evaluate.observe(system, state)
    return {c.name: v for c, v in zip(system.layout.channels, values, strict=True)}


CASES = {
    "external": (24, False),
    "internal": (60, True),
}
every_case = pytest.mark.parametrize(("z2", "internal"), CASES.values(), ids=CASES)


@every_case
@pytest.mark.parametrize("gear", [0, 1])
def test_a_missing_tooth_carries_nothing_and_the_others_all_they_did(z2, internal, gear):
    """Spur gears with eps_alpha < 2, over a whole turn and more: where only the broken tooth would carry,
    contact is lost, elsewhere the other pair carries what it carried before."""
    text = faults("b: {type: broken_tooth, tooth: 4}")
    model = machine(21, z2, *((text, "") if gear == 0 else ("", text)), internal=internal)
    system = compile_model(model)
    assert 1.0 < model.pairs["stage"].eps_alpha < 2.0
    lost = kept = 0
    for angle in np.linspace(0.013, 2 * math.pi * (1.0 if gear == 0 else z2 / 21), 1000):
        pairs = teeth_in_contact(model, angle)
        carrying = [p for p in pairs if p[gear] != 4]
        found = pressed(system, model, angle)
        force = len(carrying) * C_PRIME * WIDTH * DEPTH
        assert found["mesh_force[stage]"] == pytest.approx(force, rel=1e-9), angle
        assert (found["contact_state[stage]"] == 0.0) == (not carrying)
        lost += not carrying
        kept += len(carrying) < len(pairs) and bool(carrying)
    assert lost >= 1 and kept >= 2


@every_case
@pytest.mark.parametrize("flank", [1, -1])
@pytest.mark.parametrize("beta", [0.0, 20.0])
def test_both_flanks_of_a_broken_tooth_are_gone(z2, internal, flank, beta):
    """On the back flank the same share of the mesh cycles is touched."""
    hands = (
        ", helix_angle: 20 deg, hand: right",
        f", helix_angle: 20 deg, hand: {'right' if internal else 'left'}",
    )
    more = hands if beta else ("", "")
    text = faults("b: {type: broken_tooth, tooth: 4}")
    systems = [
        (m, compile_model(m))
        for m in (machine(21, z2, more[0] + t, more[1], internal=internal, beta=beta) for t in ("", text))
    ]
    force = np.array(
        [
            [pressed(s, m, angle, flank=flank)["mesh_force[stage]"] for m, s in systems]
            for angle in np.arange(420) * 2 * math.pi / 420
        ]
    )
    # a tooth is in contact over eps_alpha + eps_beta pitches and takes away one pitch of 21 in the mean
    assert force[:, 1].mean() == pytest.approx(force[:, 0].mean() * 20 / 21, rel=2e-3)
    pair = systems[0][0].pairs["stage"]
    touched = np.mean(abs(force[:, 1] - force[:, 0]) > 1e-9 * abs(force).max())
    assert touched * 21 == pytest.approx(pair.eps_gamma, abs=0.11)


@pytest.mark.parametrize("at", ["start", "end"])
def test_a_broken_corner_is_missing_where_it_says(at):
    """A triangle of the face at the driver's tip: at a path position of height η from the tip the width
    w (1 - η/h) is missing, less the strip DEPTH/2 over the slope across the face."""
    text = faults(f"b: {{type: broken_tooth, tooth: 4, at: {at}, width: 12 mm, height: 4 mm, shape: corner}}")
    model = machine(21, 24, text)
    system = compile_model(model)
    pair = model.pairs["stage"]
    r_b, r_a = 0.5 * pair.gear1.d_b, 0.5 * pair.gear1.d_a
    seen = 0
    for angle in np.linspace(0.0, 2 * math.pi, 400):
        force = 0.0
        for tooth, _, xi in teeth_in_contact(model, angle):
            eta = r_a - math.hypot(r_b, pair.T1C + xi)
            across = math.hypot(1.0, 12e-3 / 4e-3)  # way along the face over distance from the edge
            missing = 12e-3 * (1.0 - eta / 4e-3) if tooth == 4 else 0.0
            if tooth == 4 and DEPTH * across < missing < WIDTH:
                missing -= 0.5 * DEPTH * across
                seen += 1
            elif tooth == 4 and missing > -DEPTH * across:
                break
            force += C_PRIME * DEPTH * (WIDTH - max(0.0, missing))
        else:
            # edges between stations of the grid are straight over the roll, not over the radius
            assert pressed(system, model, angle)["mesh_force[stage]"] == pytest.approx(force, rel=2e-5)
    assert seen > 5


@every_case
@pytest.mark.parametrize("gear", [0, 1])
@pytest.mark.parametrize("opens", [True, False])
def test_a_cracked_tooth_is_in_series_with_its_pair(z2, internal, gear, opens):
    """c/(1 + c q) with q at the place of contact; a crack that the load closes changes nothing. The front
    flanks of gear 1 and of an external wheel are left ones."""
    front = "right" if internal and gear else "left"
    flank = front if opens else {"left": "right", "right": "left"}[front]
    text = faults(f"b: {{type: root_crack, tooth: 4, flank: {flank}, depth: 1.5 mm, angle: 60 deg}}")
    model = machine(21, z2, *((text, "") if gear == 0 else ("", text)), internal=internal)
    system = compile_model(model)
    pair = model.pairs["stage"]
    form = tooth_form((pair.gear1, pair.gear2)[gear])
    steel = dict(angle=math.radians(60.0), beta=0.0, E=206e9, nu=0.3)
    seen = 0
    for angle in np.linspace(0.013, 2 * math.pi * (1.0 if gear == 0 else z2 / 21), 200):
        force = 0.0
        for tooth in teeth_in_contact(model, angle):
            q = 0.0
            if tooth[gear] == 4 and opens:
                rho = abs(pair.T1C + tooth[2] - (pair.T1T2 if gear else 0.0))
                span = rho + np.array([0.0, 1e-6])
                q = crack_compliance(form, span, np.array([1.5e-3]), **steel)[0, 0]
                seen += 1
            force += WIDTH * DEPTH / (1.0 / C_PRIME + q)
        # straight lines between 129 stations over the roll
        assert pressed(system, model, angle)["mesh_force[stage]"] == pytest.approx(force, rel=1e-4), angle
    assert seen > 5 or not opens


@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.0])
@pytest.mark.parametrize("gear", [0, 1])
def test_a_cracked_tooth_is_in_series_with_a_power_of_the_overlap(exponent, gear):
    """F = K (delta - C F)^e of a spur pair with C = q/b at the place of contact, by bisection on the force:
    the crack takes its share of the overlap whatever the law of the contact says."""
    text = faults("b: {type: root_crack, tooth: 4, flank: left, depth: 2 mm, angle: 60 deg}")
    model = machine(21, 24, *((text, "") if gear == 0 else ("", text)))
    law = {"law": "hertz", "force": 300.0, "depth": 1e-6, "exponent": exponent}
    model = model.replace("meshes.stage.stiffness", law)
    system = compile_model(model)
    pair = model.pairs["stage"]
    form = tooth_form((pair.gear1, pair.gear2)[gear])
    steel = dict(angle=math.radians(60.0), beta=0.0, E=206e9, nu=0.3)
    K = 300.0 / 1e-6**exponent
    least, seen = 1.0, 0
    for angle in np.linspace(0.013, 2 * math.pi * (1.0 if gear == 0 else 24 / 21), 150):
        force = whole = 0.0
        for tooth in teeth_in_contact(model, angle):
            C = 0.0
            if tooth[gear] == 4:
                rho = abs(pair.T1C + tooth[2] - (pair.T1T2 if gear else 0.0))
                span = rho + np.array([0.0, 1e-6])
                C = crack_compliance(form, span, np.array([2e-3]), **steel)[0, 0] / WIDTH
                seen += 1
            most = K * DEPTH**exponent
            force += brentq(lambda F, C=C: K * max(DEPTH - C * F, 0.0) ** exponent - F, 0.0, most, rtol=1e-13)
            whole += most
        # straight lines between 129 stations over the roll
        assert pressed(system, model, angle)["mesh_force[stage]"] == pytest.approx(force, rel=1e-4), angle
        least = min(least, force / whole)
    assert seen > 5 and least < 0.97


LAWS = {
    "hertz": "law: hertz",
    "din3990": "law: din3990, tip_relief_factor: 0.5",
    "low load": "law: din3990, low_load: true",
    "energy": "law: energy",
    "pair_table": "law: pair_table, single_stiffness: 14 N/(mm um), values: [0.6, 1, 0.9, 0.7]",
}


@every_case
@pytest.mark.parametrize("severity", [1.0, 0.6])
def test_a_spall_takes_the_pressure_where_it_is(z2, internal, severity):
    """Integral over the face of what the penetration is above an elliptic bowl. The grid has straight lines
    between eight cells across: up to 3 % of what the widest chord takes."""
    pit = "position: 8 mm, diameter: 63 mm, length: 5 mm, height: 1.2 mm, depth: 60 um"
    text = faults(f"b: {{type: pitting, tooth: 4, flank: left, patches: [{{{pit}}}], severity: {severity}}}")
    model = machine(21, z2, text, internal=internal)
    system = compile_model(model)
    pair = model.pairs["stage"]
    z = np.linspace(0.0, WIDTH, 200001)
    seen = 0
    for angle in np.linspace(0.013, 2 * math.pi, 500):
        force = lost = 0.0
        for tooth, _, xi in teeth_in_contact(model, angle):
            left = np.full(z.size, DEPTH)
            if tooth == 4:
                along = (math.hypot(0.5 * pair.gear1.d_b, pair.T1C + xi) - 31.5e-3) / 0.6e-3
                bowl = 60e-6 * (severity**2 - ((z - 8e-3) / 2.5e-3) ** 2 - along**2)
                left = np.maximum(0.0, DEPTH - np.maximum(0.0, bowl))
            force += C_PRIME * WIDTH * left.mean()
            lost += C_PRIME * WIDTH * (DEPTH - left.mean())
        found = pressed(system, model, angle)["mesh_force[stage]"]
        assert found == pytest.approx(force, abs=0.03 * C_PRIME * DEPTH * 5e-3), angle
        seen += lost > 0.04 * force
    assert seen >= 3


GEAR = "normal_module: 3 mm, face_width: 20 mm, helix_angle: 15 deg"
TEXT = """
gears:
  g1: {{number_of_teeth: 31, hand: right, bore_diameter: 30 mm, profile_shift_coefficient: 0, {gear}{one}}}
  g2: {{number_of_teeth: 42, hand: left, bore_diameter: 50 mm, {gear}{two}}}
bodies: {{driver: {{gears: [g1]}}, driven: {{gears: [g2]}}}}
meshes:
  stage: {{gears: [g1, g2], center_distance: 113.35 mm, stiffness: {{{law}}}}}
loads:
  input: {{body: driver, torque: balance}}
  brake: {{body: driven, torque: 200 N m}}
"""


@every_case
@pytest.mark.parametrize("gear", [0, 1])
def test_worn_flanks_lack_what_archard_takes(z2, internal, gear):
    """All teeth, by load share times specific sliding, worked out here; coefficient, cycles and torque give
    the scale. Near the jumps of the load share the grid has a slope of one station instead."""
    turns = dict(coefficient=4e-16, cycles=4e4, torque=60.0)
    text = "w: {type: wear, flank: both, coefficient: 4e-7 mm^3/(N m), cycles: 4e4, torque: 60 N m}"
    model = machine(21, z2, *((faults(text), "") if gear == 0 else ("", faults(text))), internal=internal)
    system = compile_model(model)
    pair = model.pairs["stage"]
    r_b = 0.5 * abs((pair.gear1, pair.gear2)[gear].d_b)
    scale = math.prod(turns.values()) / (r_b * WIDTH)
    eps, errors, worn = pair.eps_alpha, [], 0.0
    for angle in np.linspace(0.013, 1.0, 150):
        force = 0.0
        for *_, xi in teeth_in_contact(model, angle):
            p = (pair.T1C + xi - pair.T1A) / pair.p_et
            share = 1.0 / sum(0.0 <= p + q <= eps for q in (-2, -1, 0, 1, 2))
            depth = scale * share * abs(specific_sliding_at(pair, pair.T1C + xi)[gear])
            force += C_PRIME * WIDTH * max(0.0, DEPTH - depth)
            worn = max(worn, depth)
        errors.append(pressed(system, model, angle)["mesh_force[stage]"] / force - 1.0)
    assert 1e-7 < worn < DEPTH
    # a pinion in a ring touches near its base circle, where sliding over rolling is steep
    assert np.quantile(np.abs(errors), 0.7) < 1e-3


PITS = "{number: 9, length: 4 mm, height: 2 mm, depth: 60 um}"
MODEL_FAULTS = {
    "broken": "type: broken_tooth, tooth: 3",
    "corner": "type: broken_tooth, tooth: 3, width: 9 mm, height: 3 mm, shape: corner",
    "end": "type: broken_tooth, tooth: 3, width: 9 mm",
    "crack": "type: root_crack, tooth: 3, flank: both, depth: 2 mm, length: 15 mm",
    "pits": f"type: pitting, tooth: 3, flank: both, pattern: {PITS}",
    "wear": "type: wear, flank: both, depth: 8 um",
    "pitch": "type: pitch_error, tooth: 3, amount: 6 um",
}


@lru_cache
def error(one, law="din3990", two=""):
    model = loads_model(TEXT.format(gear=GEAR, one=one, two=two, law=LAWS[law]))
    data = solve_quasistatic(compile_model(model), "stage", 8, 31)
    return data["deflection[stage]"].values, model


@pytest.mark.parametrize("fault", MODEL_FAULTS)
def test_severity_0_is_a_healthy_gear(fault):
    """To the last bit; half of the severity makes a difference. All laws: `test_faults_of_all_laws`."""
    healthy, _ = error("", "pair_table")
    found, model = error(faults(f"b: {{{MODEL_FAULTS[fault]}, severity: 0}}"), "pair_table")
    assert np.array_equal(found, healthy)
    half = compile_model(model.replace("gears.g1.faults.b.severity", 0.5))
    bad = solve_quasistatic(half, "stage", 8, 31)["deflection[stage]"].values
    assert abs(bad - healthy).max() > 1e-9


@pytest.mark.parametrize("fault", ["end", "pitch", "wear"])
def test_little_damage_does_little(fault):
    """Twice the severity does twice as much, up to terms of the next order."""
    base = f"b: {{{MODEL_FAULTS[fault]}, severity: "
    healthy, _ = error("")
    change = []
    for severity in (0.02, 0.04):
        found, _ = error(faults(base + f"{severity}}}"))
        change.append(np.abs(found - healthy).sum())
    assert change[1] / change[0] == pytest.approx(2.0, rel=0.15)


@pytest.mark.parametrize("law", LAWS)
def test_a_pitch_error_is_that_of_the_deviations(law):
    """f_p = +a, -a of two pitches in a row puts one tooth a out of its place against all others; deviations
    count from the mean of all teeth, a/z cos(alpha_t) along the base tangent, which also moves the phase."""
    a, z = 6e-6, 31
    pitch = [0.0] * z
    pitch[3], pitch[4] = a, -a
    spur = TEXT.replace("113.35", "109.45").replace(", hand: right", "").replace(", hand: left", "")
    found = []
    for one in (
        faults("b: {type: pitch_error, tooth: 3, amount: 6 um}"),
        f", deviations: {{pitch: {pitch}}}",
    ):
        gear = "normal_module: 3 mm, face_width: 20 mm"
        model = loads_model(spur.format(gear=gear, one=one, two="", law=LAWS[law]))
        data = solve_quasistatic(compile_model(model), "stage", 6, 31)
        found.append(data["transmission_error[stage]"].values)
    offset = a / z * math.cos(model.gears["g1"].geometry.alpha_t)
    assert found[1] - found[0] == pytest.approx(offset, rel=3e-3)
    assert np.ptp(found[0]) > 1e-6


@pytest.mark.parametrize("fault", ["end", pytest.param("crack", marks=pytest.mark.study)])
def test_one_bad_tooth_gives_lines_at_the_shaft(fault):
    """A run at constant speed: between mesh harmonics the force has lines at all multiples of the frequency
    of the shaft with the bad tooth, where a healthy pair has next to nothing."""
    level = []
    for severity in (0, 1):
        bad = faults(f"b: {{{MODEL_FAULTS[fault]}, severity: {severity}}}")
        text = TEXT.format(gear=GEAR, one=bad, two="", law=LAWS["din3990"])
        text = text.replace("0.5}}\n", "0.5}, damper: {ratio: 0.1}}\n").replace(
            "  input: {body: driver, torque: balance}\n", ""
        )
        text += (
            "scenarios: {steady: {drive: {driver: {speed: 600 rpm}}, duration: 0.4 s, sample_rate: 10 kHz}}\n"
        )
        model = loads_model(text)
        data = solve_time(compile_model(model, model.scenarios["steady"]))
        force = data["mesh_force[stage]"].values[-2001:-1]  # two turns at 10 Hz
        spectrum = 2.0 * np.abs(np.fft.rfft(force)) / force.size
        level.append(spectrum[2 * np.arange(1, 31)])
    assert np.median(level[1]) > 20.0 * np.median(level[0])
    assert np.sum(level[1] > level[0]) >= 28


TRAIN = """
gears:
  a: {{number_of_teeth: 21, {gear}}}
  idler: {{number_of_teeth: 30, {gear}, faults: {{b: {{type: broken_tooth, tooth: 7, width: 9 mm}}}}}}
  c: {{number_of_teeth: {z}, {gear}{kind}}}
bodies: {{first: {{gears: [a]}}, middle: {{gears: [idler]}}, last: {{gears: [c]}}}}
meshes:
  in: {{gears: [a, idler], direction: 20 deg, {law}}}
  out: {{gears: [idler, c], direction: 75 deg, {law}}}
loads:
  input: {{body: first, torque: balance}}
  brake: {{body: last, torque: {torque} N m}}
"""


@pytest.mark.parametrize("internal", [pytest.param(False, marks=pytest.mark.study), True])
def test_a_tooth_of_an_idler_is_met_by_both_mates_where_it_stands(internal):
    """The flanks differ from healthy ones in either mesh just while tooth 7 points to that mate: in the mean
    of those places, which the path of contact spreads to both sides, within half a pitch."""
    text = TRAIN.format(
        gear="normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0",
        law="stiffness: {law: din3990, tip_relief_factor: 0.5}, backlash: {base_tangent: 50 um}",
        z=75 if internal else 40,
        kind=", type: internal" if internal else "",
        torque=-100 if internal else 100,
    )
    model = loads_model(text)
    bad, good = (
        solve_quasistatic(compile_model(m), "in", 12, 30)
        for m in (model, model.replace("gears.idler.faults.b.severity", 0))
    )
    tooth = model.phasing.tooth_angle["idler"] + 2 * math.pi * 7 / 30 + bad["angle[middle]"].values
    # a ring is met on the side away from its centre
    ring_side = math.radians(75.0 + (180.0 if internal else 0.0))
    for mesh, towards in (("in", math.radians(200.0)), ("out", ring_side)):
        name = f"deflection[{mesh}]"
        meets = abs(bad[name].values - good[name].values) > 1e-8
        away = np.angle(np.exp(1j * (tooth[meets] - towards)))
        assert 10 < meets.sum() < 30
        assert abs(away.mean()) < math.pi / 30, mesh
        assert abs(away).max() < 3.0 * math.pi / 30, mesh


def test_start_is_the_end_of_lowest_z():
    """A mate that stands 10 mm higher only meets the upper half of the face."""
    found = []
    for part in ("severity: 0", "at: start, width: 9 mm", "at: end, width: 9 mm"):
        text = TEXT.format(
            gear=GEAR, one=faults(f"b: {{type: broken_tooth, tooth: 3, {part}}}"), two="", law="law: din3990"
        )
        text = text.replace("gears: [g1]}", "gears: [g1], position: [0, 0, 0]}")
        text = text.replace("gears: [g2]}", "gears: {g2: 10 mm}, position: [113.35 mm, 0, 0]}")
        data = solve_quasistatic(compile_model(loads_model(text)), "stage", 4, 31)
        found.append(data["deflection[stage]"].values)
    assert found[1] == pytest.approx(found[0], rel=1e-9)
    assert abs(found[2] - found[0]).max() > 1e-7
