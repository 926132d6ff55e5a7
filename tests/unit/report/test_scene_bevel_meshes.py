# SPDX-License-Identifier: Apache-2.0
"""Arrows of bevel meshes: at the pitch point, along the axes of gear 2, in balance with its bearings."""

from __future__ import annotations

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.power_flow import power_flow
from pitchpoint.report.scene.build import scene_of
from pitchpoint.solvers.time import solve_time
from pitchpoint.system.compile import compile_model
from tests.support.bevel_files import bevel_file

REST = """
bearings:
  one: {body: first, position: [0, 0, 120 mm], stiffness: {radial: 3e9, axial: 2e9, tilt: 3e6}}
  two: {body: second, position: [0, 0, 60 mm], stiffness: {radial: 4e9, axial: 3e9, tilt: 5e6}}
loads:
  in: {body: first, torque: 80 N m}
  out: {body: second, torque: balance}
scenarios:
  s: {speed: {first: 100 rpm}, duration: 1 ms, step: 10 us, settle_time: 0 s}
"""
FREE = "motion: free, mass: 2 kg, inertia: {inertia}, transverse_inertia: 2e-2 kg m^2"


@pytest.mark.parametrize("opens", [("+z", "+z"), ("+z", "-z")])
def test_arrows_balance_the_bearings_of_gear_2(opens):
    model = loads_model(bevel_file(shaft=75.0, spiral=30.0, opens=opens, bodies=FREE, rest=REST))
    run = solve_time(compile_model(model, "s"))
    scene = scene_of(model, run)
    arrows = {arrow.name: arrow for arrow in scene.arrows}
    mesh, bearing = (sum(arrows[n].components.values()) for n in ("m", "two"))
    assert np.allclose(mesh, -bearing, atol=2e-3 * np.abs(mesh).max())
    pair = model.bevel_pairs["m"]
    place = np.asarray(arrows["m"].at)[0]
    assert np.linalg.norm(place) == pytest.approx(pair.R_m, rel=1e-4)
    assert place[2] == pytest.approx(pair.R_m * np.cos(pair.gear1.delta), rel=1e-3)
    axis = np.array([np.sin(pair.Sigma), 0.0, np.cos(pair.Sigma)])  # from the apex into gear 2
    axial = arrows["m"].components["axial"][0]
    assert np.allclose(np.cross(axial, axis), 0.0, atol=1e-3 * np.linalg.norm(axial))


def test_power_goes_through_a_bevel_mesh():
    """All that the first gear gives arrives: nothing here loses."""
    model = loads_model(
        bevel_file(opens=("-z", "+z"), rest=REST.partition("loads")[1] + REST.partition("loads")[2])
    )
    flow = power_flow(model, solve_time(compile_model(model, "s")))
    stage = next(link for link in flow.links if link.name == "m")
    power = 80.0 * 100.0 * np.pi / 30.0
    assert stage.given == pytest.approx(power, rel=1e-3) and stage.taken == pytest.approx(power, rel=1e-3)
    assert flow.blocks[stage.start].name == "first" and flow.blocks[stage.end].name == "second"
