# SPDX-License-Identifier: Apache-2.0
"""Keys without effect beside others are said aloud, and the results show that they have none."""

from __future__ import annotations

import re
import warnings

import numpy as np
import pytest

from pitchpoint.core.errors import ValidityWarning
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import jumping_ramps, warn_of_remarks
from pitchpoint.model.remarks.keys_without_effect import keys_without_effect
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

TEXT = """
gears:
  a: {{number_of_teeth: 24, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{a}}}
  b: {{number_of_teeth: 36, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0{b}}}
bodies:
  one: {{gears: [a], motion: {motion}{one}}}
  two: {{gears: [b], motion: {motion}}}
meshes:
  s: {{gears: [a, b], backlash: {{normal: 20 um}}, stiffness: {law}{mesh}}}
{rest}
"""
PARTS = {"a": "", "b": "", "motion": "torsion", "one": "", "law": "{law: din3990}", "mesh": "", "rest": ""}
CONSTANT = "{law: constant, value: 4e8}"
BLANK = ", rim_thickness: 4 mm, web_thickness: 5 mm"
GIVEN = ", inertia: 0.003"
PRESCRIBED = (
    CONSTANT,
    "{law: fourier, mean: 4e8, cosine: [0.1]}",
    "{law: table, values: [3e8, 4e8]}",
    "{law: rectangular, high: 4e8, low: 3e8}",
)


def model_of(**parts: str):
    return loads_model(TEXT.format(**(PARTS | parts)))


def sentences(**parts: str) -> tuple[str, ...]:
    return keys_without_effect(model_of(**parts))


