# SPDX-License-Identifier: Apache-2.0
"""Marks of results whose instants are known."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.components.tooth_faults import RootCrack
from pitchpoint.report.scene.marks import MAX_MARKS, contact_marks, fault_marks, scene_marks, tooth_in_mesh
from pitchpoint.viz.scene.contacts import ContactFlank, FlankSurface, SceneContact
from tests.support.scene_models import PAIR, seen

GAP = 40e-6
"""Backlash of the results made up here [m]."""
MODEL = loads_model(PAIR.format(z="[0, 0, 1]", x="[1, 0, 0]"))


def contact(travel: np.ndarray, *, pitch: float = 10e-3, helix: float = 0.0) -> SceneContact:
    """A mesh whose pairs are in mesh from -6 to 8 mm on the path, 20 mm wide, teeth 23 and 41."""
    n = len(travel)
    surfaces = [
        FlankSurface(
            body=k, gear=gear, teeth=teeth, points=np.zeros((2, 2, 3)), turn=0.0, tooth=tooth, step=step
        )
        for k, (gear, teeth, tooth, step) in enumerate((("a", 23, 2, -1), ("b", 41, 7, 1)))
    ]
    front = ContactFlank(
        side=1, travel=travel, forces=np.ones((n, 3)), loads=np.ones((n, 3, 2)), surfaces=surfaces
    )
    return SceneContact(
        name="m",
        at=np.zeros((1, 3)),
        axes=np.eye(3)[None],
        pressure_angle=np.array([0.35]),
        base_helix=helix,
        base_pitch=pitch,
        width=(-10e-3, 10e-3),
        path=(-6e-3, 8e-3),
        penetration=np.zeros((n, 2)),
        flanks=[front],
    )


def result(time: np.ndarray, x: np.ndarray) -> xr.Dataset:
    """Channels of a mesh from the deflection of its gears: flanks touch beyond half of the backlash."""
    state = np.where(x > 0.5 * GAP, 1.0, np.where(x < -0.5 * GAP, -1.0, 0.0))
    channels = {"contact_state": state, "penetration": np.abs(x) - 0.5 * GAP, "deflection": x}
    return xr.Dataset(
        {f"{name}[m]": ("time", values) for name, values in channels.items()}, coords={"time": time}
    )


def test_a_straight_flight_is_lost_and_regained_where_it_crosses_the_gap():
    """From the front flank over the gap to the back flank and back again, at 2 mm/s and at 5 mm/s."""
    corners = [(0.0, 25e-6), (0.025, -25e-6), (0.035, -25e-6), (0.045, 25e-6), (0.1, 25e-6)]
    time = np.linspace(0.0, 0.1, 1283)  # no corner and no crossing falls on a sample
    x = np.interp(time, *zip(*corners, strict=True))
    mesh = contact(np.linspace(0.0, 0.1, time.size))
    marks, notes = scene_marks(MODEL, result(time, x), [mesh], time)
    found = [(m.kind, m.time, m.until) for m in marks if m.kind != "faulty_tooth"]
    first, gone, back = 0.0025, 0.0225, 0.036
    expected = [
        ("contact_loss", first, gone),
        ("back_flank", gone, back),
        ("impact", gone, None),
        ("contact_loss", back, 0.044),
        ("impact", 0.044, None),
    ]
    assert [(k, t) for k, t, _ in sorted(found, key=lambda m: (round(m[1], 6), m[0]))] == [
        (k, pytest.approx(t, abs=1e-9)) for k, t, _ in expected
    ]
    spans = {(k, round(t, 6)): until for k, t, until in found}
    for kind, t, until in expected:
        assert spans[kind, round(t, 6)] == (None if until is None else pytest.approx(until, abs=1e-9))
    impacts = [m.what for m in marks if m.kind == "impact"]
    assert impacts[0].startswith("m, back flank") and "2 mm/s" in impacts[0]
    assert impacts[1].startswith("m, front flank") and "5 mm/s" in impacts[1]
    assert notes == []


def test_a_mesh_that_works_on_its_back_flanks_marks_the_front_ones():
    time = np.linspace(0.0, 1.0, 101)
    x = np.where((time > 0.305) & (time < 0.395), 30e-6, -30e-6)
    kinds = [mark.kind for mark, _ in contact_marks(result(time, x), contact(0.0 * time), time)]
    assert kinds == ["front_flank"]
    steady = contact_marks(result(time, np.full_like(time, -30e-6)), contact(0.0 * time), time)
    assert steady == []


def test_contact_lost_to_the_end_and_a_single_sample_apart():
    time = np.linspace(0.0, 0.01, 11)
    x = np.full(11, 30e-6)
    x[4], x[8:] = 18e-6, 10e-6
    found = contact_marks(result(time, x), contact(0.0 * time), time)
    (first, _), (impact, speed), (last, _) = sorted(
        found, key=lambda one: (one[0].time, one[0].kind != "contact_loss")
    )[:3]
    # straight from 30 to 18 um and back: through 20 um at 5/6 of a sample before and after
    assert (first.time, first.until) == (pytest.approx(3e-3 + 10e-3 / 12), impact.time)
    assert impact.time == pytest.approx(4e-3 + 2e-3 / 12, rel=1e-9)
    assert speed == pytest.approx(12e-6 / 1e-3)
    assert last.kind == "contact_loss" and last.until == time[-1]


def test_of_many_impacts_the_strongest_are_kept():
    time = np.linspace(0.0, 1.0, 30001)
    rattle = 40e-6 * (0.6 + 0.4 * time) * np.sin(2 * math.pi * 200.0 * time)
    marks, notes = scene_marks(MODEL, result(time, rattle), [contact(0.001 * time)], time)
    impacts = [mark for mark in marks if mark.kind == "impact"]
    assert len(impacts) == MAX_MARKS
    assert min(mark.time for mark in impacts) > 0.7, "later ones are faster"
    assert any("marks of impact" in note and "strongest" in note for note in notes)
    assert [mark.time for mark in marks] == sorted(mark.time for mark in marks)


def test_too_coarse_a_record_says_so():
    """A mesh frequency of 1 kHz: 0.2 pairs from sample to sample at 5 kHz, 1.1 at 900 Hz."""
    for rate, words in ((5e3, []), (900.0, ["1.1 tooth pairs per sample interval"])):
        time = np.arange(0.0, 0.1, 1.0 / rate)
        steady = result(time, np.full_like(time, 3e-5))
        _, notes = scene_marks(MODEL, steady, [contact(10.0 * time)], time)
        assert len(notes) == len(words) and all(w in n for w, n in zip(words, notes, strict=True))
    time = np.arange(0.0, 0.1, 1.0 / 5e3)
    steady = result(time, np.full_like(time, 3e-5))
    _, notes = scene_marks(MODEL, steady, [contact(10.0 * time[::6])], time[::6])
    assert "1.2 tooth pairs per frame interval" in notes[0]


@pytest.mark.parametrize("helix", [0.0, 0.25])
@pytest.mark.parametrize("frames", [40, 4001])
def test_a_tooth_is_in_mesh_when_its_line_is_on_the_face(helix, frames):
    """Pair N is at travel - 10 mm N; its tooth of gear 1 is 2 - N, of gear 2 7 + N, modulo the teeth. Lines
    of helical teeth come and go by tan(beta_b) times half of the width earlier and later."""
    time = np.linspace(0.0, 1.0, frames)
    speed = 0.5
    mesh = contact(-0.013 + speed * time, helix=helix)
    more = math.tan(helix) * 10e-3
    (flank,) = mesh.flanks
    for surface, tooth, pairs in ((flank.surfaces[0], 21, (4, 27, 50)), (flank.surfaces[1], 5, (39,))):
        spans = tooth_in_mesh(mesh, flank, surface, tooth, time)
        expected = [
            [(end + pair * 10e-3 + 0.013) / speed for end in (-6e-3 - more, 8e-3 + more)] for pair in pairs
        ]
        assert [list(span) for span in spans if span[0] > 0.0 and span[1] < 1.0] == [
            pytest.approx(e, abs=1e-12) for e in expected if e[1] < 1.0
        ]


def test_a_gear_that_turns_back_has_its_tooth_in_mesh_twice():
    time = np.linspace(0.0, 2.0, 201)
    mesh = contact(0.03 - 0.06 * np.abs(1.0 - time))
    (flank,) = mesh.flanks
    # pair 0 (tooth 2) is between A and E from travel -6 to 8 mm, on the way up and on the way down
    spans = tooth_in_mesh(mesh, flank, flank.surfaces[0], 2, time)
    up = [1.0 - (0.03 - y) / 0.06 for y in (-6e-3, 8e-3)]
    down = [1.0 + (0.03 - y) / 0.06 for y in (8e-3, -6e-3)]
    assert [list(span) for span in spans] == [pytest.approx(up), pytest.approx(down)]


def test_marks_of_a_broken_tooth_are_where_its_pairs_lack_load():
    """Half of the face of tooth 5 is gone at one end: the kernels lay no load there, whatever is marked. It
    comes round once a turn, 0.1 s."""
    fault = "profile_shift_coefficient: 0.2, faults: {broken: {type: broken_tooth, tooth: 5, width: 15 mm}}"
    text = PAIR.format(z="[0, 0, 1]", x="[1, 0, 0]").replace("profile_shift_coefficient: 0.2", fault)
    scene, _, _ = seen(text.replace("600 rpm", "900 rpm"))
    marks = [mark for mark in scene.header["marks"] if mark["kind"] == "faulty_tooth"]
    assert len(marks) >= 2 and all(m["what"] == "a, tooth 5 (broken) in m" for m in marks)
    starts = [mark["time"] for mark in marks if mark["time"] > 0.0]
    assert np.diff(starts) == pytest.approx(60.0 / 900.0, abs=2e-5)
    mesh = scene.contact("m")
    surface = mesh["flanks"][0]["surfaces"][0]
    torn = 0
    for frame, t in enumerate(scene.times):
        for pair, line in scene.lines(mesh, 1, frame).items():
            tooth = (surface["tooth"] + surface["step"] * pair) % surface["teeth"]
            marked = any(mark["time"] <= t <= mark["until"] for mark in marks)
            assert tooth != 5 or marked
            # the break is at the start of the face, from its end to the middle
            gone = line["loads"][line["z"] < -1.5e-3]
            whole = line["loads"][line["z"] > 1.5e-3]
            if line["force"] > 500.0 and gone.size > 2 and whole.size > 2:
                assert (gone[:-1].max() == 0.0) == (tooth == 5)
                torn += tooth == 5
    assert torn > 3


@pytest.mark.parametrize(
    ("gear", "type_", "flank", "side", "marked"),
    [
        ("a", "external", "left", 1, True),
        ("a", "external", "right", 1, False),
        ("a", "external", "right", -1, True),
        ("b", "external", "left", 1, True),
        ("b", "internal", "left", 1, False),
        ("b", "internal", "right", 1, True),
        ("b", "internal", "both", -1, True),
    ],
)
def test_a_fault_counts_on_the_flanks_that_it_is_on(gear, type_, flank, side, marked):
    """Front flanks are the left ones of both gears, but the right ones of a ring, as kernels read them."""
    time = np.linspace(0.0, 1.0, 201)
    mesh = contact(0.5 * time)
    mesh = replace(mesh, flanks=[replace(mesh.flanks[0], side=side)])
    crack = {"crack": RootCrack(tooth=3, flank=flank, depth=1e-3)}
    faults = {name: crack if name == gear else {} for name in "ab"}
    types = {"a": "external", "b": type_}
    gears = {n: SimpleNamespace(type=types[n], tooth_faults=faults[n]) for n in "ab"}
    model = SimpleNamespace(gears=gears)
    found = fault_marks(model, mesh, time)
    assert bool(found) == marked
    assert all(mark.what == f"{gear}, tooth 3 (crack) in m" for mark, _ in found)
