# SPDX-License-Identifier: Apache-2.0
"""Internal teeth shaped by a pinion-type cutter, against the numeric envelope of the cutter."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from pitchpoint.core.errors import GeometryError
from pitchpoint.geometry.cutter import CutterFillet, PinionCutter
from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.tooth_form import tooth_form

SHAPED = {
    "25 teeth": CylindricalGear(z=-56, m_n=45e-3, x=-0.5, cutter=PinionCutter(z_0=25)),
    "helical, shifted cutter": CylindricalGear(
        z=-72, m_n=2e-3, beta=0.25, cutter=PinionCutter(z_0=30, x_0=0.1, rho_aP0_star=0.2)
    ),
    "sharp": CylindricalGear(z=-60, m_n=1e-3, cutter=PinionCutter(z_0=20, rho_aP0_star=0.0)),
    "full rounding": CylindricalGear(z=-60, m_n=1e-3, cutter=PinionCutter(z_0=40, rho_aP0_star=2.0)),
    "own root": CylindricalGear(z=-60, m_n=1e-3, root_diameter=-62.4e-3, cutter=PinionCutter(z_0=20)),
    "thin teeth": CylindricalGear(z=-60, m_n=1e-3, thickness_allowance=-1e-4, cutter=PinionCutter(z_0=20)),
}


@pytest.mark.parametrize("name", list(SHAPED))
def test_fillet_is_the_envelope_of_the_rounding(name: str) -> None:
    form = tooth_form(SHAPED[name])
    fillet = form.fillet
    assert isinstance(fillet, CutterFillet)
    a_0 = fillet.r_w2 - fillet.r_w0

    def distance(turn: float, point: complex) -> float:
        # Cutter and gear turn the same way by `turn` and z_0/z of it; angles clockwise from the space.
        centre = 1j * a_0 + fillet.r_c * np.exp(1j * (0.5 * math.pi - fillet.psi_c - turn))
        return abs(centre * np.exp(1j * turn * fillet.ratio) - point)

    for theta in np.linspace(fillet.theta_root, fillet.theta_flank, 9):
        r, delta = (float(v) for v in fillet.polar(theta))
        point = r * np.exp(1j * (0.5 * math.pi - delta))
        grid = np.linspace(-1.2, 1.2, 481)
        best = grid[np.argmin([distance(t, point) for t in grid])]
        bounds = (best - 0.01, best + 0.01)
        found = minimize_scalar(
            distance, bounds=bounds, args=(point,), method="bounded", options={"xatol": 1e-13}
        )
        assert float(found.fun) == pytest.approx(fillet.rho, abs=1e-9 * form.r_f)


@pytest.mark.parametrize("name", list(SHAPED))
def test_root_and_form_diameters(name: str) -> None:
    gear = SHAPED[name]
    form = tooth_form(gear)
    assert 2.0 * form.r_f == pytest.approx(abs(gear.d_fE), rel=1e-13)
    assert 2.0 * form.r_Ff == pytest.approx(abs(gear.d_Ff), rel=1e-12)
    r, angle = form.fillet_polar(form.theta_form)
    assert float(r) == pytest.approx(form.r_Ff, rel=1e-13)
    assert float(angle) == pytest.approx(float(form.involute_half_angle(form.r_Ff)), abs=1e-13)


def test_printed_form_diameter_of_a_ring() -> None:
    """KISSsoft report of the 5 MW gearbox, ring of stage 1: 2662.682 mm with 36 cutter teeth."""
    cutter = PinionCutter(z_0=36, rho_aP0_star=0.3)
    ring = CylindricalGear(z=-56, m_n=45e-3, x=-0.5013, root_diameter=-2.677617, cutter=cutter)
    assert 2e3 * tooth_form(ring).r_Ff == pytest.approx(2662.682, abs=5e-3)


@pytest.mark.parametrize(
    "values",
    [
        {"z_0": 0},
        {"z_0": 20.5},
        {"z_0": True},
        {"x_0": math.nan},
        {"rho_aP0_star": -0.1},
        {"h_aP0_star": 0.0},
    ],
)
def test_impossible_cutters_are_refused(values: dict[str, object]) -> None:
    with pytest.raises(GeometryError, match="cutter"):
        PinionCutter(**{"z_0": 20, **values})  # type: ignore[arg-type]


def test_cutter_with_too_many_teeth_is_refused() -> None:
    with pytest.raises(GeometryError, match="fewer teeth"):
        tooth_form(CylindricalGear(z=-30, m_n=1e-3, root_diameter=-32.5e-3, cutter=PinionCutter(z_0=30)))
