# SPDX-License-Identifier: Apache-2.0
"""Gearboxes in section: gears in mesh touch at the pitch line, for any train and direction of its axes."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.cli.main import run_command
from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.target import SVG_MARK
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.model.model import Model
from pitchpoint.report.pictures import plot
from pitchpoint.report.section.build import gearbox_drawing, section_of
from pitchpoint.report.section.transverse import transverse_of
from pitchpoint.report.static_power import static_powers
from pitchpoint.viz.label_placement import LETTER
from pitchpoint.viz.section_content import Section, SectionAxis
from tests.support.browser import needs_browser
from tests.support.planet_gearboxes import simpson

HOUSE = Path(__file__).parents[3]
TWO_STAGE = HOUSE / "src/pitchpoint/cli/starters/two-stage.yaml"
PLANETARY = HOUSE / "src/pitchpoint/cli/starters/planetary.yaml"
MACHINES = (
    TWO_STAGE,
    PLANETARY,
    *(
        HOUSE / "examples" / name
        for name in (
            "bevel-drive/spiral.yaml",
            "bevel-drive/differential.yaml",
            "camshaft-drive/train.yaml",
            "camshaft-drive/shafts.yaml",
            "catalogue-bearings/model.yaml",
            "overlap-ratio/pairs.yaml",
            "phm-2009-rig/model.yaml",
            "planetary-set/model.yaml",
            "shovel-gearbox/model.yaml",
            "timing-train/idle-scissor.yaml",
            "wind-drive-5mw/model.yaml",
        )
    ),
)
SVG = "{http://www.w3.org/2000/svg}"
PAIR = """
gears:
  a: {number_of_teeth: 20, normal_module: 4 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  b: {number_of_teeth: 60, normal_module: 4 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  c: {number_of_teeth: 30, normal_module: 4 mm, face_width: 30 mm, profile_shift_coefficient: 0}
  d: {number_of_teeth: 25, normal_module: 4 mm, face_width: 30 mm, profile_shift_coefficient: 0}
bodies: {one: {gears: [a]}, two: {gears: [b, c]}, three: {gears: [d]}, motor: {inertia: 0.1 kg m^2}}
couplings: {shaft: {bodies: [motor, one], stiffness: {torsion: 1e4 N m/rad}}}
meshes: {ab: {gears: [a, b]}, cd: {gears: [c, d]}}
loads: {motor: {body: motor, torque: 30 N m}, out: {body: three, torque: balance}}
scenarios: {run: {speed: {one: 900 rpm}, duration: 1 s}}
"""


def section(model: Model) -> Section:
    flows = static_powers(model)
    found = section_of(model, next(iter(flows.values())))
    assert found is not None
    return found


def pitch_lines(axis: SectionAxis) -> list[np.ndarray]:
    """Ends of all pitch lines of an axis in the drawing plane, of both halves."""
    return [axis.at(p.line, s) for p in axis.pieces if p.kind == "pitch" for s in (1.0, -1.0)]


def gap(one: SectionAxis, two: SectionAxis) -> float:
    """Least distance of pitch lines of two axes [m]."""
    return min(
        float(np.abs(a.mean(axis=0) - b.mean(axis=0)).max())
        for a in pitch_lines(one)
        for b in pitch_lines(two)
    )


@pytest.mark.parametrize("file", MACHINES, ids=lambda f: f.parent.name + "-" + f.stem)
def test_gears_in_mesh_touch_at_the_pitch_line(file: Path) -> None:
    """Every axis touches another one; the number of touching pairs is that of the meshing pairs of axes."""
    found = section(load_model(file))
    assert not found.apart
    for axis in found.axes:
        others = [gap(axis, other) for other in found.axes if other is not axis and pitch_lines(other)]
        if pitch_lines(axis):
            # equal to rounding, for planets to the pin errors and different profile shifts
            assert min(others) < 2e-3, axis.name


@pytest.mark.parametrize("file", MACHINES, ids=lambda f: f.parent.name + "-" + f.stem)
def test_labels_do_not_cover_each_other(file: Path) -> None:
    model = load_model(file)
    drawing = gearbox_drawing(model, static_powers(model))
    assert drawing is not None
    for view in list(ET.fromstring(drawing).iter(f"{SVG}svg"))[1:]:
        boxes = []
        for text in view.iter(f"{SVG}text"):
            style = {"pp-tname": "pp-name", "pp-tsub": "pp-sub"}.get(
                text.get("class", ""), text.get("class", "")
            )
            if style not in ("pp-name", "pp-sub") or text.get("x") is None:
                continue
            words = "".join(text.itertext())
            half, x, y = 0.5 * LETTER[style] * len(words), float(text.get("x", 0)), float(text.get("y", 0))
            x += {"start": half, "end": -half}.get(text.get("text-anchor", ""), 0.0)
            boxes.append((x - half, y - 10.0, x + half, y + 2.0, words))
        for a, b in combinations(boxes, 2):
            apart = a[0] >= b[2] or b[0] >= a[2] or a[1] >= b[3] or b[1] >= a[3]
            assert apart, (a[4], b[4])


def test_the_drawing_does_not_depend_on_the_direction_of_the_axes() -> None:
    text = TWO_STAGE.read_text()
    at = "    position: [0, 0, 0]"
    turned = text.replace(at, f"{at}\n    axes: {{z: [0, 1, 0], x: [0, 0, 1]}}")
    one, two = (gearbox_drawing(m, static_powers(m)) for m in (loads_model(text), loads_model(turned)))
    assert one == two


def test_the_picture_of_the_first_page_is_current() -> None:
    """`pitchpoint check src/pitchpoint/cli/starters/two-stage.yaml --drawing docs/images/gearbox.svg`."""
    model = load_model(TWO_STAGE)
    drawing = gearbox_drawing(model, static_powers(model)) or ""
    shown = (HOUSE / "docs/images/gearbox.svg").read_text(encoding="utf-8")
    assert shown == drawing.replace(">", f">{SVG_MARK}", 1)


def test_bevel_axes_are_drawn_at_their_shaft_angle() -> None:
    found = section(load_model(HOUSE / "examples/bevel-drive/spiral.yaml"))
    one, two = found.axes
    assert float(one.way @ two.way) == pytest.approx(0.0, abs=1e-12)
    assert gap(one, two) < 1e-9


def test_planets_are_drawn_once_on_each_side() -> None:
    found = section(load_model(PLANETARY))
    planets = [axis for axis in found.axes if any(p.kind == "pin" for p in axis.pieces)]
    assert [round(float(axis.origin[1]), 6) for axis in planets] == [0.051, -0.051]
    assert [axis.name for axis in planets] == ["planet_1 … planet_3", ""]


def test_gears_without_positions_get_schematic_ones() -> None:
    """Two gears of one body at the same position follow each other in the order of the power flow."""
    found = section(loads_model(PAIR))
    assert any("schematic" in note for note in found.notes)
    middle = {p.name: float(p.line[:, 0].mean()) for axis in found.axes for p in axis.pieces if p.name}
    assert middle["motor"] < middle["a"] == middle["b"] < middle["c"] == middle["d"]
    assert not found.apart


def test_gears_that_cannot_touch_are_marked() -> None:
    """A third gear in one plane, on the same pinion: one of the meshes is apart in the plane."""
    text = PAIR.replace(
        "cd: {gears: [c, d]}",
        "cd: {gears: [a, d], direction: 90 deg}, ac: {gears: [a, c], direction: 180 deg}",
    )
    text = text.replace(
        "two: {gears: [b, c]}, three: {gears: [d]}",
        "two: {gears: [b]}, four: {gears: [c]}, three: {gears: [d]}",
    )
    found = section(loads_model(text))
    assert len(found.apart) == 1
    assert found.apart[0].words in ("ab", "cd", "ac")


def test_the_transverse_view_shows_circles_at_their_distance() -> None:
    model = load_model(TWO_STAGE)
    flow = static_powers(model)["steady"]
    view = transverse_of(model, flow)
    assert view is not None
    wheels = {w.name.split(" ")[0]: w for w in view.wheels}
    apart = np.linalg.norm(wheels["wheel_1"].centre - wheels["pinion_1"].centre)
    assert apart == pytest.approx(wheels["wheel_1"].pitch + wheels["pinion_1"].pitch, abs=1e-6)
    assert {name: np.sign(w.speed or 0.0) for name, w in wheels.items()} == {
        "pinion_1": 1.0,
        "wheel_1": -1.0,
        "pinion_2": -1.0,
        "wheel_2": 1.0,
    }


def test_plot_gives_the_drawing() -> None:
    assert plot(loads_model(PAIR), "gearbox").html.startswith("<svg")
    with pytest.raises(PitchpointError, match="no gears or shafts"):
        plot(loads_model("bodies: {flywheel: {inertia: 1 kg m^2}}"), "gearbox")


def test_check_writes_the_drawing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "model.yaml"
    file.write_text(PAIR)
    target = tmp_path / "new" / "box.svg"
    assert run_command(["check", str(file), "--drawing", str(target)]) == 0
    assert f"drawing of the gearbox in section: {target}" in capsys.readouterr().out
    ET.fromstring(target.read_text())
    assert re.search("a \\(20\\)", target.read_text())
    assert run_command(["check", str(file), "--drawing", str(target.with_suffix(".html")), "-q"]) == 0
    assert target.with_suffix(".html").read_text().startswith("<!DOCTYPE html>")


@pytest.mark.parametrize(
    ("name", "words"),
    [("box.dxf", "use .svg, .html, .png or .pdf"), ("model.yaml", "has no extension of a drawing")],
)
def test_other_targets_are_refused(
    name: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "model.yaml"
    file.write_text(PAIR)
    assert run_command(["check", str(file), "--drawing", str(tmp_path / name)]) == 2
    assert words in " ".join(capsys.readouterr().err.split())
    assert file.read_text() == PAIR


def test_a_file_of_another_program_is_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, target = tmp_path / "model.yaml", tmp_path / "mine.svg"
    file.write_text(PAIR)
    target.write_text("<svg>mine</svg>")
    assert run_command(["check", str(file), "--drawing", str(target)]) != 0
    assert target.read_text() == "<svg>mine</svg>"
    assert "mine.svg" in capsys.readouterr().err


def test_planets_on_a_fixed_carrier_are_drawn_around_their_sun() -> None:
    """A star gear: no mesh apart, and the carrier is a part of the housing."""
    text = simpson().replace("  rear_carrier: {", "  rear_carrier: {motion: fixed, ")
    found = section(loads_model(text))
    assert not found.apart
    held = [piece.name for axis in found.axes for piece in axis.pieces if piece.kind == "held"]
    assert "rear_carrier" in held


def test_clutches_are_at_their_markers() -> None:
    """A synchroniser 40 mm from the start of its shaft; without the marker it was between both bodies."""
    text = """
gears: {a: {number_of_teeth: 20, normal_module: 4 mm, face_width: 20 mm, profile_shift_coefficient: 0},
  b: {number_of_teeth: 60, normal_module: 4 mm, face_width: 20 mm, profile_shift_coefficient: 0}}
shafts: {main: {sections: [{length: 200 mm, diameter: 40 mm}], markers: {hub: {position: [0, 0, 40 mm]}}}}
bodies: {idler: {gears: [a], motion: free, position: [0, 0, 80 mm]}, two: {gears: [b]}}
meshes: {ab: {gears: [a, b]}}
clutches: {sync: {bodies: [idler, main.hub], capacity: 1 kN m}}
"""
    axis = next(
        axis for axis in section(loads_model(text)).axes if any(p.name == "sync" for p in axis.pieces)
    )
    flange = next(piece for piece in axis.pieces if piece.name == "sync")
    assert float(flange.line[:, 0].min()) == pytest.approx(0.04, abs=3e-3)


def test_feet_of_the_housing_are_in_the_transverse_view() -> None:
    """Mounts at their places across the axes; those behind each other share a mark and a name."""
    housing = """
housing:
  type: rigid
  mass: 40 kg
  center_of_mass: [0, 0, 0]
  inertia_tensor: [1, 1, 1, 0, 0, 0]
  mounts:
    m_1: {position: [-60 mm, -100 mm, 0], stiffness: {radial: 1e8, axial: 1e8}}
    m_2: {position: [-60 mm, -100 mm, 80 mm], stiffness: {radial: 1e8, axial: 1e8}}
    m_3: {position: [200 mm, -100 mm, 0], stiffness: {radial: 1e8, axial: 1e8}}
bearings: {seat: {body: one, stiffness: {radial: 1e8}}}
"""
    found = transverse_of(loads_model(PAIR + housing))
    assert found is not None
    assert [(*place.round(6), names) for place, names in found.supports] == [
        (-0.06, -0.1, "m_1 and m_2"),
        (0.2, -0.1, "m_3"),
    ]
    assert "m_1 and m_2" in str(gearbox_drawing(loads_model(PAIR + housing)))


@needs_browser
def test_drawings_as_pdf(tmp_path: Path) -> None:
    """One page in the size of the drawing, at 96 pixels per inch; a PDF of another program is kept."""
    file, target = tmp_path / "model.yaml", tmp_path / "box.pdf"
    file.write_text(PAIR)
    for _ in range(2):  # replaces its own
        assert run_command(["check", str(file), "--drawing", str(target), "-q"]) == 0
    made = target.read_bytes()
    assert made.startswith(b"%PDF") and made.count(b"/Type /Page\n") == 1
    svg = str(gearbox_drawing(load_model(file), static_powers(load_model(file))))
    size = [int(n) for n in re.findall(r'viewBox="0 0 (\d+) (\d+)"', svg)[0]]
    box = [float(n) for n in re.findall(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", made)[0]]
    assert box == pytest.approx([0.75 * n for n in size], abs=0.8)
    target.write_bytes(b"%PDF-1.4 mine")
    assert run_command(["check", str(file), "--drawing", str(target)]) != 0
    assert target.read_bytes() == b"%PDF-1.4 mine"
