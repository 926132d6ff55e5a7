# SPDX-License-Identifier: Apache-2.0
"""Pressure of flanks with parabolic reliefs, crowning and tip roundings in a contact analysis."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from pitchpoint.analysis.flank_contact.teeth import mesh_teeth, pair_positions
from pitchpoint.contact.hertz import half_width, plane_strain_compliance
from pitchpoint.contact.strip_pressure import stepped_pressure
from pitchpoint.geometry.modifications import FlankModifications, deviation, flank_range
from pitchpoint.io.yaml_model import load_model, loads_model
from pitchpoint.solvers.contact_analysis.flank_states import FlankStates
from pitchpoint.solvers.contact_analysis.solve import solve_contact
from pitchpoint.solvers.contact_analysis.stepped_flanks import bends_of, step_pressures
from tests.support.contact_files import fzg, helical
from tests.support.relief_models import pair

STEEL = plane_strain_compliance(206e9, 0.3)
RELIEF = "modifications: {both: {tip_relief: {amount: 40 um, length: 1.5 mm, shape: parabolic}}}"
ROOT = "modifications: {both: {root_relief: {amount: 60 um, length: 4 mm, shape: parabolic}}}"
LINEAR = "modifications: {both: {tip_relief: {amount: 50 um, length: 3 mm}, profile_slope: 20 um}}"
LINEAR_ROOT = "modifications: {both: {root_relief: {amount: 30 um, length: 4 mm}, profile_slope: -20 um}}"
CROWNED = "modifications: {both: {profile_crowning: 30 um}}"


def contacts(model, positions=128):
    """Length of roll on gear 1, line load and pressure of the middle plane."""
    data = solve_contact(model, torque=302.0, positions=positions)
    fields = [data[name].isel(plane=5).values.ravel() for name in ("roll_1", "line_load", "pressure")]
    known = np.isfinite(fields[2]) & (fields[1] > 1e4)
    order = np.argsort(fields[0][known])
    return [values[known][order] for values in fields]


def hertz(pair, gear_1, made, roll, load):
    """Hertz with the second derivative of the removed material over the arc, by differences."""
    step = 1e-5
    rolls = np.sqrt(roll**2 + 2.0 * gear_1.r_b * step * np.array([[-1.0], [0.0], [1.0]]))
    gaps = deviation(made, gear_1, rolls)
    bent = (gaps[0] - 2.0 * gaps[1] + gaps[2]) / step**2
    curvature = 1.0 / roll + 1.0 / (pair.T1T2 - roll) + bent
    return 2.0 * load / (math.pi * half_width(load, 1.0 / curvature, STEEL, STEEL))


@pytest.mark.parametrize("text", [RELIEF, ROOT, CROWNED, LINEAR, LINEAR_ROOT])
def test_beyond_the_start_it_is_hertz_with_the_curvature_of_the_modification(
    tmp_path: Path, text: str
) -> None:
    """1e-3 for the differences over 10 µm of arc."""
    model = fzg(tmp_path, gears=(text, ""))
    pair, gear = model.pairs["stage"], model.gears["g1"]
    made = gear.modifications.side("left").of_geometry()
    roll, load, pressure = contacts(model)
    expected = hertz(pair, gear.geometry, made, roll, load)
    starts = [bend.start for bend in bends_of(FlankStates(model, "stage"))]
    far = np.all([np.abs(roll - start) > 0.7e-3 for start in starts], axis=0)
    assert far.sum() > 50
    assert pressure[far] == pytest.approx(expected[far], rel=1e-3)
    inside = np.abs(expected / hertz(pair, gear.geometry, type(made)(), roll, load) - 1.0) > 0.02
    assert (far & inside).sum() > 3


def helicoid(gear, gap, roll, turn):
    """Point of the left flank, offset by gap(roll) along its normal: length of roll and turn about the axis
    with the axial travel of the helix, any shape; last axis x, y, z."""
    lead = gear.r_b / math.tan(gear.beta_b)
    radial, tangent = (
        np.stack([np.cos(a), np.sin(a), 0.0 * a], -1)
        for a in (roll / gear.r_b + turn, roll / gear.r_b + turn - 0.5 * math.pi)
    )
    along = np.array([0.0, 0.0, 1.0])
    point = gear.r_b * radial + roll[..., None] * tangent + lead * turn[..., None] * along
    normal = tangent * math.cos(gear.beta_b) + along * math.sin(gear.beta_b)
    return point - gap(roll)[..., None] * normal


def normal_curvature(gear, made, roll):
    """Curvature of the flank along the tangent of the transverse profile, normal to the contact line,
    from its fundamental forms by differences. Material removed at the point itself is not offset: it would
    change the curvature by h/L of it, 2e-3 near the root."""
    steps = np.arange(-1, 2)
    u, v = np.meshgrid(2e-5 * steps, 1e-3 * steps, indexing="ij")
    found = []
    for one in roll:
        at = helicoid(
            gear, lambda L, at=one: deviation(made, gear, L) - deviation(made, gear, at), one + u, v
        )
        by = [(at[2, 1] - at[0, 1]) / 4e-5, (at[1, 2] - at[1, 0]) / 2e-3]
        twice = [
            [
                (at[2, 1] - 2.0 * at[1, 1] + at[0, 1]) / 4e-10,
                (at[2, 2] - at[2, 0] - at[0, 2] + at[0, 0]) / 8e-8,
            ],
            [
                (at[2, 2] - at[2, 0] - at[0, 2] + at[0, 0]) / 8e-8,
                (at[1, 2] - 2.0 * at[1, 1] + at[1, 0]) / 1e-6,
            ],
        ]
        normal = np.cross(*by)
        normal /= np.linalg.norm(normal)
        a = one / gear.r_b
        way = np.linalg.lstsq(np.array(by).T, [math.cos(a), math.sin(a), 0.0], rcond=None)[0]
        found.append(abs(way @ (np.array(twice) @ normal) @ way) / np.sum((way @ np.array(by)) ** 2))
    return np.array(found)


@pytest.mark.parametrize("modified", ["profile_crowning: 40 um", "profile_slope: -60 um", ""])
@pytest.mark.parametrize("internal", [False, True])
def test_helical_flanks_are_offset_helicoids(modified: str, internal: bool) -> None:
    """Differences over 20 µm of roll: 1e-3, while cos²β_b instead of the section normal to the contact line
    changes the pressure by 0.6 to 4.4 %."""
    model = pair(f"both: {{{modified}}}" if modified else "", beta=30.0, internal=internal)
    data = solve_contact(model, torque=300.0, positions=8)
    gear = model.gears["pinion"].geometry
    made = model.gears["pinion"].modifications
    made = FlankModifications() if made is None else made.side("left").of_geometry()
    fields = [data[name].values for name in ("roll_1", "roll_2", "line_load", "pressure")]
    known = np.isfinite(fields[3]) & (fields[2] > 1e3) & (fields[0] > flank_range(gear)[0] + 2e-5)
    one, two, load, pressure = (values[known] for values in fields)
    mate = (-1.0 if internal else 1.0) * math.cos(gear.beta_b) / two
    curvature = normal_curvature(gear, made, one) + mate
    expected = 2.0 * load / (math.pi * half_width(load, 1.0 / curvature, STEEL, STEEL))
    assert pressure.size > 20
    assert pressure == pytest.approx(expected, rel=1e-3)


def test_near_the_start_it_is_between_both_curvatures(tmp_path: Path) -> None:
    model = fzg(tmp_path, gears=(RELIEF, ""))
    pair = model.pairs["stage"]
    (bend,) = bends_of(FlankStates(model, "stage"))
    assert (bend.gear, bend.towards_tip) == (0, True)
    assert bend.start == pytest.approx(pair.T1E - 1.5e-3, rel=1e-9)
    roll, load, pressure = contacts(model, positions=2000)
    k = int(np.abs(roll - bend.start).argmin())
    involute = 1.0 / roll[k] + 1.0 / (pair.T1T2 - roll[k])
    added = bend.by_roll * (pair.gear1.r_b / roll[k]) ** 2 * bend.start / roll[k]
    low, high = (
        2.0 * load[k] / (math.pi * half_width(load[k], 1.0 / c, STEEL, STEEL))
        for c in (involute, involute + added)
    )
    assert 1.1 * low < pressure[k] < 0.95 * high
    ahead = (bend.start**2 - roll[k] ** 2) / (2.0 * pair.gear1.r_b)
    at = [(ahead, added)] if ahead >= 0.0 else [(ahead, -added)]
    inside = involute if ahead >= 0.0 else involute + added
    strips = stepped_pressure(float(inside), at, float(load[k]), 2.0 * STEEL)
    assert pressure[k] == pytest.approx(strips.maximum, rel=1e-6)


def test_equal_gears_have_mirrored_pressures(tmp_path: Path) -> None:
    """Tip relief of gear 1 before E, and of gear 2 after A."""
    text = f"{RELIEF[:-2]}}}}}"
    path = tmp_path / "equal.yaml"
    fzg(tmp_path, gears=(text, text))
    lines = (tmp_path / "fzg.yaml").read_text(encoding="utf-8")
    lines = lines.replace("number_of_teeth: 16", "number_of_teeth: 20").replace(
        "number_of_teeth: 24", "number_of_teeth: 20"
    )
    lines = lines.replace("0.1715", "0.1817").replace("91.5", "91.6")
    path.write_text(lines, encoding="utf-8")
    model = load_model(path)
    pair = model.pairs["stage"]
    roll, _, pressure = contacts(model, positions=400)
    mirrored = np.interp(pair.T1T2 - roll[::-1], roll, pressure)[::-1]
    steep = np.abs(np.gradient(pressure)) > 0.02 * pressure.max()
    assert mirrored[~steep] == pytest.approx(pressure[~steep], rel=5e-3)


def test_tip_rounding_within_the_contact(tmp_path: Path) -> None:
    """Contacts at both ends of the path, where the involute of one gear meets the rounding of its tip."""
    model = fzg(tmp_path)
    pair = model.pairs["stage"]
    flanks = FlankStates(model, "stage")
    flanks.records["rounding"] = 0.1e-3
    assert [(b.gear, b.radius) for b in bends_of(flanks)] == [(0, 1e-4), (1, 1e-4)]
    roll = np.array([pair.T1A, pair.T1C, pair.T1E])
    load = np.full(3, 1e5)
    curvature = 1.0 / roll + 1.0 / (pair.T1T2 - roll)
    fields = {"line_load": load, "roll_1": roll, "roll_2": pair.T1T2 - roll}
    fields["pressure"] = 2.0 * load / (math.pi * half_width(load, 1.0 / curvature, STEEL, STEEL))
    before = fields["pressure"].copy()
    fields["edge_pressure"] = np.full(3, np.nan)
    step_pressures(flanks, fields, np.zeros(3))
    assert fields["pressure"][1] == pytest.approx(before[1], rel=1e-12)
    for k, own in ((0, pair.T1T2 - pair.T1A), (2, pair.T1E)):
        strips = stepped_pressure(curvature[k], [(0.0, 1.0 / 1e-4 - 1.0 / own)], 1e5, 2.0 * STEEL)
        assert fields["pressure"][k] == pytest.approx(strips.maximum, rel=1e-4)
        assert fields["pressure"][k] > 1.5 * before[k]


@pytest.mark.parametrize("made", [fzg, helical])
def test_pressure_continues_from_the_flank_to_the_rounding(tmp_path: Path, made) -> None:
    """Contact passes E and A: 3 % per thousandth of a base pitch, as the contact moves to the rounding, where
    the pressure is higher although the load decreases."""
    rounded = {f"gears.{gear}.tip_rounding": 3e-4 for gear in ("g1", "g2")}
    model = made(tmp_path, planes=1).replace_all(rounded)
    data = solve_contact(model, torque=302.0, positions=1000)
    flank, edge = (data[name].values[0, :, :, 0] for name in ("pressure", "edge_pressure"))
    assert np.nanmax(edge) > np.nanmax(flank)
    teeth = mesh_teeth(data)
    place, pressure = pair_positions(data), np.fmax(flank, edge)
    for end in (0.0, teeth.eps_alpha):
        near = np.abs(place - end) < 0.004
        order = np.argsort(place[near])
        assert order.size > 5
        steps = np.diff(pressure[near][order]) / pressure[near].max()
        # the steps are equal to a fifth, over the end of the path too
        assert np.abs(steps).max() < 0.04
        assert np.ptp(steps) < 0.2 * np.abs(steps).max() + 0.004


def test_a_steep_relief_in_a_ring_is_hollow() -> None:
    """Curvatures of both flanks nearly cancel, so that h′ (r_b/L)²/L of a linear tip relief exceeds them."""
    gear = "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0"
    steep = "modifications: {both: {tip_relief: {amount: 120 um, length: 2 mm}}}"
    model = loads_model(f"""
