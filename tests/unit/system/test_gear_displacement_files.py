# SPDX-License-Identifier: Apache-2.0
"""Eccentric and wobbling gears in model files: what they become, what is refused, how they are replaced."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.model.build import build_model
from pitchpoint.model.reading.reader import Reader
from pitchpoint.solvers.equilibrium.solve import solve_equilibrium
from pitchpoint.system.compile import compile_model
from tests.support.machines import pair
from tests.unit.system.test_shaft_files import RIG

FAULT = "gears.g1.faults"


def model_of(*faults):
    """Pair whose first gear has these faults, a, b, c ..."""
    listed = ", ".join(f"{name}: {fault}" for name, fault in zip("abc", faults, strict=False))
    line = "profile_shift_coefficient: 0}"
    text = pair("{law: constant, value: 4e8}")
    return loads_model(text.replace(line, f"{line[:-1]}, faults: {{{listed}}}}}", 1))


def places(model):
    """Places of both gears as the mesh reads them, or None."""
    system = compile_model(model)
    record = system.records["gear_mesh"][0]
    assert record["fixed"] == 1 - record["displaced"]
    at = int(record["seats"])
    return system.pools["gear_mesh"][at : at + 8].reshape(2, 4) if record["displaced"] else None


def test_faults_of_a_seat_add_up_from_tooth_0():
    model = model_of(
        "{type: eccentricity, amount: 20 um, phase: 30 deg}",
        "{type: eccentricity, amount: 10 um, phase: 120 deg, severity: 0.5}",
        "{type: wobble, amount: 2 mrad, phase: 90 deg}",
    )
    tooth = model.phasing.tooth_angle["g1"]
    shift = 20e-6 * np.exp(1j * (tooth + math.radians(30))) + 5e-6 * np.exp(1j * (tooth + math.radians(120)))
    lean = math.sin(2e-3) * np.exp(1j * (tooth + math.radians(90)))
    wanted = [[shift.real, shift.imag, lean.real, lean.imag], [0.0, 0.0, 0.0, 0.0]]
    np.testing.assert_allclose(places(model), wanted, atol=1e-18)


def test_files_are_written_and_values_replaced():
    model = model_of("{type: eccentricity, amount: 20 um}", "{type: wobble, amount: 1 mrad}")
    assert loads_model(dump_model(model)) == model
    other = model.replace(f"{FAULT}.a.severity", 0.25)
    assert np.hypot(*places(other)[0, :2]) == pytest.approx(5e-6)
    none = model.replace(FAULT, {})
    assert places(none) is None
    put = none.replace("gears.g2.faults", {"e": {"type": "eccentricity", "amount": "3 um", "phase": 1.0}})
    assert np.hypot(*places(put)[1, :2]) == pytest.approx(3e-6)


WRONG = {
    "another type": ("{type: eccentric, amount: 1 um}", "type", "did you mean eccentricity?"),
    "no amount": ("{type: eccentricity}", "amount", "is missing"),
    "no unit": ("{type: eccentricity, amount: 20}", "amount", "is larger than the module (limit 3 mm)"),
    "negative": ("{type: wobble, amount: -1 mrad}", "amount", "out of range"),
    "too askew": ("{type: wobble, amount: 20 deg}", "amount", "out of range"),
    "too severe": ("{type: wobble, amount: 1 mrad, severity: 2}", "severity", "out of range"),
}


@pytest.mark.parametrize("case", WRONG)
def test_wrong_faults_are_told_with_their_lines(case):
    fault, where, words = WRONG[case]
    with pytest.raises(ModelError) as caught:
        model_of(fault)
    (problem,) = caught.value.problems
    assert problem.where == f"{FAULT}.a.{where}"
    assert words in str(problem)
    assert problem.line == 2


def test_an_eccentric_gear_on_an_elastic_shaft():
    """At rest the bodies stand by e cos(where it is - line of action) less far than the healthy ones.

    Bearings and shafts give way a little less or more as the line of action turns by e over the distance of
    the axes: 2e-4 of what they do, some nanometres.
    """
    made = copy.deepcopy(RIG)
    made["gears"]["g1"]["faults"] = {"e": {"type": "eccentricity", "amount": 10e-6, "phase": 0.5}}
    model = build_model(made, Reader())
    found = []
    for severity in (0.0, 1.0):
        rest = solve_equilibrium(compile_model(model.replace("gears.g1.faults.e.severity", severity)))
        found.append({name: float(rest[name]) for name in ("transmission_error[stage]", "mesh_force[stage]")})
        angle = float(rest["angle[input]"])
    pair_of = model.pairs["stage"]
    n = model.meshes["stage"].theta + 0.5 * math.pi - pair_of.alpha_wt
    moved = -10e-6 * math.cos(model.phasing.tooth_angle["g1"] + 0.5 + angle - n)
    healthy, faulty = found
    assert abs(moved) > 1e-6
    assert faulty["transmission_error[stage]"] - healthy["transmission_error[stage]"] == pytest.approx(
        moved, abs=5e-8
    )
