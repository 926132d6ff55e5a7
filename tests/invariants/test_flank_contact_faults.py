# SPDX-License-Identifier: Apache-2.0
"""Potential of the contact of tooth surfaces with modified, deviating and faulty teeth.

Two sources: random grids of gaps and added compliance on every tooth of a mesh alone, and gears of a model
file with relief, crowning, pitch errors, pits, a broken tooth and a crack. Grids are piecewise linear or
cubic between stations, so that the slopes hold up to the differences.
"""

import functools

import numpy as np
import pytest

from pitchpoint.io.yaml_model import loads_model
from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.energy_slopes import along_spins, shaken, slope_of_energy
from tests.support.flank_levels import N_PAIR, flexible, rigid
from tests.support.one_mesh import OneMesh, make_pair

LEVELS = {"rigid": rigid, "flexible": flexible}
PAIRS = {"spur": dict(beta=0.0), "helical": dict(beta=0.3)}
every_level = pytest.mark.parametrize("level", LEVELS)
every_pair = pytest.mark.parametrize("pair", PAIRS)
both_flanks = pytest.mark.parametrize("flank", [1, -1])


@functools.cache
def laws(pair, level):
    return LEVELS[level](make_pair(**PAIRS[pair]))


def waves(rng, teeth, cells=(9, 33)):
    """Hollows along and across the flanks of every tooth, between 0 and 1."""
    z, roll = np.meshgrid(*(np.linspace(-1.0, 1.0, n) for n in cells), indexing="ij")
    a, b, c = rng.uniform(-1.0, 1.0, (3, 2, teeth, 1, 1))
    return 0.5 + 0.5 * np.sin(3.0 * (a + b * z + c * roll))


def uneven(pair, level, kinds):
    """A mesh with random grids on all teeth of both gears."""
    m = OneMesh(make_pair(**PAIRS[pair]), laws(pair, level), n_pair=N_PAIR)
    rng = np.random.default_rng(7)
    sizes = {"gap": 1e-5, "soft": 5e-11}
    m.own(**{k: [sizes[k] * waves(rng, abs(int(m.row[z]))) for z in ("z1", "z2")] for k in kinds})
    return m


@every_pair
@every_level
@both_flanks
@pytest.mark.parametrize("kinds", [("gap",), ("soft",), ("gap", "soft")], ids="-".join)
def test_forces_of_uneven_teeth_are_the_slopes_of_one_potential(pair, level, flank, kinds):
    m = shaken(uneven(pair, level, kinds), 1e-4)
    m.frames["phi"] += [0.05, -0.05 * m.row["r_b1"] / m.row["r_b2"]]
    m.press(3e-5, flank)
    F = along_spins(m, m.evaluate())
    assert abs(F - slope_of_energy(m, spins=True)).max() < 3e-6 * abs(F).max()


MODIFIED = (
    "modifications: {both: {tip_relief: {amount: 12 um, length: 2 mm}, profile_crowning: 4 um, "
    "lead_crowning: 6 um}}"
)
GEARS = {
    "plain": ("", ""),
    "modifications": (MODIFIED, MODIFIED),
    "pitch errors": (
        f"deviations: {{pitch: [{', '.join(f'{(-1) ** k * (k % 5)} um' for k in range(25))}]}}",
        "",
    ),
    "pits": (
        "faults: {pit: {type: pitting, flank: both, tooth: 2, patches: [{position: 2 mm, diameter: 75 mm, "
        "length: 4 mm, height: 1 mm, depth: 50 um}]}}",
        "",
    ),
    "broken": ("faults: {gone: {type: broken_tooth, tooth: 2, width: 12 mm, height: 3 mm}}", ""),
    "crack": ("faults: {crack: {type: root_crack, flank: left, tooth: 2, depth: 2 mm}}", ""),
}


@functools.cache
def machine(kind, level):
    one, two = (f", {text}" if text else "" for text in GEARS[kind])
    gear = "normal_module: 3 mm, face_width: 20 mm, helix_angle: 12 deg, profile_shift_coefficient: 0"
    text = (
        f"gears:\n  g1: {{number_of_teeth: 25, hand: left, {gear}{one}}}\n"
        f"  g2: {{number_of_teeth: 40, hand: right, {gear}{two}}}\n"
        "bodies:\n"
        "  a: {gears: [g1], motion: planar, mass: 1 kg, inertia: 1e-3 kg m^2}\n"
        "  b: {gears: [g2], motion: planar, mass: 2 kg, inertia: 4e-3 kg m^2}\n"
        "bearings:\n"
        "  at_a: {body: a, stiffness: {radial: 1 N/m}}\n  at_b: {body: b, stiffness: {radial: 1 N/m}}\n"
        f"meshes:\n  stage: {{gears: [g1, g2], backlash: {{normal: 20 um}}, contact: {{level: {level}}}}}\n"
    )
    return compile_model(loads_model(text))


@pytest.mark.parametrize("kind", [kind for kind in GEARS if kind != "plain"])
@every_level
def test_gears_of_a_model_file(kind, level):
    """At rolls over three base pitches, so that the faulty tooth is in contact; the bearings are all but
    absent. Pieces between stations of the grids leave 1e-5."""
    system = machine(kind, level)
    state = system.initial_state()
    names = list(system.layout.coordinates)
    spins = [names.index("a.spin"), names.index("b.spin")]
    pair = system.records["gear_mesh"][0]
    r_b = float(pair["r_b1"]), float(pair["r_b2"])
    u, energy = (system.layout.channel(f"{name}[stage]") for name in ("deflection", "elastic_energy"))
    plain, differing = machine("plain", level), 0.0
    start = state.q.copy()
    for roll in np.linspace(-0.8, -0.05, 9):
        state.q[:] = start
        state.q[spins] += [roll, -roll * r_b[0] / r_b[1]]
        row = evaluate.observe(system, state)
        state.q[spins[0]] += (35e-6 - row[u]) / r_b[0]
        force = evaluate.residual(system, state)
        ours, theirs = (evaluate.observe(each, state)[energy] for each in (system, plain))
        differing = max(differing, abs(ours / theirs - 1.0))
        slope = np.zeros(state.q.size)
        for k in range(state.q.size):
            h, values = (1e-8 if k in spins else 1e-9), []
            for sign in (1, -1):
                state.q[k] += sign * h
                values.append(evaluate.observe(system, state)[energy])
                state.q[k] -= sign * h
            slope[k] = (values[0] - values[1]) / (2 * h)
        size = np.array([r_b[0] if k in spins else 1.0 for k in range(state.q.size)])
        scale = abs(slope / size).max()
        assert scale > 100.0
        assert (abs(np.abs(force) - np.abs(slope)) / size).max() < 1e-5 * scale
    assert differing > 0.01
