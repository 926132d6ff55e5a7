# SPDX-License-Identifier: Apache-2.0
"""Phases of all meshes of a train turned by hand (GT-IDLER): flanks in space against the mesh phases.

The outlines of both gears of each mesh are turned in space by the ratios of the tooth numbers. Gear 2 is
then turned until its front, and until its back flanks touch: both angles must be half of the backlash, and
the place of the contact on the line of action is the mesh phase. Neither the assembly nor the kinematics of
the mesh element are used, except the angle of tooth 0 at the beginning.
"""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

EXAMPLES = Path(__file__).parents[3] / "examples"


def flanks(gear, angle):
    """Involute points of all flanks in space, counter-clockwise (+1) and clockwise (-1) side [m], complex.

    Shape (2, z, n); `angle` is that of the centre of tooth 0 [rad]. The tooth has the thickness of its
    profile shift at the reference circle.
    """
    g = gear.geometry
    z, r_b = abs(g.z), 0.5 * abs(g.d_b)
    alpha_t = math.acos(abs(g.d_b) / abs(g.d))
    half = math.pi / (2 * z) + 2 * g.x * math.tan(g.alpha_n) / z + math.tan(alpha_t) - alpha_t
    radius = np.linspace(max(r_b, 0.5 * abs(g.d_f)), 0.5 * abs(g.d_a), 4000)
    roll = np.sqrt(np.maximum((radius / r_b) ** 2 - 1.0, 0.0))
    side = half - (roll - np.arctan(roll))
    teeth = angle + math.tau * np.arange(z)[:, None] / z
    return np.array([radius * np.exp(1j * (teeth + s * side)) for s in (1, -1)])


def gap(one, two, side):
    """Angle by which gear 2 turns until the sides touch [rad], and the point of contact on gear 1.

    Counter-clockwise sides (0) touch each other if gear 2 turns counter-clockwise, clockwise sides (1) if it
    turns clockwise. Points are relative to the centre of gear 2.
    """
    radius = np.abs(two[side][0])
    near = one[side][(np.abs(one[side]) < radius[-1]) & (np.abs(one[side]) > radius[0])]
    profile = np.unwrap(np.angle(two[side][0] / two[side][0][0]))
    flank = np.interp(np.abs(near), radius, profile)[:, None] + np.angle(two[side][:, 0])
    apart = np.mod((1 - 2 * side) * (np.angle(near)[:, None] - flank) + 0.01, math.tau) - 0.01
    place = np.unravel_index(np.argmin(apart), apart.shape)
    return float(apart[place]), near[place[0]]


def by_hand(model, mesh, angles):
    """Gaps of both flanks along the base tangent [m] and the mesh phase from the place of the contact.

    `angles` are those of the bodies [rad]. Half of the gap is closed by gear 1, half by gear 2, so that the
    mean travel remains. The phase is that of the plane that divides the distance of the mid-faces like the
    pitch point divides the centre distance.
    """
    one, two = (model.gears[n].geometry for n in mesh.gears)
    bodies = [model.body_of(n) for n in mesh.gears]
    centres = [complex(*model.bodies[b].origin[:2]) for b in bodies]
    turned = []
    apart, share = mesh.offset1 - mesh.offset2, one.z / (one.z + two.z)
    for name, body, offset in zip(mesh.gears, bodies, (share * apart, (share - 1.0) * apart), strict=True):
        twist = offset * math.tan(model.gears[name].beta) / (0.5 * model.gears[name].geometry.d)
        turned.append(flanks(model.gears[name], model.phasing.tooth_angle[name] + twist + angles[body]))
    front, at = gap(turned[0] + centres[0] - centres[1], turned[1], 0)
    back, _ = gap(turned[0] + centres[0] - centres[1], turned[1], 1)
    r_1, r_2 = 0.5 * one.d_b, 0.5 * two.d_b
    a = abs(centres[1] - centres[0])
    start = math.sqrt(a**2 - (r_1 + r_2) ** 2) - math.sqrt((0.5 * two.d_a) ** 2 - r_2**2)  # T_1 A
    reached = math.sqrt(abs(at + centres[1] - centres[0]) ** 2 - r_1**2) + 0.5 * r_2 * front
    return r_2 * front, r_2 * back, (reached - start) / (math.tau * r_1 / one.z)


def hand_angles(model, first, angle):
    """Angles of all bodies if the first is turned by `angle` [rad], from the tooth numbers."""
    found, queue = {first: angle}, [first]
    for body in queue:
        for mesh in model.meshes.values():
            for this, other in (mesh.gears, mesh.gears[::-1]):
                there = model.body_of(other)
                if model.body_of(this) == body and there not in found:
                    ratio = model.gears[this].number_of_teeth / model.gears[other].number_of_teeth
                    found[there] = -found[body] * ratio
                    queue.append(there)
    return found


