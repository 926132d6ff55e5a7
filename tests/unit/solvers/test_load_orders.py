# SPDX-License-Identifier: Apache-2.0
"""Torques that pulsate with the angle: mean slope zero, and their orders in a Campbell diagram."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.analysis.campbell_ranking import ranked_speeds, unstable_ranges
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.campbell import follow_modes
from pitchpoint.solvers.excitation_orders import excitation_orders
from pitchpoint.solvers.frequency_response import find_response
from pitchpoint.solvers.linear_system import linearise
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model

RPM = math.pi / 30.0
TWO = """\
bodies:
  motor: {motion: torsion, inertia: 0.02 kg m^2, position: [0, 0, 0]}
  fan: {motion: torsion, inertia: 0.05 kg m^2, position: [0, 0, 0.3 m]}
torsion_springs:
  coupling: {bodies: [motor, fan], stiffness: 5000 N m/rad, damping: 1 N m s/rad}
loads:
  m: {body: motor, torque: TORQUE}
  f: {body: fan, torque: balance}
scenarios:
  steady: {speed: {motor: 1500 rpm}, duration: 0.5 s}
"""
RIPPLE = "20 N m + 5 N m*sin(2*angle)"
STIFFNESS, DAMPING = 5000.0, 1.0
REDUCED = 1.0 / (1.0 / 0.02 + 1.0 / 0.05)


def machine(torque: str):
    """Two inertias with a torque on the motor."""
    return compile_model(loads_model(TWO.replace("TORQUE", torque)), "steady")


def orders_of(torque: str) -> dict[str, float]:
    """Orders of the loads by name, with the motor as reference."""
    system = machine(torque)
    found = follow_modes(system, [0.0, 100.0], "motor", "steady")
    return {o.name: o.value for o in excitation_orders(system, found.motions, found.rates, "loads")}


def test_the_ripple_of_a_torque_excites_torsion():
    """2 Omega = omega_d of the spring between two inertias; J |phi''|/T is the amplification."""
    system = machine(f'"{RIPPLE}"')
    data = pp.solve_campbell(system, np.linspace(0.0, 6000.0 * RPM, 21), "motor", "steady")
    zeta = DAMPING / (2.0 * math.sqrt(STIFFNESS * REDUCED))
    damped = math.sqrt(STIFFNESS / REDUCED) * math.sqrt(1.0 - zeta**2)
    (row,) = ranked_speeds(data)
    assert row.order == "2× motor (torque m)"
    assert row.source == "pulsating torque"
    assert row.speed == pytest.approx(damped / 2.0, rel=1e-8)
    assert row.participation == pytest.approx(0.05 / 0.07, rel=1e-6)
    assert row.amplification == pytest.approx(row.participation / (2.0 * zeta), rel=1e-2)
    hertz = np.array([math.sqrt(STIFFNESS / REDUCED) / (2.0 * math.pi)])
    turned = find_response(system, ["motor.spin"], ["motor.spin"], hertz, "steady").response[0, 0, 0]
    rigid = -1.0 / ((2.0 * math.pi * hertz[0]) ** 2 * 0.07)  # the rotation of the whole, no resonance
    elastic = 0.02 * (2.0 * math.pi * hertz[0]) ** 2 * abs(turned - rigid)
    assert elastic == pytest.approx(row.amplification, rel=1e-2)


def test_a_pulsating_torque_is_no_spring():
    """The mean of its slope over a revolution is zero: modes are those of the mean torque."""
    system = machine(f'"{RIPPLE}"')
    modes, steady = (find_modes(one, "steady") for one in (system, machine("20 N m")))
    assert modes.frequency == pytest.approx(steady.frequency, rel=1e-12)
    assert modes.damping_ratio == pytest.approx(steady.damping_ratio, rel=1e-12)
    assert modes.frequency[0] == modes.damping_ratio[0] == 0.0
    assert any(note.startswith("m: the mean torque") for note in modes.notes)
    data = pp.solve_campbell(system, np.linspace(0.0, 600.0, 5), "motor", "steady")
    assert unstable_ranges(data) == ()


def test_at_rest_it_is_one():
    """Frozen at one angle the slope is 2*5 N m/rad: without a speed it counts, and a note says so."""
    model = loads_model(TWO.replace("TORQUE", f'"{RIPPLE}"'))
    modes = find_modes(compile_model(model))
    assert modes.frequency[0] == pytest.approx(-math.sqrt(10.0 / 0.07) / (2.0 * math.pi), rel=1e-3)
    assert any("select a scenario with its speed" in note for note in modes.notes)


def test_its_damping_remains():
    """d T/d speed of the mean torque: -0.1 (1 + 0.3 <sin>) N m s, with and without the ripple."""
    law = "20 N m - 0.1 N m s*(1 + 0.3*sin(2*angle))*(speed - 1500 rpm)"
    pulsating = linearise(machine(f'"{law} + 5 N m*cos(angle)"'), "steady").D
    steady = linearise(machine('"20 N m - 0.1 N m s*(speed - 1500 rpm)"'), "steady").D
    assert pulsating == pytest.approx(steady, rel=1e-9)
    assert pulsating.sum() == pytest.approx(0.1, rel=1e-9)


@pytest.mark.parametrize(
    "torque, orders",
    [
        (f'"{RIPPLE}"', [2.0]),
        ('"20 N m*(1 + 0.3*sin(angle/2))^2"', [0.5, 1.0]),
        ('"20 N m + 5 N m*sin(2*pi*30 Hz*t)"', []),
        ('"20 N m"', []),
        (
            "{table: [[0 deg, 20 N m], [90 deg, 30 N m], [180 deg, 20 N m]], over: angle}",
            None,
        ),
    ],
)
def test_harmonics_above_rounding(torque: str, orders: list[float] | None):
    found = orders_of(torque)
    if orders is None:  # a triangle: odd harmonics of its period n, 1/n^2 of the first; 1/25 is below 5 %
        orders = [2.0, 6.0]
    assert list(found.values()) == pytest.approx(orders)


def test_loads_alike_are_one_line():
    text = TWO.replace("  m: {body", f'  m2: {{body: motor, torque: "{RIPPLE}"}}\n  m: {{body')
    system = compile_model(loads_model(text.replace("TORQUE", f'"{RIPPLE}"')), "steady")
    found = follow_modes(system, [0.0, 100.0], "motor", "steady")
    orders = excitation_orders(system, found.motions, found.rates, "loads")
    assert [o.name for o in orders] == ["2× motor (torque m2, m)"]


def cylinders(bodies: list[str], offsets: list[float]) -> str:
    """Four-stroke cylinders with the orders 0.5 to 3 of equal sizes, by body and firing angle [deg]."""
    waves = " + ".join(f"5 N m*cos({k / 2:g}*(angle - SHIFT))" for k in range(1, 7))
    rows = [
        f'  c{n}: {{body: {body}, torque: "2 N m + {waves.replace("SHIFT", repr(math.radians(offset)))}"}}\n'
        for n, (body, offset) in enumerate(zip(bodies, offsets, strict=True))
    ]
    return TWO.replace("  m: {body: motor, torque: TORQUE}\n", "".join(rows))


SIX = [0.0, 480.0, 240.0, 600.0, 120.0, 360.0]
"""Firing angles of a six-cylinder engine with the firing order 1-5-3-6-2-4 [deg]."""


def test_equal_cylinders_on_one_body_excite_by_the_firing_order():
    """The vector sum of six cylinders at 120 deg is zero except for the orders 3, 6 ...; a weaker cylinder
    leaves a part of all orders."""
    for weak, wanted in ((False, [3.0]), (True, [0.5, 1.0, 1.5, 2.0, 2.5, 3.0])):
        text = cylinders(["motor"] * 6, SIX)
        text = text.replace("5 N m", "4.5 N m", 6) if weak else text
        system = compile_model(loads_model(text), "steady")
        found = follow_modes(system, [0.0, 100.0], "motor", "steady")
        orders = excitation_orders(system, found.motions, found.rates, "loads")
        assert [order.value for order in orders] == pytest.approx(wanted)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_cylinders_on_two_bodies_excite_torsion_by_their_phases(sense: float):
    """One cylinder on each end of an elastic shaft, fired 360 deg apart: the orders 0.5, 1.5, 2.5 oppose each
    other and twist the shaft, 1, 2, 3 push the same way. With the rotations 1 and -J_1/J_2 = -0.4 the share
    of the mode is (1 +- 0.4)^2/(2 (1 + 0.4^2))."""
    text = cylinders(["motor", "fan"], [30.0, 390.0])
    system = compile_model(loads_model(text), "steady")
    speeds = sense * np.linspace(0.0, 12000.0 * RPM, 41)
    rows = ranked_speeds(pp.solve_campbell(system, speeds, "motor", "steady", orders="loads"))
    shares = {float(row.order.partition("×")[0]): row.participation for row in rows}
    assert sorted(shares) == [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]
    for order, share in shares.items():
        twists = 1.4 if order % 1.0 else 0.6
        assert share == pytest.approx(twists**2 / (2.0 * 1.16), rel=1e-6)
    assert all(float(row.order.partition("×")[0]) % 1.0 == 0.5 for row in rows[:3])


def test_ripple_of_a_drive():
    """The driven motor moves as given, so the coupling drives the fan: its whole strain energy."""
    text = TWO.replace("TORQUE", "20 N m").replace("  f: {body: fan, torque: balance}\n", "")
    drive = "drive: {motor: {speed: 1500 rpm, ripple: {w: {order: 3, angle: 0.1 deg}}}}"
    system = compile_model(
        loads_model(
            text.replace("speed: {motor: 1500 rpm}", drive).replace("  m: {body: motor", "  m: {body: fan")
        ),
        "steady",
    )
    data = pp.solve_campbell(system, np.linspace(0.0, 3000.0 * RPM, 11), "motor", "steady", orders="loads")
    (row,) = ranked_speeds(data)
    zeta = DAMPING / (2.0 * math.sqrt(STIFFNESS * 0.05))
    omega = math.sqrt(STIFFNESS / 0.05) * math.sqrt(1.0 - zeta**2)
    assert (row.order, row.source) == ("3× motor (ripple of the drive)", "ripple of the drive")
    assert row.speed == pytest.approx(omega / 3.0, rel=1e-8)
    assert row.participation == pytest.approx(1.0)