def forces(**parts: str) -> np.ndarray:
    """Residual of a pressed, vibrating mesh with the gears at their places, without unit and sign."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)
        system = compile_model(model_of(**parts))
    state = system.initial_state()
    rng = np.random.default_rng(5)
    state.q[system.spin("one")], state.v[system.spin("one")] = 1e-3, 100.0
    state.v[system.spin("two")] = -60.0
    state.v[:] += 1e-2 * rng.standard_normal(state.v.size)
    return evaluate.residual(system, state)


# (what is idle, the model without it, the key that the sentence names): both give the same forces
SAME = {
    "slices": ({"mesh": ", slices: 51"}, {}, "meshes.s.slices"),
    "width": ({"law": CONSTANT, "mesh": ", width: slices"}, {"law": CONSTANT}, "meshes.s.width"),
    "virtual_teeth": (
        {"law": "{law: din3990, single_stiffness: 14e9, virtual_teeth: cos3}"},
        {"law": "{law: din3990, single_stiffness: 14e9}"},
        "meshes.s.stiffness.virtual_teeth",
    ),
    "damping.law": (
        {"mesh": ", damping: {d_in: 1e4, s_0: 0, law: smooth}"},
        {"mesh": ", damping: {d_in: 1e4, s_0: 0}"},
        "meshes.s.damping.law",
    ),
    "diameter beside force": (
        {"law": "{law: hertz, force: 1 kN, depth: 5 um, diameter: operating}"},
        {"law": "{law: hertz, force: 1 kN, depth: 5 um}"},
        "meshes.s.stiffness.diameter",
    ),
    "friction.static": (
        {"mesh": ", friction: {mu: 0, static: 0.1, static_speed: 1 mm/s}"},
        {"mesh": ", friction: {mu: 0}"},
        "meshes.s.friction.static",
    ),
    "tip_alteration": (
        {"a": ", tip_diameter: 77.5 mm, tip_alteration: 0.2 mm"},
        {"a": ", tip_diameter: 77.5 mm"},
        "gears.a.tip_alteration",
    ),
    "a rim alone": ({"a": ", rim_thickness: 4 mm"}, {}, "gears.a.rim_thickness"),
    "a blank beside inertia": (
        {"a": BLANK, "law": CONSTANT, "one": GIVEN},
        {"law": CONSTANT, "one": GIVEN},
        "gears.a.rim_thickness and web_thickness",
    ),
    "a blank with energy": (
        {"a": BLANK, "law": "{law: energy}", "one": GIVEN},
        {"law": "{law: energy}", "one": GIVEN},
        "gears.a.rim_thickness and web_thickness",
    ),
    "a blank with c'": (
        {"a": BLANK, "law": "{law: din3990, single_stiffness: 14e9}", "one": GIVEN},
        {"law": "{law: din3990, single_stiffness: 14e9}", "one": GIVEN},
        "gears.a.rim_thickness and web_thickness",
    ),
    "polar_inertia": ({"a": ", polar_inertia: 5", "one": GIVEN}, {"one": GIVEN}, "gears.a.polar_inertia"),
    "a bearing of radial stiffness": (
        {"rest": "bearings: {c: {body: one, stiffness: {radial: 1e8, tilt: 1e5, axial: 1e7}}}"},
        {},
        "bearings.c",
    ),
    "an axial bearing of a planar body": (
        {"motion": "planar", "rest": "bearings: {c: {body: one, stiffness: {axial: 1e8, tilt: 1e5}}}"},
        {"motion": "planar"},
        "bearings.c",
    ),
    "a rolling bearing": (
        {"rest": "rolling_bearings: {c: {body: one, designation: 6205}}"},
        {},
        "rolling_bearings.c",
    ),
    "a plain bearing": (
        {"rest": "plain_bearings: {c: {body: one, clearance: 0.1 mm, stiffness: 1e8}}"},
        {},
        "plain_bearings.c",
    ),
    "a radial coupling": (
        {"rest": "couplings: {c: {bodies: [one, two], stiffness: {radial: 1e8}}}"},
        {},
        "couplings.c",
    ),
    "the place of a torque": (
        {"rest": "loads: {t: {body: one, torque: 5, position: [0, 0, 10 mm]}}"},
        {"rest": "loads: {t: {body: one, torque: 5}}"},
        "loads.t.position",
    ),
    "an axial force": (
        {"motion": "planar", "rest": "loads: {t: {body: one, force: [5, 0, 9]}}"},
        {"motion": "planar", "rest": "loads: {t: {body: one, force: [5, 0, 0]}}"},
        "loads.t.force",
    ),
}


@pytest.mark.parametrize(
    ("bearing", "loaded"),
    [
        ("designation: 6205", False),
        ("designation: 6205, clearance: -20 um", True),
        ("designation: 30205, axial_force_absorption: positive, preload: 300 N", True),
        ("designation: 30205, axial_force_absorption: positive, preload_distance: 5 um", True),
    ],
)
def test_a_preloaded_bearing_of_a_fixed_axis_has_a_force(bearing: str, loaded: bool) -> None:
    """It has no effect on the motion, but its preload (of elements around it, for a negative clearance)."""
    model = model_of(rest=f"rolling_bearings: {{c: {{body: one, {bearing}}}}}")
    (found,) = keys_without_effect(model)
    assert found.where == "rolling_bearings.c"
    assert found.text.startswith("has no effect: " if loaded else "has no effect and no force at any load: ")


@pytest.mark.parametrize("name", SAME)
def test_keys_without_effect_are_named_and_have_none(name: str) -> None:
    idle, without, where = SAME[name]
    (found,) = sentences(**idle)
    assert (found.where, found.kind) == (where, "remark")
    assert "no effect" in found.text
    assert sentences(**without) == ()
    np.testing.assert_array_equal(forces(**idle), forces(**without))
    with pytest.warns(ValidityWarning, match=re.escape(found.text)):
        warn_of_remarks(model_of(**idle))


# near the same keys, with an effect
ACTIVE = {
    "slices of slices": ({"mesh": ", width: slices, slices: 51"}, {"mesh": ", width: slices"}),
    "a blank by the standard": ({"a": BLANK, "one": GIVEN}, {"one": GIVEN}),
    "a blank that weighs": ({"a": BLANK, "law": CONSTANT}, {"law": CONSTANT}),
    "a bearing against rotation": (
        {"rest": "bearings: {c: {body: one, stiffness: {torsion: 1e5}}}"},
        {},
    ),
    "a bearing of a planar body": (
        {
            "motion": "planar",
            "rest": "bearings: {c: {body: one, stiffness: {radial: 1e8}, damping: {x: 10}}}",
        },
        {"motion": "planar"},
    ),
    "a plain bearing of a planar body": (
        {"motion": "planar", "rest": "plain_bearings: {c: {body: one, clearance: 1 um, stiffness: 1e8}}"},
        None,
    ),
    "virtual_teeth": ({"law": "{law: din3990, virtual_teeth: cos3}"}, None),
    "rim of a ring": ({"b": ", type: internal, rim_thickness: 20 mm, tip_diameter: 104 mm"}, None),
}


@pytest.mark.parametrize("name", ACTIVE)
def test_keys_with_effect_are_not_named(name: str) -> None:
    active, without = ACTIVE[name]
    assert sentences(**active) == ()
    if without is not None and "slices" not in name and "weighs" not in name:
        assert not np.array_equal(forces(**active), forces(**without))


@pytest.mark.parametrize("law", PRESCRIBED)
@pytest.mark.parametrize("motion", ["torsion", "planar", "free"])
def test_friction_of_a_prescribed_stiffness_is_said_to_act_at_the_pitch_point(law: str, motion: str) -> None:
    friction = ", friction: {mu: 0.1, v_eps: 1e-9}"
    (text,) = sentences(law=law, mesh=friction, motion=motion)
    assert text.startswith("meshes.s.friction: the law ")
    assert "acts only on vibration and lateral motion" in text
    assert sentences(law=law, motion=motion) == ()
    assert sentences(law=law, mesh=", friction: {mu: 0}", motion=motion) == ()


def test_rolling_teeth_of_a_prescribed_stiffness_do_not_slide() -> None:
    def power(law: str, vibration: float) -> float:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)
            system = compile_model(model_of(law=law, mesh=", friction: {mu: 0.1, v_eps: 1e-6}"))
        state = system.initial_state()
        state.q[system.spin("one")] = 1e-3
        state.v[system.spin("one")], state.v[system.spin("two")] = 100.0 + vibration, -100.0 * 24 / 36
        return evaluate.observe(system, state)[system.layout.channel("friction_power[s]")]

    assert power(CONSTANT, 0.0) == pytest.approx(0.0, abs=1e-9)
    assert power(CONSTANT, 0.5) > 0.1
    assert power("{law: din3990}", 0.0) > 10.0


@pytest.mark.parametrize("contact", ["flexible, body: ring", "flexible, teeth: finite_elements", "rigid"])
def test_a_rim_alone_has_no_effect_on_the_contact_of_flanks(contact: str) -> None:
    text = TEXT.replace("stiffness: {law}", f"contact: {{{{level: {contact}}}}}")
    (remark,) = keys_without_effect(loads_model(text.format(**(PARTS | {"a": ", rim_thickness: 4 mm"}))))
    assert remark.startswith("gears.a.rim_thickness: has no effect without web_thickness")
    assert keys_without_effect(loads_model(text.format(**(PARTS | {"a": BLANK})))) == ()


def test_energy_leaves_the_blank_to_the_inertia() -> None:
    (text,) = sentences(a=BLANK, law="{law: energy}")
    assert "only the inertia does" in text


SCENARIO = "scenarios: {{x: {{{}}}}}"
SWEEP = "sweep: {body: one, speed: [100, 200]}"
ROLL = "quasi_static: {points: 10}"


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        (f"method: rk4, speed: {{one: 150}}, {SWEEP}", "method and speed have no effect with sweep"),
        (f"tolerance: 1e-5, {ROLL}", "tolerance has no effect with quasi_static"),
        (f"step: 1e-5, settle_time: 0.1, {ROLL}", "settle_time and step have no effect with quasi_static"),
        ("duration: 1, tolerance: 1e-5", "tolerance: has no effect with method: generalized_alpha"),
        ("duration: 1, method: rk4, tolerance: 1e-5", "tolerance: has no effect with method: rk4"),
        ("duration: 1, method: constant_bdf, tolerance: 1e-5", "tolerance: has no effect with method: c"),
        ("duration: 1, method: rk4, form: SI2", "form: has no effect with method: rk4"),
        ("duration: 1, order: 3", "order: has no effect with method: generalized_alpha"),
        (f"order: 3, form: SI2, {ROLL}", "form and order have no effect with quasi_static"),
    ],
)
def test_keys_that_a_scenario_does_not_read(keys: str, words: str) -> None:
    (text,) = sentences(rest=SCENARIO.format(keys))
    assert words in text


@pytest.mark.parametrize(
    "keys",
    [
        SWEEP,
        ROLL,
        "duration: 1, method: runge_kutta, tolerance: 1e-5",
        "duration: 1, step: 1e-5",
        "duration: 1, form: SI2",
        "duration: 1, method: gstiff, form: SI1, order: 3, tolerance: 1e-5",
        "duration: 1, method: constant_bdf, order: 3",
    ],
)
def test_keys_that_a_scenario_reads(keys: str) -> None:
    assert sentences(rest=SCENARIO.format(keys)) == ()


def high_contact_ratio(addendum: float, law: str):
    rack = f", rack: {{addendum: {addendum}, dedendum: 1.6, root_radius: 0.2}}"
    return model_of(a=rack, b=rack, law=law)


@pytest.mark.parametrize(
    ("addendum", "near"), [(1.23, True), (1.25, True), (1.2, False), (1.1, False), (1.35, False)]
)
def test_ramps_near_a_whole_contact_ratio_are_named(addendum: float, near: bool) -> None:
    model = high_contact_ratio(addendum, "{law: din3990, tip_relief_factor: 0.6}")
    eps = model.pairs["s"].eps_alpha
    assert (abs(eps - 2.0) <= 0.05) == near
    found = jumping_ramps(model)
    assert len(found) == near
    if near:
        assert f"eps_alpha = {eps:.4f} is nearly 2" in found[0]
        assert "nearly 0.6 base pitches below 2" in found[0]
    for law in ("{law: din3990}", CONSTANT):
        assert jumping_ramps(high_contact_ratio(addendum, law)) == ()


def test_the_stiffness_jumps_with_the_ramps() -> None:
    def mean(addendum: float, law: str) -> float:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)
            return compile_model(high_contact_ratio(addendum, law)).records["gear_mesh"]["contact"]["k_ref"][
                0
            ]

    from scipy.optimize import brentq

    def excess(addendum: float) -> float:
        return high_contact_ratio(addendum, CONSTANT).pairs["s"].eps_alpha - 2.0

    whole = brentq(excess, 1.15, 1.35, xtol=1e-12)
    ramps, none = "{law: din3990, tip_relief_factor: 1}", "{law: din3990}"
    assert mean(whole - 1e-6, ramps) < 0.7 * mean(whole + 1e-6, ramps)
    assert mean(whole - 1e-6, none) == pytest.approx(mean(whole + 1e-6, none), rel=1e-4)