gears:
  planet: {{number_of_teeth: 60, {gear}, {steep}}}
  ring: {{type: internal, number_of_teeth: 90, {gear}}}
meshes:
  stage: {{gears: [planet, ring], contact: {{level: rigid, stiffness: 3e8 N/m, planes: 1}}}}
""")
    data = solve_contact(model, torque=20000.0, positions=32)
    spur, made = model.pairs["stage"], model.gears["planet"].modifications.side("left").of_geometry()
    fields = [data[name].values for name in ("roll_1", "roll_2", "pressure")]
    one, two, pressure = (values[np.isfinite(fields[0])] for values in fields)
    step = 1e-5
    rolls = np.sqrt(one**2 + 2.0 * spur.gear1.r_b * step * np.array([[-1.0], [0.0], [1.0]]))
    curvature = (
        1.0 / one - 1.0 / two + (np.array([1.0, -2.0, 1.0]) @ deviation(made, spur.gear1, rolls)) / step**2
    )
    on_path = np.abs(two - one - abs(spur.T1T2)) < 1e-9
    beyond = on_path & (rolls[0] > flank_range(spur.gear1)[1] - 2e-3)
    assert beyond.any() and (curvature[beyond] < 0.0).all()
    assert np.isnan(pressure[beyond]).all()
    assert "no pressure at" in data.attrs["notes"] and "steep relief" in data.attrs["notes"]


def test_a_hollow_flank_has_no_line_contact() -> None:
    """Negative profile crowning of a planet: concave at the middle of its flank, where the curvature of
    removed material, (r_b/L)² (h″ − h′/L), exceeds that of both involutes. Loads and the pressures of the
    other contacts remain."""
    model = pair("both: {profile_crowning: -60 um}", internal=True)
    data = solve_contact(model, torque=[50.0, 300.0], positions=16)
    spur = model.pairs["stage"]
    made = model.gears["pinion"].modifications.side("left").of_geometry()
    loaded = np.isfinite(data.line_load.values)
    one, two, pressure = (data[name].values[loaded] for name in ("roll_1", "roll_2", "pressure"))
    step = 1e-5
    rolls = np.sqrt(one**2 + 2.0 * spur.gear1.r_b * step * np.array([[-1.0], [0.0], [1.0]]))
    added = (np.array([1.0, -2.0, 1.0]) @ deviation(made, spur.gear1, rolls)) / step**2
    curvature = 1.0 / one - 1.0 / two + added
    on_path = np.abs(two - one - abs(spur.T1T2)) < 1e-9
    clear = on_path & (rolls[0] > flank_range(spur.gear1)[0]) & (np.abs(curvature) > 1.0)
    assert np.array_equal(np.isnan(pressure[clear]), curvature[clear] < 0.0)
    assert min((curvature[clear] < 0.0).sum(), (curvature[clear] > 0.0).sum()) > 3
    forces = np.nansum(data.plane_force.values, axis=(2, 3))
    assert forces == pytest.approx(data.mesh_force.values, rel=1e-12)
    assert "no pressure at" in data.attrs["notes"] and "negative profile_crowning" in data.attrs["notes"]
