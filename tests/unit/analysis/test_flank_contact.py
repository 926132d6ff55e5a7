# SPDX-License-Identifier: Apache-2.0
"""Numbers of a contact analysis on datasets whose load distribution is known."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from pitchpoint.analysis.flank_contact.contact_pattern import (
    contact_pattern,
    load_sharing,
    on_flank,
    on_path,
)
from pitchpoint.analysis.flank_contact.load_factors import (
    OVER,
    face_load_factor,
    line_loads,
    load_over_width,
    loaded_pairs,
    transverse_load_factor,
)
from pitchpoint.analysis.flank_contact.losses import loss_factor
from pitchpoint.analysis.flank_contact.mesh_orders import mesh_orders
from pitchpoint.analysis.flank_contact.numbers import contact_numbers
from pitchpoint.analysis.flank_contact.teeth import mesh_teeth, pair_positions
from pitchpoint.analysis.sampled import SignalError
from pitchpoint.geometry import CylindricalGear, GearPair
from pitchpoint.geometry.sliding import loss_factor_integral, loss_factor_ohlendorf

FZG = GearPair(
    CylindricalGear(z=16, m_n=4.5e-3, x=0.1817),
    CylindricalGear(z=24, m_n=4.5e-3, x=0.1715),
    91.5e-3,
)
B = 0.014


def shared_equally(
    pair: GearPair, positions: int, planes: int = 1, over_width=1.0, torque: float = 302.0
) -> xr.Dataset:
    """Load shared equally by the pairs between A and E, and over the width in proportion to `over_width`."""
    phase = np.arange(positions) / positions
    pairs = np.arange(-1, 2)
    place = phase[:, None] + pairs
    on = (place >= 0.0) & (place < pair.eps_alpha)
    force = torque / pair.gear1.r_b
    share = on / on.sum(axis=1, keepdims=True)
    width = np.full(planes, B / planes)
    across = np.broadcast_to(over_width, planes) / np.sum(np.broadcast_to(over_width, planes))
    forces = (force * share)[None, :, :, None] * across
    roll_1 = np.where(on, pair.T1A + place * pair.p_et, np.nan)[None, :, :, None] + 0.0 * across
    held = np.isfinite(roll_1)
    data = xr.Dataset({"plane_force": (OVER, np.where(held, forces, np.nan))})
    data["line_load"] = OVER, np.where(held, forces / width, np.nan)
    data["pressure"] = OVER, np.where(held, 1e9 + 0.0 * forces, np.nan)
    data["edge_pressure"] = OVER, np.full(forces.shape, np.nan)
    data["roll_1"], data["roll_2"] = (OVER, roll_1), (OVER, pair.T1T2 - roll_1)
    for name, values in {
        "transmission_error": 2e-6 + 1e-6 * np.cos(2.0 * np.pi * phase),
        "unloaded_transmission_error": 0.0 * phase,
        "mesh_stiffness": 4e8 + 0.0 * phase,
        "secant_stiffness": 3e8 + 0.0 * phase,
    }.items():
        data[name] = OVER[:2], values[None, :]
    data = data.assign_coords(torque=[torque], mesh_phase_position=phase, tooth_pair=pairs)
    data["plane"] = "plane", ((np.arange(planes) + 0.5) / planes - 0.5) * B
    data["plane_width"], data["plane_advance"] = ("plane", width), ("plane", np.zeros(planes))
    path = np.array([pair.T1A, pair.T1B, pair.T1C, pair.T1D, pair.T1E])
    data["mark_roll"] = ("gear", "mark"), np.array([path, pair.T1T2 - path])
    data["number_of_teeth"] = "gear", [float(pair.gear1.z), float(pair.gear2.z)]
    data["base_radius"] = "gear", [pair.gear1.r_b, pair.gear2.r_b]
    data["base_helix_angle"] = "gear", [0.0, 0.0]
    return data


def test_loss_factor_of_half_and_whole_load_is_that_of_ohlendorf():
    """0.1986 for FZG type C (published); 200 000 positions meet the jumps of the load to 1e-6."""
    data = shared_equally(FZG, 200_000)
    assert float(loss_factor(data)[0]) == pytest.approx(0.1986, abs=5e-5)
    assert float(loss_factor(data)[0]) == pytest.approx(loss_factor_ohlendorf(FZG), abs=1e-6)
    assert float(loss_factor(data)[0]) == pytest.approx(loss_factor_integral(FZG), abs=1e-6)


def test_geometry_of_the_mesh():
    teeth = mesh_teeth(shared_equally(FZG, 8, planes=4))
    assert teeth.base_pitch == pytest.approx(FZG.p_et, rel=1e-12)
    assert teeth.eps_alpha == pytest.approx(FZG.eps_alpha, rel=1e-12)
    assert teeth.eps_beta == 0.0
    assert pair_positions(shared_equally(FZG, 4))[1].tolist() == [-0.75, 0.25, 1.25]


def test_loads_over_the_width():
    """Linear load over the width; its mean is F_bt/b whatever the sharing of the pairs."""
    data = shared_equally(FZG, 64, planes=5, over_width=[0.6, 0.8, 1.0, 1.2, 1.4])
    w = load_over_width(data)
    assert w.shape == (1, 5)
    assert w.mean() == pytest.approx(302.0 / FZG.gear1.r_b / B, rel=1e-12)
    # the ends are half a plane beyond the outermost middles: 1.5 instead of 1.4
    assert face_load_factor(w) == pytest.approx([1.5], rel=1e-12)
    assert face_load_factor([3.0]) == pytest.approx(1.0)


def test_a_load_that_falls_towards_both_ends_has_its_maximum_in_the_middle():
    assert face_load_factor([0.0, 1.0, 2.0, 1.0, 0.0]) == pytest.approx(2.5)


def test_maximum_and_mean_line_load():
    """Single contact has twice the load of double contact; 0.4625 of the positions are double."""
    data = shared_equally(FZG, 10_000)
    most, mean = line_loads(data)
    w = 302.0 / FZG.gear1.r_b / B
    assert most[0] == pytest.approx(w, rel=1e-12)
    assert mean[0] == pytest.approx(w / FZG.eps_alpha, rel=2e-4)
    assert loaded_pairs(data)[0] == pytest.approx(FZG.eps_alpha, abs=2e-4)


def test_transverse_load_factor_of_spur_gears_is_one():
    found = contact_numbers(shared_equally(FZG, 64))
    assert found["transverse_load_factor"] == pytest.approx([1.0], rel=1e-12)


def test_transverse_load_factor_without_nominal_contact_is_not_a_number():
    teeth = mesh_teeth(shared_equally(FZG, 8))
    gone = type(teeth)(**{**vars(teeth), "mark_roll": teeth.mark_roll[:, ::-1]})
    assert np.isnan(transverse_load_factor([[[1.0]]], [0.5], gone))


def test_numbers_by_name():
    found = contact_numbers(shared_equally(FZG, 64))
    assert found["mean_transmission_error"] == pytest.approx([2e-6], rel=1e-12)
    assert found["transmission_error_pp"] == pytest.approx([2e-6], rel=1e-12)
    assert found["transmission_error_orders"][0] == pytest.approx([1e-6, 0.0, 0.0, 0.0, 0.0], abs=1e-18)
    assert found["mean_mesh_stiffness"] == pytest.approx([4e8])
    assert found["mean_secant_stiffness"] == pytest.approx([3e8])
    assert found["flank_pressure"] == pytest.approx([1e9])
    assert np.isnan(found["edge_pressure"][0])
    assert found["face_load_factor"] == pytest.approx([1.0])
    assert found["line_load_ratio"] == pytest.approx(found["max_line_load"] / found["mean_line_load"])


def test_orders_above_half_the_positions_are_omitted():
    assert mesh_orders(np.zeros((2, 8)), 10).amplitude.shape == (2, 3)
    with pytest.raises(SignalError, match="3 positions"):
        mesh_orders([1.0, 2.0, 3.0])


def test_load_share_of_one_pair():
    found = load_sharing(shared_equally(FZG, 1000))
    inside = (found.way >= 0.0) & (found.way < FZG.eps_alpha)
    single = (found.way >= FZG.eps_alpha - 1.0) & (found.way < 1.0)
    assert np.all(np.diff(found.way) > 0.0)
    assert np.all(found.share[~inside] == 0.0)
    assert np.all(found.share[single] == 1.0)
    assert np.all(found.share[inside & ~single] == 0.5)


@pytest.mark.parametrize("gear", [1, 2])
def test_pattern_on_the_flank(gear):
    """From A to E; twice the line load between B and D on both gears."""
    pattern = contact_pattern(shared_equally(FZG, 200, planes=3))
    field = on_flank(pattern, "line_load", gear)
    path = (FZG.T1A, FZG.T1E) if gear == 1 else (FZG.T1T2 - FZG.T1E, FZG.T1T2 - FZG.T1A)
    assert (field.place[0], field.place[-1]) == pytest.approx(path, rel=1e-12)
    ways = field.place if gear == 1 else FZG.T1T2 - field.place
    w = 302.0 / FZG.gear1.r_b / B
    step = FZG.p_et / 200
    for low, high, share in (
        (FZG.T1A, FZG.T1B, 0.5),
        (FZG.T1B, FZG.T1D, 1.0),
        (FZG.T1D, FZG.T1E, 0.5),
    ):
        chosen = (ways > low + step) & (ways < high - step)
        assert field.values[chosen] == pytest.approx(share * w, rel=1e-12)


def test_pattern_leaves_places_without_contact_empty():
    """Between two places of contact there is no interpolation over a gap."""
    data = shared_equally(FZG, 100)
    hole = (data["roll_1"] > FZG.T1C - 1e-3) & (data["roll_1"] < FZG.T1C + 1e-3)
    for name in ("line_load", "pressure", "edge_pressure", "roll_1", "roll_2", "plane_force"):
        data[name] = data[name].where(~hole)
    field = on_flank(contact_pattern(data), "any_pressure")
    gone = np.abs(field.place - FZG.T1C) < 0.8e-3
    assert np.all(np.isnan(field.values[gone]))
    assert np.isfinite(field.values).sum() > 0.8 * field.values.size


def with_tip_edge(length):
    """Tip edge of gear 1 in contact over a length of the path beyond E, with a pressure that falls there."""
    data = shared_equally(FZG, 100)
    place = data["mesh_phase_position"] + data["tooth_pair"]
    edge = (place >= FZG.eps_alpha) & (place < FZG.eps_alpha + length)
    beyond = place - FZG.eps_alpha
    data["edge_pressure"] = data["pressure"].fillna(0.0) * 0.0 + 2e9 * (1.0 - beyond)
    data["edge_pressure"] = data["edge_pressure"].where(edge)
    data["roll_1"] = data["roll_1"].where(~edge, FZG.T1E)
    # over places of the flank of gear 2 that are in contact before, too
    data["roll_2"] = data["roll_2"].where(~edge, FZG.T1T2 - FZG.T1E + 0.3 * FZG.p_et * beyond)
    return data


def test_tip_edges_have_their_largest_value():
    """At one place of their own gear, over a range of the other; there flanks and edges overlap."""
    pattern = contact_pattern(with_tip_edge(0.2))
    own = on_flank(pattern, "edge_pressure", 1)
    assert np.isfinite(own.values).sum() == 1
    assert own.values[-1, 0] == pytest.approx(2e9, rel=0.02)
    mate = on_flank(pattern, "edge_pressure", 2)
    touched = np.isfinite(mate.values[:, 0])
    assert mate.place[touched].max() == pytest.approx(
        FZG.T1T2 - FZG.T1E + 0.06 * FZG.p_et, abs=0.02 * FZG.p_et
    )
    both = on_flank(pattern, "any_pressure", 2)
    assert np.all(both.values[touched] >= 1.5e9)
    assert both.values[~touched & np.isfinite(both.values[:, 0])] == pytest.approx(1e9, rel=1e-12)


def test_pattern_over_the_path_includes_contact_beyond_E():
    pattern = contact_pattern(with_tip_edge(0.2))
    field = on_path(pattern, "any_pressure")
    assert field.place[0] == 0.0
    assert field.place[-1] == pytest.approx(FZG.eps_alpha + 0.2, abs=0.02)
    at_E = field.place < FZG.eps_alpha - 0.02
    assert field.values[at_E] == pytest.approx(1e9, rel=1e-12)
    assert field.values[-1, 0] == pytest.approx(1.6e9, rel=0.02)


def test_planes_are_at_their_own_place_of_the_path():
    """Helical teeth: the load of a plane belongs to the position of the plane."""
    data = shared_equally(FZG, 400, planes=3)
    data["plane_advance"] = "plane", [-0.25, 0.0, 0.25]
    along = (data["mesh_phase_position"] + data["tooth_pair"] + data["plane_advance"]).transpose(*OVER[1:])
    on = (along >= 0.0) & (along <= FZG.eps_alpha)
    data["line_load"] = (along * 1e5).where(on).expand_dims(torque=1)
    field = on_path(contact_pattern(data), "line_load", points=50)
    inside = (field.place > 0.01) & (field.place < FZG.eps_alpha - 0.01)
    for plane in range(3):
        # tooth pairs -1 to 1 reach these places in all planes
        known = inside & np.isfinite(field.values[:, plane])
        assert known.sum() > 40
        assert field.values[known, plane] == pytest.approx(1e5 * field.place[known], rel=1e-9)
