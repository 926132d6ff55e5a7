# SPDX-License-Identifier: Apache-2.0
"""Faults of rolling bearings in model files: what they become, what is refused, how they are replaced."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.system.compile import compile_model

FILE = """\
bodies:
  rotor: {{motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01 kg m^2}}
rolling_bearings:
  b:
    ends: [rotor, ground]
    elements: 9
    element_diameter: 10 mm
    pitch_diameter: 50 mm
    contact_angle: 60 deg
    stiffness: 1e9
    faults:
      f: {fault}
"""


def model_of(fault, more=""):
    return loads_model(FILE.format(fault=fault) + more)


def rows_of(model):
    """Rows of the spalls and angles added to the elements, or None."""
    system = compile_model(model)
    record, pool = system.records["rolling_bearing"][0], system.pools["rolling_bearing"]
    n, at = int(record["n_faults"]), int(record["faults"])
    spacing = pool[record["spacing"] :][:9] if record["uneven"] else None
    return pool[at : at + 6 * n].reshape(n, 6), spacing


def test_spalls_become_angles_about_the_axis_they_turn_about():
    """g = 10/50 cos 60 deg = 0.1: tracks at 22.5 and 27.5 mm, in planes where they bend twice as little."""
    for form, track, place in (("outer_race", 27.5e-3, 0.0), ("inner_race", 22.5e-3, 1.0)):
        model = model_of(f"{{type: {form}, angle: 30 deg, length: 2 mm, depth: 20 um, severity: 0.5}}")
        ((found),) = rows_of(model)[0]
        curvature = 200.0 + (-1.0 if place == 0.0 else 1.0) * 0.5 / track
        ramp = math.sqrt(2.0 * 10e-6 / curvature) / track
        wanted = [place, -1.0, math.radians(30.0), 0.5e-3 / track, ramp, 10e-6]
        np.testing.assert_allclose(found, wanted, rtol=1e-12)
    rows, _ = rows_of(
        model_of("{type: rolling_element, element: 4, angle: 10 deg, length: 1 mm, depth: 1 mm}")
    )
    np.testing.assert_allclose(rows[:, :4], [[2, 4, -math.radians(10), 0.1], [2, 4, math.radians(170), 0.1]])
    # it spans the spall: l^2/8 (1/R -+ 1/r) to 1 %
    drop = 1e-6 / 8.0 * np.array([200.0 - 0.5 / 27.5e-3, 200.0 + 0.5 / 22.5e-3])
    np.testing.assert_allclose(rows[:, 5], drop, rtol=0.01)


def test_a_worn_cage_widens_one_gap():
    spacing = rows_of(model_of("{type: cage, element: 2, widening: 8 deg, severity: 0.5}"))[1]
    gaps = np.diff(np.append(spacing, spacing[0]))
    wanted = np.full(9, -math.radians(0.5))
    wanted[2] = math.radians(4.0)
    np.testing.assert_allclose(gaps, wanted, atol=1e-15)
    assert abs(spacing.mean()) < 1e-15


def test_files_are_written_and_values_replaced():
    model = model_of(
        "{type: inner_race, length: 2 mm, depth: 20 um}", "      c: {type: cage, widening: 2 deg}\n"
    )
    assert loads_model(dump_model(model)) == model
    other = model.replace("rolling_bearings.b.faults.f.severity", 0.25)
    assert other.rolling_bearings["b"].faults["f"].severity == 0.25
    assert model.rolling_bearings["b"].faults["f"].severity == 1.0
    assert rows_of(other)[0][0, 5] == pytest.approx(5e-6)
    none = model.replace("rolling_bearings.b.faults", {})
    assert rows_of(none)[0].size == 0
    turned = none.replace(
        "rolling_bearings.b.faults", {"o": {"type": "outer_race", "length": 1e-3, "depth": 1e-5}}
    )
    assert turned.rolling_bearings["b"].faults["o"].form == "outer_race"


WRONG = {
    "no type": ("{length: 1 mm}", "faults.f.type", "is missing"),
    "another type": ("{type: inner_ring}", "faults.f.type", "did you mean inner_race?"),
    "no length": ("{type: inner_race, depth: 1 um}", "faults.f.length", "is missing"),
    "too severe": (
        "{type: inner_race, length: 1 mm, depth: 1 um, severity: 1.5}",
        "faults.f.severity",
        "out of range",
    ),
    "no unit": ("{type: outer_race, length: 11, depth: 1 um}", "faults.f.length", "can roll over"),
    "too deep": ("{type: outer_race, length: 1 mm, depth: 6 mm}", "faults.f.depth", "< 5 mm"),
    "tenth of nine": (
        "{type: rolling_element, element: 9, length: 1 mm, depth: 1 um}",
        "faults.f.element",
        "9 does not exist in a bearing of 9 elements (limit 0 to 8)",
    ),
    "negative element": ("{type: cage, element: -1, widening: 1 deg}", "faults.f.element", "out of range"),
    # 9 elements need 2 asin(1/5) = 23.074 deg each: 8 (40 - 23.074) deg are left
    "too wide": ("{type: cage, widening: 136 deg}", "faults.f.widening", "<= 135.409 deg"),
    "no mapping": ("3", "faults.f", "is not a mapping"),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_faults_are_told_with_their_lines(case):
    fault, where, words = WRONG[case]
    with pytest.raises(ModelError) as caught:
        model_of(fault)
    (problem,) = caught.value.problems
    assert problem.where == f"rolling_bearings.b.{where}"
    assert words in str(problem)
    assert problem.line == 12


def test_faults_made_in_python_are_checked_too():
    model = model_of("{type: inner_race, length: 2 mm, depth: 20 um}")
    with pytest.raises(ModelError, match=r"rolling_bearings\.b\.faults\.f\.severity"):
        model.replace("rolling_bearings.b.faults.f.severity", 2.0)
    with pytest.raises(ModelError, match="does not exist"):
        model.replace("rolling_bearings.b.faults.g.severity", 0.5)
