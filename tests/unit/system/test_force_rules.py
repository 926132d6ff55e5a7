# SPDX-License-Identifier: Apache-2.0
"""Force elements from what a user describes: records, hidden bodies, defaults."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from pitchpoint.contact.rolling import ball_bearing_stiffness
from pitchpoint.core.errors import CompileError
from pitchpoint.model.components.bushing import Bushing
from pitchpoint.model.components.clutch import Clutch
from pitchpoint.model.components.law import Constant, FormulaLaw, PythonLaw, TableLaw
from pitchpoint.model.components.rolling_bearing import PlainBearing, RollingBearing
from pitchpoint.model.components.six import Damping6, Stiffness6
from pitchpoint.model.components.spring import Maxwell, Spring
from pitchpoint.model.components.torsion_spring import TorsionMaxwell, TorsionSpring
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system.rules.bushing import bushing_bank
from pitchpoint.system.rules.clutch import clutch_bank
from pitchpoint.system.rules.places import Places, hidden_bodies
from pitchpoint.system.rules.rolling_bearing import plain_bearing_bank, rolling_bearing_bank
from pitchpoint.system.rules.spring import (
    maxwell_bank,
    spring_bank,
    torsion_maxwell_bank,
    torsion_spring_bank,
)
from pitchpoint.system.system import assemble
from tests.support.forces import wrenches

BODIES = [
    Body(motion=FREE, position=(0.0, 0.0, 0.1), mass=1.0, polar_inertia=0.2, transverse_inertia=0.1, name=n)
    for n in ("a", "b")
]
NUMBER = {"ground": 0, "a": 1, "b": 2}
POINTS = {"eye": np.array([0.0, 0.3, 0.0])}


def end(name):
    body, _, marker = name.partition(".")
    turned = np.diag([-1.0, -1.0, 1.0]) if marker == "turned" else np.eye(3)
    return NUMBER[body], POINTS.get(marker, np.zeros(3)), turned


def world(name):
    number, point, _ = end(name)
    return point if number == 0 else point + BODIES[number - 1].position


PLACES = Places(end, world, lambda name: end(name)[2], {"m": 3}.__getitem__, tree=tuple(BODIES))


def places(**sections):
    """What rules of a model with these sections read."""
    return replace(PLACES, model=SimpleNamespace(mechanism=SimpleNamespace(seats={}), **sections))


def system_of(bank, states=()):
    """A system with the bank of one rule."""
    given = {bank.kind: bank.records}
    pools = {} if bank.pool is None else {bank.kind: bank.pool}
    laws = {} if bank.laws is None else {bank.kind: list(bank.laws)}
    return assemble(
        BODIES + hidden_bodies(states), given, names={bank.kind: list(bank.names)}, pools=pools, laws=laws
    )


def moved(system, **coordinates):
    """Wrench on the first body where coordinates (q, or v after v_) are not zero."""
    state = system.initial_state()
    for name, value in coordinates.items():
        rate = name.startswith("v_")
        target = state.v if rate else state.q
        target[system.layout.coordinate(name.removeprefix("v_").replace("__", "."))] = value
    return wrenches(system, state)[1]


def test_springs():
    part = Spring(ends=("a.eye", "ground"), stiffness=50.0, damping=2.0)
    bank = spring_bank(places(springs={"s": part}))
    assert bank.records["free"][0] == pytest.approx(np.hypot(0.3, 0.1))
    assert not np.any(np.abs(moved(system_of(bank))) > 1e-15)
    bank = spring_bank(places(springs={"s": Spring(ends=("a", "ground"), stiffness=50.0, free_length=0.0)}))
    np.testing.assert_allclose(moved(system_of(bank))[:3], [0.0, 0.0, -5.0], atol=1e-15)


def test_springs_with_a_law_of_their_own(tmp_path):
    (tmp_path / "law.py").write_text("def tension(t, x, p):\n    return p[0] * x + 3.0 * p[1]\n")
    law = PythonLaw(str(tmp_path / "law.py"), "tension", (7.0,))
    bank = spring_bank(places(springs={"s": Spring(ends=("a", "ground"), free_length=0.0, force=law)}))
    found = moved(system_of(bank), a__z=0.1, v_a__z=0.5)
    assert found[2] == pytest.approx(-(7.0 * 0.2 + 1.5))


@pytest.mark.parametrize(
    ("law", "torque"),
    [
        (None, -6.0),
        (Constant(1.0), -5.0),
        (FormulaLaw("2*speed"), -5.0),
        (TableLaw((-1.0, 1.0), (4.0, -4.0), "angle"), -10.0),
        (TableLaw((0.0, 1.0), (5.0, 5.0)), -1.0),
    ],
)
def test_torsion_springs(law, torque):
    part = TorsionSpring(bodies=("a", "b"), stiffness=2.0, angle=0.5, torque=law)
    system = system_of(torsion_spring_bank(places(torsion_springs={"s": part})))
    assert moved(system, a__spin=2.5, b__spin=-1.0, v_a__spin=0.5)[5] == pytest.approx(torque)


def test_bushings():
    K = Stiffness6(radial=100.0, axial=50.0, torsion=7.0)
    part = Bushing(ends=("a", "b"), stiffness=K, damping=Damping6(axial=3.0))
    system = system_of(bushing_bank(places(bushings={"b": part})))
    found = moved(system, a__x=0.1, a__spin=0.2, v_b__z=1.0)
    np.testing.assert_allclose(found[[0, 1, 2, 5]], [-10.0, 0.0, 3.0, -1.4], atol=1e-14)


BALLS = {"ends": ("a", "b"), "elements": 9, "element_diameter": 12.7e-3, "pitch_diameter": 65e-3}


def test_rolling_bearings():
    part = RollingBearing(grooves=(0.52, 0.52), clearance=20e-6, **BALLS)
    record = rolling_bearing_bank(places(rolling_bearings={"r": part})).records[0]
    steel = 2.0 * (1.0 - 0.3**2) / 206e9
    wanted = ball_bearing_stiffness(12.7e-3, 65e-3, (0.52, 0.52), 0.0, steel)
    assert record["stiffness"] == pytest.approx(wanted)
    assert record["gap"] == 10e-6
    assert record["grooves"] == pytest.approx(0.04 * 12.7e-3)
    roller = RollingBearing(type="roller", effective_length=12e-3, **BALLS)
    record = rolling_bearing_bank(places(rolling_bearings={"r": roller})).records[0]
    assert record["exponent"] == pytest.approx(10.0 / 9.0)
    # Palmgren, two contacts: delta = 2 * 3.84e-5 Q^0.9/l^0.8 in N and mm for steel (E 206: 3.85)
    assert 1e3 * (1000.0 / record["stiffness"]) ** 0.9 == pytest.approx(
        2 * 3.84e-5 * 1000.0**0.9 / 12.0**0.8, rel=4e-3
    )
    given = RollingBearing(stiffness=1e9, **BALLS | {"ends": ("a.turned", "b")})
    np.testing.assert_allclose(
        rolling_bearing_bank(places(rolling_bearings={"r": given})).records["A_i"][0], np.eye(3), atol=1e-15
    )
    assert rolling_bearing_bank(places(rolling_bearings={"r": given})).records["stiffness"][0] == 1e9
    with pytest.raises(CompileError, match=r"rolling_bearings\.r: give grooves, or stiffness"):
        rolling_bearing_bank(places(rolling_bearings={"r": RollingBearing(**BALLS)}))


def test_plain_bearings():
    part = PlainBearing(ends=("a", "b"), clearance=2e-3, stiffness=1e6)
    system = system_of(plain_bearing_bank(places(plain_bearings={"p": part})))
    assert not np.any(moved(system, a__x=0.9e-3))
    assert moved(system, a__x=3e-3)[0] == pytest.approx(-2000.0)


def test_clutches():
    clutches = {
        "m": Clutch(bodies=("a", "b"), capacity=TableLaw((0.0, 1.0), (5.0, 9.0)), wind_up=1e-2),
        "n": Clutch(bodies=("a",), capacity=Constant(3.0), law="smooth", slip_speed=0.5),
    }
    bank = clutch_bank(places(clutches=clutches))
    assert bank.records["k"].tolist() == [3, 0]
    assert bank.records["stiffness"][0] == pytest.approx(100.0)
    system = system_of(bank, ["m"])
    assert [b.name for b in system.bodies] == ["a", "b", "m.state"]
    # fast slip: the brake at its capacity, the bristles still straight
    assert moved(system, v_a__spin=2.0)[5] == pytest.approx(-3.0 - 5.0 * 1e-3 * 100.0 * 2.0)


def test_maxwell_elements():
    line = maxwell_bank(places(maxwells={"m": Maxwell(ends=("a", "ground"), stiffness=10.0, damping=2.0)}))
    system = system_of(line, ["m"])
    state = system.initial_state()
    state.v[system.spin("m.state")] = 4.0
    np.testing.assert_allclose(wrenches(system, state)[1, :3], [0.0, 0.0, -4.0])
    turn = torsion_maxwell_bank(
        places(torsion_maxwells={"m": TorsionMaxwell(bodies=("a", "b"), stiffness=10.0, damping=2.0)})
    )
    system = system_of(turn, ["m"])
    state = system.initial_state()
    state.v[system.spin("m.state")] = 4.0
    assert wrenches(system, state)[1, 5] == pytest.approx(4.0)
