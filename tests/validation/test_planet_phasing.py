# SPDX-License-Identifier: Apache-2.0
"""PL-PHASE: which motion the harmonics of the mesh excite, from slow rolls of planetary stages.

With N planets at equal angles, harmonic l of the mesh stiffness acts on sun, ring and carrier as a rotation
if k = l z_s mod N is 0, as a translation if k is 1 or N - 1, and otherwise only on the planets (R. G. Parker,
A physical explanation for the effectiveness of planet phasing to suppress planetary gear vibration, J. Sound
Vib. 236 (2000) 561). Sets 48-16-80, 51-17-85 and 54-18-90 of four planets are those of cases.md, here with
three to five planets of the mesh stiffness of DIN 3990. The carrier is at rest, so that directions are fixed;
the sun floats. Its displacement is the translation, the mean deflection of all sun meshes the rotation.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.analysis.planet_frequencies import excited_motion
from pitchpoint.io.yaml_model import loads_model
from pitchpoint.report.planets import stages_of_model
from pitchpoint.solvers.quasistatic.roll import solve_quasistatic
from pitchpoint.system.compile import compile_model

TEETH = (
    "normal_module: 3 mm, face_width: 20 mm, profile_shift_coefficient: 0, tooth_thickness_allowance: -60 um"
)
MESH = "{stiffness: {law: din3990}}"


def set_of(sun: int, planet: int, ring: int, count: int) -> str:
    """Model file of a set with a floating sun and a carrier at rest."""
    return f"""
gears:
  sun: {{number_of_teeth: {sun}, {TEETH}}}
  ring: {{number_of_teeth: {ring}, {TEETH}, type: internal, tip_diameter: {3 * (ring - 1)} mm}}
bodies:
  sun: {{gears: [sun], motion: planar, position: [0, 0, 0]}}
  ring: {{gears: [ring], position: [0, 0, 0]}}
  carrier: {{motion: fixed}}
planetary_stages:
  set:
    sun: sun
    ring: ring
    carrier: carrier
    planets: {count}
    planet: {{number_of_teeth: {planet}, {TEETH}}}
    sun_mesh: {MESH}
    ring_mesh: {MESH}
bearings:
  spline: {{body: sun, stiffness: {{radial: 1e7 N/m}}}}
loads:
  in: {{body: sun, torque: 500 N m}}
  out: {{body: ring, torque: balance}}
scenarios:
  slow: {{quasi_static: {{mesh: sun-planet_1, points: {8 * count}}}}}
"""


@pytest.mark.parametrize(
    ("teeth", "count", "phases"),
    [
        ((48, 16, 80), 4, (0, 0, 0, 0)),
        ((51, 17, 85), 4, (0, 0.75, 0.5, 0.25)),
        ((54, 18, 90), 4, (0, 0.5, 0, 0.5)),
        ((22, 20, 62), 3, (0, 1 / 3, 2 / 3)),
        ((27, 18, 63), 5, (0, 0.4, 0.8, 0.2, 0.6)),
    ],
)
def test_motion_by_harmonic(teeth, count, phases):
    """Each harmonic of the static response has only the predicted motion: 1e-6 of the mean deflection.

    Motions that are excited are above 1e-4 of it, up to the fourth harmonic. The points of the roll are a
    multiple of the number of planets: others would see different parts of the stiffness of each planet.
    """
    model = loads_model(set_of(*teeth, count))
    rows = stages_of_model(model)["set"]["planets"].values()
    for mate in ("sun", "ring"):
        off = np.array([row["phases"][mate] for row in rows]) - np.array(phases)
        assert np.abs(off - np.round(off)).max() < 1e-6
    found = solve_quasistatic(compile_model(model, "slow"))
    names = [f"sun-planet_{k}" for k in range(1, count + 1)]
    rotation = np.mean([found[f"transmission_error[{name}]"].values[:-1] for name in names], axis=0)
    across = [found[f"displacement[sun.{axis}]"].values[:-1] for axis in "xy"]
    size = abs(rotation.mean())
    turned = np.abs(np.fft.rfft(rotation)) / rotation.size / size
    moved = np.hypot(*(np.abs(np.fft.rfft(u)) / rotation.size for u in across)) / size
    kinds = excited_motion(teeth[0], count, 4)
    for harmonic, kind in enumerate(kinds, start=1):
        assert (turned[harmonic] > 1e-4) == (kind == "rotational"), (harmonic, turned)
        assert (moved[harmonic] > 1e-4) == (kind == "translational"), (harmonic, moved)
        for quiet in [turned] * (kind != "rotational") + [moved] * (kind != "translational"):
            assert quiet[harmonic] < 1e-6, (harmonic, kind, turned, moved)


@pytest.mark.parametrize(("teeth", "shift"), [((48, 16, 80), 0.0), ((51, 17, 85), 0.25)])
def test_sun_and_ring_meshes_of_one_planet(teeth, shift):
    """From the entries of tooth pairs in a slow roll, where the stiffness jumps, and the path from A to C.

    1/2 for even and 0 for odd numbers of teeth of planets without profile shift. Tolerance: the steps of the
    roll, 1/200 of a mesh cycle, of both meshes.
    """
    text = set_of(*teeth, 4).replace("points: 32", "points: 200").replace("torque: 500", "torque: 1")
    if shift:
        none = "profile_shift_coefficient: 0,"
        arm = 0.5 * 3.0 * (teeth[0] + teeth[1])
        text = text.replace(
            f"number_of_teeth: {teeth[1]}, {TEETH}",
            f"number_of_teeth: {teeth[1]}, {TEETH}".replace(none, f"profile_shift_coefficient: {shift},"),
        )
        for z in (teeth[0], teeth[2]):
            text = text.replace(
                f"number_of_teeth: {z}, {TEETH}", f"number_of_teeth: {z}, {TEETH}".replace(none, "")
            )
        text = text.replace(
            "    carrier: carrier\n", f"    carrier: carrier\n    center_distance: {arm} mm\n"
        )
    model = loads_model(text)
    predicted = stages_of_model(model)["set"]["ring_after_sun"]
    if not shift:
        # thinner teeth of the planet by 60 um: both flanks are closer together
        assert predicted == pytest.approx(0.5 * (teeth[1] % 2 == 0) + 0.02 / math.pi, abs=1e-6)
    found = solve_quasistatic(compile_model(model, "slow"))
    passes = []
    for name in ("sun-planet_1", "planet_1-ring"):
        stiffness = found[f"tangent_stiffness[{name}]"].values
        pair = model.pairs[name]
        entry = (np.argmax(np.diff(stiffness)) + 0.5) / (stiffness.size - 1)
        passes.append(entry + (pair.T1C - pair.T1A) / pair.p_et)
    assert abs(np.remainder(passes[1] - passes[0] - predicted + 0.5, 1.0) - 0.5) < 5e-3
