# SPDX-License-Identifier: Apache-2.0
"""Which shaft and gear is damaged: faults at known places, and how often healthy signals alarm."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.analysis.diagnosis import diagnose
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import Bearing, TurningParts, train_parts

RIG = train_parts([(32, 96), (48, 80)]), 300.0, 120.0
SHOVEL = train_parts([(11, 81), (12, 68), (11, 36)]), 430.4 / (740 / 60), 740 / 60 * 15
PAIR = train_parts([(21, 40)]), 128.0, 100.0


def _signal(machine: tuple, seed: int, noise: float = 0.3) -> tuple[np.ndarray, np.ndarray]:
    """Turns of the input and mesh tones in noise."""
    parts, rate, turns = machine
    dice = np.random.default_rng(seed)
    turned = np.arange(int(rate * turns)) / rate
    x = noise * dice.standard_normal(turned.size)
    for mesh in parts.meshes:
        order = parts.mesh_order(mesh)
        for k in (1, 2, 3):
            if k * order < 0.5 * rate:
                x += np.cos(2 * np.pi * k * order * turned + dice.uniform(0, 6)) / k
    return turned, x


def _kinds(x: np.ndarray, machine: tuple) -> list[tuple[str, str, tuple[str, ...]]]:
    found = diagnose({"acc": x}, machine[1], machine[0])
    return [
        (one.kind, one.shaft, one.gears)
        for one in (*found.findings, *found.observations)
        if one.kind != "every order"
    ]


def _mesh_of(parts: TurningParts, gear: str) -> tuple[float, float, int]:
    mesh = next(mesh for mesh in parts.meshes if gear in mesh.gears)
    place = mesh.gears.index(gear)
    return parts.mesh_order(mesh), float(parts.shaft(mesh.shafts[place]).order), mesh.teeth[place]


@pytest.mark.parametrize(
    ("machine", "gear", "shaft", "gears"),
    [
        (RIG, "Z1", "shaft 1", ("Z1",)),
        # the mesh of Z2 is the second harmonic of that of Z3: nothing distinguishes them
        (RIG, "Z2", "shaft 2", ("Z2", "Z3")),
        (RIG, "Z4", "shaft 3", ("Z4",)),
        (PAIR, "Z1", "shaft 1", ("Z1",)),
        (PAIR, "Z2", "shaft 2", ("Z2",)),
        (SHOVEL, "Z3", "shaft 2", ("Z3",)),
        # 4.4 turns
        (SHOVEL, "Z5", "shaft 3", ("Z5",)),
    ],
)
def test_a_tooth_that_carries_less_is_a_local_fault_of_its_shaft(
    machine: tuple, gear: str, shaft: str, gears: tuple[str, ...]
) -> None:
    turned, x = _signal(machine, 1)
    order, turning, teeth = _mesh_of(machine[0], gear)
    gap = np.exp(-((((turned * turning + 0.37) % 1 - 0.5) * teeth / 0.7) ** 2))
    tones = [np.cos(2 * np.pi * k * order * turned) / k for k in (1, 2, 3) if k * order < 0.5 * machine[1]]
    (found,) = _kinds(x + 0.6 * gap - 0.8 * gap * sum(tones), machine)
    assert found[:2] == ("local fault", shaft)
    assert set(gears) <= set(found[2])


@pytest.mark.parametrize(
    ("machine", "gear", "shaft"),
    [(RIG, "Z1", "shaft 1"), (RIG, "Z3", "shaft 2"), (RIG, "Z4", "shaft 3"), (SHOVEL, "Z2", "shaft 2")],
)
def test_an_eccentric_gear_modulates_its_mesh_and_is_no_local_fault(
    machine: tuple, gear: str, shaft: str
) -> None:
    turned, x = _signal(machine, 2)
    order, turning, _ = _mesh_of(machine[0], gear)
    x += 0.3 * np.cos(2 * np.pi * turning * turned) * np.cos(2 * np.pi * order * turned)
    assert _kinds(x, machine) == [("modulation", shaft, (gear,))]


def test_unbalance_is_a_line_at_the_turns_of_its_shaft() -> None:
    turned, x = _signal(PAIR, 3)
    assert _kinds(x + 0.3 * np.cos(2 * np.pi * turned), PAIR) == [("once per turn", "shaft 1", ())]


@pytest.mark.parametrize("part", ["outer ring", "inner ring"])
def test_a_bearing_shows_in_the_envelope_also_when_its_elements_slip(part: str) -> None:
    orders = {"outer ring": 3.573, "inner ring": 5.17}
    machine = train_parts([(21, 40)], [Bearing("left", orders)]), 400.0, 100.0
    turned, x = _signal(machine, 4)
    slip = np.cumsum(np.random.default_rng(5).standard_normal(turned.size)) * 2e-3
    phase = turned * orders[part] * 1.004 + slip
    x += 2.0 * np.exp(-20.0 * (phase % 1)) * np.sin(2 * np.pi * 130 * (phase % 1) / orders[part])
    assert _kinds(x, machine) == [("bearing", part, ("left",))]


@pytest.mark.parametrize("machine", [PAIR, pytest.param(SHOVEL, marks=pytest.mark.study)])
def test_healthy_signals_raise_no_more_alarms_than_allowed(machine: tuple) -> None:
    # 1 % allowed: of 100 seeds, five or more alarms have the probability 0.3 %
    alarms = sum(bool(_kinds(_signal(machine, seed, noise=1.0)[1], machine)) for seed in range(100))
    assert alarms < 5


def test_too_few_turns_are_told_and_constant_channels_refused() -> None:
    _, x = _signal(SHOVEL, 5)
    found = diagnose({"acc": x}, SHOVEL[1], SHOVEL[0])
    assert "too few revolutions of shaft 4 (1.4); needs about 3" in found.untested
    with pytest.raises(SignalError, match="acc: is constant"):
        diagnose({"acc": np.ones(1000)}, 128.0, PAIR[0])


def _struck(order: float, seed: int = 1) -> np.ndarray:
    """A pair 21/40 in noise, struck without slip so many times in a turn of the input; each rings down."""
    turned = np.arange(40_000) / 400.0
    since = (turned * order + 0.3) % 1 / order
    x = np.cos(2 * np.pi * 21 * turned) + 0.5 * np.cos(2 * np.pi * 42 * turned)
    x += 0.4 * np.random.default_rng(seed).standard_normal(turned.size)
    return x + 1.5 * np.exp(-20 * since) * np.sin(2 * np.pi * 130 * since)


def _of_struck(order: float, passes: float) -> tuple[list[tuple[str, str, tuple, tuple]], tuple[str, ...]]:
    """Findings where a bearing has its balls pass so many times in a turn; 100 turns."""
    parts = train_parts([(21, 40)], [Bearing("left", {"outer ring": passes})])
    found = diagnose({"acc": _struck(order)}, 400.0, parts)
    return [(f.kind, f.shaft, f.gears, f.bearings) for f in found.findings], found.untested


@pytest.mark.parametrize("passes", [3.57, 3.05])
def test_a_bearing_without_slip_is_no_gear(passes: float) -> None:
    assert _of_struck(passes, passes)[0] == [("bearing", "outer ring", ("left",), ())]
    assert _of_struck(1.0, passes)[0] == [("local fault", "shaft 1", ("Z1",), ())]


@pytest.mark.parametrize("passes", [1.0, 2.0, 3.0])
def test_a_bearing_on_a_harmonic_of_a_shaft_is_named_with_the_gear(passes: float) -> None:
    findings, untested = _of_struck(passes, passes)
    assert findings == [("local fault", "shaft 1", ("Z1",), ("outer ring of left",))]
    assert any(
        text.startswith("outer ring of left cannot be distinguished from shaft orders") for text in untested
    )


def test_a_tooth_is_not_a_bearing_that_strikes_three_times_in_a_turn() -> None:
    assert _of_struck(1.0, 3.0)[0] == [("local fault", "shaft 1", ("Z1",), ())]


def test_a_difference_that_the_record_does_not_resolve_is_told() -> None:
    # 0.4 lines of a record of 100 turns
    findings, untested = _of_struck(3.004, 3.004)
    assert all(finding[0] != "bearing" for finding in findings)
    assert any("cannot be distinguished from shaft orders" in text for text in untested)


def test_passing_balls_of_a_healthy_bearing_are_neither_sidebands_nor_damage() -> None:
    """Meshes modulated at 3.05 orders, as by a bearing that is stiffer with a ball below the load."""
    machine = train_parts([(21, 40)], [Bearing("left", {"outer ring": 3.05})]), 128.0, 60.0
    turned, x = _signal(machine, 6)
    shaken = x * (1.0 + 0.2 * np.cos(2 * np.pi * 3.05 * turned))
    assert _kinds(shaken, machine) == []
    # what turns with the shaft itself is told, where no bearing may be the cause
    assert _kinds(x * (1.0 + 0.2 * np.cos(2 * np.pi * 3.0 * turned)), (PAIR[0], 128.0, 60.0)) != []


def test_equal_bearings_are_named_together() -> None:
    parts = train_parts([(21, 40)], [Bearing(name, {"outer ring": 3.57}) for name in ("left", "right")])
    found = diagnose({"acc": _struck(3.57)}, 400.0, parts)
    assert [finding.gears for finding in found.findings] == [("left or right",)]


def test_bearings_of_a_record_of_a_few_turns_are_not_tested_and_told() -> None:
    """Three turns: lines of a healthy machine fill the spectrum, and nothing is left in which to look."""
    bearings = [Bearing(f"b{k}", {"outer ring": order, "inner ring": 8 - order}) for k, order in
                enumerate((3.0523, 1.0174, 0.6105))]  # fmt: skip
    parts = train_parts([(32, 96), (48, 80)], bearings)
    found = diagnose({"acc": _struck(1.0)[:1600]}, 400.0, parts)
    assert any(text.startswith(("too few events", "bearings not tested")) for text in found.untested)
    assert all(finding.kind != "bearing" for finding in found.findings)


def _strikes(turned: np.ndarray, amplitude: np.ndarray, teeth: int) -> np.ndarray:
    """A knock that rings down at each tooth of shaft 2 (12/68), as large as `amplitude` says there."""
    since = (turned * 12 / 68 * teeth + 0.4) % 1 / teeth
    return amplitude * np.exp(-900.0 * since) * np.sin(2 * np.pi * 1500.0 * since)


@pytest.mark.parametrize("one", [0.0, 6.0])
def test_teeth_that_another_mesh_makes_unequal_are_not_one_damaged_tooth(one: float) -> None:
    """With 68 and 11 teeth on a shaft, products of both meshes are on all of its orders, and peaked."""
    parts, rate = train_parts([(12, 68), (11, 36)]), 1200.0
    turned = np.arange(int(rate * 120)) / rate
    wheel = turned * 12 / 68
    number = np.floor((wheel * 11 + 0.4) % 11)
    unequal = 1.0 + 0.3 * np.cos(2 * np.pi * 68 * wheel) + 0.25 * np.sin(4 * np.pi * 68 * wheel)
    x = 0.05 * np.random.default_rng(8).standard_normal(turned.size) + 0.2 * np.cos(2 * np.pi * 12 * turned)
    x += _strikes(turned, unequal + one * (number == 3), 11)
    found = diagnose({"acc": x}, rate, parts)
    (comb,) = [e for e in found.evidence if (e.kind, e.shaft) == ("comb", "shaft 2")]
    assert comb.found
    assert [(f.kind, f.shaft) for f in found.findings] == ([("local fault", "shaft 2")] if one else [])
    assert any((o.kind, o.shaft) == ("every order", "shaft 2") for o in found.observations) == (not one)
