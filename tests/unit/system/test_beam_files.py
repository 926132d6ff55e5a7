# SPDX-License-Identifier: Apache-2.0
"""Beams from files: against the elastica, the beam equations and the beams of `shafts`."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from pitchpoint.core.errors import ModelError
from pitchpoint.geometry.materials import material
from pitchpoint.io.yaml_model import dump_model, loads_model
from pitchpoint.solvers.equilibrium.solve import find_equilibrium
from pitchpoint.solvers.modal import find_modes
from pitchpoint.system.compile import compile_model
from tests.support.mechanism_files import accelerations

TIP = "{motion: free, mass: 1 mg, inertia_tensor: [1e-9, 1e-9, 1e-9, 0, 0, 0], position: [1 m, 0, 0], %s}"
ROD = """\
bodies:
  tip: {tip}
beams:
  rod: {{ends: [{root}, tip.end], section: {section}, axis: [0, 1, 0], pieces: {pieces}}}
"""
LIGHT = "{youngs_modulus: 200 GPa, poisson_ratio: 0.3, density: 1e-6 kg/m^3}"
THIN = "{area: 1e-3 m^2, bending: [1e-9 m^4, 1e-9 m^4], torsion: 2e-9 m^4}"


def rod(section, *, pieces=8, root="ground", more=""):
    """A bar of 1 m along x from ground to a tip of next to no mass."""
    tip = TIP % "markers: {end: {}}"
    return ROD.format(tip=tip, section=section, pieces=pieces, root=root) + more


def system_of(text):
    """System of a text that survives a round trip."""
    model = loads_model(text)
    assert loads_model(dump_model(model)) == model
    return compile_model(model)


def elastica(alpha):
    """Deflection and shortened reach, per length, of a cantilever under P L^2 / (E I) = alpha at its tip.

    Bisshopp and Drucker, Large deflection of cantilever beams, Quarterly of Applied Mathematics 3 (1945)
    272-275: with p^2 = (1 + sin phi)/2 of the tip's slope phi and sin t = 1/(p sqrt 2), sqrt(alpha) = K(p) -
    F(p, t), deflection = 1 - 2 (E(p) - E(p, t))/sqrt(alpha), reach = sqrt(2 sin phi / alpha).
    """

    def angle(m):
        return math.asin(1.0 / math.sqrt(2.0 * m))

    m = brentq(lambda m: ellipk(m) - ellipkinc(angle(m), m) - math.sqrt(alpha), 0.5 + 1e-12, 1.0 - 1e-12)
    bent = ellipe(m) - ellipeinc(angle(m), m)
    return 1.0 - 2.0 * bent / math.sqrt(alpha), math.sqrt(2.0 * (2.0 * m - 1.0) / alpha)


def test_the_elastica_has_the_published_deflections():
    # Bisshopp and Drucker's curve as tabulated since: 0.3017 at 1, 0.6700 at 4, 0.8106 at 10
    assert [round(elastica(a)[0], 4) for a in (1.0, 4.0, 10.0)] == [0.3017, 0.67, 0.8106]


@pytest.mark.parametrize("alpha", [1.0, 4.0, 10.0])
def test_a_cantilever_bends_as_the_elastica_does(alpha):
    # without shear; stretching, P/(E A), is 1e-5 here at most. The error falls with the fourth power of the
    # length of the pieces once they turn by less than a right angle each
    errors = []
    for pieces in (4, 8):
        load = f"loads:\n  pull: {{body: tip, marker: end, force: [0, {200.0 * alpha} N, 0]}}\n"
        text = rod(THIN, pieces=pieces, more=load).replace("axis:", f"material: {LIGHT}, axis:")
        system = system_of(text)
        rest = find_equilibrium(system).state
        at = [system.layout.coordinates.index(f"tip.{c}") for c in "xy"]
        down, reach = elastica(alpha)
        errors.append(max(abs(rest.q[at[1]] - down), abs(1.0 + rest.q[at[0]] - reach)))
    assert errors[0] < 4e-3
    assert errors[1] < errors[0] / 12.0


def test_a_cantilever_vibrates_as_timoshenko_has_it():
    # first frequencies in both planes by Euler's beam, beta L = 1.8751; shear and rotary inertia lower them
    # by (h/L)^2 (1.8751)^2 (1 + E/(kappa G))/24, 6e-5 and 2.4e-4 of them; pieces add 1e-5
    system = system_of(rod("{width: 20 mm, height: 10 mm}", pieces=12))
    steel = material("steel")
    found = np.sort(find_modes(system).frequency)[:2]
    for frequency, height in zip(found, (0.01, 0.02), strict=True):
        euler = 1.8751041**2 / math.tau * height * math.sqrt(steel.youngs_modulus / (12.0 * steel.density))
        shear = (height * 1.8751) ** 2 * (1.0 + 2.6 / 0.85) / 24.0
        assert frequency == pytest.approx(euler * (1.0 - shear), rel=5e-5)


def test_a_beam_that_turns_with_its_hub_starts_with_its_speed():
    text = rod("{diameter: 20 mm, bore: 10 mm}", pieces=3, root="hub.root").replace(
        "bodies:",
        "bodies:\n"
        "  hub: {mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], markers: {root: {position: [0.2 m, 0, 0]}}}",
    )
    text = text.replace("motion: free, ", "")
    joints = (
        "joints:\n"
        "  axle: {type: revolute, bodies: [ground, hub], position: [0, 0, 0], speed: {spin: 50 rad/s}}\n"
        "  flange: {type: free, bodies: [hub, tip], position: [1 m, 0, 0]}\n"
    )
    system = system_of(text + joints)
    assert [body.name for body in system.bodies] == ["hub", "tip", "rod.2", "rod.3"]
    # the pieces feel the centrifugal forces of a rigid rod and nothing else: they stretch it at first
    a, _ = accelerations(system, system.initial_state())
    a = dict(zip(system.layout.coordinates, a, strict=True))
    outward = {name: x for name, x in a.items() if abs(x) > 1e-6}
    assert set(outward) == {"tip.x", "rod.2.z", "rod.3.z"}
    assert min(outward.values()) > 500.0


@pytest.mark.parametrize(("speed", "first", "second"), [(2.0, 4.1373, 22.6149), (6.0, 7.3604, 26.8091)])
def test_a_blade_that_turns_stiffens(speed, first, second):
    # Wright, Smith, Thresher, Wang, J. Appl. Mech. 49 (1982) 197-202, Table 1, hub radius 0; frequencies and
    # speed times L^2 sqrt(rho A/(E I)). Pieces of constant tension each leave an error of their square, 1/256
    steel = material("steel")
    unit = 0.002 * math.sqrt(steel.youngs_modulus / (3.0 * steel.density)) / 2.0
    text = f"""\
