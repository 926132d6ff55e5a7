# SPDX-License-Identifier: Apache-2.0
"""Parts of a gearbox in section whose shape the model does not give: their positions and radii are those of
the model."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.model import Model
from pitchpoint.report.section.build import gearbox_drawing, section_of
from pitchpoint.report.section.transverse import transverse_of
from pitchpoint.viz.label_placement import Label, common_area
from pitchpoint.viz.section_content import Piece, Section, SectionLink
from pitchpoint.viz.section_drawing import section_parts
from pitchpoint.viz.wheel_labels import column_labels, wheel_labels

HOUSE = Path(__file__).parents[3]
SET = """
gears:
  sun: {number_of_teeth: 24, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
  ring: {type: internal, number_of_teeth: 72, normal_module: 2 mm, face_width: 20 mm,
    profile_shift_coefficient: 0, bore_diameter: 160 mm}
  drive: {number_of_teeth: 90, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0,
    bore_diameter: 150 mm}
  wheel: {number_of_teeth: 30, normal_module: 2 mm, face_width: 20 mm, profile_shift_coefficient: 0}
bodies:
  sun: {gears: [sun], position: [0, 0, 0]}
  carrier: {inertia: 1e-3 kg m^2}
  drum: {gears: {ring: 0 mm, drive: 60 mm}, position: [0, 0, 0]}
  wheel: {gears: {wheel: 60 mm}, position: [120 mm, 0, 0]}
planetary_stages:
  set: {sun: sun, ring: ring, carrier: carrier, planets: 3, planet: {number_of_teeth: 24, normal_module: 2 mm,
    face_width: 20 mm, profile_shift_coefficient: 0, bore_diameter: 16 mm}}
meshes: {out: {gears: [drive, wheel]}}
clutches:
  lock: {bodies: [carrier, drum], capacity: 100 N m}
  hold: {bodies: [drum], capacity: 100 N m}
  stop: {bodies: [sun], capacity: 100 N m}
"""


@pytest.fixture(scope="module")
def wind_drive() -> tuple[Model, Section]:
    model = load_model(HOUSE / "examples/wind-drive-5mw/model.yaml")
    return model, _section(model)


@pytest.fixture(scope="module")
def planetary() -> Section:
    return _section(loads_model(SET))


def _section(model: Model) -> Section:
    found = section_of(model)
    assert found is not None
    return found


def _named(section: Section, name: str) -> Piece:
    return next(p for axis in section.axes for p in axis.pieces if p.name == name)


def _kind(section: Section, kind: str) -> list[Piece]:
    return [p for axis in section.axes for p in axis.pieces if p.kind == kind]


def test_carriers_fixed_to_shafts_are_drawn(wind_drive: tuple[Model, Section]) -> None:
    """Plates next to planets of 491 mm, up to beyond the pins of 400 mm at 863 mm; a hub up to the shaft."""
    _, section = wind_drive
    assert not section.apart
    plate = _named(section, "carrier_1")
    assert plate.kind == "plate"
    low, high = plate.line[:, 0].min(), plate.line[:, 0].max()
    assert high < -0.2455 and low > -0.4  # between the planets and the end of the main shaft at -400 mm
    assert plate.line[:, 1].max() == pytest.approx(0.863 + 1.7 * 0.2)
    hub = [p for p in _kind(section, "plate") if p.line[:, 0].min() == pytest.approx(-0.4)]
    assert [p.line[:, 1].max() for p in hub] == pytest.approx([0.35])
    pins = sorted(p.line[:, 1].max() for p in _kind(section, "pin"))
    assert pins == pytest.approx([0.19, 0.19, 0.2, 0.2])


def test_bodies_fixed_to_shafts_are_discs_at_their_places(wind_drive: tuple[Model, Section]) -> None:
    """Rotor before the start of the main shaft at -2.4 m; brake disc on the shaft of 280 mm at 2.781 m."""
    _, section = wind_drive
    rotor, disc = _named(section, "rotor"), _named(section, "brake_disc")
    assert rotor.line[:, 0].max() == pytest.approx(-2.4)
    assert disc.line[:, 0].mean() == pytest.approx(2.781)
    assert disc.line[:, 1].min() == pytest.approx(0.14)


def test_carrier_bearings_are_around_the_plates(wind_drive: tuple[Model, Section]) -> None:
    """At their positions of 300 mm on both sides, on the outside radius of the plates."""
    _, section = wind_drive
    for name, z in (("PLC_A", -0.3), ("PLC_B", 0.3)):
        line = _named(section, name).line
        assert line[:, 0].mean() == pytest.approx(z)
        assert line[:, 1].min() == pytest.approx(0.863 + 1.7 * 0.2)


def test_a_brake_is_at_its_marker_in_a_fixed_part(wind_drive: tuple[Model, Section]) -> None:
    _, section = wind_drive
    ground = _named(section, "brake")
    disc = next(p for p in _kind(section, "lining"))
    assert ground.kind == "ground"
    assert ground.line[:, 0].mean() == disc.line[:, 0].mean() == pytest.approx(1.931 + 0.85)
    assert disc.line[:, 1].min() == pytest.approx(0.14)
    assert ground.line[:, 1].min() > disc.line[:, 1].max()


def test_main_bearings_have_pedestals_of_their_own(wind_drive: tuple[Model, Section]) -> None:
    """The main shaft has no gears: its bearings are not in the walls of the gearbox."""
    _, section = wind_drive
    places = sorted(p.line[:, 0].mean() for p in _kind(section, "pedestal"))
    assert places == pytest.approx([-2.4 + 0.333, -2.4 + 1.166])


def test_a_drum_leads_from_a_ring_to_the_next_gear(planetary: Section) -> None:
    """Between the ring gear up to 10 mm and the wheel from 50 mm, outside of the planets; it is hollow."""
    model = loads_model(SET)
    tips = 48e-3 + 0.5 * model.gears["planet_1"].geometry.d_a
    drum = max(_kind(planetary, "drum"), key=lambda p: float(np.ptp(p.line[:, 0])))
    assert (drum.line[:, 0].min(), drum.line[:, 0].max()) == pytest.approx((0.01, 0.05))
    assert tips < drum.line[:, 1].min() < drum.line[:, 1].max() <= 80e-3
    spindles = [p for p in _kind(planetary, "spindle") if p.line[:, 1].max() > 70e-3]
    assert not spindles


def test_a_clutch_between_carrier_and_ring_has_two_plates(planetary: Section) -> None:
    """Side by side beyond the planets, between the radii of carrier and ring."""
    plate = _named(planetary, "lock")
    other = min(
        (p for p in _kind(planetary, "lining") if p is not plate),
        key=lambda p: abs(float(p.line[:, 0].mean() - plate.line[:, 0].mean())),
    )
    assert other.line[:, 0].max() < plate.line[:, 0].min()
    assert np.allclose(other.line[:, 1], plate.line[:, 1])
    assert abs(float(plate.line[:, 0].mean())) > 10e-3
    assert plate.line[:, 1].max() <= 80e-3 + 1e-9


def test_a_brake_of_a_ring_is_around_it(planetary: Section) -> None:
    ground = _named(planetary, "hold")
    disc = next(p for p in _kind(planetary, "lining") if p.line[:, 1].min() == pytest.approx(80e-3))
    assert disc.line[:, 0].mean() == ground.line[:, 0].mean() == pytest.approx(0.0)


def test_a_bearing_of_a_ring_is_around_it() -> None:
    text = SET + "bearings: {around: {body: drum, stiffness: {radial: 1e8}}}\n"
    text = text.replace("{ring: 0 mm, drive: 60 mm}", "[ring]").replace(
        "meshes: {out: {gears: [drive, wheel]}}", ""
    )
    text = text.replace("  wheel: {gears: {wheel: 60 mm}, position: [120 mm, 0, 0]}\n", "")
    line = _named(_section(loads_model(text)), "around").line
    assert (line[:, 0].mean(), line[:, 1].min()) == pytest.approx((0.0, 80e-3))


def test_scissor_gears_have_their_names_on_each_shaft() -> None:
    """Two camshafts with equal scissor gears are no planets: both are drawn with names."""
    section = _section(load_model(HOUSE / "examples/timing-train/idle-scissor.yaml"))
    names = {p.name for p in _kind(section, "teeth")}
    assert {"exhaust", "exhaust_free", "inlet", "inlet_free"} <= names


def test_horizontal_centre_distances_are_below_the_section() -> None:
    """Axes at right angles to the input: their centre distance is along the drawing."""
    section = _section(load_model(HOUSE / "examples/bevel-drive/spiral.yaml"))
    link = SectionLink(start=np.zeros(2), end=np.array([0.1, 0.0]), words="a = 100 mm")
    _, tall, _ = section_parts(section)
    _, taller, parts = section_parts(replace(section, distances=[link]))
    assert taller > tall
    assert "rotate(-90)" not in "".join(parts)


LONG = "not_a_catalogue_gear_of_the_second_stage_"


def test_long_names_are_apart_in_both_views() -> None:
    """Names of 40 letters are abbreviated in the middle; no two of them overlap."""
    text = SET.replace(
        "{sun: sun, ring: ring,", f"{{planet_name: {LONG}planet, sun: {LONG}sun, ring: {LONG}ring,"
    )
    text = text.replace("  sun: {number", f"  {LONG}sun: {{number").replace(
        "  ring: {type", f"  {LONG}ring: {{type"
    )
    text = text.replace("gears: [sun]", f"gears: [{LONG}sun]").replace("{ring: 0 mm", f"{{{LONG}ring: 0 mm")
    model = loads_model(text)
    drawing = gearbox_drawing(model) or ""
    assert LONG not in drawing
    assert "not_a_cata…d_stage_sun" in drawing
    view = transverse_of(model)
    assert view is not None
    inside, outside = wheel_labels(view.wheels, lambda p: 2e3 * np.asarray(p), 2e3)
    circles = [(*(2e3 * w.centre), 2e3 * max(w.tip, w.root)) for w in view.wheels]
    labels: list[Label] = [*inside, *column_labels(outside, circles)[0]]
    assert len(labels) >= 4
    assert all(not common_area(a.box, b.box) for a, b in combinations(labels, 2))


def test_a_pinion_is_in_its_ring() -> None:
    """Pinion of a ring gear without carrier: in mesh in the drawing, at the centre distance."""
    section = _section(load_model(HOUSE / "examples/nearly-driven/internal.yaml"))
    assert not section.apart
    assert [link.words for link in section.distances] == ["a = 61.9 mm"]
