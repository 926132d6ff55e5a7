# SPDX-License-Identifier: Apache-2.0
"""Several sensors: default channels, places by name or option, nearest sensor, faults seen only elsewhere."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from pitchpoint.analysis.diagnosis import Diagnosis
from pitchpoint.analysis.findings import Evidence, Finding
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.analysis.turning_parts import Bearing, Mesh, Shaft, TurningParts, train_parts
from pitchpoint.report.diagnosis.channels import MOST, Places, every_quantity, given_places, preferred
from pitchpoint.report.diagnosis.levels import levels_of, nearest_sensor
from pitchpoint.report.diagnosis.over_angle import OverAngle
from pitchpoint.report.diagnosis.study import Study, study

RATE, TURNS = 200.0, 300.0
ORDERS = {"outer ring": 3.58, "inner ring": 5.42}
ONE_SHAFT = (Shaft("rotor", Fraction(1)),)


def _channel(strength: float, seed: int, order: float = 3.585) -> np.ndarray:
    """Impacts of the outer ring in noise of the power one."""
    turned = np.arange(int(RATE * TURNS)) / RATE
    power = 1.0 + strength * np.exp(-8.0 * (order * turned % 1.0))
    return np.sqrt(power) * np.random.default_rng(seed).standard_normal(turned.size)


def _study(channels: dict[str, np.ndarray], bearings: tuple[Bearing, ...], **given: tuple[str, ...]) -> Study:
    parts = TurningParts(ONE_SHAFT, (), bearings)
    over = OverAngle(channels, RATE, 25.0, RATE)
    return study(over, parts, false_alarm=0.01, sensors=Places(parts, {}, given))


def test_the_nearest_sensor_is_that_with_the_highest_level() -> None:
    bearings = (Bearing("left", ORDERS, "rotor"), Bearing("right", ORDERS, "rotor"))
    channels = {"acc_right": _channel(2.0, 1), "acc_left": _channel(30.0, 2), "far": _channel(0.0, 3)}
    found = _study(channels, bearings)
    (rows,) = found.levels
    assert [row.channel for row in rows] == ["acc_left", "acc_right", "far"]
    assert [row.visible for row in rows] == [True, True, False]
    apart = rows[0].value - rows[0].limit - (rows[1].value - rows[1].limit)
    assert apart > 3.0
    # equal bearings are not distinguished by their lines, but by the sensor
    (words,) = found.sensors
    assert words.startswith(f"nearest of the given sensors: acc_left, near left (by {apart:.0f} dB); ")
    assert words.endswith("below the limit in far")
    (row,) = found.as_data()["findings"]
    assert row["nearest_sensor"] == words and row["levels"][0]["channel"] == "acc_left"


def test_channels_are_compared_in_the_same_detector() -> None:
    """Levels of different detectors are not comparable: 9 dB above 15 dB in one, 3 dB above 27 dB in another.

    By the one that names the part in both, "b" is 4 dB clearer.
    """
    levels = {
        "a": {"one": (24.0, 15.0), "two": (20.0, 27.0)},
        "b": {"one": (28.0, 15.0), "two": (30.0, 27.0)},
    }
    by = {"a": "one", "b": "two"}
    rows = tuple(
        Evidence(
            channel=name,
            kind="bearing",
            shaft="outer ring",
            gear="left",
            value=mine[by[name]][0],
            threshold=mine[by[name]][1],
            probability=1e-9,
            order=3.58,
            amplitude=0.0,
            sideband=0,
            found=True,
            detectors=(by[name],),
            levels=mine,
        )
        for name, mine in levels.items()
    )
    finding = Finding("bearing", "outer ring", ("left",), "a", 1e-9)
    parts = TurningParts(ONE_SHAFT, (), (Bearing("left", ORDERS, "rotor"),))
    known = Diagnosis((finding,), (), rows, {}, (), (), {"rotor": 300.0}, 2, 0.01)
    found = levels_of(finding, known, parts, 300.0)
    assert [(row.channel, row.value, row.limit) for row in found] == [("b", 28.0, 15.0), ("a", 24.0, 15.0)]
    words = nearest_sensor(finding, found, Places(parts))
    assert words == "nearest of the given sensors: b (by 4 dB); 9 dB above the limit in a"


def test_the_probability_in_noise_is_that_of_all_channels() -> None:
    """Each part is tested as often as there are channels (Bonferroni)."""
    bearings = (Bearing("left", ORDERS, "rotor"),)
    channels = {"a": _channel(30.0, 2), "b": _channel(0.0, 3), "c": _channel(0.0, 4)}
    alone, all_three = (
        {(e.channel, e.shaft): e.probability for e in _study(some, bearings).diagnosis.evidence}
        for some in ({"a": channels["a"]}, channels)
    )
    compared = {key: p for key, p in alone.items() if 0.0 < p < 0.3}
    assert compared
    for key, chance in compared.items():
        assert all_three[key] == pytest.approx(3.0 * chance)


def test_bearings_with_similar_lines_are_named_by_the_nearest_sensor() -> None:
    """Orders that differ by 0.4 %, within the slip: both are named, the one at the clearest sensor first."""
    other = {part: 1.004 * order for part, order in ORDERS.items()}
    for near, far in (("left", "right"), ("right", "left")):
        bearings = (Bearing("left", ORDERS, "rotor"), Bearing("right", other, "rotor"))
        found = _study({f"acc {near}": _channel(30.0, 2), f"acc {far}": _channel(1.0, 1)}, bearings)
        (finding,) = found.diagnosis.findings
        assert finding.gears == (near,) and finding.bearings == (f"outer ring of {far}",)
        words = f"of bearing {near} (or outer ring of {far}: this record cannot distinguish them)"
        assert words in found.sentences[0]


def test_a_bearing_is_not_named_if_only_the_sensor_of_another_one_shows_it() -> None:
    bearings = (Bearing("left", ORDERS, "rotor"), Bearing("right", {"outer ring": 3.05}, "rotor"))
    channels = {"ch1": _channel(30.0, 2), "ch2": _channel(0.0, 1)}
    assert [f.gears for f in _study(channels, bearings).diagnosis.findings] == [("left",)]
    found = _study(channels, bearings, ch1=("right",), ch2=("left",))
    assert found.diagnosis.findings == ()
    (*_, reason) = found.diagnosis.unreported
    assert reason.startswith("outer ring of left in ch1: not visible in ch2, next to this bearing; ")
    assert found.sentences[0].startswith("nothing found: 1 of 10 tests exceeds its limit")


TRAIN = train_parts([(20, 40), (17, 60), (21, 43), (19, 44)])
PARTS = TurningParts(
    TRAIN.shafts,
    TRAIN.meshes,
    tuple(Bearing(f"b{k}", ORDERS, f"shaft {k // 2 + 1}") for k in range(10)),
)


def test_default_channels_of_a_result_are_near_every_bearing() -> None:
    names = [f"bearing_force[b{k}]" for k in range(10)]
    chosen = preferred(names, Places(PARTS))
    assert chosen == names and len(chosen) <= MOST
    assert Places(PARTS).remark(chosen, True) == []
    # without the machine, six spread over the list
    few = preferred(names)
    assert few == [names[k * 10 // 6] for k in range(6)]
    (remark,) = Places(PARTS).remark(few, True)
    assert remark == "no tested channel is near b2, b4, b7, b9; --all-channels tests all"


def test_default_channels_remain_six_if_they_are_near_everything() -> None:
    names = [f"acceleration[shaft {k // 6 + 1}][{k}]" for k in range(30)]
    assert preferred(names, Places(PARTS)) == preferred(names)


SIDES = ("left", "right")
TWO_SIDES = TurningParts(
    (Shaft("left in or right in", Fraction(1)), Shaft("left out or right out", Fraction(1, 2))),
    (
        Mesh(
            "left or right",
            ("a or c", "b or d"),
            (20, 40),
            ("left in or right in", "left out or right out"),
        ),
    ),
)
BODIES = {f"{side} {end}": f"left {end} or right {end}" for side in SIDES for end in ("in", "out")}
SENSED = [f"signal[{name}]" for name in ("left in x", "left in y", "left out x")]
INSIDE = [f"mesh_force[{side}]" for side in SIDES]


def test_a_side_without_sensors_is_seen_by_internal_quantities() -> None:
    """Equal meshes of two sides have the same lines, but a sensor is near that of its own side only."""
    places = Places(TWO_SIDES, BODIES, meshes_at={body: (body.split()[0],) for body in BODIES})
    assert places.singly(SENSED[0]) == {"left"} and places.near(SENSED[0]) == {"left or right"}
    chosen = preferred([*INSIDE, *SENSED], places)
    assert chosen == [*SENSED, "mesh_force[right]"]
    (remark,) = places.remark(chosen, True)
    assert remark == "no sensor is near right: mesh_force[right] tested instead"
    # what no channel is near to is stated
    assert preferred(SENSED, places) == SENSED
    assert places.remark(SENSED, False) == ["no tested channel is near right"]
    # internal quantities alone are no replacement for sensors
    assert places.remark(INSIDE, True) == []


def test_a_side_with_a_sensor_needs_no_internal_quantity() -> None:
    places = Places(TWO_SIDES, BODIES, meshes_at={body: (body.split()[0],) for body in BODIES})
    assert preferred([*INSIDE, *SENSED, "signal[right out x]"], places) == [*SENSED, "signal[right out x]"]


def test_channels_without_known_places_have_no_remark() -> None:
    assert Places(PARTS).remark(["acc 1", "acc 2"], False) == []


def test_all_channels_are_those_of_vibration() -> None:
    names = ["angle[a]", "mesh_force[m]", "signal[s]", "power[a]", "bearing_force[b.fx]"]
    assert every_quantity([*names, "bearing_force[b.direction]"]) == [names[2], names[4], names[1]]


def test_places_by_name_and_by_option() -> None:
    mesh = Mesh("first", ("z1", "z2"), (20, 40), ("input", "output"))
    shafts = (Shaft("input", Fraction(1)), Shaft("output", Fraction(1, 2)))
    bearings = (Bearing("input_a", ORDERS, "input"), Bearing("input_b", ORDERS, "input"))
    places = Places(TurningParts(shafts, (mesh,), bearings), {"input": "input", "output": "output"})
    assert places.near("acc input") == {"first", "input_a", "input_b"}
    assert places.near("bearing_force[input_a]") == {"first", "input_a"}  # the longer name counts
    assert places.near("X_OUTPUT_z") == {"first"}
    assert places.near("acc") == frozenset()
    found = given_places(["*_1=input_b"], ["acc_1", "acc_2"], places)
    assert found == {"acc_1": ("input_b",)}
    for text, words in (
        ("acc_1", "is not CHANNEL=PART"),
        ("acc_1=inptu_a", "no bearing, mesh or shaft 'inptu_a'; did you mean input_a"),
        ("ac_1=input_a", "no channel ac_1; did you mean acc_1"),
    ):
        with pytest.raises(SignalError, match=words.replace("?", r"\?")):
            given_places([text], ["acc_1", "acc_2"], places)