bodies:
  hub: {{mass: 1 kg, inertia_tensor: [1, 1, 1, 0, 0, 0], markers: {{root: {{}}}}}}
  tip: {{mass: 1 mg, inertia_tensor: [1e-9, 1e-9, 1e-9, 0, 0, 0], position: [1 m, 0, 0]}}
joints:
  axle: {{type: revolute, bodies: [ground, hub], position: [0, 0, 0]}}
  flange: {{type: free, bodies: [hub, tip], position: [1 m, 0, 0]}}
beams:
  blade: {{ends: [hub.root, tip], section: {{width: 40 mm, height: 2 mm}}, axis: [0, 1, 0], pieces: 16}}
scenarios:
  turn:
    drive: {{hub: {{speed: {speed * unit} rad/s}}}}
    speed: {{hub: {speed * unit} rad/s}}
    duration: 1 s
"""
    model = loads_model(text)
    found = find_modes(compile_model(model, "turn"))
    flaps = math.tau * np.sort(found.frequency)[:2] / unit
    assert flaps == pytest.approx([first, second], rel=2e-3)


@pytest.mark.parametrize(
    ("change", "where", "words"),
    [
        (("{diameter: 20 mm}", "{}"), "beams.rod.section (line 4)", "give diameter, or width and height"),
        (("{diameter: 20 mm}", "{diameter: 20 mm, width: 3 mm}"), "beams.rod.section (line 4)", "width"),
        (
            ("20 mm}", "20 mm, bore: 20 mm}"),
            "beams.rod.section.bore (line 4)",
            "is not smaller than the diameter",
        ),
        (("20 mm}", "20 mm, shear: [0.8, 0.8]}"), "beams.rod.section.shear (line 4)", "remove it"),
        (("axis: [0, 1, 0]", "axis: [1, 0, 0]"), "beams.rod.axis (line 4)", "points along the beam"),
        (("axis: [0, 1, 0]", "axis: [0, 0, 0]"), "beams.rod.axis (line 4)", "has no direction"),
        (("[ground, tip.end]", "[tip, tip.end]"), "beams.rod.ends (line 4)", "are on the same body, tip"),
        (("[ground, tip.end]", "[ground, tip.edn]"), "beams.rod.ends[1] (line 4)", "did you mean end?"),
        (("position: [1 m, 0, 0]", "position: [0, 0, 0]"), "beams.rod.ends (line 4)", "coincide"),
        (("pieces: 8", "pieces: 0"), "beams.rod.pieces (line 4)", ">= 1"),
    ],
)
def test_wrong_beams_are_told_with_their_line(change, where, words):
    text = rod("{diameter: 20 mm}")
    assert change[0] in text
    with pytest.raises(ModelError) as error:
        loads_model(text.replace(*change))
    assert where in str(error.value)
    assert words in str(error.value)
    assert len(error.value.problems) == 1
