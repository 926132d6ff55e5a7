# SPDX-License-Identifier: Apache-2.0
"""NL-KS90: oscillator with backlash, constant stiffness and internal excitation, swept up and down.

Source: A. Kahraman, R. Singh, Non-linear dynamics of a spur gear pair, Journal of Sound and Vibration 142
(1990) 49-75: x'' + 2 zeta x' + g(x) = F_m + F_a Omega^2 sin(Omega tau), g = x -+ 1 outside |x| <= 1, here
with zeta 0.05, F_m 0.1, F_a 0.05. The numbers were computed independently of this package by a fourth-order
Runge-Kutta method with 2000 to 8000 steps per period and by harmonic balance with 30 harmonics, which agree
in six digits. `examples/backlash-oscillator/constant-twin.yaml` maps them to a gear pair: x is the deflection
over half the backlash, Omega the mesh frequency over 3000 Hz, the excitation the static transmission error.

Tolerances. rms 1e-4 and jumps 0.001 in Omega as the source gives them. Extremes 2e-4: they are taken at the
steps, 400 or more per period, and the response turns sharply where the flanks meet. Jumps are the midpoint of
two points 0.001 apart. In the linear range 1e-5: nothing but the integration error is left.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from pitchpoint import compile_model, load_model
from pitchpoint.sweep.speed import run_sweep

FILE = Path(__file__).parents[2] / "examples" / "backlash-oscillator" / "constant-twin.yaml"
ZETA, F_M, F_A = 0.05, 0.1, 0.05
HALF_GAP, NATURAL = 50e-6, 3000.0

TABLE = [  # branch, Omega, rms of the alternating part, least, greatest x
    ("up", 0.60, 0.019801, 1.071998, 1.128002),
    ("down", 0.75, 0.224724, 0.716349, 1.353042),
    ("down", 0.80, 0.202258, 0.761570, 1.333009),
    ("up", 0.90, 0.162860, 0.839249, 1.297581),
    ("up", 1.00, 0.133083, 0.895288, 1.269255),
    ("up", 1.20, 0.094212, 0.963318, 1.228616),
    ("up", 1.35, 0.076193, 0.991929, 1.207227),
    ("up", 0.75, 0.044803, 1.036639, 1.163361),
]


def amplitude(omega):
    """Of the linear response, closed form."""
    return F_A * omega**2 / math.hypot(1.0 - omega**2, 2.0 * ZETA * omega)


def swept(scenario):
    """Points by direction and Omega, and the jumps as direction and Omega."""
    found = run_sweep(compile_model(load_model(FILE), scenario))
    assert found.status == 1, found.sentence
    points = {(p["direction"], round(p["mesh_frequency"] / NATURAL, 6)): p for p in found.points}
    return points, [(j["direction"], j["mesh_frequency"] / NATURAL) for j in found.jumps]


@pytest.fixture(scope="module")
def branches():
    return swept("branches")[0]


@pytest.fixture(scope="module")
def jumps():
    return swept("jumps")


def test_file_is_the_oscillator():
    model = load_model(FILE)
    row = compile_model(model).records["gear_mesh"][0]
    mass = 0.5 * model.bodies["driver"].inertia / row["r_b1"] ** 2
    assert math.sqrt(row["contact"]["k_ref"] / mass) / (2.0 * math.pi) == pytest.approx(NATURAL, rel=1e-7)
    assert row["d_gap"] == pytest.approx(2.0 * ZETA * math.sqrt(row["contact"]["k_ref"] * mass), rel=1e-12)
    assert model.loads["input"].torque.value / (
        row["r_b1"] * row["contact"]["k_ref"] * HALF_GAP
    ) == pytest.approx(F_M, rel=1e-7)
    assert row["now"]["gap"] == pytest.approx(2.0 * HALF_GAP, rel=1e-9)


@pytest.mark.parametrize(("direction", "omega", "rms", "least", "greatest"), TABLE)
def test_published_points(branches, direction, omega, rms, least, greatest):
    x = branches[direction, omega]["deflection"]
    assert x["rms"] / HALF_GAP == pytest.approx(rms, abs=1e-4)
    assert x["min"] / HALF_GAP == pytest.approx(least, abs=2e-4)
    assert x["max"] / HALF_GAP == pytest.approx(greatest, abs=2e-4)


def test_jumps_at_different_speeds(jumps):
    points, found = jumps
    assert [d for d, _ in found] == ["up", "down"]
    assert found[0][1] == pytest.approx(0.8285, abs=1e-3)
    assert found[1][1] == pytest.approx(0.7081, abs=1e-3)
    # levels on both sides of the jumps; near a fold they move fast with Omega, hence 5 %
    for direction, omega, rms in (("up", 0.828, 0.0818), ("up", 0.829, 0.1900)):
        assert points[direction, omega]["deflection"]["rms"] / HALF_GAP == pytest.approx(rms, rel=0.05)
    for direction, omega, rms in (("down", 0.709, 0.2325), ("down", 0.707, 0.0352)):
        assert points[direction, omega]["deflection"]["rms"] / HALF_GAP == pytest.approx(rms, rel=0.05)


def test_flanks_part_only_inside_the_closed_form_band(branches, jumps):
    """Contact is lost where the linear amplitude reaches F_m: 0.75 y^2 - 1.99 y + 1 = 0, y = Omega^2."""
    low, high = (math.sqrt((1.99 + s * math.sqrt(1.99**2 - 3.0)) / 1.5) for s in (-1.0, 1.0))
    assert (low, high) == (pytest.approx(0.820630, abs=2e-6), pytest.approx(1.407090, abs=2e-6))
    assert amplitude(low) == pytest.approx(F_M, rel=1e-12)
    for (direction, omega), point in {**branches, **jumps[0]}.items():
        if direction == "up":  # the linear branch, then the only one
            assert (point["contact_loss_share"] > 0.0) == (low < omega < high), omega
    lost = [
        omega for (direction, omega), p in jumps[0].items() if direction == "up" and p["contact_loss_share"]
    ]
    assert min(lost) - low == pytest.approx(0.0005, abs=0.0005)  # one step of the sweep


def test_linear_outside_the_band(branches):
    for (direction, omega), point in branches.items():
        if point["contact_loss_share"] == 0.0:
            x = point["deflection"]
            assert x["rms"] / HALF_GAP == pytest.approx(amplitude(omega) / math.sqrt(2.0), abs=1.5e-5), (
                direction
            )
            assert x["mean"] / HALF_GAP == pytest.approx(1.0 + F_M, abs=1e-6)