def assert_phases(model, first, angle):
    """Both gaps of every mesh are half of its backlash, and the phases those of the places of contact."""
    angles = hand_angles(model, first, angle)
    system = compile_model(model)
    state = system.initial_state()
    for name, value in angles.items():
        turns = round(value / math.tau)
        state.q[system.spin(name)] = value - math.tau * turns
        state.turns[system.layout.bodies.index(name)] = turns
    values = evaluate.observe(system, state)
    for name, mesh in model.meshes.items():
        front, back, phase = by_hand(model, mesh, angles)
        half = 0.5 * model.backlash(name) if mesh.backlash is None else 0.0  # given, with teeth as drawn
        assert (front, back) == pytest.approx((half, half), abs=2e-9), name
        found = values[system.layout.channel(f"mesh_phase[{name}]")]
        assert math.remainder(phase - found, 1.0) == pytest.approx(0.0, abs=5e-4), name


@pytest.mark.parametrize("angle", [0.0, 0.7, -2.9, 41.3])
def test_the_timing_train_turned_by_hand(angle):
    """Chain, double idler and branches, helical, with offset face widths and scissor gears."""
    assert_phases(load_model(EXAMPLES / "timing-train" / "idle-scissor.yaml"), "crankshaft", angle)


LOOP = """
gears:
  crank: {{number_of_teeth: 31, {data}, hand: left}}
  left: {{number_of_teeth: 43, {data}, hand: right}}
  right: {{number_of_teeth: 43, {data}, hand: right}}
  cam: {{number_of_teeth: 62, {data}, hand: left}}
  pump: {{number_of_teeth: 23, {data}, hand: left}}
bodies:
  k: {{gears: {{crank: 2 mm}}, position: [0, 0, 0]}}
  l: {{gears: {{left: -3 mm}}, position: [{x_l!r} m, {y_l!r} m, 0]}}
  r: {{gears: {{right: 4 mm}}, position: [{x_r!r} m, {y_l!r} m, 0]}}
  c: {{gears: {{cam: 0 mm}}, position: [0, {y_c!r} m, 0]}}
  p: {{gears: {{pump: 0 mm}}}}
meshes:
  kl: {{gears: [crank, left]}}
  kr: {{gears: [crank, right]}}
  lc: {{gears: [left, cam]}}
  rc: {{gears: [cam, right]}}
  rp: {{gears: [pump, right], direction: 161.3 deg, center_distance: 67.7 mm}}
"""


def closed_loop():
    """Crank, two idlers and a cam gear in a symmetric loop whose teeth meet, with a pump at one idler.

    The teeth meet if the pitches on the arcs inside the quadrangle of the axes, gears that turn one way less
    those that turn the other way, are whole: z_1 2 d + z_3 2 e - 2 z_2 (pi - d - e) = 2 pi n, with
    sin e = sin d (z_1 + z_2)/(z_3 + z_2).
    """
    m_t = 2e-3 / math.cos(math.radians(12.0))
    near, far = 0.5 * m_t * (31 + 43) + 0.1e-3, 0.5 * m_t * (62 + 43) + 0.1e-3

    def inside(d):
        """Difference of the pitches inside the quadrangle."""
        e = math.asin(near * math.sin(d) / far)
        return (31 * 2 * d + 62 * 2 * e - 2 * 43 * (math.pi - d - e)) / math.tau

    low, high = 0.8, 0.9
    whole = round(inside(high) - 0.5)  # increases by more than one
    for _ in range(80):
        d = 0.5 * (low + high)
        low, high = (d, high) if (inside(d) - whole) * (inside(high) - whole) <= 0.0 else (low, d)
    e = math.asin(near * math.sin(d) / far)
    places = {"x_l": -near * math.sin(d), "x_r": near * math.sin(d), "y_l": near * math.cos(d)}
    data = "normal_module: 2 mm, helix_angle: 12 deg, face_width: 20 mm, profile_shift_coefficient: 0"
    return LOOP.format(data=data, y_c=near * math.cos(d) + far * math.cos(e), **places)


@pytest.mark.parametrize("angle", [0.0, -1.3, 17.9])
def test_a_loop_of_meshes_turned_by_hand(angle):
    """Backlash from the centre distances; the last gear is at an angle of its own."""
    model = loads_model(closed_loop())
    assert model.phasing.loops_close and max(map(abs, model.phasing.offset.values())) < 1e-9
    assert_phases(model, "k", angle)
