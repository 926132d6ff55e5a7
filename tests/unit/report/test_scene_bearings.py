# SPDX-License-Identifier: Apache-2.0
"""Bearings of a scene: dimensions, places of the rolling elements over time, faults."""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.scene.bearing_sections import (
    element_surface,
    raceway,
    ring,
    roller_line,
    rows_of,
    sphere_radius,
)
from pitchpoint.report.scene.bearing_sizes import size_of, size_on
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from pitchpoint.viz.scene.file import scene_texts
from tests.support.scene_reader import Seen
from tests.unit.report.test_scene_supports import is_closed, volume

SIDES = ("positive", "negative")
BALLS, D, PITCH = 9, 7.94e-3, 39.04e-3

RIG = """\
bodies:
  rotor: {{motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01 kg m^2}}
  outer: {{motion: planar, position: [0, 0, 0], mass: 2 kg, inertia: 0.01 kg m^2}}
rolling_bearings:
  front:
    ends: [rotor, outer]
    elements: 9
    element_diameter: 7.94 mm
    pitch_diameter: 39.04 mm
    grooves: [0.52, 0.52]
    damping: 5
    {faults}
scenarios:
  run: {{drive: {{rotor: {{speed: 6000 rpm}}, outer: {{speed: -1500 rpm}}}}, duration: 50 ms, step: 50 us}}
bushings:
  mount: {{ends: [outer, ground], stiffness: {{radial: 1e8 N/m}}, damping: {{radial: 1e4 N s/m}}}}
"""
FAULTS = """faults:
      pit: {type: inner_race, angle: 20 deg, length: 1 mm, depth: 0.1 mm}
      hole: {type: outer_race, angle: 270 deg, length: 2 mm, depth: 0.1 mm}
      flat: {type: rolling_element, element: 3, length: 1 mm, depth: 0.1 mm}
      worn: {type: cage, element: 5, widening: 3 deg}
      mild: {type: outer_race, angle: 0 deg, length: 2 mm, depth: 0.1 mm, severity: 0}"""


def rolling(**more):
    keys = {
        "elements": 10,
        "element_diameter": "12.7 mm",
        "pitch_diameter": "70 mm",
        "stiffness": 1e9,
        **more,
    }
    text = ", ".join(f"{k}: {v}" for k, v in keys.items())
    body = "bodies: {a: {motion: planar, mass: 1 kg, inertia: 1 kg m^2, position: [0, 0, 0]}}"
    return loads_model(f"{body}\nrolling_bearings: {{b: {{ends: [a, ground], {text}}}}}").rolling_bearings[
        "b"
    ]


@pytest.fixture(scope="module")
def runs():
    found = {}
    for faults in ("", FAULTS):
        model = loads_model(RIG.format(faults=faults))
        result = solve_time(compile_model(model, "run"))
        found[faults] = Seen(*scene_texts(scene_of(model, result))), result
    return found


@pytest.mark.parametrize("angle", [0.0, 15.0, -25.0])
@pytest.mark.parametrize("kind", ["ball", "roller"])
def test_rings_are_closed_and_touch_the_elements(kind, angle):
    """Elements touch both races at the contact angle, and are nowhere inside a ring."""
    size = size_of(rolling(type=kind, contact_angle=f"{angle} deg"), None)
    for inner in (True, False):
        surface = ring(size, inner, 96)
        assert is_closed(surface) and volume(surface) > 0.0
        # distance of the race from the axis of the element in a section
        line = raceway(size, inner)
        fine = np.concatenate(
            [a + (b - a) * np.linspace(0, 1, 40)[:, None] for a, b in zip(line, line[1:], strict=False)]
        )
        from_middle = fine - [0.5 * size.pitch, 0.0]
        alpha = size.angle
        if kind == "ball":
            gap = np.hypot(*from_middle.T) - 0.5 * size.element
        else:
            normal, along = (
                from_middle @ [math.cos(alpha), math.sin(alpha)],
                from_middle @ [-math.sin(alpha), math.cos(alpha)],
            )
            own = 0.5 * size.element * (1.0 - 2.0 * along * math.sin(alpha) / size.pitch)
            gap = (np.abs(normal) - own)[np.abs(along) < 0.49 * size.length]
        # a groove of 0.52 diameters around a ball of 0.50, in chords: within 0.5 % of the diameter
        assert gap.min() > -5e-3 * size.element and gap.min() < 5e-3 * size.element
    for sides in (16, 32):
        assert is_closed(element_surface(size, sides))


