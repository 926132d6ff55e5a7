# SPDX-License-Identifier: Apache-2.0
"""Rules of the assembly of a gear pair: clearance on both flanks, orientation that is kept, order of gears.

Source of the rules: Adams Machinery, "Gear Pair (Advanced 3D Contact)", Fixed Orientation.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.tooth_form import gear_outline
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from tests.support.model_files import gear, pair

THINNER = "tooth_thickness_allowance: -60 um"
RING = "type: internal, tip_diameter: 178 mm"


def clearances(model):
    """Least distances of the left and right flanks of gear 1 from gear 2, from the outlines alone [m]."""
    mesh, (one, two) = model.meshes["m"], (model.gears[g].geometry for g in model.meshes["m"].gears)
    angles = [model.phasing.tooth_angle[g] for g in mesh.gears]
    theta = mesh.theta
    first = gear_outline(one, 400, rotation=angles[0])
    second = gear_outline(two, 400, rotation=angles[1]) + abs(mesh.a_w) * np.array(
        [math.cos(theta), math.sin(theta)]
    )
    near = (
        np.hypot(*(first - 0.5 * abs(one.d) * np.array([math.cos(theta), math.sin(theta)])).T) < 4 * one.m_n
    )
    if two.is_internal:
        pole = -0.5 * abs(one.d) * np.array([math.cos(theta), math.sin(theta)])
        near = np.hypot(*(first - pole).T) < 4 * one.m_n
    points = first[near]
    start, along = second, np.roll(second, -1, axis=0) - second
    close = np.hypot(*(start - points.mean(axis=0)).T) < 10 * one.m_n
    start, along = start[close], along[close]
    offset = points[:, None] - start
    share = np.clip((offset * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-30), 0.0, 1.0)
    distance = np.hypot(*np.moveaxis(offset - share[..., None] * along, -1, 0)).min(axis=1)
    pitch = math.tau / one.z
    side = np.remainder(np.arctan2(points[:, 1], points[:, 0]) - angles[0] + 0.5 * pitch, pitch) - 0.5 * pitch
    # without tips and roots, which are farther away
    return float(distance[side > 0.0].min()), float(distance[side < 0.0].min())


@pytest.mark.parametrize(
    ("direction", "start"),
    [
        pytest.param("0 deg", "0", marks=pytest.mark.study),
        pytest.param("33 deg", "0", marks=pytest.mark.study),
        pytest.param("0 deg", "3.7 deg", marks=pytest.mark.study),
        ("33 deg", "3.7 deg"),
    ],
)
@pytest.mark.parametrize("second", [gear("b", 41, 0.0, THINNER), gear("b", 61, 0.0, f"{RING}, {THINNER}")])
def test_both_flanks_have_half_of_the_backlash(direction, start, second):
    """Chords of the outlines are within 0.05 µm of the flanks."""
    first = gear("a", 23, 0.0, f"initial_angle: {start}, {THINNER}")
    model = loads_model(pair(first, second, f"direction: {direction}"))
    half = 0.5 * model.pairs["m"].j_bt
    assert half > 20e-6
    assert clearances(model) == pytest.approx((half, half), abs=1e-7)


@pytest.mark.parametrize("kept", ["a", "b"])
@pytest.mark.parametrize("more", ["type: external", RING])
def test_the_gear_with_an_initial_angle_keeps_it(kept, more):
    """Also the ring: then the external gear is turned."""
    angle = {name: "initial_angle: 0.1" if name == kept else "initial_angle: null" for name in ("a", "b")}
    model = loads_model(
        pair(gear("a", 23, 0.0, angle["a"]), gear("b", 61, 0.0, f"{more}, {angle['b']}")).replace(
            ", initial_angle: null", ""
        )
    )
    assert model.phasing.tooth_angle[kept] == pytest.approx(0.1, abs=1e-15)
    assert model.phasing.offset["m"] == pytest.approx(0.0, abs=1e-15)


def test_without_an_initial_angle_gear_1_stays():
    model = loads_model(pair(gear("a", 23), gear("b", 40)))
    assert model.phasing.tooth_angle["a"] == 0.0


def test_the_internal_gear_is_gear_2():
    ring = gear("b", 61, 0.0, RING)
    text = pair(gear("a", 23), ring)
    with pytest.raises(ModelError, match="b is internal and is given as gear 1"):
        loads_model(text.replace("[a, b]", "[b, a]"))
    with pytest.raises(ModelError, match="both internal"):
        loads_model(pair(gear("a", 60, 0.0, "type: internal, tip_diameter: 175 mm"), ring))


def test_planets_are_turned_to_the_sun():
    """The sun keeps its angle; the planets follow it, and the ring follows the planets."""
    text = (
        "gears:\n"
        + gear("sun", 24, 0.0, "initial_angle: 0.05")
        + gear("p0", 18)
        + gear("ring", 60, 0.0, "type: internal, tip_diameter: 177 mm")
        + "meshes:\n  s: {gears: [sun, p0], direction: 20 deg}\n"
        + "  r: {gears: [p0, ring], direction: 200 deg}\n"
    )
    phasing = loads_model(text).phasing
    assert phasing.tooth_angle["sun"] == pytest.approx(0.05, abs=1e-15)
    assert max(abs(v) for v in phasing.offset.values()) < 1e-12


TWO = """
gears:
  a: {{number_of_teeth: 25, normal_module: 3 mm, face_width: {a} mm, profile_shift_coefficient: 0.2}}
  b: {{number_of_teeth: 40, normal_module: 3 mm, face_width: {b} mm, profile_shift_coefficient: 0}}
bodies:
  one: {{gears: [a], motion: torsion}}
  two: {{gears: [b], motion: torsion}}
meshes:
  m: {{gears: [{order}], contact: {{level: rigid, stiffness: 4e8 N/m, planes: 7}}}}
"""


@pytest.mark.parametrize("widths", [(20, 30), (30, 20)])
def test_the_order_of_external_gears_does_not_matter(widths):
    """The wider gear may be gear 1: contact planes divide the common face width."""
    found = {}
    for order, torque in (("a, b", 300.0), ("b, a", 300.0 * 40.0 / 25.0)):
        model = loads_model(TWO.format(a=widths[0], b=widths[1], order=order))
        assert model.meshes["m"].b_w == pytest.approx(20e-3, rel=1e-12)
        found[order] = solve_contact(model, torque=torque, positions=200)["transmission_error"].values[0]
    one, two = found.values()
    assert two.mean() == pytest.approx(one.mean(), rel=2e-3)
    assert (two.min(), two.max()) == pytest.approx((one.min(), one.max()), rel=5e-3)
