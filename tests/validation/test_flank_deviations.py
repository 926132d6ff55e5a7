# SPDX-License-Identifier: Apache-2.0
"""Micro-geometry and deviations of single teeth in the transmission error: amount, sign, place and tooth.

Closed forms of involute geometry, worked out here tooth by tooth from the angles of the teeth (counted
counter-clockwise from tooth 0, as `geometry.deviations` and the drawings do) and not from the separation
grids. Without load the flanks touch where the gap of the pairs in contact is least: u_bt = j_bt/2 + min gap.
A tooth displaced counter-clockwise by f has its left flank nearer to its mate by f cos(alpha_t); gear 1
touches with its left flanks at the front, so do external wheels, internal ones with their right flanks; the
drawing of the gears in mesh confirms it. Tolerances: the flank law is of first order in the deviations d, so
d^2 over a length of the mesh is left.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.spatial import cKDTree

from pitchpoint.geometry import CylindricalGear
from pitchpoint.geometry.modifications import flank_range
from pitchpoint.geometry.placement import mesh_outlines
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model

M_N = 3e-3
C_PRIME = 14e9
WIDTH = 20e-3


def machine(z1, z2, one="", two="", *, internal=False, direction=0.0, torque=10.0, beta=0.0):
    """Pair on spinning bodies, loaded on the front flanks, rectangular pairs (S_R 1, T_R 0)."""
    kind = "type: internal, " if internal else ""
    gear = "number_of_teeth: {}, normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    load = -torque if internal else torque
    pitch_radii = 1.5 / math.cos(math.radians(beta))
    distance = pitch_radii * (z2 - z1) - 0.2 if internal else pitch_radii * (z1 + z2) + 0.2
    text = (
        f"gears:\n  g1: {{{gear.format(z1)}{one}}}\n  g2: {{{kind}{gear.format(z2)}{two}}}\n"
        "bodies:\n  driver: {gears: [g1]}\n  driven: {gears: [g2]}\n"
        "meshes:\n  stage: {gears: [g1, g2], "
        f"center_distance: {distance!r} mm, "
        f"direction: {direction!r}, "
        "stiffness: {law: din3990, single_stiffness: 14 N/(mm um), stiffness_ratio: 1, "
        "tip_relief_factor: 0}}\n"
        f"loads:\n  input: {{body: driver, torque: 'balance'}}\n"
        f"  brake: {{body: driven, torque: {load!r} N m}}\n"
    )
    return loads_model(text)


def rolled(model, points, periods):
    """Unloaded error less half the backlash, angles of gear 1, all results; no repeated last point."""
    data = solve_quasistatic(compile_model(model), "stage", points, periods)
    error = data["unloaded_transmission_error[stage]"].values[:-1] - 0.5 * model.pairs["stage"].j_bt
    return error, data["angle[driver]"].values[:-1], data


def teeth_in_contact(model, angle1, margin=0.0):
    """(tooth of gear 1, tooth of gear 2, path position from the pitch point) of all pairs on the path.

    `margin` adds pairs that are as close to its ends [m].

    From the angles of the teeth alone: flanks at the pitch point when the arcs on both base circles agree.
    """
    pair = model.pairs["stage"]
    gear1, gear2 = pair.gear1, pair.gear2
    theta = model.meshes["stage"].theta + (math.pi if gear2.z < 0 else 0.0)
    towards2 = theta if gear2.z < 0 else theta + math.pi
    r_b1, r_b2 = 0.5 * gear1.d_b, 0.5 * gear2.d_b
    angle2 = -angle1 * gear1.z / gear2.z
    tooth0, tooth0_2 = (model.phasing.tooth_angle[g] for g in ("g1", "g2"))
    inv = math.tan(pair.alpha_wt) - pair.alpha_wt
    out = []
    for k in range(gear1.z):
        arc = math.remainder(tooth0 + 2 * math.pi * k / gear1.z + angle1 - theta, 2 * math.pi)
        xi = r_b1 * (arc + gear1.psi_b - inv)  # its left flank along the line of action
        if not pair.T1A - pair.T1C - margin <= xi <= pair.T1E - pair.T1C + margin:
            continue
        # its mate: the tooth beside the space into which this tooth reaches, on the side of its left flank
        want = (-1 if gear2.z > 0 else 1) * abs(r_b1 / r_b2) * arc
        half = (-1 if gear2.z > 0 else 1) * math.pi / abs(gear2.z)
        space = tooth0_2 + angle2 - towards2
        m = (want + half - space) * abs(gear2.z) / (2 * math.pi)
        assert abs(m - round(m)) < 0.05
        out.append((k, round(m) % abs(gear2.z), xi))
    return out


@pytest.mark.parametrize(("z2", "internal"), [(24, False), (60, True)])
def test_teeth_in_contact_are_those_of_the_drawing(z2, internal):
    """Outlines turned until the front flanks touch: same teeth, and the sides that the module text names."""
    model = machine(21, z2, internal=internal)
    pair = model.pairs["stage"]
    theta = math.pi if internal else 0.0
    first, second = (model.phasing.tooth_angle[g] for g in ("g1", "g2"))
    for angle in (0.0, 0.05, 0.13, 0.21):
        drawn = first + angle - theta
        phi2 = (pair.j_bt - drawn * pair.gear1.d_b) / pair.gear2.d_b
        turned = (pair.j_bt - angle * pair.gear1.d_b) / pair.gear2.d_b
        one, two = mesh_outlines(pair, drawn, 300, phi2=phi2, direction=theta)
        at = pair.a_w * np.array([math.cos(theta), math.sin(theta)])
        near, mate = cKDTree(two).query(one)
        found = set()
        for i in np.nonzero(near < 12e-6)[0]:
            k, side1 = which_flank(one[i], 21, first + angle)
            m, side2 = which_flank(two[mate[i]] - at, z2, second + turned)
            found.add((k, side1, m, side2))
        side = -1 if internal else 1
        touching, close = (
            {(k, 1, m, side) for k, m, _ in teeth_in_contact(model, angle, margin)}
            for margin in (0.0, 1.5e-3)
        )
        # flanks inside a ring are all but congruent: the next pair is within micrometres before it touches
        assert touching <= found <= close
        if not internal:
            assert found == touching


def which_flank(point, z, angle):
    """Number of the tooth at a point of an outline, and its side: 1 counter-clockwise (left), -1 right."""
    place = (math.atan2(point[1], point[0]) - angle) * z / math.tau
    return round(place) % z, 1 if place > round(place) else -1


@pytest.mark.parametrize("direction", [0.0, 2.1])
@pytest.mark.parametrize(("z2", "internal"), [(24, False), (60, True)])
def test_pitch_deviations_of_both_gears(z2, internal, direction):
    """Any pitch deviations: the pair with the least gap leads, tooth by tooth over a whole turn of gear 1."""
    rng = np.random.default_rng(7)
    z1 = 21
    pitch = [np.round(rng.normal(size=z), 3) for z in (z1, z2)]
    given = [f", deviations: {{pitch: [{', '.join(f'{p} um' for p in values)}]}}" for values in pitch]
    model = machine(z1, z2, *given, internal=internal, direction=direction)
    place = []
    for values in pitch:
        sums = np.cumsum(1e-6 * (values - values.mean()))
        place.append((sums - sums.mean()) * math.cos(math.radians(20.0)))
    error, angles, _ = rolled(model, 4, z1)
    expected = []
    for angle in angles:
        gaps = [
            -place[0][k] + (1 if internal else -1) * place[1][m] for k, m, _ in teeth_in_contact(model, angle)
        ]
        expected.append(min(gaps))
    assert np.abs(error - expected).max() < 1e-10


@pytest.mark.parametrize(("z2", "internal"), [(24, False), (60, True)])
def test_one_displaced_tooth_shows_once_per_turn(z2, internal):
    """Tooth 5 of gear 2 displaced towards its mate by 8 um: seen for eps_alpha base pitches in a turn."""
    sign = -1.0 if internal else 1.0
    pitch = [0.0] * z2
    pitch[5], pitch[6] = 8.0 * sign, -8.0 * sign
    text = f", deviations: {{pitch: [{', '.join(f'{p} um' for p in pitch)}]}}"
    model = machine(21, z2, "", text, internal=internal)
    error, _, _ = rolled(model, 8, z2)
    rest = 8e-6 / z2 * math.cos(math.radians(20.0))
    low, high = error.min(), error.max()
    assert high == pytest.approx(rest, abs=1e-10)
    assert high - low == pytest.approx(8e-6 * math.cos(math.radians(20.0)), abs=1e-10)
    share = np.mean(error < 0.5 * (low + high)) * z2
    assert share == pytest.approx(model.pairs["stage"].eps_alpha, abs=1.0 / 8.0)


def runout_error(model, which, error, angle1):
    """Part of an eccentricity of 2 um at 30 deg of one of the gears along the line of action."""
    pair = model.pairs["stage"]
    u = 0.5 * pair.j_bt + error
    angle = angle1 if which == 1 else (2.0 * u - angle1 * pair.gear1.d_b) / pair.gear2.d_b
    theta = model.meshes["stage"].theta + (math.pi if pair.gear2.is_internal else 0.0)
    normal = theta + 0.5 * math.pi - pair.alpha_wt  # direction in which gear 1 pushes
    along = 2e-6 * np.cos(model.phasing.tooth_angle[f"g{which}"] + angle + math.radians(30.0) - normal)
    return -along if which == 1 else along


@pytest.mark.parametrize("which", [1, 2])
@pytest.mark.parametrize(("z2", "internal"), [(24, False), (60, True)])
def test_runout_is_a_sine_over_the_turn(which, z2, internal):
    """An eccentricity E moves all flanks by its share along the line of action, which stands still."""
    model = machine(
        21,
        z2,
        *(", deviations: {runout: {amount: 4 um, phase: 30 deg}}" if k == which else "" for k in (1, 2)),
        internal=internal,
        direction=0.4,
    )
    z = 21 if which == 1 else z2
    error, angle1, _ = rolled(model, 3, z)
    assert np.abs(error - runout_error(model, which, error, angle1)).max() < 1e-9


@pytest.mark.each_value
@pytest.mark.parametrize("which", [1, 2])
@pytest.mark.parametrize("internal", [False, True])
@pytest.mark.parametrize("beta", [15.0, -30.0])
def test_runout_of_helical_gears_is_the_same_sine(which, internal, beta):
    """All points of a contact line have one normal: the helix changes nothing, whatever the overlap.

    eps_beta is 0.55 and 1.06. The tip of a ring reaches below the form circle of a small pinion, where no
    flank is; this one has teeth enough. The law is of first order in the deviations, hence the tolerance.
    """
    z1, z2 = (61, 150) if internal else (21, 24)
    hands = ("right", "left") if beta > 0.0 else ("left", "right")
    if internal:
        hands = (hands[0], hands[0])
    runout = ", deviations: {runout: {amount: 4 um, phase: 30 deg}}"
    given = [
        f", helix_angle: {abs(beta)} deg, hand: {hands[k - 1]}" + (runout if k == which else "")
        for k in (1, 2)
    ]
    model = machine(z1, z2, *given, internal=internal, direction=0.4, beta=beta)
    assert not model.pairs["stage"].warnings()
    error, angle1, _ = rolled(model, 3, z1 if which == 1 else z2)
    assert np.abs(error - runout_error(model, which, error, angle1)).max() < 1e-10


RELIEF = 20e-6


def relieved(gear):
    """Linear tip relief over a quarter of the usable flank, on stations of the separation grid."""
    first, last = flank_range(CylindricalGear(z=gear, m_n=M_N, b=WIDTH))
    length = 0.25 * (last - first)
    return length, f", modifications: {{both: {{tip_relief: {{amount: 20 um, length: {length!r} m}}}}}}"


def test_tip_relief_delays_the_contact():
    """Tips of gear 2 relieved: a pair entering at A carries only where the deflection exceeds the relief."""
    length, text = relieved(45)
    model = machine(30, 45, "", text, torque=300.0)
    pair = model.pairs["stage"]
    _, _, data = rolled(model, 100, 1)
    force = 300.0 / (0.5 * pair.gear2.d_b)
    k = C_PRIME * WIDTH
    phase = data["mesh_phase[stage]"].values
    deflection = data["deflection[stage]"].values - 0.5 * pair.j_bt
    p_bt = pair.p_et
    checked = 0
    for psi, delta in zip(phase, deflection, strict=True):
        places = [psi + q for q in range(2) if psi + q <= pair.eps_alpha]
        # path from A in metres; the relief of the tip of gear 2 ends `length` behind A
        relief = [RELIEF * max(0.0, 1.0 - p * p_bt / length) for p in places]
        carried = sum(k * max(0.0, delta - c) for c in relief)
        assert carried == pytest.approx(force, rel=2e-3)
        checked += any(c > delta for c in relief)
    assert checked > 3
    # first contact: where the deflection of the one pair in contact equals what is left of the relief
    first = (1.0 - force / k / RELIEF) * length / p_bt
    share = data["mesh_stiffness[stage]"].values > 1.5 * k
    assert phase[share].min() == pytest.approx(first, abs=0.02)


def test_unloaded_error_of_a_long_relief():
    """Relief of gear 1 longer than the double contact: a pair alone shows its relieved tip in the error."""
    first, last = flank_range(CylindricalGear(z=30, m_n=M_N, b=WIDTH))
    length = 0.75 * (last - first)
    text = f", modifications: {{both: {{tip_relief: {{amount: 2 um, length: {length!r} m}}}}}}"
    model = machine(30, 45, text)
    pair = model.pairs["stage"]
    error, _, data = rolled(model, 40, 1)
    p_bt, eps = pair.p_et, pair.eps_alpha
    for psi, found in zip(data["mesh_phase[stage]"].values[:-1], error, strict=True):
        # of two pairs the one that entered last is further from its tip
        assert found == pytest.approx(2e-6 * max(0.0, 1.0 - (eps - psi) * p_bt / length), abs=1e-9)
    assert np.ptp(error) == pytest.approx(2e-6 * (1.0 - (eps - 1.0) * p_bt / length), rel=0.05)


@pytest.mark.parametrize(
    ("z2", "internal", "front"), [(45, False, "left"), (60, True, "right")], ids=["external", "internal"]
)
@pytest.mark.parametrize("side", ["left", "right"])
def test_side_of_the_wheel_that_touches(z2, internal, front, side):
    """Crowning of one side of the wheel weakens the front or the back flank only."""
    model = machine(21, z2, "", f", modifications: {{{side}: {{lead_crowning: 8 um}}}}", internal=internal)
    system = compile_model(model)
    pair = model.pairs["stage"]
    channel = system.layout.channel("mesh_force[stage]")
    force = []
    for turn in (1.0, -1.0):
        state = system.initial_state()
        state.q[system.spin("driver")] = turn * (0.5 * pair.j_bt + 10e-6) / (0.5 * pair.gear1.d_b)
        force.append(turn * evaluate.observe(system, state)[channel])
    weak, full = force if side == front else force[::-1]
    # mean gap of the crowning is a third of its height
    assert weak / full == pytest.approx(1.0 - 8.0 / 3.0 / 10.0, abs=5e-3)