def bought(keys):
    """A bearing by designation."""
    body = "bodies: {a: {motion: free, mass: 1 kg, inertia: 1, transverse_inertia: 1, position: [0, 0, 0]}}"
    model = loads_model(f"{body}\nrolling_bearings: {{b: {{body: a, {keys}}}}}")
    return size_of(model.rolling_bearings["b"], None)


@pytest.mark.parametrize(
    "keys",
    [
        *("designation: 22208", "designation: 23220", "designation: 1308", "designation: 2206"),
        *("designation: 3208", "designation: NA4908", "designation: RNA4908", "designation: NUP 208"),
        *(f"designation: {n}, axial_force_absorption: {side}" for n in (51108, "NJ 208") for side in SIDES),
    ],
)
def test_elements_of_all_types_are_between_their_rings(keys):
    """In sections and as solids: rings closed, no element in a ring, contact with both, inside the width."""
    size = bought(keys)
    assert is_closed(element_surface(size, 16)) and element_surface(size, 16)[0].shape[1] == 3
    races = [raceway(size, inner) for inner in (True, False)]
    for inner, race in zip((True, False), races, strict=True):
        if size.bare and inner:
            continue
        surface = ring(size, inner, 64)
        assert is_closed(surface) and volume(surface) > 0.0
        fine = np.concatenate(
            [a + (b - a) * np.linspace(0, 1, 30)[:, None] for a, b in zip(race, race[1:], strict=False)]
        )
        nearest = []
        for row in rows_of(size):
            from_middle = fine - [row.radius, row.height]
            if size.type == "ball":
                nearest.append((np.hypot(*from_middle.T) - 0.5 * size.element).min())
                continue
            along = from_middle @ [-math.sin(row.angle), math.cos(row.angle)]
            normal = np.abs(from_middle @ [math.cos(row.angle), math.sin(row.angle)])
            drop = 0.0
            if size.form == "sphere":
                radius = sphere_radius(size)
                drop = radius - np.sqrt(radius**2 - np.minimum(along**2, radius**2))
            gap = (normal - 0.5 * size.element + drop)[np.abs(along) < 0.49 * size.length]
            nearest.append(gap.min())
        assert np.abs(nearest).max() < 8e-3 * size.element
    for row in range(size.rows):
        points = element_surface(size, 24, row)[0]
        assert np.abs(points[:, 2]).max() <= 0.5 * size.width
    if size.rows == 2:  # elements of one row do not reach those of the other, half a spacing on
        one, two = rows_of(size)
        turned = math.pi / size.count
        between = math.hypot(2.0 * one.radius * math.sin(0.5 * turned), one.height - two.height)
        assert between > size.element
        assert size.type == "ball" or abs(one.height - two.height) > size.length * math.cos(one.angle)


def test_barrels_and_balls_of_self_aligning_bearings_are_in_a_sphere():
    """No point of an element is outside the sphere about the middle, and some are on it."""
    for keys in ("designation: 22208", "designation: 1308"):
        size = bought(keys)
        for row in (0, 1):
            away = np.linalg.norm(element_surface(size, 64, row)[0], axis=1)
            assert away.max() == pytest.approx(sphere_radius(size), rel=2e-3)
        assert size.form == "sphere"
    barrel = element_surface(bought("designation: 22208"), 64)[0]
    flat = element_surface(bought("designation: NU 208"), 64)[0]
    assert len(barrel) != len(flat)


def test_a_tapered_roller_and_its_races_have_one_apex_on_the_axis():
    """Pure rolling: all three cones meet the axis at the height (d_m/2)/tan(alpha) from the middle."""
    size = size_of(rolling(type="roller", contact_angle="14 deg", effective_length="18 mm"), None)
    apex = 0.5 * size.pitch / math.tan(size.angle)
    for sign in (-1.0, 1.0):
        (r0, z0), (r1, z1) = roller_line(size, sign)
        assert z0 - r0 * (z1 - z0) / (r1 - r0) == pytest.approx(apex, rel=1e-9)


@pytest.mark.parametrize(
    ("shaft", "outside", "width"),
    [(10, 30, 9), (25, 54.5, 15), (50, 90, 20), (100, 180, 34), (600, 1080, 170)],
)
def test_linear_bearings_have_the_size_of_a_catalogue(shaft, outside, width):
    """6200, 6210, 6220 of ISO 15; between and beyond in proportion (6205: 52 x 15)."""
    for axial in (True, False):
        size = size_on(0.5e-3 * shaft, axial)
        assert size.bore == pytest.approx(1e-3 * shaft)
        assert 1e3 * size.outside == pytest.approx(outside, rel=0.01)
        assert 1e3 * size.width == pytest.approx(width, rel=0.04)
        assert size.type == ("ball" if axial else "roller")
        # the elements have room on their circle and inside the rings
        assert size.count * size.element < math.pi * size.pitch
        assert size.element < size.width


