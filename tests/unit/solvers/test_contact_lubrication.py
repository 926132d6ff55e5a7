# SPDX-License-Identifier: Apache-2.0
"""Oil film, flash temperature and friction loss of a contact analysis at a speed."""

from __future__ import annotations

import math

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.flank_contact.contact_pattern import contact_pattern, on_path
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.contact.film_thickness import film_thickness
from pitchpoint.contact.flash_temperature import STEEL
from pitchpoint.contact.hertz import plane_strain_compliance
from pitchpoint.core.errors import SolverError
from pitchpoint.solvers.contact_analysis.lubrication import Operation, with_operation
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.contact_files import fzg

SOFT = 2.0 * plane_strain_compliance(206e9, 0.3)
OMEGA = 2000.0 * math.pi / 30.0
OIL = Operation(speed=OMEGA, friction=0.05, viscosity=0.02, pressure_viscosity=20e-9)


@pytest.fixture(scope="module")
def analysed(tmp_path_factory: pytest.TempPathFactory) -> tuple[xr.Dataset, object]:
    model = fzg(tmp_path_factory.mktemp("fzg"), planes=3)
    return solve_contact(model, torque=302.0, positions=200), model.pairs["stage"]


def test_fields_follow_from_load_pressure_and_speeds(analysed: tuple[xr.Dataset, object]) -> None:
    data, pair = analysed
    found = with_operation(data, OIL)
    assert set(found.data_vars) - set(data.data_vars) == {
        "friction_coefficient",
        "sliding_speed",
        "rolling_speed",
        "film_thickness",
        "flash_temperature",
    }
    pattern = contact_pattern(found)
    k = int(np.abs(pattern.position - 1.2).argmin())
    rho = pair.T1A + pattern.position[k] * pair.p_et  # type: ignore[attr-defined]
    v_1, v_2 = OMEGA * rho, OMEGA / 1.5 * (pair.T1T2 - rho)  # type: ignore[attr-defined]
    R = 1.0 / (1.0 / rho + 1.0 / (pair.T1T2 - rho))  # type: ignore[attr-defined]
    w = pattern.line_load[k, 1]
    others = {name: values[k, 1] for name, values in pattern.others.items()}
    assert others["sliding_speed"] == pytest.approx(abs(v_1 - v_2), rel=1e-9)
    assert others["rolling_speed"] == pytest.approx(0.5 * (v_1 + v_2), rel=1e-9)
    film = film_thickness(w, R, 0.5 * (v_1 + v_2), SOFT, 0.02, 20e-9)
    assert others["film_thickness"] == pytest.approx(float(film), rel=1e-9)
    b_H = math.sqrt(4.0 * w * R * SOFT / math.pi)
    sink = math.sqrt(b_H) * STEEL * (math.sqrt(v_1) + math.sqrt(v_2))
    assert others["flash_temperature"] == pytest.approx(0.785983 * 0.05 * w * abs(v_1 - v_2) / sink, rel=1e-9)


def test_main_results(analysed: tuple[xr.Dataset, object]) -> None:
    data, pair = analysed
    numbers = contact_numbers(with_operation(data, OIL))
    assert numbers["loss_share"] == pytest.approx(0.05 * numbers["loss_factor"])
    found = with_operation(data, OIL)
    assert numbers["max_flash_temperature"][0] == float(found["flash_temperature"].max())
    assert numbers["min_film_thickness"][0] == float(found["film_thickness"].min())
    # no sliding at C
    field = on_path(contact_pattern(found), "flash_temperature", points=2000)
    at_C = (pair.T1C - pair.T1A) / pair.p_et  # type: ignore[attr-defined]
    near = np.abs(field.place - at_C) < 0.01
    assert np.nanmax(field.values[near]) < 0.05 * numbers["max_flash_temperature"][0]


def test_parts_of_the_operation(analysed: tuple[xr.Dataset, object]) -> None:
    data, _ = analysed
    assert set(with_operation(data, Operation()).data_vars) == set(data.data_vars)
    friction = contact_numbers(with_operation(data, Operation(friction=0.04)))
    assert "loss_share" in friction
    assert "max_flash_temperature" not in friction
    film = contact_numbers(with_operation(data, Operation(speed=-OMEGA, viscosity=0.02)))
    assert film["min_film_thickness"][0] > 0.0
    assert "loss_share" not in film


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"speed": 0.0}, r"speed: 0.0 is out of range \(limit not 0, in rad/s\); give the speed of gear 1"),
        ({"speed": math.inf}, "speed: inf"),
        ({"speed": "1000 rpm"}, "speed: '1000 rpm'"),
        ({"speed": True}, "speed: True"),
        ({"friction": -0.01}, r"friction: -0.01 is out of range \(limit 0 to 2\)"),
        ({"friction": 2.5}, "friction"),
        ({"viscosity": 0.0}, r"viscosity: 0.0 is out of range \(limit above 0, in Pa s\)"),
        ({"viscosity": math.nan}, "viscosity: nan"),
        ({"pressure_viscosity": None}, "pressure_viscosity: None"),
        ({"pressure_viscosity": -20e-9}, "pressure_viscosity"),
        ({"thermal_contact": (STEEL, -1.0)}, "thermal_contact: -1.0"),
        ({"thermal_contact": STEEL}, "thermal_contact: 13795.0 is not a pair"),
        ({"speed": None}, "viscosity: has no effect without a speed; give `speed`, too"),
    ],
)
def test_conditions_that_are_refused(change: dict[str, object], words: str) -> None:
    with pytest.raises(SolverError, match=f"operating conditions: {words}"):
        Operation(**({"speed": OMEGA, "friction": 0.05, "viscosity": 0.02} | change))  # type: ignore[arg-type]


def test_all_problems_of_the_conditions_are_in_one_error() -> None:
    with pytest.raises(SolverError) as caught:
        Operation(speed=math.nan, friction=-1.0, viscosity=-0.02, pressure_viscosity=0.0)
    assert str(caught.value).splitlines()[0] == "operating conditions: 4 problems"
    assert Operation(speed=-1, friction=0, viscosity=np.float64(0.02)).friction == 0
