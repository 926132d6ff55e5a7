# SPDX-License-Identifier: Apache-2.0
"""Loads of teeth with the numbers of the model: a broken tooth is the one without pulses."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.fatigue import LoadCases, fatigue_loads
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.planet_stages import stage_file
from tests.unit.cli.test_fatigue import PAIR

LAW = "stiffness: {law: din3990}, damper: {ratio: 0.2}"
STAGE = stage_file(mesh=LAW).replace(
    "duration: 5 ms, settle_time: 2 ms", "duration: 0.3 s, step: 40 us, settle_time: 20 ms"
)


def with_broken(text, teeth, tooth):
    count = f"number_of_teeth: {teeth},"
    assert count in text
    return text.replace(count, f"{count} faults: {{b: {{type: broken_tooth, tooth: {tooth}}}}},")


def computed(text, scenario):
    model = loads_model(text)
    return model, solve_time(compile_model(model, scenario))


def loads(text, scenario):
    model, data = computed(text, scenario)
    return fatigue_loads(LoadCases(model, [data], [None]))


def without_pulses(found, gear, flank):
    return np.flatnonzero(np.array(found["teeth"][gear][flank]["pulses"]) == 0).tolist()


@pytest.mark.parametrize(("gear", "teeth", "tooth"), [("pinion", 20, 3), ("wheel", 30, 17)])
@pytest.mark.parametrize("torque", [50, -50])
@pytest.mark.parametrize("helix", [0, 20])
def test_external_gears(gear, teeth, tooth, torque, helix):
    text = PAIR.replace("torque: 50 N m", f"torque: {torque} N m")
    for name, hand in (("pinion", "right"), ("wheel", "left")) if helix else ():
        text = text.replace(f"{name}: {{", f"{name}: {{helix_angle: {helix} deg, hand: {hand}, ")
    found = loads(with_broken(text, teeth, tooth), "run")
    assert without_pulses(found, gear, "front" if torque > 0 else "back") == [tooth]


@pytest.mark.parametrize(
    ("teeth", "tooth", "expected"),
    [
        (21, 5, [("sun", "front")]),
        (99, 30, [("ring", "back")]),
        (39, 11, [(f"planet_{k}", flank) for k in (1, 2, 3) for flank in ("front", "back")]),
    ],
)
def test_gears_of_a_planetary_stage(teeth, tooth, expected):
    """Both meshes of a planet and all meshes of sun and ring count the same teeth."""
    found = loads(with_broken(STAGE, teeth, tooth), "steady")
    for gear, flank in expected:
        assert without_pulses(found, gear, flank) == [tooth]


def test_teeth_of_load_cases_are_added_by_tooth():
    """A case of a third of a turn starts anywhere; the tooth without pulses is the same one."""
    model, data = computed(with_broken(PAIR, 20, 3), "run")
    parts = [data.isel(time=slice(0, 5600)), data.isel(time=slice(2400, None))]
    found = fatigue_loads(LoadCases(model, parts, [None, 2.0]))
    assert without_pulses(found, "pinion", "front") == [3]


def test_results_without_rotation_have_no_teeth():
    model, data = computed(PAIR, "run")
    kept = [n for n in data.data_vars if "pair_force" in str(n)]
    found = fatigue_loads(LoadCases(model, [data[kept]], [None]))
    assert found["teeth"] == {}
    assert found["notes"] == ["stage: no loads of teeth; the result lacks the channel angle[a]"]
    found = fatigue_loads(LoadCases(model, [data.drop_vars(kept[1])], [None]))
    assert found["teeth"] == {}
    assert found["notes"] == [f"stage: no loads of teeth; the result lacks the channels {kept[1]}"]


def test_large_exponents():
    """1e4 N to the power 100 is not a number that can be stored."""
    model, data = computed(PAIR, "run")
    row = fatigue_loads(LoadCases(model, [data], [None]), tooth_slope=100.0)["teeth"]["pinion"]["front"]
    assert row["equivalent"] == pytest.approx(row["largest"], rel=0.02)


def test_results_of_other_models():
    """Other values are a note, other teeth or meshes an error."""
    model, data = computed(PAIR, "run")
    _, heavier = computed(PAIR.replace("inertia: 0.02", "inertia: 0.03"), "run")
    notes = fatigue_loads(LoadCases(model, [data, heavier], [None, None]))["notes"]
    assert any("different versions of the model" in note for note in notes)
    assert not any(
        "versions" in n for n in fatigue_loads(LoadCases(model, [data, data], [None, None]))["notes"]
    )
    for other, words in (
        (PAIR.replace("number_of_teeth: 30", "number_of_teeth: 31"), "numbers of teeth.*: wheel"),
        (PAIR.replace("  stage: {", "  pair: {"), "meshes pair"),
    ):
        _, changed = computed(other, "run")
        with pytest.raises(PitchpointError, match=words):
            fatigue_loads(LoadCases(model, [data, changed], [None, None]))