def test_elements_are_where_the_kernel_has_them(runs):
    """Both rings rotate. Angle of the cage of the result, and of the closed form of pure rolling."""
    seen, result = runs[""]
    b = seen.body("front (cage)")
    cage = seen.header["bodies"][b]
    assert cage["part"] and cage["parent"] == seen.body("outer")
    samples = np.searchsorted(result["time"].values, seen.times)
    gamma = D / PITCH
    for frame in (0, 17, len(seen.times) - 1):
        own = seen.pose(b, frame)[1]
        outer = seen.pose(cage["parent"], frame)[1]
        angle = math.atan2(*(outer.T @ own)[[1, 0], 0])
        stored = float(result["cage_angle[front]"][samples[frame]])
        assert abs(math.remainder(angle - stored, 2.0 * math.pi)) < 1e-6
        inner, ring_angle = (float(result[f"angle[{n}]"][samples[frame]]) for n in ("rotor", "outer"))
        absolute = 0.5 * inner * (1.0 - gamma) + 0.5 * ring_angle * (1.0 + gamma)
        world = math.atan2(*own[[1, 0], 0])
        assert abs(math.remainder(world - absolute, 2.0 * math.pi)) < 1e-6
    assert result["angle[rotor]"][-1] > 8.0 * math.pi
    # as many balls of their diameter on the pitch circle
    balls = seen.placed("front, balls", 0).reshape(BALLS, -1, 3)
    middles = balls.mean(axis=1)
    assert np.hypot(*middles.T[:2]) == pytest.approx(np.full(BALLS, 0.5 * PITCH), rel=1e-3)
    assert np.ptp(balls[0], axis=0).max() == pytest.approx(D, rel=5e-3)


def test_faults_are_marked_where_they_are(runs):
    """Spalls on both races at their angles, the element, the gap; none of severity zero."""
    seen, _ = runs[FAULTS]
    pieces = seen.solid("front, balls")["pieces"]
    texts = {p["fault"]: seen.array(p["turns"]) for p in pieces if "fault" in p}
    assert set(texts) == {"spall on element 3 (flat)", "wider gap behind element 5 (worn)"}
    # three degrees wider between 5 and 6, all others narrower by 3/8 degrees
    turns = np.sort(np.concatenate([seen.array(p["turns"]) for p in pieces]))
    gaps = np.degrees(np.diff(turns))
    assert gaps[5] == pytest.approx(43.0) and gaps[:5] == pytest.approx(40.0 - 3.0 / 8.0)
    spalls = {s["name"]: s for s in seen.header["solids"] if s["name"].endswith(" race")}
    assert set(spalls) == {"front, inner race", "front, outer race"}
    for name, degrees, body, half in (
        ("front, inner race", 20.0, "rotor", 0.5e-3 / (0.5 * (PITCH - D))),
        ("front, outer race", 270.0, "outer", 1e-3 / (0.5 * (PITCH + D))),
    ):
        assert spalls[name]["body"] == seen.body(body)
        assert spalls[name]["pieces"][0]["fault"].startswith(
            f"spall of {1 if '20' in str(degrees) else 2} mm"
        )
        points = seen.mesh(name)[0]
        angle = np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
        middle = 0.5 * (angle.min() + angle.max())
        assert abs(math.remainder(middle - math.radians(degrees), 2.0 * math.pi)) < 1e-6
        assert np.ptp(angle) == pytest.approx(2.0 * max(half, 0.02), rel=1e-4)


SHAFT = """\
shafts:
  main: {sections: [{length: 200 mm, diameter: 50 mm}], position: [0, 0, 0]}
bearings:
  left: {body: main, position: [0, 0, 20 mm], stiffness: {radial: 1e8 N/m, axial: 1e7 N/m}}
  right: {body: main, position: [0, 0, 180 mm], stiffness: {radial: 1e8 N/m}}
"""


