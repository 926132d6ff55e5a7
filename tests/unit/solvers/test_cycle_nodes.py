# SPDX-License-Identifier: Apache-2.0
"""Mean stiffness over the mesh cycle that modes are made with, against the integral of the description."""

from __future__ import annotations

import math

import pytest

from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.rules.mesh_laws import mean_stiffness, mesh_laws
from tests.support.machines import compiled, pair

pytestmark = pytest.mark.filterwarnings(
    "ignore:.*both flanks are in contact without load", "ignore:.*has no effect as slices"
)

TABLE = "values: [0.6, 0.8, 0.95, 1, 0.9, 0.8, 0.7]"
LAWS = {
    "parabola": "{law: din3990}",
    "ramp": "{law: din3990, tip_relief_factor: 0.5}",
    "table": f"{{law: pair_table, single_stiffness: 14 N/(mm um), {TABLE}}}",
    "rectangular": "{law: rectangular, high: 4e8, low: 2e8, duty: 0.37}",
    "rectangular on slices": "{law: rectangular, high: 4e8, low: 2e8, duty: 0.37}, width: slices",
    "fourier": "{law: fourier, mean: 3e8, cosine: [0.2, 0.1]}",
    "wave": "{law: table, values: [3.6e8, 2.7e8, 3.3e8, 2.4e8, 3e8]}",
}


def ratio_to_mean(law: str, *, beta: str = "", gap: str = "0.1 mm", torque: str = "100 N m") -> float:
    """Stiffness that belongs to the one natural frequency of the pair over the mean of its law."""
    text = pair(law, beta=beta, torque=torque).replace("base_tangent: 0.1 mm", f"base_tangent: {gap}")
    if torque == "0 N m":
        text = text[: text.index("loads:")]
    model, system = compiled(text)
    r = [0.5 * model.gears[g].geometry.d_b for g in ("g1", "g2")]
    mass = 1.0 / (r[0] ** 2 / 0.002 + r[1] ** 2 / 0.01)
    k = (2.0 * math.pi * find_modes(system).frequency.max()) ** 2 * mass
    return k / mean_stiffness(model.pairs["stage"], mesh_laws(model, "stage").stiffness)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("beta", ["", "17 deg"])
@pytest.mark.parametrize("torque", ["100 N m", "-100 N m"])
def test_modes_take_the_exact_mean(law: str, beta: str, torque: str) -> None:
    assert ratio_to_mean(LAWS[law], beta=beta, torque=torque) == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("beta", ["", "17 deg"])
@pytest.mark.parametrize("torque", ["0 N m", "100 N m"])
def test_both_flanks_of_a_mesh_with_negative_backlash_have_twice_the_mean(
    law: str, beta: str, torque: str
) -> None:
    """The kinks and jumps of both flanks lie at phases of their own."""
    assert ratio_to_mean(LAWS[law], beta=beta, gap="-20 um", torque=torque) == pytest.approx(2.0, rel=1e-9)


@pytest.mark.parametrize("beta", ["", "17 deg"])
def test_modes_take_the_mean_of_the_energy_law(beta: str) -> None:
    """A table of 129 points counts as smooth."""
    assert ratio_to_mean("{law: energy}", beta=beta) == pytest.approx(1.0, rel=3e-5)
    assert ratio_to_mean("{law: energy}", beta=beta, gap="-20 um") == pytest.approx(2.0, rel=3e-5)
