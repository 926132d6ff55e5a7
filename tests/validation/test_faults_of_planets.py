# SPDX-License-Identifier: Apache-2.0
"""Faulty teeth of a planet set, met where they stand: of the sun, of the ring, of a planet on both its sides.

Kinematics alone, as Willis has them: sun and carrier turn by phi_s and phi_c = phi_s z_s/(z_s + z_r), planets
by phi_c - (phi_s - phi_c) z_s/z_p, and every mesh is pressed by the same depth. A tooth that points along the
line of centres of a mesh is in the middle of its contact there:

* of the sun, it meets N planets in every turn against the carrier, one after the other, evenly;
* of the ring, it meets each planet once in every turn of the carrier, when that planet stands there;
* of a planet, it meets the sun and the ring once each in every turn against the carrier, half a turn apart,
  with opposite flanks: the sun pushes it, and with its other side it pushes the ring.

How far beside the line of centres a tooth touches is the path of contact: at most two pitches.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from pitchpoint.system import evaluate
from pitchpoint.system.compile import compile_model
from tests.support.planet_stages import planet_set

SUN, PLANET, RING, COUNT = 21, 39, 99, 3
DEPTH = 8e-6
TOOTH = 5
LAW = {"law": "din3990", "tip_relief_factor": 0.5}
MESHES = [f"{side}{k}" for side in "sr" for k in range(COUNT)]


@pytest.fixture(scope="module")
def healthy():
    model = planet_set(SUN, PLANET, RING, COUNT)
    return model.replace_all({f"meshes.{name}.stiffness": LAW for name in MESHES})


def fault(kind, flank="both"):
    if kind == "broken_tooth":
        return {"type": kind, "tooth": TOOTH, "width": "10 mm"}
    if kind == "root_crack":
        return {"type": kind, "tooth": TOOTH, "flank": flank, "depth": "3 mm"}
    patch = {"position": 20e-3, "length": 30e-3, "height": 6e-3, "depth": 50e-6}
    return {"type": kind, "tooth": TOOTH, "flank": flank, "patches": [patch]}


def rolled(model, turns):
    """Forces of all meshes, shape (n, 2 COUNT), where the sun has turned so far against the carrier [rad].

    Planets are turned until they press the ring, then the sun until it presses the planets.
    """
    system = compile_model(model)
    columns = {
        what: [system.layout.channel(f"{what}[{name}]") for name in MESHES]
        for what in ("deflection", "mesh_force")
    }
    bodies = {name: system.spin(name) for name in ("sun", "carrier", *(f"b{k}" for k in range(COUNT)))}
    r_s, r_p = (0.5 * model.gears[name].geometry.d_b for name in ("sun", "p0"))
    found = []
    for turn in turns:
        carrier = turn * SUN / RING
        angles = {"sun": turn + carrier, "carrier": carrier}
        angles |= {f"b{k}": -turn * SUN / PLANET for k in range(COUNT)}
        for _ in range(2):
            state = system.initial_state()
            for name, angle in angles.items():
                whole = round(angle / (2.0 * math.pi))
                state.q[bodies[name]] = angle - 2.0 * math.pi * whole
                state.turns[system.layout.bodies.index(name)] = whole
            values = evaluate.observe(system, state)
            seen = values[columns["deflection"]]
            gaps = [0.5 * model.backlash(name) for name in MESHES]
            for k in range(COUNT):
                step = -(DEPTH + gaps[COUNT + k]) - seen[COUNT + k]
                angles[f"b{k}"] += step / r_p
                seen[k] += step
            angles["sun"] += (DEPTH + gaps[0] - seen[0]) / r_s
        assert np.ptp(values[columns["deflection"]][:COUNT]) < 1e-12
        found.append(values[columns["mesh_force"]])
    return np.array(found)


def touched(model, changed, turns):
    """At which of the turns each mesh is another one than that of healthy gears, shape (n, 2 COUNT)."""
    good, bad = rolled(model, turns), rolled(changed, turns)
    assert (good[:, :COUNT] > 0.0).all() and (good[:, COUNT:] < 0.0).all()
    return abs(bad - good) > 1e-9 * abs(good).max()


def beside(model, gear, spin, towards):
    """Angle of the tooth beside a line of centres [rad]."""
    tooth = model.phasing.tooth_angle[gear] + 2.0 * math.pi * TOOTH / model.gears[gear].number_of_teeth
    return np.angle(np.exp(1j * (tooth + spin - towards)))


def met(there, away, pitch):
    """A mesh is touched around the line of centres, over a contact ratio of 1 to 2 pitches, else nowhere."""
    assert np.array_equal(
        there, abs(away - away[there].mean()) <= abs(away[there] - away[there].mean()).max()
    )
    assert abs(away[there].mean()) < 0.5 * pitch
    assert 1.0 * pitch < np.ptp(away[there]) < 2.0 * pitch


EVERY = ["broken_tooth", "root_crack"]


@pytest.mark.parametrize("kind", EVERY)
def test_a_tooth_of_the_sun_meets_the_planets_in_turn(healthy, kind):
    """COUNT times in a turn against the carrier, in the order of the planets; the ring never feels it."""
    turns = np.arange(SUN * 24) * 2.0 * math.pi / (SUN * 24) + 1e-3
    changed = healthy.replace("gears.sun.faults.f", fault(kind))
    found = touched(healthy, changed, turns)
    assert not found[:, COUNT:].any()
    middles = []
    for k in range(COUNT):
        away = beside(healthy, "sun", turns, 2.0 * math.pi * k / COUNT)
        met(found[:, k], away, 2.0 * math.pi / SUN)
        middles.append(np.angle(np.exp(1j * turns[found[:, k]]).mean()))
    steps = np.diff([*middles, middles[0]]) % (2.0 * math.pi)
    assert steps == pytest.approx([2.0 * math.pi / COUNT] * COUNT, abs=0.1 * 2.0 * math.pi / SUN)


@pytest.mark.parametrize("kind", EVERY)
def test_a_tooth_of_the_ring_meets_each_planet_at_its_place(healthy, kind):
    """Once in a turn of the carrier, when the planet stands before it; the sun never feels it."""
    turns = np.arange(RING * 12) * 2.0 * math.pi * RING / SUN / (RING * 12) + 1e-3
    changed = healthy.replace("gears.ring.faults.f", fault(kind))
    found = touched(healthy, changed, turns)
    assert not found[:, :COUNT].any()
    for k in range(COUNT):
        stands = turns * SUN / RING + 2.0 * math.pi * k / COUNT
        met(found[:, COUNT + k], -beside(healthy, "ring", 0.0, stands), 2.0 * math.pi / RING)


@pytest.mark.parametrize("kind", EVERY)
def test_a_tooth_of_a_planet_meets_sun_and_ring(healthy, kind):
    """Once each in a turn against the carrier; other planets never feel it."""
    turns = np.arange(PLANET * 14) * 2.0 * math.pi * PLANET / SUN / (PLANET * 14) + 1e-3
    changed = healthy.replace("gears.p1.faults.f", fault(kind))
    found = touched(healthy, changed, turns)
    assert not np.delete(found, [1, COUNT + 1], axis=1).any()
    outwards = 2.0 * math.pi / COUNT  # seen from the carrier
    for mesh, towards in ((1, outwards + math.pi), (COUNT + 1, outwards)):
        met(found[:, mesh], beside(healthy, "p1", -turns * SUN / PLANET, towards), 2.0 * math.pi / PLANET)


@pytest.mark.parametrize("kind", ["root_crack", "pitting"])
@pytest.mark.parametrize("flank", ["left", "right"])
def test_sun_and_ring_touch_opposite_flanks_of_a_planet(healthy, kind, flank):
    """The sun turns counter-clockwise and pushes with left flanks, on left ones of the planets, which press
    the ring with their right ones."""
    turns = np.arange(PLANET * 8) * 2.0 * math.pi * PLANET / SUN / (PLANET * 8) + 1e-3
    damage = fault(kind, flank)
    if kind == "pitting":
        damage["patches"][0]["diameter"] = healthy.gears["p1"].geometry.d
    found = touched(healthy, healthy.replace("gears.p1.faults.f", damage), turns)
    assert found[:, 1].any() == (flank == "left")
    assert found[:, COUNT + 1].any() == (flank == "right")