def test_bearings_of_a_shaft_fit_on_it():
    """A fixed and a floating bearing on 50 mm, drawn as 6210 and NU 210 at their positions."""
    model = loads_model(SHAFT)
    seen = Seen(*scene_texts(scene_of(model)))
    for name, word, z in (("left", "balls", 20e-3), ("right", "rollers", 180e-3)):
        inner = seen.placed(f"bearing {name}, inner ring", 0)
        outer = seen.placed(f"bearing {name}, outer ring", 0)
        assert np.hypot(*inner.T[:2]).min() == pytest.approx(25e-3, rel=0.01)
        assert np.hypot(*outer.T[:2]).max() == pytest.approx(45e-3, rel=0.01)
        assert np.ptp(outer[:, 2]) == pytest.approx(20e-3, rel=0.01)
        assert 0.5 * (outer[:, 2].min() + outer[:, 2].max()) == pytest.approx(z, abs=1e-6)
        elements = seen.solid(f"{name}, {word}")
        assert elements["kind"] == "element" and elements["schematic"]
    assert any("catalogue sizes" in note for note in seen.header["notes"])


@pytest.mark.parametrize("bore", ["", ", bore_diameter: 60 mm"], ids=["solid", "bored"])
def test_bearings_of_gears_without_a_shaft_hide_no_teeth(bore):
    """A planet of 33 teeth, module 3: on its spindle, beside the gear, within the root circle of 91.5 mm."""
    gear = (
        f"{{number_of_teeth: 33, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0{bore}}}"
    )
    model = loads_model(
        f"gears: {{planet: {gear}}}\n"
        "bodies: {wheel: {gears: [planet], motion: planar, position: [0, 0, 0]}}\n"
        "bearings: {needles: {body: wheel, stiffness: {radial: 8e8 N/m}}}"
    )
    root = 0.5 * model.gears["planet"].geometry.d_f
    assert 2.0 * root == pytest.approx(91.5e-3)
    seen = Seen(*scene_texts(scene_of(model)))
    spindle = 0.03 if bore else 0.35 * root
    rings = [s["name"] for s in seen.header["solids"] if s["name"].endswith("ring")]
    assert len(rings) == 4
    for name in rings:
        points = seen.placed(name, 0)
        away = np.hypot(*points.T[:2])
        assert away.max() < spindle + 0.5 * (root - spindle)
        assert away.min() == pytest.approx(spindle, rel=0.01) or "outer" in name
        assert np.abs(points[:, 2]).min() > 20e-3


@pytest.mark.parametrize("bore", ["", ", bore_diameter: 60 mm"], ids=["solid", "bored"])
@pytest.mark.parametrize("axis", ["[0, 0, 1]", "[1, 0, 0]"])
def test_pins_have_the_bore_of_the_bearings_on_them(bore, axis):
    """NA4906, 30 x 47 x 17 mm: a pin of the carrier in the planet, which has room for the outer ring."""
    gear = "number_of_teeth: {}, normal_module: 3 mm, face_width: 40 mm, profile_shift_coefficient: 0"
    model = loads_model(
        f"gears: {{sun: {{{gear.format(21)}}}}}\n"
        f"bodies:\n  sun: {{gears: [sun], motion: planar, axes: {{z: {axis}}}}}\n"
        f"  carrier: {{mass: 12 kg, inertia: 0.12, axes: {{z: {axis}}}}}\n"
        "bearings: {spline: {body: sun, stiffness: {radial: 1e6 N/m}}}\n"
        "planetary_stages:\n"
        "  set: {sun: sun, carrier: carrier, planets: 3, motion: planar, center_distance: 90 mm,\n"
        f"    planet: {{{gear.format(39)}{bore}}}}}\n"
        "rolling_bearings:\n"
        + "".join(f"  pin_{k}: {{ends: [carrier, planet_{k}], designation: NA4906}}\n" for k in (1, 2, 3))
    )
    seen = Seen(*scene_texts(scene_of(model)))
    names = [solid["name"] for solid in seen.header["solids"]]
    assert not [name for name in names if name.startswith("planet") and name.endswith("(spindle)")]
    for k in (1, 2, 3):
        pin, inner = seen.placed(f"planet_{k} (pin)", 0), seen.placed(f"pin_{k}, inner ring", 0)
        assert seen.solid(f"planet_{k} (pin)")["body"] == seen.solid("pin_1, inner ring")["body"]
        along = np.array([float(word) for word in axis.strip("[]").split(",")])
        middle = inner.mean(axis=0)
        across = [part - middle - np.outer((part - middle) @ along, along) for part in (pin, inner)]
        radii = [np.linalg.norm(part, axis=1) for part in across]
        assert radii[0].max() == pytest.approx(15e-3, rel=0.01)
        assert radii[1].min() == pytest.approx(15e-3, rel=0.01)
        assert np.ptp(pin @ along) > 40e-3
