# SPDX-License-Identifier: Apache-2.0
"""Torsional elements at a marker of an elastic shaft twist the shaft up to there."""

from __future__ import annotations

import math

import numpy as np
import pytest

import pitchpoint as pp
from pitchpoint.core.errors import ModelError
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.model.remarks.collect import remarks_of
from pitchpoint.solvers.modal import solve_modal

# G = E/(2 (1 + nu)) = 80 GPa; k = G pi d^4/(32 L)
SHAFT = """\
gears: {spare: {number_of_teeth: 20, normal_module: 1 mm, face_width: 5 mm, profile_shift_coefficient: 0}}
shafts:
  bar:
    sections: [{length: 200 mm, diameter: 20 mm}]
    material: {youngs_modulus: 208 GPa, poisson_ratio: 0.3, density: 7850 kg/m^3}
    position: [0, 0, 0]
    axes: {AXES}
    markers: {MARKERS}
bodies:
  wheel: {inertia: 0.3, motion: torsion, position: [0, 0, 0], axes: {AXES}}
bearings:
  seat: {body: bar, position: [0, 0, 0], stiffness: {radial: 1e9 N/m, axial: 1e9 N/m, tilt: 1e6 N m/rad}}
torsion_springs:
  base: {bodies: [bar], stiffness: 1e9 N m/rad}
  link: {bodies: BODIES, stiffness: 1e9 N m/rad}
loads:
  push: {body: wheel, torque: 40 N m}
scenarios:
  rest: {duration: 1 ms}
"""
AXES = ("{z: [0, 0, 1], x: [1, 0, 0]}", "{z: [0.6, 0, -0.8], x: [0.8, 0, 0.6]}")
STIFFNESS = 80e9 * math.pi * 0.02**4 / (32.0 * 0.2)


def model(bodies: str, axes: str = AXES[0], more: str = ""):
    text = SHAFT.replace("{AXES}", axes).replace("BODIES", bodies) + more
    places = (("middle", 100), ("end", 200))  # a marker that is not used is a remark
    markers = [f"{n}: {{position: [0, 0, {z} mm]}}" for n, z in places if f"bar.{n}" in text]
    text = text.replace("MARKERS", ", ".join(markers))
    return loads_model(text)


@pytest.mark.parametrize("axes", AXES)
@pytest.mark.parametrize(("place", "share"), [(".end", 1.0), (".middle", 0.5), ("", 0.0)])
def test_twist_of_the_shaft(axes, place, share):
    for bodies in (f"[bar{place}, wheel]", f"[wheel, bar{place}]"):
        system = pp.compile_model(model(bodies, axes), "rest")
        data = pp.solve_time(system)
        twist = float(data["angle[wheel]"][0]) - float(data["angle[bar]"][0])
        assert twist == pytest.approx(40.0 * share / STIFFNESS + 40.0 / 1e9, rel=1e-5)


def test_frequency_of_a_wheel_on_a_bar():
    (lowest, *_) = solve_modal(pp.compile_model(model("[bar.end, wheel]"), "rest")).frequency.values
    # the bar has a third of its inertia at the wheel (Rayleigh)
    inertia = 0.3 + 7850 * math.pi * 0.02**4 / 32.0 * 0.2 / 3.0
    assert float(lowest) == pytest.approx(math.sqrt(STIFFNESS / inertia) / math.tau, rel=1e-4)


def test_remarks_and_refusals():
    assert not any("link" in one or "end is not used" in one for one in remarks_of(model("[bar.end, wheel]")))
    for bodies, problem in (
        ("[bar.4, wheel]", "names the marker '4', which bar does not have; bar has no markers"),
        ("[bar.end, bar.middle]", "names bar twice; name two bodies"),
        ("[bare.end, wheel]", "names the body 'bare', which does not exist; did you mean bar"),
    ):
        with pytest.raises(ModelError, match=problem):
            model(bodies)


def test_clutches_and_maxwell_elements():
    more = (
        "torsion_maxwells:\n  slow: {bodies: [wheel, bar.middle], stiffness: 1e6 N m/rad, "
        "damping: 1e4 N m s/rad}\nclutches:\n  slip: {bodies: [bar.end, wheel], capacity: 100 N m}\n"
    )
    system = pp.compile_model(model("[bar.end, wheel]", more=more), "rest")
    (slow,), (slip,) = system.records["torsion_maxwell"], system.records["friction_clutch"]
    names = system.layout.bodies
    last = max(int(n.rpartition(".")[2]) for n in names if n.startswith("bar."))
    assert (names[slip["i"]], names[slip["j"]]) == (f"bar.{last}", "wheel")
    assert names[slow["i"]] == "wheel" and names[slow["j"]] not in ("bar", f"bar.{last}")
    assert np.isfinite(pp.solve_time(system)["angle[wheel]"].values).all()
