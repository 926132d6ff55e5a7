# SPDX-License-Identifier: Apache-2.0
"""Stations of a rotor: convergence everywhere, momentum and power, limits, mirror images."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.core.status import OK
from pitchpoint.elements.rotor.induction import heavy_induction
from pitchpoint.elements.rotor.record import POINT
from pitchpoint.geometry.rotor.blade import Rotor
from pitchpoint.geometry.rotor.flow import RotorFlow
from pitchpoint.geometry.rotor.polar import Polar
from pitchpoint.geometry.rotor.tower import Tower
from pitchpoint.solvers.rotor_performance import evaluate_stations, solve_rotor_performance
from pitchpoint.solvers.rotor_wind import wind_field
from tests.support.rotors import aerodyn, plain_blade, polar_of, report_rotor

FREE = RotorFlow(tip_loss=False, hub_loss=False, sectors=1)


def points(count: int, seed: int, stations: int) -> np.ndarray:
    """Random flow at random stations, all quadrants, standstill and still air among them."""
    rng = np.random.default_rng(seed)
    out = np.zeros(count, POINT)
    out["station"] = rng.integers(0, stations, count)
    out["vx"], out["vy"] = rng.normal(0.0, 10.0, count), rng.normal(0.0, 40.0, count)
    out["vx"][::11], out["vy"][::13] = 0.0, 0.0
    out["vx"][::7] *= 1e-3
    out["pitch"] = rng.uniform(-np.pi, np.pi, count)
    return out


@pytest.mark.parametrize("losses", [True, False])
def test_every_station_converges_in_any_flow(losses: bool) -> None:
    """NREL 5 MW, 20000 random flows: a root of the balance of momentum always exists, and is found."""
    rotor = report_rotor()
    rows = points(20_000, 1, len(rotor.radius))
    flow = RotorFlow(tip_loss=losses, hub_loss=losses)
    assert evaluate_stations(rotor, flow, rows) == OK
    assert all(np.isfinite(rows[name]).all() for name in POINT.names or ())


@pytest.mark.parametrize("seed", range(4))
def test_every_station_converges_with_any_polar(seed: int) -> None:
    """Lift and drag at random over the angle of attack; 54 such polars were searched without a failure."""
    rng = np.random.default_rng(seed)
    alpha = np.r_[-np.pi, np.linspace(-3.0, 3.0, 25) + rng.uniform(-0.1, 0.1, 25), np.pi]
    lift, drag = rng.normal(0.0, 1.2, 27), rng.uniform(0.0, 2.0, 27)
    lift[-1], drag[-1] = lift[0], drag[0]
    rotor = report_rotor((Polar(alpha=alpha, lift=lift, drag=drag),) * 8)
    rows = points(3000, seed, len(rotor.radius))
    assert evaluate_stations(rotor, RotorFlow(), rows) == OK


def balance(rows: np.ndarray, rotor: Rotor, rho: float) -> tuple[np.ndarray, np.ndarray]:
    """Thrust and torque by the momentum of the air per length of all blades, with the induction found."""
    r = rotor.radius[rows["station"]]
    ux, uy = rows["speed"] * np.sin(rows["phi"]), rows["speed"] * np.cos(rows["phi"])
    flow = 2.0 * np.pi * r * rho * np.abs(ux) * rows["loss"]
    return flow * 2.0 * (rows["vx"] - ux), flow * 2.0 * r * (uy - rows["vy"])


def test_forces_are_those_of_the_momentum() -> None:
    """Thrust and torque of the blades against momentum theory with the same induction; a <= 0.4 and swirl."""
    rotor = report_rotor()
    rows = points(5000, 2, len(rotor.radius))
    assert evaluate_stations(rotor, RotorFlow(), rows) == OK
    thrust, torque = balance(rows, rotor, 1.225)
    f_n, f_t = 3 * rows["f_n"], 3 * rows["f_t"] * rotor.radius[rows["station"]]
    inner = (rows["loss"] > 1e-3) & (rows["a"] < 0.4) & (rows["a"] > -5.0) & (np.abs(rows["vx"]) > 0.1)
    scale = 0.5 * 1.225 * rows["speed"] ** 2 * 3 * 4.0
    assert inner.sum() > 500
    assert np.abs(thrust - f_n)[inner] / scale[inner] == pytest.approx(0.0, abs=1e-7)
    assert np.abs(torque - f_t)[inner] / scale[inner] / 60.0 == pytest.approx(0.0, abs=1e-7)


def test_heavily_loaded_stations_have_the_thrust_of_buhl() -> None:
    """C_T = 8/9 + (4 F - 40/9) a + (50/9 - 4 F) a^2 for a > 0.4 (Buhl 2005), which continues 4 a F (1 - a)
    with its value and slope and ends at 2."""
    rotor = report_rotor()
    rows = points(5000, 5, len(rotor.radius))
    assert evaluate_stations(rotor, RotorFlow(skewed_wake=False), rows) == OK
    rows = rows[(rows["a"] > 0.4) & (rows["a"] < 0.999) & (np.abs(rows["vx"]) > 0.3) & (rows["loss"] > 1e-3)]
    a, F, r = rows["a"], rows["loss"], rotor.radius[rows["station"]]
    buhl = lambda a, F: 8.0 / 9.0 + (4.0 * F - 40.0 / 9.0) * a + (50.0 / 9.0 - 4.0 * F) * a**2  # noqa: E731
    assert buhl(1.0, 0.7) == pytest.approx(2.0)
    assert buhl(0.4, 0.7) == pytest.approx(4.0 * 0.4 * 0.7 * 0.6)
    assert (buhl(0.4 + 1e-6, 0.7) - buhl(0.4, 0.7)) / 1e-6 == pytest.approx(4.0 * 0.7 * 0.2, abs=1e-4)
    thrust = 3.0 * rows["f_n"] * np.sign(rows["vx"]) / (1.225 * np.pi * r * rows["vx"] ** 2)
    assert len(rows) > 100
    np.testing.assert_allclose(thrust, buhl(a, F), rtol=1e-6)


@pytest.mark.parametrize("f", [0.1, 0.5, 0.9, 1.0])
def test_derivatives_of_buhls_curve(f: float) -> None:
    """The quadratic equation C_T(a) = 4 F κ (1 - a)^2 differentiated, also where it is linear."""
    singular = (25.0 / 9.0 - 2.0 * f) / (2.0 * f)
    for kappa in (0.7, 3.0, 50.0, *(singular + d for d in (-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-3))):
        a, by_kappa, by_f = heavy_induction(kappa, f)
        thrust = 8.0 / 9.0 + (4.0 * f - 40.0 / 9.0) * a + (50.0 / 9.0 - 4.0 * f) * a * a
        assert thrust == pytest.approx(4.0 * f * kappa * (1.0 - a) ** 2, rel=1e-12)
        by_a = 4.0 * f - 40.0 / 9.0 + 2.0 * (50.0 / 9.0 - 4.0 * f) * a + 8.0 * f * kappa * (1.0 - a)
        assert by_kappa == pytest.approx(4.0 * f * (1.0 - a) ** 2 / by_a, rel=1e-12)
        wanted = 4.0 * (kappa * (1.0 - a) ** 2 - a * (1.0 - a)) / by_a
        assert by_f == pytest.approx(wanted, rel=1e-11, abs=1e-13)


def test_power_of_the_wind_is_that_of_rotor_swirl_and_drag() -> None:
    """Thrust times speed through the disc = rotor power + swirl of the wake + drag times relative speed."""
    rotor = report_rotor()
    rows = points(2000, 3, len(rotor.radius))
    assert evaluate_stations(rotor, RotorFlow(), rows) == OK
    chord = rotor.blade.chord[rows["station"]]
    ux, uy = rows["speed"] * np.sin(rows["phi"]), rows["speed"] * np.cos(rows["phi"])
    wind = rows["f_n"] * ux
    drag = 0.5 * 1.225 * rows["speed"] ** 3 * chord * rows["drag"] * (rows["loss"] > 0)
    swirl = rows["f_t"] * (uy - rows["vy"])
    scale = 0.5 * 1.225 * rows["speed"] ** 3 * chord
    assert (np.abs(wind - rows["f_t"] * rows["vy"] - swirl - drag) <= 1e-12 * scale + 1e-9).all()


def test_without_induction_it_is_a_wing() -> None:
    rotor = report_rotor()
    rows = points(200, 4, len(rotor.radius))
    free = RotorFlow(axial_induction=False, tangential_induction=False, tip_loss=False, hub_loss=False)
    assert evaluate_stations(rotor, free, rows) == OK
    assert (rows["a"] == 0).all() and (rows["a_prime"] == 0).all()
    assert rows["speed"] == pytest.approx(np.hypot(rows["vx"], rows["vy"]), rel=1e-14)
    k = 5
    polar = rotor.blade.polars[rotor.blade.polar_index[rows["station"][k]]]
    lift, drag, _ = polar.at(rows["alpha"][k])
    assert (rows["lift"][k], rows["drag"][k]) == pytest.approx((lift, drag), abs=1e-12)
    q = 0.5 * 1.225 * rows["speed"][k] ** 2 * rotor.blade.chord[rows["station"][k]]
    assert np.hypot(rows["f_n"][k], rows["f_t"][k]) == pytest.approx(q * np.hypot(lift, drag), rel=1e-12)


def optimum(ratio: float, n: int = 400) -> Rotor:
    """Optimum rotor of Glauert without drag: chord and twist in closed form."""
    polar = polar_of(lambda a: 2.0 * np.pi * a, lambda a: 0.0 * a, within=30.0)
    r = np.linspace(2.5, 50.0, n)
    phi = 2.0 / 3.0 * np.arctan(50.0 / (ratio * r))
    angle = np.radians(5.0)
    chord = 8.0 * np.pi * r * (1.0 - np.cos(phi)) / (3.0 * 2.0 * np.pi * angle)
    return Rotor(blade=plain_blade(r, 2.5, chord, phi - angle, polar), hub_radius=2.5)


@pytest.mark.parametrize("ratio", [2.0, 8.0, 100.0])
def test_optimum_rotor(ratio: float) -> None:
    """Glauert 1935: a = 1/3 far out and a' = (1 - 3a)/(4a - 1); power towards Betz' 16/27 for large λ."""
    rotor = optimum(ratio)
    found = solve_rotor_performance(rotor, 8.0, tip_speed_ratio=ratio, flow=FREE)
    a, prime = found.axial_induction[0].values, found.tangential_induction[0].values
    phi = 2.0 / 3.0 * np.arctan(50.0 / (ratio * rotor.radius))
    assert found.inflow_angle[0].values == pytest.approx(phi, rel=1e-8)
    assert prime == pytest.approx((1 - 3 * a) / (4 * a - 1), rel=1e-5)
    if ratio == 100.0:
        ring = 1.0 - (2.5 / 50.0) ** 2
        assert float(found.power_coefficient[0]) == pytest.approx(16 / 27 * ring, rel=1e-3)
        assert float(found.thrust_coefficient[0]) == pytest.approx(8 / 9 * ring, rel=1e-3)


@pytest.mark.nojit
def test_tip_loss_of_prandtl() -> None:
    """F = 2/π acos exp(-B/2 (R - r)/(r sin φ)), and no load at the very tip."""
    rotor = report_rotor()
    found = solve_rotor_performance(
        rotor, 8.0, tip_speed_ratio=7.55, flow=RotorFlow(sectors=1, hub_loss=False)
    )
    r, phi = rotor.radius[1:-1], np.abs(found.inflow_angle[0].values[1:-1])
    tip = 2 / np.pi * np.arccos(np.exp(-1.5 * (63.0 - r) / (r * np.sin(phi))))
    assert found.loss_factor[0].values[1:-1] == pytest.approx(tip, rel=1e-9)
    assert float(found.normal_force[0, -1]) == 0.0


def test_hub_loss_of_prandtl() -> None:
    """F = 2/π acos exp(-B/2 (r - r_h)/(r_h sin φ)), and no load at the very root; both losses multiply."""
    rotor = report_rotor()

    def loss(**options):
        flow = RotorFlow(sectors=1, **options)
        found = solve_rotor_performance(rotor, 8.0, tip_speed_ratio=7.55, flow=flow)
        sine = np.abs(np.sin(found.inflow_angle[0].values[1:-1]))
        return found.loss_factor[0].values[1:-1], sine, float(found.normal_force[0, 0])

    r = rotor.radius[1:-1]
    factor, sine, root = loss(tip_loss=False)
    hub = 2 / np.pi * np.arccos(np.exp(-1.5 * (r - 1.5) / (1.5 * sine)))
    assert factor == pytest.approx(hub, rel=1e-9)
    assert root == 0.0 and hub.min() < 0.95
    factor, sine, _ = loss()
    tip = 2 / np.pi * np.arccos(np.exp(-1.5 * (63.0 - r) / (r * sine)))
    hub = 2 / np.pi * np.arccos(np.exp(-1.5 * (r - 1.5) / (1.5 * sine)))
    assert factor == pytest.approx(tip * hub, rel=1e-9)


def test_mirrored_rotor() -> None:
    """Wind from behind, or rotation the other way, with the airfoil turned to suit: mirrored loads."""
    rotor = report_rotor()
    sym = polar_of(lambda a: np.sin(2 * a), lambda a: 0.01 + np.sin(a) ** 2, within=179.9, step=0.1)
    rotor = report_rotor((sym,) * 8)
    rows = np.zeros((4, 12), POINT)
    rows["station"] = np.arange(3, 15)
    rows["vx"], rows["vy"] = 8.0, 1.0 * rotor.radius[3:15]
    theta = rotor.blade.twist[3:15]
    rows["vx"][1] *= -1.0
    rows["pitch"][1] = -2.0 * theta
    rows["vy"][2] *= -1.0
    rows["pitch"][2] = np.pi - 2.0 * theta
    rows["vx"][3] *= -1.0
    rows["vy"][3] *= -1.0
    rows["pitch"][3] = np.pi
    assert evaluate_stations(rotor, RotorFlow(), rows) == OK
    for k, (sx, sy) in enumerate([(1, 1), (-1, 1), (1, -1), (-1, -1)]):
        assert rows["f_n"][k] == pytest.approx(sx * rows["f_n"][0], rel=1e-6)
        assert rows["f_t"][k] == pytest.approx(sy * rows["f_t"][0], rel=1e-6)


def test_skewed_wake_moves_load_to_the_upwind_side() -> None:
    """Yaw 20°: mean induction nearly kept, a varies by 15π/32 tan(χ/2) r/R over the azimuth."""
    rotor = report_rotor()
    rows = np.zeros(2, POINT)
    rows["station"], rows["vx"], rows["vy"] = 12, 8.0, 50.0
    rows["yaw"], rows["downwind"] = np.radians(20.0), [1.0, -1.0]
    evaluate_stations(rotor, RotorFlow(), rows)
    plain = rows.copy()
    evaluate_stations(rotor, RotorFlow(skewed_wake=False), plain)
    a = plain["a"][0]
    factor = 15 * np.pi / 32 * np.tan(0.5 * (1 + 0.6 * a) * np.radians(20.0)) * rotor.radius[12] / 63.0
    assert rows["a"] == pytest.approx([a * (1 + factor), a * (1 - factor)], rel=1e-12)
    assert rows["f_n"][1] > plain["f_n"][1] > rows["f_n"][0]


def test_turning_the_wind_and_the_azimuth_together_changes_nothing() -> None:
    """Yaw left or right of a rotor without tilt and shear: equal totals."""
    rotor = Rotor(blade=aerodyn().blade, hub_radius=1.5)
    left, right = (
        solve_rotor_performance(rotor, 10.0, 1.2, flow=RotorFlow(yaw=yaw, sectors=24)) for yaw in (0.3, -0.3)
    )
    for name in ("rotor_thrust", "rotor_torque", "root_flap_moment"):
        assert float(left[name][0]) == pytest.approx(float(right[name][0]), rel=1e-10)


@pytest.mark.nojit
def test_still_air_and_standstill() -> None:
    """Hovering propeller: momentum gives T = 2 ρ A v²; parked rotor: finite loads."""
    sym = polar_of(lambda a: 2 * np.pi * np.sin(a) * np.cos(a), lambda a: 0.0 * a, within=179.9, step=0.1)
    r = np.linspace(0.5, 1.0, 6)
    rotor = Rotor(blade=plain_blade(r, 0.5, np.full(6, 0.1), np.full(6, 0.2), sym), hub_radius=0.5)
    rows = np.zeros(6, POINT)
    rows["station"], rows["vy"] = np.arange(6), 100.0 * r
    flow = RotorFlow(tip_loss=False, hub_loss=False, density=1.0)
    assert evaluate_stations(rotor, flow, rows) == OK
    thrust, _ = balance(rows, rotor, 1.0)
    assert (rows["f_n"] < 0).all()
    assert 3 * rows["f_n"] == pytest.approx(thrust, rel=1e-9)
    rows["vx"], rows["vy"] = 12.0, 0.0
    assert evaluate_stations(rotor, flow, rows) == OK
    assert (rows["f_n"] > 0).all() and np.isfinite(rows["f_t"]).all()


def test_polar_of_the_kernel_is_that_of_python_and_smooth() -> None:
    """Continuous slope, no values beyond those of the table."""
    polar: Polar = aerodyn().blade.polars[-1]
    rotor = Rotor(
        blade=plain_blade(np.array([1.0, 2.0]), 1.0, np.ones(2), np.zeros(2), polar), hub_radius=1.0
    )
    alpha = np.linspace(-3.14, 3.14, 4001)
    rows = np.zeros(alpha.size, POINT)
    rows["vx"], rows["vy"] = np.sin(alpha), np.cos(alpha)
    off = RotorFlow(axial_induction=False, tangential_induction=False, tip_loss=False, hub_loss=False)
    evaluate_stations(rotor, off, rows)
    assert rows["lift"] == pytest.approx(np.array([polar.at(a)[0] for a in alpha]), abs=1e-12)
    for k in range(1, len(polar.alpha) - 1):
        x, h = polar.alpha[k], 1e-6
        left, right = (polar.at(x) - polar.at(x - h)) / h, (polar.at(x + h) - polar.at(x)) / h
        assert left == pytest.approx(right, abs=1e-2)
    assert rows["lift"].max() <= polar.lift.max() and rows["drag"].min() >= polar.drag.min()


@pytest.mark.nojit
def test_wind_around_the_tower() -> None:
    """Potential flow: stagnation at the tower, twice the wind beside it, 1 - (R/x)² in front, no source."""
    tower = Tower(elevation=[0.0, 100.0], diameter=[6.0, 6.0])
    rotor = Rotor(blade=aerodyn().blade, hub_radius=1.5, overhang=6.0)
    flow = RotorFlow(tower=tower, sectors=36, yaw=0.4)
    c, s = np.cos(0.4), np.sin(0.4)
    along, across = np.array([c, -s, 0.0]), np.array([s, c, 0.0])

    def wind(x: float, y: float, height: float = 50.0) -> np.ndarray:
        found = wind_field(rotor, flow, (x * along + y * across)[None], np.array([height]))[0]
        return np.array([found @ along, found @ across])

    assert wind(-3.0, 0.0) == pytest.approx([0.0, 0.0], abs=1e-12)
    assert wind(0.0, 3.0) == pytest.approx([2.0, 0.0], abs=1e-12)
    assert wind(-6.0, 0.0) == pytest.approx([1 - 0.25, 0.0], abs=1e-12)
    assert wind(-6.0, 0.0, 101.0) == pytest.approx([1.0, 0.0], abs=1e-12)
    h = 1e-5
    x, y = -5.0, 2.0
    source = (wind(x + h, y) - wind(x - h, y))[0] + (wind(x, y + h) - wind(x, y - h))[1]
    curl = (wind(x + h, y) - wind(x - h, y))[1] - (wind(x, y + h) - wind(x, y - h))[0]
    assert (source / h, curl / h) == pytest.approx((0.0, 0.0), abs=1e-8)
    angle = np.radians(np.arange(0, 360, 5.0))
    radial = [wind(3 * np.cos(t), 3 * np.sin(t)) @ [np.cos(t), np.sin(t)] for t in angle]
    assert radial == pytest.approx(np.zeros(angle.size), abs=1e-12)


def test_tower_changes_the_mean_power_little() -> None:
    """In potential flow the disturbance has no mean along a line across the wind: below 1 % of the power."""
    tower = Tower(elevation=[0.0, 87.6], diameter=[6.0, 3.87])
    rotor = Rotor(blade=aerodyn().blade, hub_radius=1.5, overhang=5.0, tilt=0.087, precone=0.044)
    free, behind = (
        solve_rotor_performance(rotor, 8.0, 0.95, flow=RotorFlow(tower=shadow, sectors=72)).rotor_power.item()
        for shadow in (None, tower)
    )
    assert 0.99 < behind / free < 0.9999


def test_shear_and_yaw_of_the_wind_field() -> None:
    """Power law of the height; the wind turns against a yawed nacelle."""
    rotor = Rotor(blade=aerodyn().blade, hub_radius=1.5, hub_height=90.0)
    height = np.array([45.0, 90.0, 135.0])
    found = wind_field(rotor, RotorFlow(shear_exponent=0.2, yaw=0.1), np.zeros((3, 3)), height)
    assert np.hypot(found[:, 0], found[:, 1]) == pytest.approx((height / 90.0) ** 0.2)
    assert found[1] == pytest.approx([np.cos(0.1), -np.sin(0.1), 0.0])
    with pytest.raises(ModelError, match="lowest station above ground"):
        solve_rotor_performance(
            Rotor(blade=aerodyn().blade, hub_radius=1.5, hub_height=50.0),
            8.0,
            1.0,
            flow=RotorFlow(shear_exponent=0.2),
        )


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({}, "needs a rotor_speed or a tip_speed_ratio"),
        ({"rotor_speed": 1.0, "tip_speed_ratio": 7.0}, "and not both"),
        ({"rotor_speed": [1.0, 1.1, 1.2]}, "equal, or single numbers"),
        ({"rotor_speed": np.nan}, "operation.rotor_speed: is not finite"),
        ({"rotor_speed": 1.0, "wind_speed": [0.0, 5.0]}, "0 m/s is out of range (limit > 0)"),
    ],
)
def test_bad_operation(arguments: dict, expected: str) -> None:
    arguments = {"wind_speed": [5.0, 6.0], **arguments}
    with pytest.raises(ModelError) as error:
        solve_rotor_performance(report_rotor(), **arguments)
    assert expected in str(error.value)


def test_bad_flow() -> None:
    with pytest.raises(ModelError, match="4 problems"):
        RotorFlow(density=0.0, yaw=4.0, shear_exponent=-1.0, sectors=0)
    with pytest.raises(ModelError, match="12 is out of range"):
        RotorFlow(tower=Tower(elevation=[0, 1], diameter=[1, 1]))
